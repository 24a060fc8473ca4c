// NIfTI files: both versions, scaled samples, thresholds that are found, and where samples lie.
#include "Input/DenseTesting.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numeric>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Nifti = DenseVolumes;

/// A NIfTI header of version 1 or 2, of 3 x 2 x 1 bytes.
std::string nifti(bool isVersion1, bool big) {
  std::string header(isVersion1 ? 352 : 544, '\0');
  const auto put = [&](std::size_t at, const std::string &bytes) { header.replace(at, bytes.size(), bytes); };
  put(0, bytesOf<std::int32_t>({isVersion1 ? 348 : 540}, big));
  if (isVersion1) {
    put(344, std::string("n+1\0", 4));
    put(40, bytesOf<std::int16_t>({3, 3, 2, 1, 1, 1, 1, 1}, big));
    put(70, bytesOf<std::int16_t>({2, 8}, big));
    put(76, bytesOf<float>({1, 2, 3, 4}, big));
    put(108, bytesOf<float>({352}, big));
  } else {
    put(4, std::string("n+2\0\r\n\x1a\n", 8));
    put(16, bytesOf<std::int64_t>({3, 3, 2, 1, 1, 1, 1, 1}, big));
    put(12, bytesOf<std::int16_t>({2, 8}, big));
    put(104, bytesOf<double>({1, 2, 3, 4}, big));
    put(168, bytesOf<std::int64_t>({544}, big));
  }
  return header;
}

TEST_F(Nifti, OfBothVersionsAndByteOrders) {
  for (const bool isVersion1 : {true, false})
    for (const bool big : {true, false}) {
      const std::string file = nifti(isVersion1, big) + "\1\2\3\4\5\6";
      EXPECT_EQ(voxels("a.nii", file), kSix) << isVersion1 << big;
      EXPECT_THAT(toModel(1, 1, 1), ElementsAre(2, 3, 4));
      EXPECT_EQ(voxels("a.nii.gz", gzipped(file)), kSix) << isVersion1 << big;
      EXPECT_EQ(voxels("b.nii", gzipped(file)), kSix) << isVersion1 << big;
    }
}

TEST_F(Nifti, ScalesItsSamplesAndTakesTheFirstVolume) {
  std::string file = nifti(true, false);
  file.replace(112, 8, bytesOf<float>({-2, 12}));
  file.replace(40, 16, bytesOf<std::int16_t>({4, 3, 2, 1, 2, 1, 1, 1}));
  file += "\1\2\3\4\5\6xxxxxx";
  // 10, 8, 6, 4, 2 and 0, which is empty.
  Voxels found = voxels("a.nii", file);
  EXPECT_EQ(found, (Voxels{{0, kWhite}, {1, 0xffcccccc}, {8, 0xff999999}, {2, 0xff666666}, {3, 0xff333333}}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("2 volumes")));
  options_.threshold = 7;
  EXPECT_EQ(voxels("a.nii", file).size(), 2u);
}

TEST_F(Nifti, WhatNobodySaysOfThemIsFound) {
  std::string file = nifti(true, false);
  // Halves are no labels: the samples are 0.5 and 2.5 to 3.
  file.replace(112, 4, bytesOf<float>({0.5}));
  file.replace(80, 12, bytesOf<float>({1, 1, 1}));
  file += "\1\1\1\5\6\6";
  options_.isAutomatic = true;
  EXPECT_EQ(voxels("a.nii", file).size(), 3u); // From a threshold between 0.5 and 2.5.
  EXPECT_THAT(warnings_, testing::IsEmpty());
  // Most is solid, which may be meant; no voxel is black.
  options_.threshold = 0.5;
  const Voxels automatic = voxels("a.nii", file);
  EXPECT_THAT(warnings_,
              ElementsAre(HasSubstr("no sample is below the threshold 0.5, which leaves none out")));
  for (const auto &[place, word] : automatic)
    EXPECT_GT(word & 255, 90u);
  // The up of NIfTI files is +z, unless it is said.
  options_.window = {{0, 3}};
  const Voxels upright = voxels("a.nii", file);
  options_.isUpKnown = true;
  const Voxels asTheyLie = voxels("a.nii", file);
  options_.zUp = true;
  EXPECT_EQ(voxels("a.nii", file), upright);
  EXPECT_NE(asTheyLie, upright);
}

