// Candidates in words.
#include "choosing/BuildCommand.h"

#include "voxc/Measure/SearchVerdict.h"
#include "voxc/Support/ShellWord.h"

namespace voxc::tool {

std::string nameOf(const Candidate &candidate) {
  return measure::plainName(candidate.text, candidate.passes);
}

std::string searchCommand(const std::string &input, const InputArguments &arguments,
                          const std::string &device) {
  std::string text = "voxc search " + shellWord(input);
  for (const std::string &word : toWords(arguments))
    text += " " + shellWord(word);
  return text + " --device " + shellWord(device) + " -o found";
}

std::string buildCommand(const std::string &input, const InputArguments &arguments,
                         const Candidate &candidate) {
  std::string text = "voxc build " + shellWord(candidate.text) + " " + shellWord(input);
  for (const std::string &word : toWords(arguments))
    text += " " + shellWord(word);
  for (const std::string &pass : candidate.passes)
    text += " --" + pass;
  return text + " -o scene.hvx";
}

} // namespace voxc::tool
