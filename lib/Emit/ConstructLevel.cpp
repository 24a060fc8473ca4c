// Levels as structs: the constants that their headers ask for, and the classes that these are given.
#include "ConstructLevel.h"

#include "ConstructConstants.h"
#include "Names.h"
#include "RuntimeText.h"

#include "voxc/Emit/Emit.h"

#include <set>

namespace voxc {
namespace {

/// The headers that a level needs, each once.
std::set<std::string_view> headersOf(const Stratum &stratum, const LevelForm &form) {
  std::set<std::string_view> headers = {form.header(stratum)};
  for (const LevelAlias &alias : form.aliases(stratum))
    if (!alias.of.name.empty())
      headers.insert(alias.of.header);
  return headers;
}

/// Those of `constructConstants` that the headers speak of, and the classes of the level.
std::string levelText(const Plan &plan, const LevelForm &form, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const std::string name = levelStruct(index);
  std::set<std::string, std::less<>> asked;
  for (const EmbeddedFile &header : includedBy(headersOf(stratum, form), constructHeaders()))
    asked.merge(namesBehind("Level::", header.text));
  std::string text = levelComment(plan, index) + "struct " + name + " {\n";
  for (const ConstructConstant &constant : constructConstants(plan, index))
    if (asked.contains(constant.name))
      text += "  static constexpr " + constant.text + "\n";
  const bool isLast = plan.layout.holdsVoxels(index);
  text +=
      "  using Cells = " + (isLast ? std::string(form.voxels) : subVolumeOf(plan, form, index + 1)) + ";\n";
  for (const LevelAlias &alias : form.aliases(stratum))
    if (!alias.of.name.empty())
      text += "  using " + std::string(alias.name) + " = " + std::string(alias.of.name) + "<" + name + ">;\n";
  return text + "};\n";
}

} // namespace

std::string levelStruct(std::size_t index) { return "Level" + std::to_string(index + 1); }

std::string subVolumeOf(const Plan &plan, const LevelForm &form, std::size_t index) {
  return std::string(form.subVolume(plan.layout.strata[index])) + "<" + levelStruct(index) + ">";
}

std::string constructLevels(const Plan &plan, const LevelForm &form) {
  std::set<std::string_view> headers;
  for (const Stratum &stratum : plan.layout.strata)
    headers.merge(headersOf(stratum, form));
  std::string text;
  for (const std::string_view header : headers)
    text += "#include \"" + std::string(header) + "\"\n";
  text += "\nnamespace {\n\nusing namespace voxc::construct;\n";
  for (std::size_t i = plan.layout.strata.size(); i-- > 0;)
    text += levelText(plan, form, i);
  return text;
}

} // namespace voxc
