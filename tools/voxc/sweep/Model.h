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

/// The arguments as words for a command line.
std::vector<std::string> toWords(const InputArguments &arguments);

/// A file of an input, and the name by which the input refers to it.
struct ContentFile {
  std::string name;
  std::string path;
};

/// The files of an input, its own first, in an order that is always the same; none of what is built in.
/// Error: `Input` if one cannot be read.
Expected<std::vector<ContentFile>> contentFiles(const std::string &input);

/// The path in "grid:WxHxD:FILE" and "raw:WxHxD:TYPE:FILE", or the input itself.
std::string fileOf(const std::string &input);

/// Digest of an input's content: its file, or all that its pattern names, and the files beside and below it
/// whose names stand in it, as those of an .obj's materials and textures do. Error: `Input` if the file
/// cannot be read.
Expected<std::string> contentDigest(const std::string &input);

} // namespace voxc::tool::bench
