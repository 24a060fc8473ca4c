// Reading models.
#include "sweep/Model.h"

#include "bench/Digest.h"
#include "common/NumberedName.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace voxc::tool::bench {
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

/// A number so that it comes back as it was.
std::string exact(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

std::string joined(const std::vector<double> &numbers) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ",") + exact(number);
  return text;
}

} // namespace

std::string nameOfInput(const std::string &input) {
  constexpr std::string_view kBuiltin = "builtin:";
  std::string name = input.starts_with(kBuiltin) ? input.substr(kBuiltin.size())
                                                 : stemOfNumbered(input.substr(input.rfind(':') + 1));
  std::ranges::replace_if(name, [](char c) { return !isNameCharacter(c); }, '-');
  return isName(name) ? name : "model";
}

std::vector<std::string> toWords(const InputArguments &arguments) {
  std::vector<std::string> words;
  const auto add = [&](const char *option, const std::string &value) {
    if (!value.empty())
      words.push_back(std::string(option) + "=" + value);
  };
  add("--resolution", arguments.resolution == 0 ? "" : std::to_string(arguments.resolution));
  add("--voxel-size", arguments.voxelSize);
  add("--unit", arguments.unit);
  add("--align", joined(arguments.align));
  add("--bounds", joined(arguments.bounds));
  add("--up", arguments.up);
  add("--coverage", arguments.coverage);
  add("--colour", arguments.colour);
  add("--threshold", arguments.threshold ? exact(*arguments.threshold) : "");
  add("--colour-map", arguments.colourMap);
  add("--window", joined(arguments.window));
  add("--volume", arguments.volume == 0 ? "" : std::to_string(arguments.volume));
  add("--grid", arguments.grid);
  add("--interior", arguments.interior);
  add("--fill-colour", arguments.fillColour);
  if (arguments.crop)
    words.push_back("--crop");
  return words;
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
  if (Expected<void> parsed = parseOptions(text.substr(options), model.arguments); !parsed)
    return parsed.error();
  const Expected<std::string> content = contentDigest(model.input);
  if (!content)
    return content.error();
  Digest digest;
  digest.add(*content);
  for (const std::string &word : toWords(model.arguments))
    digest.add(word);
  model.digest = digest.hex();
  return model;
}

} // namespace voxc::tool::bench
