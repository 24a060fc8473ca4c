// Skins and morph targets of glTF models, as they stand without animation.
#include "LoadTesting.h"

namespace voxc {
namespace {

constexpr int kBytes = 5121;
constexpr int kShorts = 5123;
constexpr int kFloats = 5126;

/// Writes a buffer and its accessors.
class Arrays {
public:
  template <typename Value>
  Arrays &add(int component, const std::string &type, std::size_t count, std::initializer_list<Value> values,
              const std::string &more = "") {
    const std::string bytes = bytesOf(values);
    const std::string comma = count_ == 0 ? "" : ",";
    views_ += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(buffer_.size()) + R"(,"byteLength":)" +
              std::to_string(bytes.size()) + "}";
    accessors_ += comma + R"({"bufferView":)" + std::to_string(count_++) + R"(,"componentType":)" +
                  std::to_string(component) + R"(,"count":)" + std::to_string(count) + R"(,"type":")" + type +
                  "\"" + more + "}";
    buffer_ += bytes;
    return *this;
  }

  std::string model(const std::string &rest) const {
    return R"({"asset":{"version":"2.0"},)" + rest + R"(,"accessors":[)" + accessors_ +
           R"(],"bufferViews":[)" + views_ + R"(],"buffers":[{"uri":"p.bin","byteLength":)" +
           std::to_string(buffer_.size()) + "}]}";
  }
  const std::string &buffer() const { return buffer_; }

private:
  std::string views_;
  std::string accessors_;
  std::string buffer_;
  int count_ = 0;
};

using PosedTriangle = std::array<ReadCorner, 3>;

class GltfPoses : public LoadTest {
protected:
  TriangleScene pose(const Arrays &arrays, const std::string &rest) {
    folder_.file("p.bin", arrays.buffer());
    return load("p.gltf", arrays.model(rest));
  }
  std::string wrong(const Arrays &arrays, const std::string &rest) {
    folder_.file("p.bin", arrays.buffer());
    return problem("p.gltf", arrays.model(rest));
  }
  std::vector<PosedTriangle> posed(const Arrays &arrays, const std::string &rest) {
    const TriangleScene scene = pose(arrays, rest);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    return trianglesOf(scene);
  }

  /// Accessor 0: the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0).
  static Arrays triangle() {
    return Arrays().add(kFloats, "VEC3", 3, {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f});
  }
  /// 1 moves the second corner by (2, 0, 0), 2 the third by (0, 0, 4): the latter is sparse.
  static Arrays morphs() {
    Arrays arrays = triangle();
    arrays.add(kFloats, "VEC3", 3, {0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 0.f, 0.f, 0.f});
    arrays.add(kFloats, "VEC3", 3, {0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f},
               R"(,"sparse":{"count":1,"indices":{"bufferView":3,"componentType":5123},)"
               R"("values":{"bufferView":4}})");
    arrays.add<std::uint16_t>(kShorts, "SCALAR", 1, {2});
    arrays.add(kFloats, "VEC3", 1, {0.f, 0.f, 4.f});
    return arrays;
  }
  /// Of each corner: all by joint 0, all by joint 1, half by each.
  static Arrays bound() {
    Arrays arrays = triangle();
    arrays.add<std::uint8_t>(kBytes, "VEC4", 3, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 9, 9});
    arrays.add(kFloats, "VEC4", 3, {1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, .5f, .5f, 0.f, 0.f});
    return arrays;
  }
};

const std::string kTargets =
    R"("primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1},{"POSITION":2}]}])";

TEST_F(GltfPoses, MorphTargetsByTheWeightsOfTheMesh) {
  const auto triangles =
      posed(morphs(), R"("nodes":[{"mesh":0}],"meshes":[{)" + kTargets + R"(,"weights":[0.5,1]}])");
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{0, 0, 0}, {2, 0, 0}, {0, 1, 4}}}}));
}

