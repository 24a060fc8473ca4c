// The models of a sweep: inputs with a name and with how they become voxels.
#pragma once

#include "options/InputArguments.h"

#include <string>
#include <vector>

namespace voxc::tool::bench {

struct Model {
  std::string name;
  std::string input; ///< As INPUT of `voxc build`.
  InputArguments arguments;
  std::string digest; ///< Of the input's content and of the arguments.
};

/// What an input is called: "dir/sponza.obj" is sponza, "builtin:terrain:64" is terrain-64.
std::string nameOfInput(const std::string &input);

/// Reads a model as it is written on the command line: "[NAME=]INPUT [OPTION...]", where the options are
/// those of inputs, in place of `defaults`. The name is what the input is called where none is given. Errors:
/// `Usage` for a name or option that cannot be, `Input` for a file that cannot be read.
Expected<Model> readModel(const std::string &text, const InputArguments &defaults);

} // namespace voxc::tool::bench
