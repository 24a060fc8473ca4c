// Volumes with streams of a voxel each.
#include "voxc/Volume/Attributes.h"

#include "Decode.h"
#include "StreamTable.h"

#include "voxc/Volume/CoarseBlocks.h"
#include "voxc/Volume/Frames.h"

namespace voxc {
namespace {

/// What the streams of a volume lie in that shares another's.
struct Kept {
  std::shared_ptr<const Volume> volume;
  std::vector<std::byte> elements;
};

/// Streams that say what the voxels are, not what is known of each.
bool isReserved(std::string_view name) { return name == kWordStream || name == kFrameStream; }

std::vector<Stream> streamsWithout(const Volume &volume, std::string_view name) {
  std::vector<Stream> streams(volume.streams().begin(), volume.streams().end());
  std::erase_if(streams, [&](const Stream &stream) { return stream.name == name; });
  return streams;
}

/// What a file could not hold.
std::string describeProblem(const Volume &volume, const Attribute &attribute) {
  if (isReserved(attribute.name))
    return "an attribute cannot be called '" + attribute.name + "', as the " + attribute.name +
           " of the volume are";
  if (coarseSideOf(attribute.name))
    return "an attribute cannot be called '" + attribute.name + "', as coarse blocks of a volume are";
  if (!isStreamName(attribute.name))
    return "'" + attribute.name +
           "' is no name of an attribute; it has 1 to 31 of a to z, 0 to 9 and '-', the first a letter";
  if (attribute.elementBytes == 0 || attribute.elementBytes > kMostElementBytes)
    return "an element of an attribute has 1 to 256 bytes, not " + std::to_string(attribute.elementBytes);
  const std::uint64_t voxels = volume.info().voxels;
  if (attribute.elements.size() % attribute.elementBytes != 0 ||
      attribute.elements.size() / attribute.elementBytes != voxels)
    return "attribute '" + attribute.name + "' has " + std::to_string(attribute.elements.size()) +
           " bytes, but the volume has " + std::to_string(voxels) + " voxels of " +
           std::to_string(attribute.elementBytes) + " each";
  return {};
}

} // namespace

Expected<std::vector<std::byte>> zeroElements(const Volume &volume, std::uint32_t elementBytes,
                                              std::uint64_t mostBytes) {
  const std::uint64_t voxels = volume.info().voxels;
  if (voxels > mostBytes / elementBytes)
    return Error::input("an attribute of " + std::to_string(elementBytes) + " bytes for each of the " +
                        std::to_string(voxels) + " voxels would take more than the " +
                        std::to_string(mostBytes) + " bytes that it may; a larger --memory would do");
  return std::vector<std::byte>(voxels * elementBytes);
}

Expected<void> visitVoxels(const Volume &volume, const VoxelVisit &visit, const Progress &progress) {
  const auto visitCube = [&](const Cube &cube, std::uint32_t, std::uint64_t number) {
    for (std::uint64_t i = 0; i < std::uint64_t{1} << (3 * cube.log2Side); ++i)
      if (!visit(cube.low + mortonCell(i), number + i))
        return false;
    return true;
  };
  return decodeNumbered(volume, visitCube, progress);
}

Expected<Volume> withAttribute(std::shared_ptr<const Volume> volume, Attribute attribute) {
  if (std::string problem = describeProblem(*volume, attribute); !problem.empty())
    return Error::usage(std::move(problem));
  std::vector<Stream> streams = streamsWithout(*volume, attribute.name);
  if (streams.size() == kMostStreams)
    return Error::usage("the volume has 63 attributes, and none can have more; drop one first");
  VolumeInfo info = volume->info();
  const auto kept = std::make_shared<const Kept>(Kept{std::move(volume), std::move(attribute.elements)});
  streams.push_back({std::move(attribute.name), attribute.elementBytes, kept->elements});
  return Volume(std::move(info), std::move(streams), kept);
}

Expected<Volume> withoutAttribute(std::shared_ptr<const Volume> volume, std::string_view name) {
  std::vector<Stream> streams = streamsWithout(*volume, name);
  if (isReserved(name) || streams.size() == volume->streams().size())
    return Error::usage("the volume has no attribute '" + std::string(name) +
                        "'; voxc info lists its streams");
  VolumeInfo info = volume->info();
  return Volume(std::move(info), std::move(streams), std::move(volume));
}

const Stream *findAttribute(const Volume &volume, std::string_view name) {
  const Stream *const stream = volume.findStream(name);
  const bool isOne = stream && !isReserved(name) && stream->bytes.size() % stream->elementBytes == 0 &&
                     stream->elements() == volume.info().voxels;
  return isOne ? stream : nullptr;
}

} // namespace voxc
