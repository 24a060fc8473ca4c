// Base 64, blocks of zlib's, and what stands before them.
#include "Input/Vtk/VtkData.h"

#include "Input/Dense/ByteStream.h"
#include "Input/Dense/GzipReader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>
#include <vector>

namespace voxc {

namespace {

constexpr std::string_view kBase64Blanks = " \t\r\n";

/// 0 to 63, or -1.
int valueOf(char letter) {
  if (letter >= 'A' && letter <= 'Z')
    return letter - 'A';
  if (letter >= 'a' && letter <= 'z')
    return letter - 'a' + 26;
  if (letter >= '0' && letter <= '9')
    return letter - '0' + 52;
  return letter == '+' ? 62 : letter == '/' ? 63 : -1;
}

/// Base 64 in which ends may follow each other: VTK encodes what stands before data on its own.
class Base64Stream final : public ByteStream {
public:
  explicit Base64Stream(std::string_view text) : text_(text), most_(text.size() / 4 * 3) {}

  Expected<std::size_t> readSome(std::span<std::byte> target) override {
    for (std::size_t done = 0; done < target.size(); ++done) {
      if (at_ == count_)
        VOXC_TRY(decode());
      if (at_ == count_)
        return done;
      target[done] = bytes_[at_++];
    }
    return target.size();
  }
  std::uint64_t mostBytes() const override { return most_; }

private:
  /// The next four letters; none at the end.
  Expected<void> decode() {
    at_ = count_ = 0;
    unsigned bits = 0;
    std::size_t letters = 0, pads = 0;
    while (letters + pads < 4) {
      text_.remove_prefix(std::min(text_.find_first_not_of(kBase64Blanks), text_.size()));
      // What stands behind the last data of a file is the end of its element.
      if (letters + pads == 0 && (text_.empty() || text_.front() == '<'))
        return {};
      const int value = text_.empty() ? -1 : valueOf(text_.front());
      const bool isPad = !text_.empty() && text_.front() == '=' && letters >= 2;
      if (!isPad && (value < 0 || pads > 0))
        return Error::input("its data are no base 64, or end within four letters of it");
      bits = bits << 6 | static_cast<unsigned>(std::max(value, 0));
      letters += !isPad;
      pads += isPad;
      text_.remove_prefix(1);
    }
    count_ = 3 - pads;
    for (std::size_t i = 0; i < count_; ++i)
      bytes_[i] = static_cast<std::byte>(bits >> (16 - 8 * i));
    return {};
  }

  std::string_view text_;
  std::uint64_t most_;
  std::array<std::byte, 3> bytes_{};
  std::size_t at_ = 0, count_ = 0;
};

Expected<std::uint64_t> readHeaderNumber(ByteStream &stream, const VtiFile &file) {
  std::array<std::byte, 8> bytes{};
  const auto size = static_cast<std::size_t>(file.headerBytes);
  const auto read = VOXC_TRY(stream.readSome(std::span(bytes).first(size)));
  if (read < size)
    return Error::input("its data end before they say how long they are");
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i)
    number |= std::to_integer<std::uint64_t>(bytes[i]) << 8 * (file.isBigEndian ? size - 1 - i : i);
  return number;
}

Error otherSize(std::uint64_t found, std::uint64_t wanted) {
  return Error::input("an array has " + std::to_string(found) + " bytes, but its extent needs " +
                      std::to_string(wanted));
}

/// What stands before compressed blocks.
struct PackedBlocks {
  std::uint64_t bytes = 0; ///< Of each block but the last,
  std::uint64_t last = 0;  ///< and of that one.
  std::vector<std::uint64_t> packed;
};

Expected<PackedBlocks> readBlocks(ByteStream &stream, const VtiFile &file, std::uint64_t bytes) {
  std::array<std::uint64_t, 3> head{};
  for (std::uint64_t &number : head)
    number = VOXC_TRY(readHeaderNumber(stream, file));
  const auto [count, size, last] = head;
  const std::uint64_t most = stream.mostBytes() / static_cast<std::uint64_t>(file.headerBytes);
  if (count > most || (count > 0 && (size == 0 || (count - 1) > bytes / size || last > size)))
    return Error::input("its compressed data speak of " + std::to_string(count) + " blocks of " +
                        std::to_string(size) + " bytes, which are not the " + std::to_string(bytes) +
                        " of its extent");
  PackedBlocks blocks{size, last == 0 ? size : last, {}};
  const std::uint64_t all = count == 0 ? 0 : (count - 1) * size + blocks.last;
  if (all != bytes)
    return otherSize(all, bytes);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto packed = VOXC_TRY(readHeaderNumber(stream, file));
    blocks.packed.push_back(packed);
  }
  return blocks;
}

