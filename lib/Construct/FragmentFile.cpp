// Layout of fragment files, and their checks.
#include "FragmentFile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace voxc {
namespace {

constexpr std::array<char, 8> kMagic = {'\x89', 'H', 'V', 'F', '\r', '\n', '\x1a', '\n'};
constexpr std::uint32_t kVersion = 4;
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint64_t kMaxTextBytes = 1 << 20;

/// The fixed part of the header; little-endian, no padding. The texts follow, then the parts.
struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t byteOrder = kByteOrder;
  std::uint64_t checksum = 0; ///< XXH3-64 of all that follows the header, then of the header with 0 here.
  std::uint64_t parts = 0;
  std::uint64_t index = 0;
  std::uint64_t count = 0;
  std::array<std::int32_t, 3> extent{};
  std::int32_t log2Side = 0;
  std::uint32_t irBytes = 0;
  std::uint32_t provenanceBytes = 0;
  std::array<double, 12> voxelToModel{};
};
static_assert(sizeof(Header) == 168);

/// What stands before each part; its words, array, blocks (a word of 8 bytes each), cells, values and shared
/// counts follow.
struct PartHeader {
  std::array<std::int32_t, 3> low{};
  std::array<std::uint32_t, 3 + construct::kMaskWords> node{}; ///< Kind, value, masks, voxels.
  std::uint32_t colour = 0;                                    ///< Of all voxels, of payload=constant.
  std::int32_t log2Side = 0;                                   ///< Of the part.
  std::uint64_t words = 0;
  std::uint64_t array = 0;
  std::uint64_t blocks = 0;
  std::uint64_t cells = 0;
  std::uint64_t values = 0;
  std::uint64_t voxels = 0;
};
static_assert(sizeof(PartHeader) == 96);
static_assert(sizeof(construct::PlacedCell) == 20);

constexpr int kKindBits = 2;
constexpr int kLevelBits = 6;

std::uint64_t pack(const BlockRecord &block) {
  return block.kind | block.level << kKindBits | block.words << (kKindBits + kLevelBits);
}

BlockRecord unpack(std::uint64_t packed) {
  return {static_cast<BlockRecord::Kind>(packed & ((1u << kKindBits) - 1)),
          static_cast<std::uint32_t>(packed >> kKindBits & ((1u << kLevelBits) - 1)),
          packed >> (kKindBits + kLevelBits)};
}

Header headerOf(const FragmentInfo &info) {
  const VolumeInfo &volume = info.volume;
  Header header;
  header.index = info.index;
  header.count = info.count;
  header.extent = {volume.extent.x, volume.extent.y, volume.extent.z};
  header.log2Side = info.log2Side;
  header.irBytes = static_cast<std::uint32_t>(printIr(volume.format).size());
  header.provenanceBytes = static_cast<std::uint32_t>(volume.provenance.size());
  header.voxelToModel = rowsOf(volume.voxelToModel);
  return header;
}

} // namespace

FragmentWriter::FragmentWriter(OutputFile file, FragmentInfo info)
    : file_(std::move(file)), info_(std::move(info)), sum_(std::make_unique<Checksum>()) {}

Expected<FragmentWriter> FragmentWriter::create(const std::string &path, const FragmentInfo &info) {
  auto file = OutputFile::create(path);
  if (!file)
    return file.error();
  if (!file->isRegular())
    return Error::input("'" + path + "' is no file; a fragment needs one");
  FragmentWriter writer(std::move(*file), info);
  const Header header = headerOf(info);
  const std::string texts = printIr(info.volume.format) + info.volume.provenance;
  if (auto written = writer.file_.write(&header, sizeof header); !written)
    return written.error();
  if (auto written = writer.write(texts.data(), texts.size()); !written)
    return written.error();
  return writer;
}

Expected<void> FragmentWriter::write(const void *data, std::size_t size) {
  sum_->add(data, size);
  return file_.write(data, size);
}

Expected<void> FragmentWriter::add(const Fragment &fragment) {
  const construct::Node &node = fragment.node;
  const PartHeader header = {
      {fragment.cube.low.x, fragment.cube.low.y, fragment.cube.low.z},
      {node.kind, node.value, node.masks[0], node.masks[1], node.masks[2], node.masks[3], node.voxels},
      fragment.colour,
      fragment.cube.log2Side,
      fragment.words.size(),
      fragment.array.size(),
      fragment.blocks.size(),
      fragment.cells.size(),
      fragment.values.size(),
      fragment.voxels};
  std::vector<std::uint64_t> blocks;
  blocks.reserve(fragment.blocks.size());
  for (const BlockRecord &block : fragment.blocks)
    blocks.push_back(pack(block));
  const std::array<std::span<const std::byte>, 7> pieces = {
      std::as_bytes(std::span(&header, 1)),     std::as_bytes(std::span(fragment.words)),
      std::as_bytes(std::span(fragment.array)), std::as_bytes(std::span(blocks)),
      std::as_bytes(std::span(fragment.cells)), std::as_bytes(std::span(fragment.values)),
      std::as_bytes(std::span(fragment.shared))};
  for (const auto &piece : pieces)
    if (auto written = write(piece.data(), piece.size()); !written)
      return written;
  ++parts_;
  return {};
}

