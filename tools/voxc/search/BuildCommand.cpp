// Candidates in words.
#include "search/BuildCommand.h"

#include "common/ShellWord.h"
#include "sweep/Model.h"

#include <algorithm>

namespace voxc::tool {

namespace {

/// True for passes that change the kernel alone, and so no byte of a volume.
bool isWalk(const std::string &pass) {
  const auto walks = searchedWalks();
  return std::ranges::find(walks, pass) != walks.end();
}

} // namespace

std::string nameOf(const Candidate &candidate) {
  std::string name = candidate.text;
  const char *separator = " with ";
  for (const std::string &pass : candidate.passes) {
    const bool isShort = pass.starts_with("short-pointers");
    if (!isShort && !isWalk(pass))
      continue;
    name += separator + (isShort ? "short pointers" : pass);
    separator = ", ";
  }
  return name;
}

std::string buildCommand(const std::string &input, const InputArguments &arguments,
                         const Candidate &candidate) {
  std::string text = "voxc build " + shellWord(candidate.text) + " " + shellWord(input);
  for (const std::string &word : bench::toWords(arguments))
    text += " " + word;
  for (const std::string &pass : candidate.passes)
    text += " --" + pass;
  return text + " -o scene.hvx";
}

} // namespace voxc::tool
