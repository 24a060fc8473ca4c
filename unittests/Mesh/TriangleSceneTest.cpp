// Numbers of views of every type, and the corners of every primitive mode.
#include "voxc/Mesh/TriangleScene.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

using Type = AttributeView::Type;

template <typename Stored>
AttributeView viewOf(const std::vector<Stored> &values, Type type, bool normalized) {
  return {
      reinterpret_cast<const std::byte *>(values.data()), values.size(), sizeof(Stored), type, 1, normalized};
}

template <typename Stored> double numberOf(Stored value, Type type, bool normalized) {
  return readRow<2>(viewOf(std::vector<Stored>{Stored{1}, value}, type, normalized), 1)[0];
}

TEST(TriangleScene, ReadsEveryType) {
  for (const bool normalized : {false, true}) {
    EXPECT_EQ(numberOf<float>(-1.5f, Type::Float32, normalized), -1.5);
    EXPECT_EQ(numberOf<double>(1e300, Type::Float64, normalized), 1e300);
  }
  EXPECT_EQ(numberOf<std::int8_t>(-128, Type::Int8, false), -128);
  EXPECT_EQ(numberOf<std::uint8_t>(200, Type::Uint8, false), 200);
  EXPECT_EQ(numberOf<std::int16_t>(-3, Type::Int16, false), -3);
  EXPECT_EQ(numberOf<std::uint16_t>(65535, Type::Uint16, false), 65535);
  EXPECT_EQ(numberOf<std::int32_t>(-3, Type::Int32, false), -3);
  EXPECT_EQ(numberOf<std::uint32_t>(0xffffffff, Type::Uint32, false), 4294967295.0);
}

TEST(TriangleScene, NormalizedIntegersAreFractions) {
  EXPECT_EQ(numberOf<std::uint8_t>(51, Type::Uint8, true), 0.2);
  EXPECT_EQ(numberOf<std::uint16_t>(65535, Type::Uint16, true), 1);
  EXPECT_EQ(numberOf<std::int8_t>(-127, Type::Int8, true), -1);
  EXPECT_EQ(numberOf<std::int8_t>(-128, Type::Int8, true), -1);
  EXPECT_EQ(numberOf<std::int16_t>(32767, Type::Int16, true), 1);
}

TEST(TriangleScene, RowsHaveTheirStrideAndComponents) {
  const std::vector<float> values{1, 2, 3, 4, 5, 6};
  AttributeView view{reinterpret_cast<const std::byte *>(values.data()), 2, 12, Type::Float32, 2, false};
  EXPECT_EQ(readRow<4>(view, 1), (std::array<double, 4>{4, 5, 0, 0}));
  view.stride = 0;
  EXPECT_EQ(readRow<2>(view, 1), (std::array<double, 2>{1, 2}));
  EXPECT_FALSE(AttributeView{});
  EXPECT_TRUE(view);
}

using Triple = std::array<std::uint32_t, 3>;

std::vector<Triple> primitives(const MeshPart &part) {
  std::vector<Triple> all;
  for (std::uint64_t i = 0; i < part.triangles(); ++i)
    all.push_back(part.corners(i));
  return all;
}

TEST(TriangleScene, EveryModeHasItsPrimitives) {
  MeshPart part;
  part.positions.count = 5;
  const auto of = [&](PrimitiveMode mode) {
    part.mode = mode;
    return primitives(part);
  };
  EXPECT_EQ(of(PrimitiveMode::Points).back(), (Triple{4, 4, 4}));
  EXPECT_EQ(of(PrimitiveMode::Points).size(), 5u);
  EXPECT_EQ(of(PrimitiveMode::Lines), (std::vector<Triple>{{0, 1, 1}, {2, 3, 3}}));
  EXPECT_EQ(of(PrimitiveMode::LineLoop),
            (std::vector<Triple>{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 4, 4}, {4, 0, 0}}));
  EXPECT_EQ(of(PrimitiveMode::LineStrip), (std::vector<Triple>{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 4, 4}}));
  EXPECT_EQ(of(PrimitiveMode::Triangles), (std::vector<Triple>{{0, 1, 2}}));
  EXPECT_EQ(of(PrimitiveMode::TriangleStrip), (std::vector<Triple>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
  EXPECT_EQ(of(PrimitiveMode::TriangleFan), (std::vector<Triple>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(TriangleScene, TooFewVerticesMakeNoPrimitive) {
  MeshPart part;
  for (int mode = 0; mode < 7; ++mode) {
    part.mode = static_cast<PrimitiveMode>(mode);
    part.positions.count = mode == 0 ? 0 : mode < 4 ? 1 : 2;
    EXPECT_EQ(part.triangles(), 0u) << mode;
  }
}

TEST(TriangleScene, IndicesAreFollowed) {
  const std::vector<std::uint16_t> indices{7, 9, 8, 300};
  MeshPart part;
  part.positions.count = 301;
  part.indices = viewOf(indices, Type::Uint16, false);
  part.mode = PrimitiveMode::TriangleStrip;
  EXPECT_EQ(primitives(part), (std::vector<Triple>{{7, 9, 8}, {9, 300, 8}}));
}

} // namespace
} // namespace voxc