TEST_F(Nifti, AThresholdThatPartsNothingIsToldWithTheRange) {
  const std::string file = nifti(true, false) + "\1\2\3\4\5\6";
  options_.threshold = 6.5;
  EXPECT_TRUE(voxels("a.nii", file).empty());
  EXPECT_THAT(warnings_, ElementsAre("no sample reaches the threshold 6.5; they are from 1 to 6"));
  options_.threshold = 0.5;
  EXPECT_EQ(voxels("a.nii", file).size(), 6u);
  EXPECT_THAT(warnings_,
              ElementsAre(HasSubstr(
                  "no sample is below the threshold 0.5, which leaves none out; they are from 1 to 6")));
  options_.threshold = 4;
  EXPECT_EQ(voxels("a.nii", file).size(), 3u);
  EXPECT_THAT(warnings_, testing::IsEmpty());
  options_.threshold = std::nan("");
  const auto none = openInput(folder_.file("a.nii", file), options_);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("nan is none"));
}

TEST_F(Nifti, FactsAreThoseOfTheFile) {
  options_.describe = true;
  const auto input =
      openInput(folder_.file("a.nii", nifti(true, false) + std::string("\0\1\1\5\6\6", 6)), options_);
  ASSERT_TRUE(input) << input.error().message;
  std::map<std::string, InputFact> facts;
  for (const InputFact &fact : input->facts)
    facts[fact.name] = fact;
  EXPECT_EQ(facts["kind"].text, "a dense volume");
  EXPECT_EQ(facts["samples"].text, "uint8");
  EXPECT_THAT(facts["range"].numbers, ElementsAre(0, 6));
  EXPECT_THAT(facts["zeros"].numbers, ElementsAre(1));
  const std::vector<double> &counts = facts["histogram"].numbers;
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0.0), 5);
  EXPECT_EQ(counts.back(), 2);
  EXPECT_EQ(facts["size"].numbers.size(), 3u);
}

TEST_F(Nifti, AFormThatIsNoMapIsLeftOut) {
  std::string file = nifti(true, false) + "\1\2\3\4\5\6";
  file.replace(252, 4, bytesOf<std::int16_t>({1, 1}));
  file.replace(256, 24, bytesOf<float>({0, 0, 0, 10, 20, 30}));
  file.replace(76, 16, bytesOf<float>({1, 2, 3, 4}));
  for (const float number : {0.0f, std::nanf("")}) {
    for (std::size_t i = 0; i < 12; ++i)
      file.replace(280 + 4 * i, 4, bytesOf<float>({number}));
    voxels("a.nii", file);
    EXPECT_THAT(toModel(0.5, 0.5, 0.5), ElementsAre(10, 20, 30)) << number;
    EXPECT_THAT(toModel(1.5, 0.5, 0.5), ElementsAre(12, 20, 30)) << number;
    EXPECT_THAT(warnings_, testing::Contains("its sform is no map of a volume, and is left out"));
  }
  // A size of 0 is one that nobody wrote.
  file.replace(254, 2, bytesOf<std::int16_t>({0}));
  file.replace(76, 16, bytesOf<float>({1, 0, std::nanf(""), 4}));
  voxels("a.nii", file);
  EXPECT_THAT(toModel(1.5, 1.5, 0.5), ElementsAre(11, 21, 30));
}

TEST_F(Nifti, SaysWhereItsSamplesLie) {
  std::string file = nifti(true, false) + "\1\2\3\4\5\6";
  file.replace(252, 4, bytesOf<std::int16_t>({1, 0}));
  // A half turn about z: the quaternion (0, 0, 0, 1); and z mirrored. Voxels go to the right, front and up,
  // so that the first one is the last sample.
  file.replace(256, 24, bytesOf<float>({0, 0, 1, 10, 20, 30}));
  file.replace(76, 4, bytesOf<float>({-1}));
  voxels("a.nii", file);
  EXPECT_THAT(toModel(2.5, 1.5, 0.5), ElementsAre(10, 20, 30));
  EXPECT_THAT(toModel(1.5, 0.5, 0.5), ElementsAre(8, 17, 30));
  // About another axis the rounding of float32 turns nothing: z becomes y, and y becomes z.
  const float half = std::sqrt(0.5f);
  file.replace(256, 24, bytesOf<float>({0, half, half, 10, 20, 30}));
  file.replace(76, 16, bytesOf<float>({1, 1, 1, 1}));
  voxels("a.nii", file);
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row)
      EXPECT_NEAR(map_[axis][row], std::round(map_[axis][row]), 1e-12) << axis << row;
  // Of both, the matrix counts; it swaps x and y.
  file.replace(254, 2, bytesOf<std::int16_t>({1}));
  file.replace(280, 48, bytesOf<float>({0, 5, 0, 1, 6, 0, 0, 2, 0, 0, 7, 3}));
  voxels("a.nii", file);
  EXPECT_THAT(toModel(0.5, 0.5, 0.5), ElementsAre(1, 2, 3));
  EXPECT_THAT(toModel(0.5, 1.5, 0.5), ElementsAre(1, 8, 3));
  EXPECT_EQ(extent_, (Int3{2, 3, 1}));
}

} // namespace
} // namespace voxc
