// Declarations of leaves, found by the names that others speak of.
#include "LeafPrelude.h"

#include "Emit/KernelConstants.h"
#include "Emit/RuntimeText.h"

#include "Glsl/Parse.h"
#include "Glsl/Print.h"
#include "Glsl/Visit.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/SlotKind.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace voxc::test {
namespace {

using glsl::Declaration;
using Kind = Declaration::Kind;

constexpr std::string_view kBegin = R"(#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#define real float
#define real3 vec3
#define INLINE
#ifndef OUT_OF_LINE
#define OUT_OF_LINE
#endif
#define VOXC_INDEX uint
uint volume;
uint VOXC_LOAD(uint volume, uint index) { return index; }
bool VOXC_FIND(uint volume, uint index, out uint word) { word = index; return true; }
// What packets of a processor bring.
uint ray_words[64];
uint hit_words[64];
const uint FEWEST_LANES = 4u;
uint lanes_at_work(int changing) { return 1u; }
)";

/// What emitters write themselves: the size of the volume, and the shape of each level.
constexpr std::string_view kWritten = R"(const ivec3 VOLUME_SIZE = ivec3(8);
const ivec3 LEVEL_LOG2_SIZE = ivec3(3);
const int LEVEL_DEPTH = 3;
const int LEVEL_BRANCH = 1;
const int LEVEL_LOG2_CELL = 0;
const int LEVEL_LOG2_SIDE = 3;
const int LEVEL_LAYER = 1;
)";

std::string constantOf(std::string_view name, const ConstantValue &value) {
  constexpr const char *kTypes[] = {"bool ", "int ", "uint "};
  return "const " + std::string(kTypes[value.index()]) + std::string(name) + " = " + literal(value) + ";\n";
}

std::string constants() {
  const Plan plan = *makePlan(*parseFormat("R(1,1,1) G(1)"));
  std::map<std::string, std::string> lines; // By their names: kinds of slots share some.
  for (const PlanConstant &constant : planConstants())
    lines[std::string(constant.name)] = constantOf(constant.name, constant.of(plan));
  for (const LevelConstant &constant : levelConstants())
    lines["LEVEL_" + std::string(constant.name)] =
        constantOf("LEVEL_" + std::string(constant.name), constant.of(plan, 1));
  for (const SlotKind *kind : slotKinds()) {
    Stratum stratum;
    stratum.encoding = defaultEncoding(*kind);
    for (const SlotConstant &own : kind->constants(stratum)) {
      const std::string name = "LEVEL_" + std::string(own.name);
      lines[name] = constantOf(name, std::visit([](auto value) { return ConstantValue(value); }, own.value));
    }
  }
  std::string text(kWritten);
  for (const auto &[name, line] : lines)
    text += line;
  return text;
}

std::vector<std::string> namesIn(const Declaration &declaration) {
  std::vector<std::string> names;
  glsl::forEachType(declaration, [&](const std::string &type) { names.push_back(type); });
  glsl::forEachExpression(declaration, [&](const glsl::Expression &expression) {
    if (expression.kind == glsl::Expression::Kind::Name || expression.kind == glsl::Expression::Kind::Call)
      names.push_back(expression.text);
  });
  return names;
}

std::vector<std::string> declaredBy(const Declaration &declaration) {
  std::vector<std::string> names;
  if (!declaration.name.empty() && declaration.kind != Kind::Directive)
    names.push_back(declaration.name);
  if (declaration.kind == Kind::Variable || declaration.kind == Kind::Block)
    for (const glsl::Variable &variable : declaration.variables)
      names.push_back(variable.name);
  return names;
}

/// Other names of functions of levels and layers: f_level is f_next for the level above.
std::string asDeclared(std::string name) {
  static constexpr std::pair<std::string_view, std::string_view> kEndings[] = {{"_level_1", "_level"},
                                                                               {"_next", "_level"},
                                                                               {"_lowest", "_level"},
                                                                               {"_lower", "_layer"},
                                                                               {"_highest", "_layer"}};
  for (const auto &[ending, declared] : kEndings)
    if (name.ends_with(ending))
      name.replace(name.size() - ending.size(), ending.size(), declared);
  return name;
}

class Prelude {
public:
  explicit Prelude(std::string_view path) {
    for (const std::string &other : leaves()) {
      const auto module = glsl::parse(runtimeFile(shaderFiles(), other));
      for (const Declaration &declaration : module->declarations) {
        if (other == path)
          own_.push_back(declaration);
        else
          for (const std::string &name : declaredBy(declaration))
            others_.emplace(name, declaration);
      }
    }
    for (const Declaration &declaration : own_)
      if (declaration.kind != Kind::Function)
        for (const std::string &name : declaredBy(declaration))
          seen_.insert(name);
  }

  std::string text() {
    for (const Declaration &declaration : own_)
      declareAll(declaration);
    return std::string(kBegin) + constants() + declarations_ + prototypes_;
  }

private:
  void declareAll(const Declaration &user) {
    for (const std::string &name : namesIn(user))
      declare(name);
  }

  /// All functions of a name; of others, the first, since leaves that declare one stand for each other.
  void declare(const std::string &name) {
    if (!seen_.insert(name).second)
      return;
    for (const Declaration &declaration : own_)
      if (declaration.kind == Kind::Function && declaration.name != name &&
          declaration.name == asDeclared(name))
        prototype(declaration, name);
    const auto [begin, end] = others_.equal_range(asDeclared(name));
    for (auto at = begin; at != end; ++at) {
      const Declaration &declaration = at->second;
      if (declaration.kind == Kind::Function) {
        prototype(declaration, name);
        continue;
      }
      declareAll(declaration);
      for (const std::string &also : declaredBy(declaration))
        seen_.insert(also);
      declarations_ += glsl::print({{declaration}});
      break;
    }
  }

  void prototype(Declaration function, const std::string &name) {
    for (const glsl::Parameter &parameter : function.parameters)
      declare(parameter.type);
    declare(function.type);
    function.notes = {};
    function.body.clear();
    function.isPrototype = true;
    function.isSeldom = function.isInline = false;
    function.name = name;
    const std::string text = glsl::print({{function}});
    std::string types;
    for (const glsl::Parameter &parameter : function.parameters)
      types += parameter.type + ",";
    if (signatures_.insert(name + "(" + types).second)
      prototypes_ += text;
  }

  std::vector<Declaration> own_;
  std::multimap<std::string, Declaration> others_;
  std::set<std::string> seen_;
  std::set<std::string> signatures_;
  std::string declarations_;
  std::string prototypes_;
};

} // namespace

std::vector<std::string> leaves() {
  std::vector<std::string> paths;
  for (const EmbeddedFile &file : shaderFiles())
    if (file.path.ends_with(".glsl") &&
        !file.path.starts_with("header/r") && // Those are shaders of their own,
        !file.path.starts_with("builtins/"))  // and those are for languages that lack what GLSL has.
      paths.emplace_back(file.path);
  return paths;
}

std::string preludeOf(std::string_view path) { return Prelude(path).text(); }

std::vector<std::string> builtins() {
  std::vector<std::string> paths;
  for (const EmbeddedFile &file : shaderFiles())
    if (file.path.starts_with("builtins/"))
      paths.emplace_back(file.path);
  return paths;
}

} // namespace voxc::test
