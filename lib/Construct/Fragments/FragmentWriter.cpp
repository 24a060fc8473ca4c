// Writing the files of fragments.
#include "FragmentFile.h"
#include "FragmentLayout.h"

#include <array>
#include <string>

namespace voxc {

using namespace hvf;

namespace {

Header headerOf(const FragmentInfo &info) {
  const VolumeInfo &volume = info.volume;
  Header header;
  header.index = info.share.index;
  header.count = info.share.count;
  header.begin = info.share.begin;
  header.end = info.share.end;
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
  const bool isRegular = VOXC_TRY(OutputFile::isRegularAt(path));
  if (!isRegular)
    return Error::input("'" + path + "' is no file; a fragment needs one");
  auto file = VOXC_TRY(OutputFile::create(path));
  FragmentWriter writer(std::move(file), info);
  const Header header = headerOf(info);
  const std::string texts = printIr(info.volume.format) + info.volume.provenance;
  VOXC_TRY(writer.file_.write(&header, sizeof header));
  writer.bytes_ = sizeof header;
  VOXC_TRY(writer.write(texts.data(), texts.size()));
  return writer;
}

Expected<void> FragmentWriter::write(const void *data, std::size_t size) {
  sum_->add(data, size);
  bytes_ += size;
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
  const std::array<std::span<const std::byte>, 6> pieces = {
      std::as_bytes(std::span(&header, 1)),     std::as_bytes(std::span(fragment.words)),
      std::as_bytes(std::span(fragment.array)), std::as_bytes(std::span(blocks)),
      std::as_bytes(std::span(fragment.cells)), std::as_bytes(std::span(fragment.values))};
  for (const auto &piece : pieces)
    VOXC_TRY(write(piece.data(), piece.size()));
  ++parts_;
  voxels_ += fragment.voxels;
  return {};
}

Expected<void> FragmentWriter::finish(std::uint64_t looked) {
  Header header = headerOf(info_);
  if (looked != header.end - header.begin)
    return Error::environment("a fragment is not written: of its " +
                              std::to_string(header.end - header.begin) + " cubes " + std::to_string(looked) +
                              " were looked at");
  const Trailer trailer = {.bytes = bytes_ + sizeof(Trailer)};
  VOXC_TRY(write(&trailer, sizeof trailer));
  header.parts = parts_;
  header.looked = looked;
  header.voxels = voxels_;
  sum_->add(&header, sizeof header);
  header.checksum = sum_->digest();
  VOXC_TRY(file_.rewrite(0, &header, sizeof header));
  return file_.commit();
}

} // namespace voxc
