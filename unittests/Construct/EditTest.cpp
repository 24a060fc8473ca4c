// An edited volume has the words of a build of the edited voxels.
#include "EditTesting.h"
#include "NewFolder.h"
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Construct/EditJournal.h"
#include "voxc/Source/Edit.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/WorkingMemory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <utility>

namespace voxc {
namespace {

using Words = std::vector<std::uint32_t>;

std::shared_ptr<const Volume> smallVolume(std::mt19937 &random, Int3 extent) {
  const Format format = *parseFormat("R(1^3) G(4)");
  const auto scenes = test::hardScenes(extent);
  return test::buildVolume(format,
                           *scenes[std::size_t(test::pick(random, 0, int(scenes.size()) - 1))].source());
}

VoxelEdit randomEdit(std::mt19937 &random, Int3 extent) {
  constexpr std::uint32_t kWords[] = {0, 0xff0000ff, 0x7f102030};
  const Int3 low = test::within(random, extent);
  VoxelEdit edit{low, test::within(random, extent - low), kWords[test::pick(random, 0, 2)], nullptr};
  const Int3 &size = edit.size;
  const bool canPaste =
      size.x > 0 && size.y > 0 && size.z > 0 && size.x <= 32 && size.y <= 32 && size.z <= 32;
  if (canPaste && test::pick(random, 0, 1) == 1)
    edit.pasted = smallVolume(random, edit.size);
  return edit;
}

/// What a voxel becomes, cell by cell, as `VoxelEdit` says it.
std::uint32_t edited(const Volume &volume, const std::vector<VoxelEdit> &edits, Int3 cell) {
  std::uint32_t word = volume.lookup(cell).value;
  for (const VoxelEdit &edit : edits) {
    const Int3 inside = cell - edit.low;
    if (!contains(edit.size, inside))
      continue;
    if (!edit.pasted)
      word = edit.word;
    else if (const std::uint32_t pasted = edit.pasted->lookup(inside).value; pasted != 0)
      word = pasted;
  }
  return word;
}

void expectSameAsBuild(const Format &format, const test::HardScene &scene, std::mt19937 &random) {
  const auto constructor = Constructor::compile(format);
  ASSERT_TRUE(constructor) << constructor.error().message;
  const auto volume = test::buildVolume(format, *scene.source());
  if (!volume) // The scene has more than the format's payload keeps.
    return;
  std::vector<VoxelEdit> edits;
  for (int i = test::pick(random, 0, 3); i >= 0; --i)
    edits.push_back(randomEdit(random, scene.extent));
  const auto after =
      makeFunctionSource(scene.extent, [&](Int3 cell) { return edited(*volume, edits, cell); });
  const auto expected = constructor->build(*after);
  const auto found = constructor->edit(volume, edits);
  ASSERT_EQ(bool(found), bool(expected))
      << toString(format) << " " << scene.name << " " << (found ? expected : found).error().message;
  if (!found)
    return;
  EXPECT_EQ(Words(found->volume.words().begin(), found->volume.words().end()),
            Words(expected->volume.words().begin(), expected->volume.words().end()))
      << printIr(format) << " " << scene.name;
  EXPECT_EQ(found->volume.info().voxels, expected->volume.info().voxels);
  EXPECT_EQ(found->report.voxels, expected->report.voxels);
}

TEST(Edit, GivesTheWordsOfABuild) {
  std::mt19937 random(3);
  for (int i = 0; i < test::rounds(8); ++i) {
    const Format format = test::randomFormat(random, test::pick(random, 3, 7));
    const auto scenes = test::hardScenes(format.extent());
    expectSameAsBuild(format, scenes[std::size_t(test::pick(random, 0, int(scenes.size()) - 1))], random);
  }
}

/// A voxel alone in its node, and a cube of eight alone in the node above: the same words.
TEST(Edit, CountsVoxelsOfNodesThatTwoLayersShare) {
  const Format format = *parseFormat("G(7)");
  const auto source = makeFunctionSource({128, 128, 128}, [](Int3 cell) {
    const bool isCube = (cell >> 1) == Int3{4, 4, 4};
    return cell == Int3{0, 0, 0} || isCube || cell == Int3{100, 100, 100} ? 0xff0000ffu : 0u;
  });
  const auto volume = test::buildVolume(format, *source);
  ASSERT_EQ(volume->info().voxels, 10u);
  const auto edited = Constructor::compile(format)->edit(volume, {VoxelEdit{{100, 100, 100}, {1, 1, 1}}});
  ASSERT_TRUE(edited);
  EXPECT_EQ(edited->volume.info().voxels, 9u);
  const auto counted = checkStructure(format, edited->volume.words());
  ASSERT_TRUE(counted);
  EXPECT_EQ(*counted, 9u);
}

/// Levels of one cell that stand below another, in parts that are copied as they are.
TEST(Edit, CopiesLevelsOfOneCell) {
  const auto source = makeBuiltinSource("terrain", 128);
  for (const char *text :
       {"G(7) G(0)", "S(7) S(0) G(0)", "R(4^3) G(3) G(0) S(0)", "R(3^3) G(4) G(0) M(0^3)"}) {
    const Format format = *parseFormat(text);
    const auto volume = test::buildVolume(format, **source);
    const auto edited = Constructor::compile(format)->edit(volume, {VoxelEdit{{100, 2, 100}, {1, 1, 1}}});
    ASSERT_TRUE(edited) << text << ": " << edited.error().message;
    EXPECT_EQ(edited->volume.info().voxels,
              volume->info().voxels - (volume->lookup({100, 2, 100}).value != 0))
        << text;
  }
}

TEST(Edit, WhatIsOutsideOfTheVolumeIsAnError) {
  const auto source = makeBuiltinSource("terrain", 16);
  const Format format = *parseFormat("R(2^3) G(2)");
  const auto volume = test::buildVolume(format, **source);
  const auto constructor = Constructor::compile(format);
  for (const VoxelEdit &edit :
       {VoxelEdit{{10, 0, 0}, {7, 1, 1}}, VoxelEdit{{-1, 0, 0}, {1, 1, 1}}, VoxelEdit{{0, 0, 0}, {1, 1, -1}},
        VoxelEdit{{2147483647, 0, 0}, {2147483647, 1, 1}}})
    EXPECT_FALSE(constructor->edit(volume, {edit}));
  const auto failed =
      constructor->edit(volume, {VoxelEdit{{0, 0, 0}, {1, 1, 1}}, VoxelEdit{{0, 16, 0}, {1, 1, 1}}});
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message,
            "edit 2 has (1, 1, 1) voxels from (0, 16, 0) on, but the volume ends at (16, 16, 16)");
  const auto other = Constructor::compile(*parseFormat("G(4)"));
  ASSERT_FALSE(other->edit(volume, {}));
}

/// What a few kilobytes of a journal stand for is kept within one bound, however many volumes they paste.
TEST(Edit, OfAJournalPastesWithinItsMemory) {
  const auto folder = test::newFolder("voxc-edit");
  const std::string path = (folder / "volume.hvx").string();
  const auto scene = makeBuiltinSource("terrain", 64);
  ASSERT_TRUE(test::buildVolume(*parseFormat("G(6)"), **scene)->save(path));
  const auto pasted = test::buildVolume(*parseFormat("R(6^3)"), **scene); // A megabyte of words.
  {
    auto journal = EditJournal::open(path);
    ASSERT_TRUE(journal) << journal.error().message;
    ASSERT_TRUE(journal->append({{{}, pasted->info().extent, 0, pasted}}));
  }
  const auto memory = WorkingMemory::create(1 << 18);
  const auto edits = readJournal(path, memory);
  ASSERT_TRUE(edits) << edits.error().message;
  ASSERT_EQ(edits->size(), 1u);
  EXPECT_TRUE(std::ranges::equal(edits->front().pasted->words(), pasted->words()));
  EXPECT_GT(memory->scratchPeak(), 0u);
  std::filesystem::remove_all(folder);
}

/// An edit that comes while its volume is written anew is kept, with what it is of.
TEST(Edit, OfAJournalIsNotLostToAWriter) {
  const auto folder = test::newFolder("voxc-edit");
  const std::string path = (folder / "volume.hvx").string();
  const auto scene = makeBuiltinSource("terrain", 16);
  ASSERT_TRUE(test::buildVolume(*parseFormat("G(4)"), **scene)->save(path));
  const auto other = test::buildVolume(*parseFormat("R(4^3)"), **scene);
  bool isEdited = false;
  SaveOptions options{.compress = true};
  options.progress.report = [&](std::string_view, double, std::uint64_t) {
    if (!std::exchange(isEdited, true)) {
      EXPECT_TRUE(EditJournal::open(path)->append({{{15, 0, 0}, {1, 1, 1}, 0xff0000ff, nullptr}}));
    }
  };
  const auto saved = other->save(path, options);
  ASSERT_TRUE(isEdited);
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message.find("edits of '"), std::string::npos) << saved.error().message;
  const auto kept = loadEdited(path);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_EQ(toString(kept->format()), "G(4)");
  std::filesystem::remove_all(folder);
}

