// Frames one after the other: the first is built, and edited into each other one.
#include "voxc/Construct/Frames.h"

#include "voxc/Construct/EditableVolume.h"
#include "voxc/Layout/Edits.h"

#include <string>

namespace voxc {
namespace {

/// The frames after the first.
class FrameEdits {
public:
  FrameEdits(EditableVolume &volume, const OpenFrame &open, const BuildOptions &options)
      : volume_(volume), open_(open), options_(options) {}

  Expected<void> run(std::unique_ptr<VoxelSource> first, std::size_t count) {
    states_.push_back(volume_.snapshot());
    for (std::size_t i = 1; i < count; ++i) {
      VOXC_TRY(options_.progress.check());
      auto next = VOXC_TRY(open_(i));
      if (auto added = add(*first, *next); !added)
        return Error{added.error().kind, "frame " + std::to_string(i + 1) + ": " + added.error().message};
      first = std::move(next);
    }
    return {};
  }

  const std::vector<EditableVolume::Snapshot> &states() const { return states_; }
  std::vector<FrameReport> takeReports() { return std::move(reports_); }

private:
  Expected<void> add(VoxelSource &before, VoxelSource &after) {
    const Int3 extent = after.extent(), most = volume_.volume()->info().extent;
    if (extent.x > most.x || extent.y > most.y || extent.z > most.z)
      return Error::input("it is larger than the first, and would be cut off");
    auto voxels = VOXC_TRY(differenceOf(before, after));
    const std::uint64_t changed = voxels.size(), words = volume_.words();
    if (changed != 0)
      VOXC_TRY(volume_.apply(*makeListChange(voxels)));
    if (volume_.words() > options_.maxWords)
      return Error::input("with it the volume has " + std::to_string(volume_.words()) +
                          " words, more than were allowed");
    states_.push_back(volume_.snapshot());
    reports_.push_back({volume_.voxels(), changed, volume_.words() - words});
    return {};
  }

  EditableVolume &volume_;
  const OpenFrame &open_;
  const BuildOptions &options_;
  std::vector<EditableVolume::Snapshot> states_;
  std::vector<FrameReport> reports_;
};

Expected<Built> buildFirst(const Format &format, VoxelSource &source, BuildOptions options,
                           const CompileCache *cache) {
  options.path.clear(); // What is written is the volume of all frames.
  options.compress = false;
  const auto constructor = VOXC_TRY(Constructor::compile(format, cache));
  return constructor.build(source, options);
}

} // namespace

Expected<BuiltFrames> buildFrames(const Format &format, std::size_t count, const OpenFrame &open,
                                  const BuildOptions &options, const CompileCache *cache) {
  if (const std::string reason = whyNoEdits(layoutOf(format)); !reason.empty())
    return Error::input("frames are edits of one another; " + reason);
  auto first = VOXC_TRY(open(0));
  auto built = VOXC_TRY(buildFirst(format, *first, options, cache));
  auto volume = VOXC_TRY(EditableVolume::create(built.volume, {.memory = options.memory, .cache = cache}));
  std::vector<FrameReport> reports{{volume.voxels(), volume.voxels(), volume.words()}};
  FrameEdits edits(volume, open, options);
  VOXC_TRY(edits.run(std::move(first), count));
  for (const FrameReport &report : edits.takeReports())
    reports.push_back(report);
  auto framed = VOXC_TRY(volume.framed(edits.states()));
  if (!options.path.empty())
    if (auto saved = framed.save(options.path, {.compress = options.compress,
                                                .threads = options.threads,
                                                .memory = options.memory,
                                                .progress = options.progress});
        !saved)
      return saved.error();
  return BuiltFrames{std::move(framed), std::move(built.report), std::move(reports)};
}

} // namespace voxc
