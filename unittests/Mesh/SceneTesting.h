// Scenes written by hand.
#pragma once

#include "voxc/Mesh/MeshSource.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace voxc::test {

/// What a part is made of; `uvs` and `colours` may stay empty.
struct HandPart {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::uint32_t> indices; ///< Empty: the positions in their order.
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::array<float, 4>> colours;
  std::uint32_t material = 0;
};

template <typename Row>
AttributeView viewOf(const std::vector<Row> &rows, AttributeView::Type type, std::uint8_t components) {
  if (rows.empty())
    return {};
  return {reinterpret_cast<const std::byte *>(rows.data()), rows.size(), sizeof(Row), type, components};
}

inline MeshPart partOf(const HandPart &hand) {
  using Type = AttributeView::Type;
  MeshPart part;
  part.positions = viewOf(hand.positions, Type::Float32, 3);
  part.indices = viewOf(hand.indices, Type::Uint32, 1);
  part.uvs = viewOf(hand.uvs, Type::Float32, 2);
  part.colours = viewOf(hand.colours, Type::Float32, 4);
  part.material = hand.material;
  return part;
}

/// A scene of these parts, each once where it is; without materials it gets a white one.
inline std::shared_ptr<TriangleScene> sceneOf(std::vector<HandPart> hands,
                                              std::vector<Material> materials = {}) {
  auto scene = std::make_shared<TriangleScene>();
  auto kept = std::make_shared<std::vector<HandPart>>(std::move(hands));
  for (const HandPart &hand : *kept) {
    scene->instances.push_back({static_cast<std::uint32_t>(scene->parts.size()), {}});
    scene->parts.push_back(partOf(hand));
  }
  scene->storage.push_back(kept);
  scene->materials = std::move(materials);
  if (scene->materials.empty())
    scene->materials.emplace_back();
  return scene;
}

/// A scene of separate white triangles.
inline std::shared_ptr<TriangleScene> soupOf(std::vector<std::array<float, 3>> corners) {
  return sceneOf({{std::move(corners)}});
}

inline Texture textureOf(int width, int height, const std::vector<std::uint32_t> &texels) {
  auto kept = std::make_shared<ScratchArray<std::uint32_t>>(WorkingMemory::create(1 << 20));
  EXPECT_TRUE(kept->append(texels));
  return {width, height, std::move(kept)};
}

} // namespace voxc::test
