// Candidates in words.
#include "search/BuildCommand.h"

#include "common/ShellWord.h"
#include "sweep/Model.h"

#include <algorithm>

namespace voxc::tool {

namespace {

/// What a pass is called in a name; "" of those that all candidates for a scene have.
std::string phraseOf(const std::string &pass) {
  const auto walks = searchedWalks();
  if (std::ranges::find(walks, pass) != walks.end())
    return pass;
  return pass.starts_with("short-pointers") ? "short pointers" : pass == "octant-masks" ? "octant masks" : "";
}

} // namespace

std::string nameOf(const Candidate &candidate) {
  std::string name = candidate.text;
  const char *separator = " with ";
  for (const std::string &pass : candidate.passes) {
    const std::string phrase = phraseOf(pass);
    if (phrase.empty())
      continue;
    name += separator + phrase;
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