/// One that was opened and got no edits is none.
TEST(Edit, WithoutOneNoJournalStays) {
  const auto folder = test::newFolder("voxc-edit");
  const std::string path = (folder / "volume.hvx").string();
  const auto scene = makeBuiltinSource("terrain", 16);
  ASSERT_TRUE(test::buildVolume(*parseFormat("G(4)"), **scene)->save(path));
  {
    auto journal = EditJournal::open(path);
    ASSERT_TRUE(journal) << journal.error().message;
    EXPECT_FALSE(EditJournal::open(path)); // Another has it, and does not take it away.
    EXPECT_TRUE(std::filesystem::exists(journalPathOf(path)));
    EXPECT_FALSE(journal->append({{{15, 0, 0}, {2, 1, 1}, 1, nullptr}}));
  }
  EXPECT_FALSE(std::filesystem::exists(journalPathOf(path)));
  {
    auto journal = EditJournal::open(path);
    ASSERT_TRUE(journal) << journal.error().message;
    EXPECT_TRUE(journal->append({{{15, 0, 0}, {1, 1, 1}, 0xff0000ff, nullptr}}));
  }
  EXPECT_TRUE(std::filesystem::exists(journalPathOf(path)));
  EXPECT_TRUE(EditJournal::open(path)); // And to be left as it is.
  EXPECT_EQ(readJournal(path)->size(), 1u);
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace voxc