Expected<void> FragmentWriter::finish() {
  Header header = headerOf(info_);
  header.parts = parts_;
  sum_->add(&header, sizeof header);
  header.checksum = sum_->digest();
  if (auto written = file_.rewrite(0, &header, sizeof header); !written)
    return written;
  return file_.commit();
}

namespace {

/// Files are summed by so much, which then goes: a merge opens many before it reads the first.
constexpr std::size_t kSummedAtOnce = std::size_t{4} << 20;

std::uint64_t checksumOf(Header header, const MappedFile &file) {
  header.checksum = 0;
  Checksum checksum;
  for (auto body = file.bytes().subspan(sizeof(Header)); !body.empty();) {
    const auto piece = body.first(std::min(body.size(), kSummedAtOnce));
    checksum.add(piece.data(), piece.size());
    file.letGo();
    body = body.subspan(piece.size());
  }
  checksum.add(&header, sizeof header);
  return checksum.digest();
}

/// What is wrong with a header, or nothing.
std::string problemOf(const Header &header, const MappedFile &file) {
  const std::span<const std::byte> bytes = file.bytes();
  const std::uint64_t textBytes = std::uint64_t{header.irBytes} + header.provenanceBytes;
  if (header.version != kVersion || header.byteOrder != kByteOrder)
    return "is of another version or byte order; build it again with this voxc";
  if (textBytes > kMaxTextBytes || textBytes > bytes.size() - sizeof(Header) || header.count == 0 ||
      header.index >= header.count || header.log2Side < 0 || header.log2Side > kMaxLog2Extent)
    return "has a header that contradicts itself";
  if (checksumOf(header, file) != header.checksum)
    return "is damaged: its checksum does not match its contents";
  return {};
}

bool fits(Int3 extent, const Format &format) {
  const Int3 most = format.extent();
  for (int axis = 0; axis < 3; ++axis)
    if (extent[axis] < 0 || extent[axis] > most[axis])
      return false;
  return true;
}

/// Copies values out of bytes that may be too few for them.
class ByteReader {
public:
  ByteReader(std::span<const std::byte> bytes, std::uint64_t at) : bytes_(bytes), at_(at) {}

  std::uint64_t at() const { return at_; }

  template <typename T> bool read(T &value) { return copy(&value, sizeof value); }
  template <typename T> bool read(std::vector<T> &values, std::uint64_t count) {
    if (count > (bytes_.size() - at_) / sizeof(T))
      return false;
    values.resize(count);
    return copy(values.data(), count * sizeof(T));
  }

private:
  bool copy(void *to, std::uint64_t size) {
    if (size > bytes_.size() - at_)
      return false;
    std::copy_n(bytes_.data() + at_, size, static_cast<std::byte *>(to));
    at_ += size;
    return true;
  }

  std::span<const std::byte> bytes_;
  std::uint64_t at_;
};

Cube cubeOf(const PartHeader &header) {
  return {{header.low[0], header.low[1], header.low[2]}, header.log2Side};
}

/// Adds to `size` the bytes of what a part's header counts; false if one count is more than a file of `most`
/// bytes has.
bool addBytes(const PartHeader &header, std::uint64_t most, std::uint64_t &size) {
  const std::array<std::pair<std::uint64_t, std::uint64_t>, 5> counts = {
      {{header.words, sizeof(std::uint32_t)},
       {header.array, sizeof(std::uint32_t)},
       {header.blocks, sizeof(std::uint64_t)},
       {header.cells, sizeof(construct::PlacedCell)},
       {header.values, sizeof(std::uint32_t)}}};
  for (const auto &[count, bytes] : counts) {
    if (count > most / bytes)
      return false;
    size += count * bytes;
  }
  return true;
}

/// True if the blocks are all of the words but the first, and all of the array but number 0.
bool covers(const Fragment &fragment, const Layout &layout) {
  std::uint64_t words = fragment.words.size();
  std::uint64_t array = fragment.array.size();
  const bool hasArray = std::ranges::any_of(layout.strata, &Stratum::isIndexed);
  if (words-- == 0 || array < (hasArray ? kIndexedWords : 0))
    return false;
  array -= hasArray ? kIndexedWords : 0;
  for (const BlockRecord &block : fragment.blocks) {
    const bool isForget = block.kind == BlockRecord::Forget;
    if (block.kind > BlockRecord::InternLeaf || block.level == 0 || block.level > layout.strata.size() ||
        isForget != (block.words == 0))
      return false;
    std::uint64_t &left = layout.isIndexed(block.level - 1) ? array : words;
    if (block.words > left || (&left == &array && !isForget && block.words != kIndexedWords))
      return false;
    left -= block.words;
  }
  return words == 0 && array == 0;
}

} // namespace

