// Models of points alone: each point is one voxel of its colour.
#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"

namespace voxc {
namespace {

class ModelPoints : public testing::Test {
protected:
  Voxels voxels(const std::string &content, int resolution) {
    options_.resolution = resolution;
    auto input = openInput(folder_.file("points.obj", content), options_);
    EXPECT_TRUE(input) << input.error().message;
    provenance_ = input ? input->provenance : "";
    return input ? voxelsOf(*input->source) : Voxels{};
  }

  TemporaryFolder folder_;
  InputOptions options_;
  std::string provenance_;
};

TEST_F(ModelPoints, ObjWithoutFaces) {
  // The second lies on the face between two voxels: it is one of them.
  EXPECT_EQ(voxels("v 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 4 0 0 0 0 1\n", 4),
            (Voxels{{mortonCode({0, 0, 0}), rgba(255, 0, 0)},
                    {mortonCode({2, 0, 0}), rgba(0, 255, 0)},
                    {mortonCode({3, 0, 0}), rgba(0, 0, 255)}}));
}

TEST_F(ModelPoints, TheGridIsKeptInTheProvenance) {
  options_.voxelSize = {0.5, 0};
  options_.align = {0.25, 0, 0};
  voxels("v 0 0 0\nv 2 0 0\n", 0);
  EXPECT_NE(provenance_.find("voxel-size=0.5 align=0.25,0,0"), std::string::npos) << provenance_;
}

TEST_F(ModelPoints, ObjWithElementsP) {
  folder_.file("m.mtl", "newmtl a\nKd 0 1 0\n");
  EXPECT_EQ(voxels("mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 4 0 0\nusemtl a\np 1 3\n", 4),
            (Voxels{{mortonCode({0, 0, 0}), rgba(0, 255, 0)}, {mortonCode({3, 0, 0}), rgba(0, 255, 0)}}));
}

TEST_F(ModelPoints, PointsBesideFacesAreTouchedCells) {
  EXPECT_GT(voxels("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 2\nf 1 2 3\np 4\n", 4).size(), 10u);
}

TEST_F(ModelPoints, ManyInOneVoxelAreTheFirst) {
  EXPECT_EQ(voxels("v 0 0 0 255 0 0\nv 0.1 0 0 0 255 0\nv 4 4 4 0 0 255\n", 4),
            (Voxels{{mortonCode({0, 0, 0}), rgba(255, 0, 0)}, {mortonCode({3, 3, 3}), rgba(0, 0, 255)}}));
}

} // namespace
} // namespace voxc
