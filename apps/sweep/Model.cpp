// Reading models.
#include "sweep/Model.h"

#include "common/NumberedName.h"
#include "jobs/InputContent.h"
#include "voxc/Measure/Digest.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace voxc::tool::bench {

using namespace measure;

namespace {

namespace fs = std::filesystem;

bool isNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
}

/// A name is also that of a picture's file.
bool isName(std::string_view name) {
  return !name.empty() && name[0] != '.' && std::ranges::all_of(name, isNameCharacter);
}

Expected<void> parseOptions(const std::string &text, InputArguments &arguments) {
  const CommandLine command;
  addInputArguments(command, arguments);
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  if (const Expected<void> parsed = command.parse(words); !parsed)
    return Error::usage("options '" + text + "' of an input are not understood: " + parsed.error().message);
  return {};
}

} // namespace

std::string nameOfInput(const std::string &input) {
  constexpr std::string_view kBuiltin = "builtin:";
  std::string name = input.starts_with(kBuiltin) ? input.substr(kBuiltin.size())
                                                 : stemOfNumbered(input.substr(input.rfind(':') + 1));
  std::ranges::replace_if(name, [](char c) { return !isNameCharacter(c); }, '-');
  return isName(name) ? name : "model";
}

Expected<Model> readModel(const std::string &text, const InputArguments &defaults) {
  const std::size_t options = std::min(text.find(" --"), text.size());
  Model model{"", text.substr(0, options), defaults, ""};
  const std::size_t equals = model.input.find('=');
  std::error_code ignored;
  if (equals != std::string::npos && !fs::exists(model.input, ignored)) {
    model.name = model.input.substr(0, equals);
    model.input.erase(0, equals + 1);
    if (!isName(model.name))
      return Error::usage("'" + model.name +
                          "' is no name of a model; use letters, digits, '-', '_' and '.'");
  } else {
    model.name = nameOfInput(model.input);
  }
  VOXC_TRY(parseOptions(text.substr(options), model.arguments));
  const auto content = VOXC_TRY(contentDigest(model.input));
  Digest digest;
  digest.add(content);
  for (const std::string &word : toWords(model.arguments))
    digest.add(word);
  model.digest = digest.hex();
  return model;
}

} // namespace voxc::tool::bench