Expected<FragmentReader> FragmentReader::open(const std::string &path) {
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  const auto broken = [&](const std::string &problem) { return Error::input("'" + path + "' " + problem); };
  FragmentReader reader(std::move(*file), path);
  const std::span<const std::byte> bytes = reader.bytes();
  Header header;
  if (bytes.size() >= sizeof(Header))
    std::memcpy(&header, bytes.data(), sizeof(Header));
  if (bytes.size() < sizeof(Header) || header.magic != kMagic)
    return broken("is not a fragment of a volume");
  if (const std::string problem = problemOf(header, reader.file_); !problem.empty())
    return broken(problem);

  const auto *text = reinterpret_cast<const char *>(bytes.data()) + sizeof(Header);
  Diagnostics diagnostics;
  Format format = parseIr(std::string_view(text, header.irBytes), diagnostics);
  const Int3 extent = {header.extent[0], header.extent[1], header.extent[2]};
  if (diagnostics.hasErrors() || format != storageFormat(format) || !fits(extent, format))
    return broken("names no valid format, or one that is too small");
  reader.info_ = {{std::move(format), extent, transformOfRows(header.voxelToModel), 0,
                   std::string(text + header.irBytes, header.provenanceBytes)},
                  header.log2Side,
                  header.index,
                  header.count};
  reader.at_ = sizeof(Header) + std::uint64_t{header.irBytes} + header.provenanceBytes;
  reader.remaining_ = header.parts;
  return reader;
}

std::optional<Cube> FragmentReader::next() const {
  PartHeader header;
  ByteReader reader(bytes(), at_);
  if (remaining_ == 0 || !reader.read(header))
    return std::nullopt;
  return cubeOf(header);
}

std::vector<PartPlace> FragmentReader::places() const {
  std::vector<PartPlace> places;
  const std::uint64_t shared = (info_.volume.format.levels.size() + 1) * sizeof(std::uint64_t);
  std::uint64_t at = at_;
  for (std::uint64_t part = 0; part < remaining_; ++part) {
    PartHeader header;
    ByteReader reader(bytes(), at);
    std::uint64_t size = shared;
    if (!reader.read(header) || !addBytes(header, bytes().size(), size) ||
        size > bytes().size() - reader.at())
      break;
    places.push_back({cubeOf(header), size});
    at = reader.at() + size;
  }
  return places;
}

Expected<Fragment> FragmentReader::take() {
  const Error broken = Error::input("'" + path_ + "' is broken: a part of it contradicts itself");
  const std::size_t levels = info_.volume.format.levels.size();
  ByteReader reader(bytes(), at_);
  PartHeader header;
  Fragment fragment;
  std::vector<std::uint64_t> blocks;
  if (!reader.read(header) || !reader.read(fragment.words, header.words) ||
      !reader.read(fragment.array, header.array) || !reader.read(blocks, header.blocks) ||
      !reader.read(fragment.cells, header.cells) || !reader.read(fragment.values, header.values) ||
      !reader.read(fragment.shared, levels + 1))
    return broken;
  fragment.blocks.reserve(blocks.size());
  for (const std::uint64_t block : blocks)
    fragment.blocks.push_back(unpack(block));
  if (!covers(fragment, layoutOf(info_.volume.format)) || header.node[0] > construct::Node::Inner)
    return broken;
  fragment.cube = cubeOf(header);
  fragment.node = {static_cast<construct::Node::Kind>(header.node[0]), header.node[1]};
  std::copy_n(header.node.begin() + 2, construct::kMaskWords, fragment.node.masks);
  fragment.node.voxels = header.node.back();
  fragment.voxels = header.voxels;
  fragment.colour = header.colour;
  at_ = reader.at();
  --remaining_;
  return fragment;
}

} // namespace voxc
