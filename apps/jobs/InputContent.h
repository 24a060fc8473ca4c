// The content of an input: its files, and their digest.
#pragma once

#include "voxc/Support/Error.h"

#include <span>
#include <string>
#include <vector>

namespace voxc::tool {

/// A file of an input, and the name by which the input refers to it.
struct ContentFile {
  std::string name;
  std::string path;
};

/// The files of an input, its own first, in an order that is always the same; none of what is built in.
/// `named` are those that its content names, as `Input::files` has them. Error: `Input` if a pattern has no
/// file.
Expected<std::vector<ContentFile>> contentFiles(const std::string &input, std::span<const std::string> named);

/// The path in "grid:WxHxD:FILE" and "raw:WxHxD:TYPE:FILE", or the input itself.
std::string fileOf(const std::string &input);

/// Digest of an input's content: its file, or all that its pattern names, a volume's journal, and the files
/// that are read with it, as an .obj's materials and textures. Errors: `Input` if a file cannot be
/// read, `Interrupted`.
Expected<std::string> contentDigest(const std::string &input);

} // namespace voxc::tool
