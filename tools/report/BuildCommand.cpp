// Commands out of records.
#include "report/BuildCommand.h"

#include "common/ShellWord.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace voxc::report {
namespace {

using Words = std::vector<std::string>;

/// Options that say how an input becomes voxels; all but `--crop` have a value.
constexpr std::array<std::string_view, 15> kInputOptions = {
    "--resolution", "--voxel-size", "--unit",   "--align",     "--bounds",
    "--up",         "--coverage",   "--colour", "--threshold", "--colour-map",
    "--window",     "--volume",     "--grid",   "--interior",  "--fill-colour"};
constexpr std::string_view kCrop = "--crop";

/// The words of a command, of which some stand in single quotes.
Words wordsOf(std::string_view command) {
  Words words;
  bool isInside = false, isQuoted = false;
  for (const char c : command)
    if (c == '\'') {
      isQuoted = !isQuoted;
      if (!isInside)
        words.emplace_back();
      isInside = true;
    } else if (c == ' ' && !isQuoted) {
      isInside = false;
    } else {
      if (!isInside)
        words.emplace_back();
      isInside = true;
      words.back() += c;
    }
  return words;
}

/// A model as a command names it: "NAME=INPUT OPTION...", both but INPUT if they are wanted.
struct ModelArgument {
  std::string input;
  Words options;
};

/// Reads a word as the model's argument, if it is that.
std::optional<ModelArgument> modelArgument(const std::string &word, const tool::bench::ModelPart &model) {
  const std::size_t options = std::min(word.find(" --"), word.size());
  std::string input = word.substr(0, options);
  if (input.starts_with(model.name + "="))
    input.erase(0, model.name.size() + 1);
  if (model.input.empty() || input.substr(input.rfind('/') + 1) != model.input)
    return std::nullopt;
  return ModelArgument{input, wordsOf(word.substr(options))};
}

/// The options of inputs among a command's words; values that follow one another as the same option are one.
Words inputOptions(const Words &words) {
  Words options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    if (words[i] == kCrop || (std::ranges::count(kInputOptions, name) > 0 && name != words[i])) {
      options.push_back(words[i]);
    } else if (std::ranges::count(kInputOptions, name) > 0 && i + 1 < words.size()) {
      const bool goesOn = !options.empty() && options.back().starts_with(name + "=");
      if (goesOn)
        options.back() += "," + words[++i];
      else
        options.push_back(name + "=" + words[++i]);
    }
  }
  return options;
}

/// The model's own options, and those of the whole command that they do not replace.
Words allOptions(const Words &own, const Words &common) {
  Words all = common;
  for (const std::string &option : own) {
    const std::string name = option.substr(0, option.find('='));
    std::erase_if(all, [&](const std::string &other) { return other.substr(0, other.find('=')) == name; });
  }
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

ModelArgument findModel(const Cell &cell) {
  const Words words = wordsOf(cell.madeBy.command);
  const Words common = inputOptions(words);
  for (const std::string &word : words)
    if (auto argument = modelArgument(word, cell.model)) {
      argument->options = allOptions(inputOptions(argument->options), common);
      return *argument;
    }
  return {cell.model.input, common};
}

} // namespace

std::string buildCommand(const Cell &cell) {
  const ModelArgument model = findModel(cell);
  const bool looksLikeOption = model.input.starts_with("-");
  std::string text = "voxc build " + tool::shellWord(cell.format.name) + " " +
                     tool::shellWord((looksLikeOption ? "./" : "") + model.input);
  for (const std::string &option : model.options)
    text += " " + tool::shellWord(option);
  for (const std::string &pass : cell.format.passes)
    text += " " + tool::shellWord("--" + pass);
  return text + " -o " +
         tool::shellWord((cell.model.name.starts_with("-") ? "./" : "") + cell.model.name + ".hvx");
}

} // namespace voxc::report
