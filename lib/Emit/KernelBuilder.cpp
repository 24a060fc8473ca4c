// Reading of leaves, and what makes those of a level out of them.
#include "KernelBuilder.h"

#include "Emit/KernelConstants.h"
#include "Emit/RuntimeText.h"

#include "Glsl/Parse.h"
#include "Glsl/Verify.h"
#include "Glsl/Visit.h"

#include "voxc/Emit/Emit.h"

#include <array>
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
                                         {"EXACT_FALLBACK", "bool"},
                                         {"COMES_NEAR", "bool"},
                                         {"COUNT_WORDS", "bool"},
                                         {"COUNT_LOOKUPS", "bool"},
                                         {"load_word", "uint"}};

/// What names of a level, and of a layer, are in a kernel.
class LevelNames {
public:
  LevelNames(const Plan &plan, std::size_t index, int layer)
      : number_(std::to_string(index + 1)),
        next_(plan.layout.holdsVoxels(index) ? "voxel" : "level_" + std::to_string(index + 2)),
        layers_{{{"_layer", layer}, {"_lower", layer - 1}, {"_highest", plan.layout.strata[index].depth}}} {}

  void rename(glsl::Declaration &declaration) const {
    forEachName(declaration, [&](std::string &name) { rename(name); });
  }

  template <typename Visit> static void forEachName(glsl::Declaration &declaration, const Visit &visit) {
    visit(declaration.name);
    for (glsl::Variable &variable : declaration.variables)
      visit(variable.name);
    glsl::forEachExpression(declaration, [&](glsl::Expression &expression) {
      if (expression.kind == glsl::Expression::Kind::Name || expression.kind == glsl::Expression::Kind::Call)
        visit(expression.text);
    });
  }

private:
  struct Layer {
    std::string_view suffix;
    int number;
  };

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
      renameOfLevel(name, behind);
    else if (name.ends_with("_next"))
      name.replace(name.size() - 4, 4, next_);
  }

  void renameOfLevel(std::string &name, std::size_t behind) const {
    name.insert(behind, "_" + number_);
    for (const Layer &layer : layers_)
      if (name.ends_with(layer.suffix))
        name.replace(name.size() - layer.suffix.size(), layer.suffix.size(),
                     "_layer_" + std::to_string(layer.number));
  }

  std::string number_;
  std::string next_;
  std::array<Layer, 3> layers_;
};

} // namespace

KernelBuilder::KernelBuilder(const Plan &plan, FormatWords words)
    : plan_(plan), words_(std::move(words)), constants_(constantsOf(plan)) {}

glsl::Module KernelBuilder::parsed(std::string_view name, std::string_view text) {
  auto module = glsl::parse(text);
  if (!module && !problem_)
    problem_ = Error::input(std::string(name) + ", " + module.error().message);
  return module ? std::move(*module) : glsl::Module();
}

glsl::Module KernelBuilder::read(std::string_view path) {
  const std::string file = std::string(path) + ".glsl";
  return parsed(file, replaceWords(runtimeFile(shaderFiles(), file), words_));
}

void KernelBuilder::append(glsl::Module module, bool isApart) {
  if (module.declarations.empty())
    return;
  for (glsl::Declaration &declaration : module.declarations)
    declaration.leads = isOfFormat_;
  std::vector<std::string> &above = module.declarations.front().notes.above;
  if (isApart && (above.empty() || !above.front().empty()))
    above.insert(above.begin(), "");
  std::ranges::move(module.declarations, std::back_inserter(module_.declarations));
}

void KernelBuilder::add(std::string_view path) {
  glsl::Module module = read(path);
  const std::string lowest = "_level_" + std::to_string(plan_.layout.strata.size());
  constexpr std::string_view kLowest = "_lowest";
  for (glsl::Declaration &declaration : module.declarations)
    LevelNames::forEachName(declaration, [&](std::string &name) {
      if (name.ends_with(kLowest))
        name.replace(name.size() - kLowest.size(), kLowest.size(), lowest);
    });
  append(std::move(module));
}

void KernelBuilder::addLevel(std::string_view path, std::size_t index) { addLayer(path, index, 0); }

void KernelBuilder::addLayer(std::string_view path, std::size_t index, int layer) {
  glsl::Module module = read(path);
  glsl::Constants constants = constantsOf(plan_, index);
  constants["LEVEL_LAYER"] = std::to_string(layer);
  glsl::unroll(module, {{"LEVEL_DEPTH", std::to_string(plan_.layout.strata[index].depth)}});
  glsl::fold(module, constants);
  const LevelNames names(plan_, index, layer);
  for (glsl::Declaration &declaration : module.declarations)
    names.rename(declaration);
  append(std::move(module));
}

void KernelBuilder::addText(std::string_view text, bool isApart) { append(parsed("text", text), isApart); }

Expected<glsl::Module> KernelBuilder::specialised(const glsl::Names &roots) && {
  if (problem_)
    return std::move(*problem_);
  const bool inDoubles = plan_.steps == StepArithmetic::Float64;
  glsl::renameTypes(module_,
                    {{"real", inDoubles ? "double" : "float"}, {"real3", inDoubles ? "dvec3" : "vec3"}});
  glsl::inlineValues(module_);
  glsl::unroll(module_, constants_);
  glsl::fold(module_, constants_);
  glsl::dropUnused(module_, roots);
  if (plan_.sharesStack())
    glsl::shareArrays(module_, "path");
  VOXC_TRY(glsl::verify(module_, kExternals));
  glsl::fold(module_, {});          // Conversions that types show to be none,
  glsl::dropUnused(module_, roots); // and members.
  return std::move(module_);
}

} // namespace voxc
