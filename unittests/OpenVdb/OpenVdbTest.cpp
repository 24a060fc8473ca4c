// OpenVDB files: level sets and fog, where the component was built; a clear message where it was not.
#include "Mesh/SharedModels.h"
#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"

#include <gmock/gmock.h>

#ifdef VOXC_HAS_OPENVDB
#include "voxc/OpenVdb/OpenVdb.h"
#endif

namespace voxc {
namespace {

using ::testing::HasSubstr;

TEST(OpenVdb, ABuildWithoutItSaysSo) {
  const TemporaryFolder folder;
  const auto input = openInput(folder.file("a.vdb", ""), {});
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().kind, ErrorKind::Environment);
  EXPECT_THAT(input.error().message, HasSubstr("VOXC_OPENVDB=ON"));
}

TEST(OpenVdb, ABuildWithoutItWritesNone) {
  const TemporaryFolder folder;
  VolumeInfo info;
  info.format = *parseFormat("R(1, 1, 1)");
  info.extent = {2, 2, 2};
  const auto written = exportVoxels(Volume(info, {0}), folder.path("v.vdb"));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::Environment);
  EXPECT_THAT(written.error().message, HasSubstr("VOXC_OPENVDB=ON"));
  EXPECT_EQ(folder.count(), 0);
}

#ifdef VOXC_HAS_OPENVDB

InputOptions withOpenVdb() {
  InputOptions options;
  options.otherKinds = {openVdbKind()};
  return options;
}

TEST(OpenVdb, FogIsTheVolumeThatItWasMadeFrom) {
  VOXC_SKIP_WITHOUT("volumes/fuel_fog.vdb");
  const auto fog = openInput(sharedModel("volumes/fuel_fog.vdb"), withOpenVdb());
  ASSERT_TRUE(fog) << fog.error().message;
  EXPECT_EQ(fog->source->extent(), (Int3{63, 32, 32}));
  const Voxels voxels = voxelsOf(*fog->source);
  EXPECT_EQ(voxels.size(), 13731u);
  EXPECT_EQ(voxelsOf(*fog->source->view()), voxels);
  // The box of the samples that are not 0 is smaller than the grid that has them.
  const auto grid = openInput("raw:64x33x32:uint8:" + sharedModel("volumes/fuel_64x33x32_uint8.raw"), {});
  ASSERT_TRUE(grid);
  const Voxels dense = voxelsOf(*grid->source);
  ASSERT_EQ(dense.size(), voxels.size());
  const auto lowest = [](const Voxels &of) {
    Int3 low{1 << 21, 1 << 21, 1 << 21};
    for (const auto &[code, word] : of)
      for (int axis = 0; axis < 3; ++axis)
        low[axis] = std::min(low[axis], mortonCell(code)[axis]);
    return low;
  };
  const Int3 shift = lowest(dense) - lowest(voxels);
  for (const auto &[code, word] : voxels)
    ASSERT_TRUE(dense.contains(mortonCode(mortonCell(code) + shift)));
}

TEST(OpenVdb, LevelSetsAreFilled) {
  VOXC_SKIP_WITHOUT("volumes/bunny_levelset.vdb");
  InputOptions options = withOpenVdb();
  const std::string path = sharedModel("volumes/bunny_levelset.vdb");
  const auto inside = openInput(path, options);
  ASSERT_TRUE(inside) << inside.error().message;
  EXPECT_EQ(inside->source->extent(), (Int3{214, 212, 167}));
  const Voxels filled = voxelsOf(*inside->source);
  options.threshold = -1e9;
  const auto none = openInput(path, options);
  ASSERT_TRUE(none);
  EXPECT_TRUE(voxelsOf(*none->source).empty());
  // `empty` hides nothing.
  std::size_t count = 0;
  for (std::uint64_t brick = 0; brick < 32 * 32 * 32; ++brick) {
    std::array<std::uint32_t, 512> words;
    ASSERT_TRUE(inside->source->read({mortonCell(brick) * 8, 3}, words.data()));
    count += 512 - static_cast<std::size_t>(std::count(words.begin(), words.end(), 0u));
  }
  EXPECT_EQ(filled.size(), count);
  EXPECT_EQ(count, 102602u);
  options = withOpenVdb();
  options.zUp = true;
  const auto turned = openInput(path, options);
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->source->extent(), (Int3{214, 167, 212}));
  EXPECT_EQ(voxelsOf(*turned->source).size(), count);
}