TEST_F(GltfPoses, WeightsOfANodeComeBeforeThoseOfItsMesh) {
  // One mesh in four poses: by the node, without any, by the mesh, and with fewer weights than targets.
  const auto triangles =
      posed(morphs(), R"("nodes":[{"mesh":0,"weights":[0,-1],"scale":[2,2,2]},{"mesh":0,"weights":[0,0]},)"
                      R"({"mesh":0},{"mesh":0,"weights":[2]}],"meshes":[{)" +
                          kTargets + R"(,"weights":[1,0]}])");
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{0, 0, 0}, {2, 0, 0}, {0, 2, -8}}},
                                                   {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                                   {{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}}},
                                                   {{{0, 0, 0}, {5, 0, 0}, {0, 1, 0}}}}));
}

TEST_F(GltfPoses, MeshesWithoutWeightsAreSharedAndStayInPlace) {
  const TriangleScene scene =
      pose(morphs(), R"("nodes":[{"mesh":0},{"mesh":0}],"meshes":[{)" + kTargets + "}]");
  EXPECT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].positions.type, AttributeView::Type::Float32);
}

TEST_F(GltfPoses, MorphsOfColoursAreToldOf) {
  const TriangleScene scene =
      pose(morphs(), R"("nodes":[{"mesh":0}],"meshes":[{"weights":[1],"primitives":[{"attributes":)"
                     R"({"POSITION":0},"targets":[{"COLOR_0":1}]}]}])");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], "morph targets of colours and texture coordinates are not applied");
}

const std::string kSkinned =
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}}]}])";

TEST_F(GltfPoses, JointsPlaceWhatIsBoundToThem) {
  // The node's own transform means nothing. Joint 0 is below a node that no scene has; it is moved by 10 and
  // joint 1 by 100, along x.
  const auto triangles =
      posed(bound(), R"("scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[)"
                     R"({"mesh":0,"skin":0,"translation":[7,7,7]},{"translation":[100,0,0]},)"
                     R"({"translation":[4,0,0],"children":[3]},{"translation":[6,0,0]}],)"
                     R"("skins":[{"joints":[3,1]}],)" +
                         kSkinned);
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{10, 0, 0}, {101, 0, 0}, {55, 1, 0}}}}));
}

TEST_F(GltfPoses, InverseBindMatricesComeFirst) {
  Arrays arrays = bound();
  // Halves, and moves by -8 along z.
  arrays.add(kFloats, "MAT4", 2,
             {.5f, 0.f, 0.f, 0.f, 0.f, .5f, 0.f, 0.f, 0.f, 0.f, .5f, 0.f, 0.f, 0.f, 0.f,  1.f,
              1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, -8.f, 1.f});
  const auto triangles = posed(arrays, R"("nodes":[{"mesh":0,"skin":0},{"scale":[4,4,4]}],)"
                                       R"("skins":[{"joints":[1,1],"inverseBindMatrices":3}],)" +
                                           kSkinned);
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{0, 0, 0}, {4, 0, -32}, {0, 3, -16}}}}));
}

TEST_F(GltfPoses, WeightsOfAnyKindAreShares) {
  Arrays arrays = triangle();
  arrays.add<std::uint16_t>(kShorts, "VEC4", 3, {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0});
  // A quarter and three quarters of 200 / 255; the last vertex is moved by nothing, so by the first it names.
  arrays.add<std::uint8_t>(kBytes, "VEC4", 3, {50, 150, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0},
                           R"(,"normalized":true)");
  const auto triangles = posed(
      arrays,
      R"("nodes":[{"mesh":0,"skin":0},{},{"translation":[0,0,8]}],"skins":[{"joints":[1,2]}],)" + kSkinned);
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{0, 0, 6}, {1, 0, 0}, {0, 1, 8}}}}));
}

TEST_F(GltfPoses, MoreThanFourJoints) {
  Arrays arrays = bound();
  arrays.add<std::uint8_t>(kBytes, "VEC4", 3, {2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0});
  arrays.add(kFloats, "VEC4", 3, {1.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f});
  const auto triangles = posed(
      arrays, R"("nodes":[{"mesh":0,"skin":0},{},{"translation":[0,0,8]}],"skins":[{"joints":[1,1,2]}],)"
              R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,)"
              R"("JOINTS_1":3,"WEIGHTS_1":4}}]}])");
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{0, 0, 4}, {1, 0, 0}, {0, 1, 0}}}}));
}

