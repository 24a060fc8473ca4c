// A scene that suggest and search read from an input.
#pragma once

#include "common/Command.h"
#include "common/Json.h"
#include "options/BuildFigures.h"
#include "options/InputArguments.h"
#include "voxc/Search/SearchScene.h"

#include <memory>
#include <string>
#include <vector>

namespace voxc::tool {

struct Scene : SearchScene {
  std::string provenance; ///< As volumes of the input have it.
  ToldSentences told;     ///< Of the input.
};

/// How such an input is opened: by its arguments, of any size.
InputOptions sceneOptions(const InputArguments &arguments, std::shared_ptr<WorkingMemory> memory,
                          const Progress &progress);

/// Reads an input. Figures of reading are added. Errors: those of inputs; an input without a voxel.
Expected<Scene> readScene(const std::string &input, const InputOptions &options, const CommonOptions &common,
                          Json &figures);

/// The formats of a list (`readFormatList`), as `candidatesOf` takes them; those that voxc suggest
/// knows if `list` is "". Errors: those of lists, a line that is no format.
Expected<std::vector<Candidate>> readCandidates(const std::string &list, const SearchScene &scene);

/// Says which formats of a list are left out since they are for other sizes than the scene's, if only some
/// are.
void noteOtherSizes(const std::vector<Candidate> &candidates, const SearchScene &scene,
                    const CommonOptions &common);

} // namespace voxc::tool
