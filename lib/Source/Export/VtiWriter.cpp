// VTK image data: a colour for each cell, compressed, and where the cells lie.
#include "Source/Export/VoxelVisit.h"
#include "Source/Export/Writers.h"

#include <glm/geometric.hpp>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace voxc {

namespace {

/// Cells of a block, which is compressed on its own.
constexpr std::uint64_t kBlockCells = std::uint64_t{1} << 18;
constexpr std::uint64_t kBlockBytes = kBlockCells * 4;

std::string textOf(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), end.ptr};
}

std::string textOf(const glm::dvec3 &v) { return textOf(v.x) + " " + textOf(v.y) + " " + textOf(v.z); }

/// Origin, spacing and, where axes are turned, direction; nothing of a map that is none.
std::string placeOf(const Transform &map) {
  const auto length = [&](int axis) { return glm::length(glm::dvec3(map[axis])); };
  if (!isFinite(map) || !std::isfinite(length(0) + length(1) + length(2)))
    return "";
  glm::dvec3 spacing;
  std::array<glm::dvec3, 3> axes;
  bool isTurned = false;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 step(map[i]);
    glm::dvec3 straight(0);
    spacing[i] = length(i);
    straight[i] = spacing[i];
    isTurned = isTurned || step != straight;
    // Adding 0 takes the sign off a zero.
    axes[static_cast<std::size_t>(i)] = (spacing[i] > 0 ? step / spacing[i] : straight) + 0.0;
  }
  std::string text = " Origin=\"" + textOf(glm::dvec3(map[3])) + "\" Spacing=\"" + textOf(spacing) + "\"";
  if (!isTurned)
    return text;
  text += " Direction=\"";
  for (int row = 0; row < 3; ++row)
    text += (row == 0 ? "" : " ") + textOf({axes[0][row], axes[1][row], axes[2][row]});
  return text + "\"";
}

std::string headOf(const Volume &volume) {
  const Int3 size = volume.info().extent;
  const std::string extent =
      "0 " + std::to_string(size.x) + " 0 " + std::to_string(size.y) + " 0 " + std::to_string(size.z);
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
         "compressor=\"vtkZLibDataCompressor\">\n"
         "  <ImageData WholeExtent=\"" +
         extent + "\"" + placeOf(volume.info().voxelToModel) +
         ">\n"
         "    <Piece Extent=\"" +
         extent +
         "\">\n"
         "      <PointData/>\n"
         "      <CellData Scalars=\"voxels\">\n"
         "        <DataArray type=\"UInt8\" Name=\"voxels\" NumberOfComponents=\"4\" format=\"appended\" "
         "offset=\"0\"/>\n"
         "      </CellData>\n"
         "    </Piece>\n"
         "  </ImageData>\n"
         "  <AppendedData encoding=\"raw\">\n"
         "   _";
}

/// Takes words one after the other, and writes each block when it is full.
class BlockWriter {
public:
  explicit BlockWriter(OutputFile &file) : file_(file), packed_(compressBound(kBlockBytes)) {}

  Expected<void> add(std::span<const std::uint32_t> words) {
    while (!words.empty()) {
      const std::size_t now = std::min<std::size_t>(words.size(), kBlockCells - block_.size());
      block_.insert(block_.end(), words.begin(), words.begin() + static_cast<std::ptrdiff_t>(now));
      words = words.subspan(now);
      if (block_.size() == kBlockCells)
        VOXC_TRY(flush());
    }
    return {};
  }

  Expected<void> flush() {
    if (block_.empty())
      return {};
    uLongf size = packed_.size();
    if (compress2(packed_.data(), &size, reinterpret_cast<const Bytef *>(block_.data()), block_.size() * 4,
                  Z_BEST_SPEED) != Z_OK)
      return Error::environment("there is no memory to compress voxels");
    sizes_.push_back(size);
    block_.clear();
    return file_.write(packed_.data(), size);
  }

  /// Bytes of all blocks, in their order.
  const std::vector<std::uint64_t> &sizes() const { return sizes_; }

private:
  OutputFile &file_;
  std::vector<Bytef> packed_;
  std::vector<std::uint32_t> block_;
  std::vector<std::uint64_t> sizes_;
};

} // namespace

Expected<void> writeVtkImage(const Volume &volume, OutputFile &file, const ExportOptions &options,
                             Exported &) {
  const Int3 extent = volume.info().extent;
  const std::uint64_t cells = static_cast<std::uint64_t>(extent.x) * static_cast<std::uint64_t>(extent.y) *
                              static_cast<std::uint64_t>(extent.z);
  const std::uint64_t blocks = (cells + kBlockCells - 1) / kBlockCells;
  const std::string head = headOf(volume);
  // Sizes are known last, and stand first.
  std::vector<std::uint64_t> numbers(3 + blocks);
  VOXC_TRY(file.write(head.data(), head.size()));
  VOXC_TRY(file.write(numbers.data(), numbers.size() * 8));
  BlockWriter writer(file);
  const auto add = [&](std::span<const std::uint32_t> words) { return writer.add(words); };
  VOXC_TRY(forEachRun(volume, options.save.progress, add));
  VOXC_TRY(writer.flush());
  numbers = {blocks, kBlockBytes, cells % kBlockCells * 4};
  numbers.insert(numbers.end(), writer.sizes().begin(), writer.sizes().end());
  VOXC_TRY(file.rewrite(head.size(), numbers.data(), numbers.size() * 8));
  constexpr std::string_view kTail = "\n  </AppendedData>\n</VTKFile>\n";
  return file.write(kTail.data(), kTail.size());
}

} // namespace voxc