Expected<VtkNumbers> stored(VtkBytes cells, bool isBigEndian) {
  const std::byte *const first = cells.data();
  return VtkNumbers{first, std::make_shared<const VtkBytes>(std::move(cells)), isBigEndian};
}

Expected<VtkNumbers> inflateBlocks(ByteStream &stream, const VtiFile &file, std::uint64_t bytes,
                                   const InputOptions &options) {
  constexpr std::uint64_t kMostPerByte = 1040; // zlib makes no more of one.
  const auto blocks = VOXC_TRY(readBlocks(stream, file, bytes));
  VtkBytes cells(options.memory), packed(options.memory);
  for (std::size_t i = 0; i < blocks.packed.size(); ++i) {
    const std::uint64_t size = i + 1 == blocks.packed.size() ? blocks.last : blocks.bytes;
    VOXC_TRY(packed.resize(0));
    VOXC_TRY(appendBytes(stream, blocks.packed[i], packed, *options.memory, options.progress));
    if (size / kMostPerByte > packed.size())
      return Error::input("a compressed block of " + std::to_string(packed.size()) + " bytes cannot hold " +
                          std::to_string(size));
    const std::uint64_t begin = cells.size();
    VOXC_TRY(cells.resize(begin + size));
    GzipReader reader(std::as_const(packed).span(), GzipReader::Wrapping::Zlib);
    VOXC_TRY(reader.read(cells.span().subspan(begin, size)));
    options.memory->relieve(size);
  }
  return stored(std::move(cells), file.isBigEndian);
}

Expected<VtkNumbers> readText(const VtkArray &array, std::uint64_t bytes, const InputOptions &options) {
  const auto stream = makeTextStream(std::as_bytes(std::span(array.text)), *array.type);
  VtkBytes cells(options.memory);
  VOXC_TRY(appendBytes(*stream, bytes, cells, *options.memory, options.progress));
  std::byte more{};
  const auto behind = VOXC_TRY(stream->readSome(std::span(&more, 1)));
  if (behind != 0)
    return Error::input("an array has more numbers than the " +
                        std::to_string(bytes / byteSize(*array.type)) + " of its extent");
  return stored(std::move(cells), std::endian::native == std::endian::big);
}

} // namespace

Expected<VtkNumbers> readVtkNumbers(const VtiFile &file, const VtkArray &array, std::uint64_t bytes,
                                    const InputOptions &options) {
  if (array.format == VtkFormat::Ascii)
    return readText(array, bytes, options);
  const bool isAppended = array.format == VtkFormat::Appended;
  if (isAppended && array.offset > file.appended.size())
    return Error::input("its array '" + array.name.substr(0, 80) + "' begins behind the end of the file");
  const std::string_view text = isAppended ? file.appended.substr(array.offset) : array.text;
  const bool isRaw = isAppended && !file.isAppendedBase64;
  const auto stream =
      isRaw ? makeRawStream(std::as_bytes(std::span(text))) : std::make_unique<Base64Stream>(text);
  if (file.compressor == "vtkZLibDataCompressor")
    return inflateBlocks(*stream, file, bytes, options);
  if (!file.compressor.empty())
    return Error::input("its data are compressed by " + file.compressor.substr(0, 80) +
                        "; voxc reads those of vtkZLibDataCompressor, and those without");
  const auto size = VOXC_TRY(readHeaderNumber(*stream, file));
  if (size != bytes)
    return otherSize(size, bytes);
  const auto head = static_cast<std::size_t>(file.headerBytes);
  if (isRaw && text.size() - head < bytes)
    return Error::input("its data end within an array of " + std::to_string(bytes) + " bytes");
  if (isRaw)
    return VtkNumbers{reinterpret_cast<const std::byte *>(text.data()) + head, nullptr, file.isBigEndian};
  VtkBytes cells(options.memory);
  VOXC_TRY(appendBytes(*stream, bytes, cells, *options.memory, options.progress));
  return stored(std::move(cells), file.isBigEndian);
}

} // namespace voxc