TEST_F(GltfPoses, AHatBesideABodyStaysWhereItIs) {
  // One primitive of the mesh is bound, the other not; and another node has the mesh without a skin.
  const auto triangles =
      posed(bound(), R"("nodes":[{"mesh":0,"skin":0,"translation":[0,5,0]},{"translation":[0,0,9]},)"
                     R"({"mesh":0}],"skins":[{"joints":[1,1]}],"meshes":[{"primitives":[{"attributes":)"
                     R"({"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}},{"attributes":{"POSITION":0}}]}])");
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}},
                                                   {{{0, 5, 0}, {1, 5, 0}, {0, 6, 0}}},
                                                   {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                                   {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}));
}

TEST_F(GltfPoses, MorphsComeBeforeSkins) {
  Arrays arrays = bound();
  arrays.add(kFloats, "VEC3", 3, {1.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f});
  const auto triangles = posed(
      arrays, R"("nodes":[{"mesh":0,"skin":0,"weights":[1]},{"scale":[3,3,3]}],"skins":[{"joints":[1,1]}],)"
              R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},)"
              R"("targets":[{"POSITION":3}]}]}])");
  EXPECT_EQ(triangles, (std::vector<PosedTriangle>{{{{3, 0, 0}, {3, 0, 0}, {0, 3, 0}}}}));
}

TEST_F(GltfPoses, AnimationsAreToldOf) {
  const TriangleScene scene =
      pose(triangle(), R"("nodes":[{"mesh":0}],"animations":[{}],)"
                       R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], "animations are not applied: the model is read as it stands without them");
}

TEST_F(GltfPoses, WhatIsWrongIsToldOf) {
  const auto expect = [&](const Arrays &arrays, const std::string &rest, const std::string &message) {
    EXPECT_NE(wrong(arrays, rest).find(message), std::string::npos) << wrong(arrays, rest);
  };
  const std::string node = R"("nodes":[{"mesh":0,"skin":0},{},{}],)";
  expect(bound(), node + R"("skins":[{"joints":[1]}],)" + kSkinned,
         "meshes[0].primitives[0] binds vertex 1 to a joint that its skin, which has 1, does not have");
  expect(bound(), node + R"("skins":[{"joints":[1,3]}],)" + kSkinned, "skins[0].joints[1] is 3");
  expect(bound(), node + R"("skins":[{"joints":[1,2],"inverseBindMatrices":0}],)" + kSkinned,
         "skins[0] has inverse bind matrices of 3 components");
  Arrays few = bound();
  few.add(kFloats, "MAT4", 1,
          {1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f});
  expect(few, node + R"("skins":[{"joints":[1,2],"inverseBindMatrices":3}],)" + kSkinned,
         "skins[0] has 2 joints, but 1 inverse bind matrices");
  expect(bound(),
         R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"skin":0},{"children":[2]},)"
         R"({"children":[1]}],"skins":[{"joints":[1,2]}],)" +
             kSkinned,
         "is below itself, but nodes make a tree");
  expect(bound(), R"("nodes":[{"mesh":0,"weights":[true]}],)" + kSkinned,
         "nodes[0].weights[0] is not a number");
}

TEST_F(GltfPoses, AFileAsksForNoMoreWorkThanItIsWorth) {
  // Each of many nodes has a skin of many joints.
  std::string joints;
  std::string nodes = R"("nodes":[{})";
  for (int i = 0; i < 20000; ++i) {
    joints += i == 0 ? "0" : ",0";
    nodes += i % 2 == 0 ? R"(,{"mesh":0,"skin":0})" : R"(,{"mesh":0,"skin":1})";
  }
  const std::string skin = R"({"joints":[)" + joints + "]}";
  // Or a mesh of many primitives that are nothing.
  std::string empty = R"({"attributes":{}})";
  for (int i = 0; i < 2000; ++i)
    empty += R"(,{"attributes":{}})";
  EXPECT_NE(wrong(bound(), nodes + R"(],"skins":[{"joints":[0]},{"joints":[0]}],"meshes":[{"primitives":[)" +
                               empty + "]}]")
                .find("too many for files"),
            std::string::npos);
  EXPECT_NE(wrong(bound(), nodes + R"(],"skins":[)" + skin + "," + skin + "]," + kSkinned)
                .find("too many for files"),
            std::string::npos);
}

} // namespace
} // namespace voxc
