// Buffers: the binary chunk, mapped files, and data in the JSON itself.
#include "Mesh/Gltf/GltfBuffers.h"

#include "Mesh/Gltf/DataUri.h"
#include "Mesh/Gltf/GltfMeshopt.h"
#include "Support/WatchedFile.h"

namespace voxc {

namespace {

constexpr std::uint64_t kMostStride = 252; // By the specification.

/// Compressed views may show the same bytes again and again, and each is decoded.
constexpr std::uint64_t kMostDecodedAByte = 1024;

} // namespace

GltfBuffers::GltfBuffers(GltfContext &context)
    : context_(context), list_(context.root.list("buffers")), views_(context.root.list("bufferViews")),
      buffers_(list_.size()), bytesOfFiles_(context.fileBytes) {}

GltfBuffers::View GltfBuffers::view(std::size_t index) {
  const GltfObject json = views_[index];
  const GltfObject meshopt = meshoptOf(json);
  if (!meshopt)
    return stored(json);
  const std::uint64_t stride = json.count("byteStride").value_or(0);
  const std::uint64_t length = json.count("byteLength").value_or(0);
  const std::span<const std::byte> bytes = decoded(index, meshopt);
  if (stride > kMostStride || length > bytes.size()) {
    json.problem("has a byteStride or a byteLength that is not that of its compressed data");
    return {};
  }
  return {bytes.first(length), static_cast<std::uint32_t>(stride)};
}

std::span<const std::byte> GltfBuffers::decoded(std::size_t index, const GltfObject &meshopt) {
  const auto [entry, isNew] = decoded_.try_emplace(index);
  if (!isNew)
    return entry->second;
  const std::span<const std::byte> compressed = stored(meshopt).bytes;
  bytesDecoded_ += meshoptBytes(meshopt, compressed.size());
  if (bytesDecoded_ / kMostDecodedAByte > context_.fileBytes + bytesOfFiles_) {
    meshopt.problem("and those before it claim " + std::to_string(bytesDecoded_) +
                    " bytes, but the files have only " + std::to_string(bytesOfFiles_));
    return {};
  }
  if (context_.problem)
    return {};
  const auto kept = decodeMeshopt(meshopt, compressed, context_.memory, context_.problem);
  if (!kept)
    return {};
  context_.scene.storage.push_back(kept);
  bytesOfFiles_ += kept->size();
  return entry->second = kept->span();
}

GltfBuffers::View GltfBuffers::stored(const GltfObject &json) {
  const auto bufferIndex = json.index("buffer", list_);
  if (!bufferIndex) {
    json.problem("has no buffer");
    return {};
  }
  const std::span<const std::byte> bytes = buffer(*bufferIndex);
  const std::uint64_t offset = json.count("byteOffset").value_or(0);
  const std::uint64_t length = json.count("byteLength").value_or(0);
  const std::uint64_t stride = json.count("byteStride").value_or(0);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    json.problem("reaches over the end of its buffer, which has " + std::to_string(bytes.size()) + " bytes");
    return {};
  }
  if (stride > kMostStride && !json.has("mode")) { // What is decoded may have 256.
    json.problem("has a byteStride of " + std::to_string(stride) + ", more than 252");
    return {};
  }
  return {bytes.subspan(offset, length), static_cast<std::uint32_t>(stride)};
}

std::span<const std::byte> GltfBuffers::buffer(std::size_t index) {
  Buffer &buffer = buffers_[index];
  if (!buffer.isRead) {
    buffer.bytes = readBuffer(list_[index], index == 0);
    buffer.isRead = true;
  }
  return buffer.bytes;
}

std::span<const std::byte> GltfBuffers::readBuffer(const GltfObject &json, bool isFirst) {
  const std::uint64_t length = json.count("byteLength").value_or(0);
  std::span<const std::byte> bytes;
  if (const std::string_view uri = json.text("uri"); !uri.empty())
    bytes = isDataUri(uri) ? readData(uri, json) : readFile(uri, json);
  else if (isFirst && context_.binary)
    bytes = *context_.binary;
  else
    json.problem("has no uri, and there is no binary chunk for it");
  if (bytes.size() < length) {
    json.problem("claims to have " + std::to_string(length) + " bytes, but has " +
                 std::to_string(bytes.size()));
    return {};
  }
  return bytes.first(length);
}

std::span<const std::byte> GltfBuffers::readData(std::string_view uri, const GltfObject &json) {
  auto bytes = decodeDataUri(uri, context_.memory);
  if (!bytes) {
    context_.problem.set(Error{bytes.error().kind, json.name() + ": " + bytes.error().message});
    return {};
  }
  const auto kept = std::make_shared<const ScratchArray<std::byte>>(std::move(*bytes));
  context_.scene.storage.push_back(kept);
  return kept->span();
}

std::span<const std::byte> GltfBuffers::readFile(std::string_view uri, const GltfObject &json) {
  const std::string &path = context_.uris.path(uri);
  const auto [entry, isNew] = files_.try_emplace(path);
  if (!isNew)
    return entry->second;
  auto file = WatchedFile::open(path, context_.memory);
  if (!file) {
    context_.problem.set(Error{file.error().kind, json.name() + ": " + file.error().message});
    return {};
  }
  context_.scene.storage.push_back(*file);
  context_.scene.files.push_back(path);
  bytesOfFiles_ += (*file)->bytes().size();
  return entry->second = (*file)->bytes();
}

} // namespace voxc
