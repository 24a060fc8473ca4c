// Arrays that a reader has filled, as attributes of a scene.
#pragma once

#include "voxc/Mesh/TriangleScene.h"

#include <memory>
#include <utility>

namespace voxc {

/// What the numbers of an array's rows are.
struct RowKind {
  AttributeView::Type type = AttributeView::Type::Float32;
  std::uint8_t components = 1;
  bool normalized = false;
};

inline constexpr RowKind kFloatRows3{AttributeView::Type::Float32, 3};
inline constexpr RowKind kDoubleRows3{AttributeView::Type::Float64, 3};
inline constexpr RowKind kFloatRows2{AttributeView::Type::Float32, 2};
inline constexpr RowKind kIndexRows{AttributeView::Type::Uint32, 1};
inline constexpr RowKind kColourRows{AttributeView::Type::Uint8, 4, true};

/// Gives the array to the scene. The view of it has one row an element; that of an empty array is absent.
template <typename Row> AttributeView keep(ScratchArray<Row> &&array, RowKind kind, TriangleScene &scene) {
  const auto kept = std::make_shared<const ScratchArray<Row>>(std::move(array));
  scene.storage.push_back(kept);
  return {reinterpret_cast<const std::byte *>(kept->data()),
          kept->size(),
          sizeof(Row),
          kind.type,
          kind.components,
          kind.normalized};
}

} // namespace voxc
