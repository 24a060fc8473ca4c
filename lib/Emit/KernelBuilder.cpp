// Reading of leaves, and what makes those of a level out of them.
#include "KernelBuilder.h"

#include "Glsl/Parse.h"
#include "Glsl/Visit.h"

#include "voxc/Emit/Emit.h"

#include <cctype>
#include <iterator>

namespace voxc {
namespace {

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
    if (name.starts_with("LEVEL_") && !std::isdigit(static_cast<unsigned char>(name[6])))
      name.insert(6, number_ + "_");
    else if (name.ends_with("_level"))
      name += "_" + number_;
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

/// An empty line stands before each file.
void KernelBuilder::append(glsl::Module module) {
  if (module.declarations.empty())
    return;
  std::vector<std::string> &above = module.declarations.front().notes.above;
  if (above.empty() || !above.front().empty())
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
  glsl::fold(*module, constantsOf(names, "LEVEL_"));
  const LevelNames level(plan_, index);
  for (glsl::Declaration &declaration : module->declarations)
    level.rename(declaration);
  append(std::move(*module));
}

void KernelBuilder::addText(std::string_view text) {
  if (auto module = read("text", text))
    append(std::move(*module));
}

Expected<glsl::Module> KernelBuilder::specialised(const glsl::Names &roots,
                                                  const glsl::Constants &constants) && {
  if (problem_)
    return std::move(*problem_);
  glsl::Constants all = constantsOf(names_, "");
  for (const auto &[name, value] : constants)
    all[name] = value;
  glsl::fold(module_, all);
  glsl::dropUnused(module_, roots);
  return std::move(module_);
}

} // namespace voxc