TEST(OpenVdb, WhatIsWrittenComesBackAsFog) {
  const TemporaryFolder folder;
  Voxels voxels;
  for (int i = 0; i < 13; ++i)
    voxels[mortonCode({i, i % 8, i % 5})] = rgba(static_cast<std::uint32_t>(i), 255, 0);
  const std::string path = folder.path("v.vdb");
  ExportOptions options;
  EXPECT_FALSE(
      exportVoxels(denseVolume(voxels, {13, 8, 5}, transformOfRows({0, 0, 2, 5, 0, 2, 0, 6, -2, 0, 0, 7})),
                   path, options));
  options.otherKinds = {openVdbExport()};
  const auto written = exportVoxels(
      denseVolume(voxels, {13, 8, 5}, transformOfRows({0, 0, 2, 5, 0, 2, 0, 6, -2, 0, 0, 7})), path, options);
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_EQ(folder.count(), 1);
  const auto fog = openInput(path, withOpenVdb());
  ASSERT_TRUE(fog) << fog.error().message;
  EXPECT_EQ(fog->source->extent(), (Int3{13, 8, 5}));
  Voxels places;
  for (const auto &[code, word] : voxelsOf(*fog->source))
    places[code] = voxels.contains(code) ? voxels[code] : 0;
  EXPECT_EQ(places, voxels);
  EXPECT_EQ(rowsOf(fog->source->voxelToModel()),
            (std::array<double, 12>{0, 0, 2, 5, 0, 2, 0, 6, -2, 0, 0, 7}));
}

TEST(OpenVdb, GridsAreTakenByName) {
  const TemporaryFolder folder;
  const std::string path = folder.path("v.vdb");
  ExportOptions exported;
  exported.otherKinds = {openVdbExport()};
  ASSERT_TRUE(exportVoxels(denseVolume({{mortonCode({1, 2, 0}), rgba(9, 8, 7)}}, {2, 3, 1}, Transform()),
                           path, exported));
  // It has a grid of density, and one of colours, which is no shape.
  InputOptions options = withOpenVdb();
  const auto first = openInput(path, options);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_THAT(first->warnings,
              ::testing::ElementsAre("the grid 'density' is taken, and left out are Cd (vec3s) (--grid NAME "
                                     "takes one of them)"));
  options.grid = "density";
  const auto named = openInput(path, options);
  ASSERT_TRUE(named) << named.error().message;
  EXPECT_THAT(named->warnings, ::testing::IsEmpty());
  EXPECT_THAT(named->provenance, HasSubstr(" grid=density"));
  EXPECT_EQ(voxelsOf(*named->source), voxelsOf(*first->source));
  for (const char *other : {"Cd", "heat"}) {
    options.grid = other;
    const auto refused = openInput(path, options);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("it has no grid of 32-bit floats of the name '" +
                                                   std::string(other) + "'; there are "));
    EXPECT_THAT(refused.error().message, HasSubstr("Cd (vec3s)"));
    EXPECT_THAT(refused.error().message, HasSubstr("density (float)"));
  }
}

TEST(OpenVdb, BrokenFilesAreErrors) {
  const TemporaryFolder folder;
  for (const std::string &content : {std::string(), std::string("nonsense"), std::string(5000, 'x')}) {
    const auto input = openInput(folder.file("a.vdb", content), withOpenVdb());
    ASSERT_FALSE(input);
    EXPECT_THAT(input.error().message, HasSubstr("is not a usable OpenVDB file"));
  }
  EXPECT_FALSE(openInput(folder.path("none.vdb"), withOpenVdb()));
  VOXC_SKIP_WITHOUT("volumes/fuel_fog.vdb");
  InputOptions small = withOpenVdb();
  small.formatExtent = {16, 16, 16};
  EXPECT_THAT(openInput(sharedModel("volumes/fuel_fog.vdb"), small).error().message,
              HasSubstr("its grid takes 63x32x32 voxels, but the format holds 16x16x16"));
}

#endif

} // namespace
} // namespace voxc
