// Reading of leaves, and what makes those of a level out of them.
#include "KernelBuilder.h"

#include "Glsl/Parse.h"
#include "Glsl/Verify.h"
#include "Glsl/Visit.h"

#include "voxc/Emit/Emit.h"

#include <cctype>
#include <iterator>

namespace voxc {
namespace {

/// What devices, and the text around a module, have.
constexpr glsl::External kExternals[] = {{"gl_GlobalInvocationID", "uvec3"},
                                         {"gl_LocalInvocationIndex", "uint"},
                                         {"gl_WorkGroupSize", "uvec3"},
                                         {"texelFetch", "uvec4"},
                                         {"VOXC_LOAD", "uint"},
                                         {"VOXC_INDEX", "uint"},
                                         {"VOXC_FIND", "bool"},
                                         {"volume", "VOXC_VOLUME"},
                                         {"lanes_at_work", "uint"},
                                         {"words", "uint[]"},
                                         {"ray_words", "uint[]"},
                                         {"hit_words", "uint[]"},
                                         {"words_read", "uint"},
                                         {"lacks_page", "bool"},
                                         {"page_table", "uint[]"},
                                         {"LOG2_PAGE_WORDS", "uint"},
                                         {"PAGES", "uint"},
                                         {"FEWEST_LANES", "uint"},
                                         {"SPREAD", "float"},
                                         {"SETTLES", "bool"},
                                         {"COMES_NEAR", "bool"},
                                         {"COUNT_WORDS", "bool"},
                                         {"COUNT_LOOKUPS", "bool"},
                                         {"load_word", "uint"}};

/// "values-apart" as VALUES_APART, which leaves have in place of a condition.
std::string constantOf(std::string_view prefix, std::string_view condition) {
  std::string name(prefix);
  for (const char c : condition)
    name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

glsl::Constants constantsOf(const TemplateNames &names, std::string_view prefix) {
  glsl::Constants constants;
  for (const auto &[condition, holds] : names.conditions)
    constants[constantOf(prefix, condition)] = holds ? "true" : "false";
  return constants;
}

/// What names of a level are in a kernel.
class LevelNames {
public:
  LevelNames(const Plan &plan, std::size_t index)
      : number_(std::to_string(index + 1)),
        next_(plan.layout.holdsVoxels(index) ? "voxel" : "level_" + std::to_string(index + 2)) {}

  void rename(glsl::Declaration &declaration) const {
    rename(declaration.name);
    for (glsl::Variable &variable : declaration.variables)
      rename(variable.name);
    glsl::forEachExpression(declaration, [&](glsl::Expression &expression) {
      if (expression.kind == glsl::Expression::Kind::Name || expression.kind == glsl::Expression::Kind::Call)
        rename(expression.text);
    });
  }

private:
  void rename(std::string &name) const {
    const auto isDigit = [&](std::size_t at) {
      return at < name.size() && std::isdigit(static_cast<unsigned char>(name[at]));
    };
    constexpr std::string_view kLevel = "_level";
    const std::size_t level = name.find(kLevel), behind = level + kLevel.size();
    if (name.starts_with("LEVEL_") && !isDigit(6))
      name.insert(6, number_ + "_");
    else if (level != std::string::npos && (behind == name.size() || name[behind] == '_') &&
             !isDigit(behind + 1))
      name.insert(behind, "_" + number_);
    else if (name.ends_with("_next"))
      name.replace(name.size() - 4, 4, next_);
  }

  std::string number_;
  std::string next_;
};

} // namespace

std::optional<glsl::Module> KernelBuilder::read(std::string_view name, std::string_view text) {
  auto module = glsl::parse(text);
  if (!module && !problem_)
    problem_ = Error::input(std::string(name) + ", " + module.error().message);
  return module ? std::optional(std::move(*module)) : std::nullopt;
}

void KernelBuilder::append(glsl::Module module, bool isApart) {
  if (module.declarations.empty())
    return;
  std::vector<std::string> &above = module.declarations.front().notes.above;
  if (isApart && (above.empty() || !above.front().empty()))
    above.insert(above.begin(), "");
  std::ranges::move(module.declarations, std::back_inserter(module_.declarations));
}

void KernelBuilder::add(std::string_view path, const TemplateNames &names) {
  const std::string file = std::string(path) + ".glsl";
  if (auto module = read(file, fillFile(shaderFiles(), file, names)))
    append(std::move(*module));
}

void KernelBuilder::addLevel(std::string_view path, std::size_t index, const TemplateNames &names) {
  const std::string file = std::string(path) + ".glsl";
  auto module = read(file, fillFile(shaderFiles(), file, names));
  if (!module)
    return;
  glsl::Constants constants = constantsOf(names, "LEVEL_");
  if (plan_.layout.strata[index].log2Shape.x == 1) // Else its name is worth more than the number.
    constants["LEVEL_BRANCH"] = "1";
  glsl::fold(*module, constants);
  const LevelNames level(plan_, index);
  for (glsl::Declaration &declaration : module->declarations)
    level.rename(declaration);
  append(std::move(*module));
}

void KernelBuilder::addText(std::string_view text, bool isApart) {
  if (auto module = read("text", text))
    append(std::move(*module), isApart);
}

Expected<glsl::Module> KernelBuilder::specialised(const glsl::Names &roots) && {
  if (problem_)
    return std::move(*problem_);
  const bool inDoubles = plan_.steps == Steps::Float64;
  glsl::renameTypes(module_,
                    {{"real", inDoubles ? "double" : "float"}, {"real3", inDoubles ? "dvec3" : "vec3"}});
  glsl::inlineValues(module_);
  glsl::fold(module_, constantsOf(names_, ""));
  glsl::dropUnused(module_, roots);
  if (const auto verified = glsl::verify(module_, kExternals); !verified)
    return verified.error();
  glsl::fold(module_, {});          // Conversions that types show to be none,
  glsl::dropUnused(module_, roots); // and members.
  return std::move(module_);
}

} // namespace voxc
