// Reading the files of fragments, and their checks.
#include "Construct/Parts/PartBuilder.h"
#include "FragmentFile.h"
#include "FragmentLayout.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace voxc {

using namespace hvf;

namespace {

constexpr std::uint64_t kMaxTextBytes = 1 << 20;

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

/// True if the file ends as one that was written to its end.
bool hasTrailer(std::span<const std::byte> bytes) {
  Trailer trailer;
  std::memcpy(&trailer, bytes.last(sizeof trailer).data(), sizeof trailer);
  return trailer.magic == kTrailerMagic && trailer.bytes == bytes.size();
}

/// What is wrong with a header, or nothing.
std::string problemOf(const Header &header, const MappedFile &file) {
  const std::span<const std::byte> bytes = file.bytes();
  const std::uint64_t textBytes = std::uint64_t{header.irBytes} + header.provenanceBytes;
  if (header.version < kFirstWholeVersion && header.byteOrder == kByteOrder)
    return "was written by an earlier voxc, which could leave out voxels after an interruption; build it "
           "again with this voxc";
  if (header.version < kVersion && header.byteOrder == kByteOrder)
    return "is of version " + std::to_string(header.version) +
           ", which an earlier voxc wrote, and this one reads " + "version " + std::to_string(kVersion) +
           "; build it again with this voxc";
  if (header.version != kVersion || header.byteOrder != kByteOrder)
    return "is of another version or byte order; build it again with this voxc";
  if (bytes.size() < sizeof(Header) + sizeof(Trailer) || !hasTrailer(bytes))
    return "is not whole: it does not end as a fragment does; build it again";
  if (textBytes > kMaxTextBytes || textBytes > bytes.size() - sizeof(Header) - sizeof(Trailer) ||
      header.count == 0 || header.index >= header.count || header.begin > header.end || header.log2Side < 0 ||
      header.log2Side > kMaxLog2Extent)
    return "has a header that contradicts itself";
  if (header.looked != header.end - header.begin)
    return "is not whole: of its " + std::to_string(header.end - header.begin) + " cubes " +
           std::to_string(header.looked) + " were looked at; build it again";
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
  const bool hasArray = layout.hasArray();
  if (words-- == 0 || array < (hasArray ? kIndexedWords : 0))
    return false;
  array -= hasArray ? kIndexedWords : 0;
  for (const BlockRecord &block : fragment.blocks) {
    const bool isForget = block.kind == BlockRecord::Forget;
    if (block.kind > BlockRecord::InternLeaf || block.level == 0 || block.level > layout.strata.size() ||
        isForget != (block.words == 0))
      return false;
    std::uint64_t &left = layout.strata[block.level - 1].inArray() ? array : words;
    if (block.words > left || (&left == &array && !isForget && block.words != kIndexedWords))
      return false;
    left -= block.words;
  }
  return words == 0 && array == 0;
}

/// True if there are so many cubes of this size in a volume of the layout.
bool hasCubes(const Header &header, const Layout &layout, Int3 extent) {
  const PartGrid grid = PartGrid::of(extent, layout, header.log2Side);
  return grid.log2Side == header.log2Side && header.end <= grid.count();
}

} // namespace

Expected<FragmentReader> FragmentReader::open(const std::string &path) {
  auto file = VOXC_TRY(MappedFile::open(path));
  const auto broken = [&](const std::string &problem) { return Error::input("'" + path + "' " + problem); };
  FragmentReader reader(std::move(file), path);
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
  reader.layout_ = layoutOf(format);
  if (!hasCubes(header, reader.layout_, extent))
    return broken("has a share of cubes that its volume does not have");
  reader.info_ = {{std::move(format), extent, transformOfRows(header.voxelToModel), header.voxels,
                   std::string(text + header.irBytes, header.provenanceBytes)},
                  header.log2Side,
                  {header.index, header.count, header.begin, header.end}};
  reader.at_ = sizeof(Header) + std::uint64_t{header.irBytes} + header.provenanceBytes;
  reader.remaining_ = header.parts;
  return reader;
}

Next<Cube> FragmentReader::next() const {
  const std::uint64_t end = bytes().size() - sizeof(Trailer);
  if (remaining_ == 0 && at_ == end && voxels_ == info_.volume.voxels)
    return End{};
  if (remaining_ == 0)
    return Error::input("'" + path_ + "' is broken: it does not hold the parts that it says");
  PartHeader header;
  ByteReader reader(bytes().first(end), at_);
  if (!reader.read(header))
    return Error::input("'" + path_ + "' is broken: a part of it is missing");
  return cubeOf(header);
}

std::vector<PartPlace> FragmentReader::places() const {
  std::vector<PartPlace> places;
  std::uint64_t at = at_;
  for (std::uint64_t part = 0; part < remaining_; ++part) {
    PartHeader header;
    ByteReader reader(bytes(), at);
    std::uint64_t size = 0;
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
  ByteReader reader(bytes(), at_);
  PartHeader header;
  Fragment fragment;
  std::vector<std::uint64_t> blocks;
  if (!reader.read(header) || !reader.read(fragment.words, header.words) ||
      !reader.read(fragment.array, header.array) || !reader.read(blocks, header.blocks) ||
      !reader.read(fragment.cells, header.cells) || !reader.read(fragment.values, header.values))
    return broken;
  fragment.blocks.reserve(blocks.size());
  for (const std::uint64_t block : blocks)
    fragment.blocks.push_back(unpack(block));
  if (!covers(fragment, layout_) || header.node[0] > construct::Node::Inner)
    return broken;
  fragment.cube = cubeOf(header);
  fragment.node = {static_cast<construct::Node::Kind>(header.node[0]), header.node[1]};
  std::copy_n(header.node.begin() + 2, construct::kMaskWords, fragment.node.masks);
  fragment.node.voxels = header.node.back();
  fragment.voxels = header.voxels;
  fragment.colour = header.colour;
  at_ = reader.at();
  voxels_ += fragment.voxels;
  --remaining_;
  return fragment;
}

} // namespace voxc
