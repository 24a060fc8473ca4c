// Buffers of a glTF model, in place, and views of them.
#pragma once

#include "Mesh/Gltf/GltfContext.h"

#include <map>
#include <vector>

namespace voxc {

class GltfBuffers {
public:
  explicit GltfBuffers(GltfContext &context);

  /// Part of a buffer, and the distance of its rows, 0 if it does not say.
  struct View {
    std::span<const std::byte> bytes;
    std::uint32_t stride = 0;
  };

  /// A buffer view, decoded if it is compressed. Empty, with a problem, if it lies outside its buffer or the
  /// buffer cannot be read.
  View view(std::size_t index);

  const GltfList &views() const { return views_; }

  /// Bytes of the model's file and of all buffers that have been asked for, and those of compressed views
  /// when they are decoded.
  std::uint64_t bytesOfFiles() const { return bytesOfFiles_; }

private:
  struct Buffer {
    bool isRead = false;
    std::span<const std::byte> bytes;
  };

  View stored(const GltfObject &json);
  std::span<const std::byte> decoded(std::size_t index, const GltfObject &meshopt);
  std::span<const std::byte> buffer(std::size_t index);
  std::span<const std::byte> readBuffer(const GltfObject &json, bool isFirst);
  std::span<const std::byte> readData(std::string_view uri, const GltfObject &json);
  std::span<const std::byte> readFile(std::string_view uri, const GltfObject &json);

  GltfContext &context_;
  GltfList list_;
  GltfList views_;
  std::vector<Buffer> buffers_;
  std::map<std::string, std::span<const std::byte>> files_;   ///< By path.
  std::map<std::size_t, std::span<const std::byte>> decoded_; ///< Compressed views, by index.
  std::uint64_t bytesOfFiles_;
  std::uint64_t bytesDecoded_ = 0;
};

} // namespace voxc
