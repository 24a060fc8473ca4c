// The textures of a model, each image decoded once.
#pragma once

#include "Image/ImageDecoder.h"
#include "Support/Warnings.h"
#include "voxc/Mesh/TriangleScene.h"

#include <functional>
#include <map>
#include <string>

namespace voxc {

/// Fills the textures of a scene. An image that is missing or broken becomes a warning and no texture.
class TextureSet {
public:
  TextureSet(std::shared_ptr<WorkingMemory> memory, TriangleScene &scene, Warnings &warnings,
             ImageNumbers numbers = ImageNumbers::AsSaid)
      : memory_(std::move(memory)), decoder_(memory_, numbers), scene_(scene), warnings_(warnings) {}

  /// Index of the texture of an image file, or -1. Errors: no memory.
  Expected<int> readFile(const std::string &path);

  /// The same for an image whose bytes `use` hands to the function that it is given; `key` tells images
  /// apart.
  using Decode = std::function<Expected<Texture>(std::span<const std::byte>)>;
  using Use = std::function<Expected<Texture>(const Decode &decode)>;
  Expected<int> read(const std::string &key, const std::string &name, const Use &use);

  std::uint64_t libraryPeakBytes() const { return decoder_.libraryPeakBytes(); }

private:
  Expected<Texture> decode(std::span<const std::byte> bytes);

  std::shared_ptr<WorkingMemory> memory_;
  ImageDecoder decoder_;
  TriangleScene &scene_;
  Warnings &warnings_;
  std::map<std::string, int> indices_;
};

} // namespace voxc
