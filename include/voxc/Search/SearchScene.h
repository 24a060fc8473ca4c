// What suggesting and searching know of a scene: it is read once, into a graph.
#pragma once

#include "voxc/Search/Candidate.h"
#include "voxc/Search/FormatPredictor.h"
#include "voxc/Search/SceneDag.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/Transform.h"
#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voxc {

struct SearchScene {
  SceneDag shape;
  std::optional<SceneDag> colours; ///< If there was memory for them.
  Int3 extent;
  Transform voxelToModel;
  std::uint64_t voxels = 0;
  std::uint64_t valueWords = 0; ///< Of values apart; 0 if all have one.
  CandidateTraits traits;

  ModelledScene modelled() const { return {shape, colours ? &*colours : nullptr, valueWords, extent}; }
};

/// Reads a scene, twice if its colours are more than the memory holds: `open` opens it anew. `name` is what
/// errors call it. Errors: those of the source; a scene without a voxel (`Input`).
Expected<SearchScene> readSearchScene(const std::string &name,
                                      const std::function<Expected<std::unique_ptr<VoxelSource>>()> &open,
                                      const std::shared_ptr<WorkingMemory> &memory,
                                      const Progress &progress = {});

/// Each of these formats with and without short pointers, if that differs; those that voxc knows if there is
/// none. Error: a text that is no format.
Expected<std::vector<Candidate>> candidatesOf(const std::vector<std::string> &texts,
                                              const SearchScene &scene);

/// Those that cannot hold it, or waste a height.
std::vector<std::string> formatsOfOtherSizes(const std::vector<Candidate> &candidates,
                                             const SearchScene &scene);

/// Why no candidate could be rated: none is of the scene's size, or all take more than is allowed.
Error explainNone(const std::vector<Candidate> &candidates, const SearchScene &scene);

/// Of each kind that are simulated: more do not change which format it is.
inline constexpr std::size_t kSimulatedRays = 4096;
/// Of each kind, among which those are chosen.
inline constexpr std::size_t kConsideredRays = 8 * kSimulatedRays;

} // namespace voxc
