// What suggest and search know of an input: it is read once, into a graph.
#pragma once

#include "common/Command.h"
#include "common/Json.h"
#include "options/BuildFigures.h"
#include "options/InputArguments.h"
#include "voxc/Search/Candidate.h"
#include "voxc/Search/FormatPredictor.h"
#include "voxc/Search/SceneDag.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/Transform.h"
#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voxc::tool {

struct Scene {
  SceneDag shape;
  std::optional<SceneDag> colours; ///< If there was memory for them.
  Int3 extent;
  Transform voxelToModel;
  std::string provenance; ///< As volumes of the input have it.
  std::uint64_t voxels = 0;
  std::uint64_t valueWords = 0; ///< Of values apart; 0 if all have one.
  CandidateTraits traits;
  ToldSentences told; ///< Of the input.

  ModelledScene priced() const { return {shape, colours ? &*colours : nullptr, valueWords}; }
};

/// Reads an input, twice if its colours are more than the memory holds. Figures of reading are added. Errors:
/// those of inputs; an input without a voxel.
Expected<Scene> readScene(const std::string &input, const InputArguments &arguments,
                          const std::shared_ptr<WorkingMemory> &memory, const CommonOptions &common,
                          const Progress &progress, Json &figures);

/// The formats of a list (`bench::readFormatList`), each with and without short pointers if that differs;
/// those that voxc suggest knows if `list` is "". Errors: those of lists, a line that is no format.
Expected<std::vector<Candidate>> readCandidates(const std::string &list, const Scene &scene);

/// Why no format of a list could be rated: none is as large as the scene, or all take more than is allowed.
Error explainNone(const std::vector<Candidate> &candidates, const Scene &scene);
/// Says which formats of a list are left out since they are for other sizes than the scene's, if only some
/// are.
void noteOtherSizes(const std::vector<Candidate> &candidates, const Scene &scene,
                    const CommonOptions &common);

/// Of each kind: more do not change which format it is.
inline constexpr std::size_t kSimulatedRays = 4096;
/// Of each kind, among which those are chosen.
inline constexpr std::size_t kConsideredRays = 8 * kSimulatedRays;

} // namespace voxc::tool
