// What is of interest goes to the front.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace voxc::glsl {
namespace {

using Outer = Declaration::Kind;

void addNames(const Declaration &declaration, Names &names) {
  forEachType(declaration, [&](const std::string &type) { names.insert(type); });
  forEachExpression(declaration, [&](const Expression &expression) {
    if (expression.kind == Expression::Kind::Name || expression.kind == Expression::Kind::Call)
      names.insert(expression.text);
  });
}

bool declares(const Declaration &declaration, const Names &names) {
  const bool isOfVariables = declaration.kind == Outer::Variable || declaration.kind == Outer::Block;
  return (!declaration.name.empty() && names.contains(declaration.name)) ||
         (isOfVariables && std::ranges::any_of(declaration.variables, [&](const Variable &variable) {
            return names.contains(variable.name);
          }));
}

/// What follows may need a directive or a layout, and nothing names it.
bool isUnnamed(const Declaration &declaration) {
  return declaration.kind == Outer::Directive || declaration.kind == Outer::Layout;
}

Declaration prototypeOf(const Declaration &function) {
  Declaration prototype = function;
  prototype.notes = {};
  prototype.body.clear();
  prototype.isPrototype = true;
  return prototype;
}

/// One of those that come before, with no empty line above it but of the first.
void put(std::vector<Declaration> &declarations, Declaration declaration) {
  std::vector<std::string> &above = declaration.notes.above;
  if (!declarations.empty() && !above.empty() && above.front().empty() && declaration.kind == Outer::Variable)
    above.erase(above.begin());
  declarations.push_back(std::move(declaration));
}

} // namespace

void lead(Module &module) {
  Names names; // Of what leads and, from its end to its begin, of what that needs.
  for (const Declaration &declaration : module.declarations)
    if (declaration.leads)
      addNames(declaration, names);
  std::vector<Declaration> needed, prototypes, leading, others;
  for (auto at = module.declarations.rbegin(); at != module.declarations.rend(); ++at) {
    if (at->leads) {
      leading.push_back(std::move(*at));
    } else if (at->kind == Outer::Function) {
      if (names.contains(at->name)) {
        for (const Parameter &parameter : at->parameters)
          names.insert(parameter.type);
        names.insert(at->type);
        prototypes.push_back(prototypeOf(*at));
      }
      others.push_back(std::move(*at));
    } else if (isUnnamed(*at) || declares(*at, names)) {
      addNames(*at, names);
      needed.push_back(std::move(*at));
    } else {
      others.push_back(std::move(*at));
    }
  }
  module.declarations.clear();
  for (auto at = needed.rbegin(); at != needed.rend(); ++at)
    put(module.declarations, std::move(*at));
  if (!prototypes.empty())
    prototypes.back().notes.above = {"", "// What follows behind the format."};
  for (auto *const part : {&prototypes, &leading, &others})
    std::move(part->rbegin(), part->rend(), std::back_inserter(module.declarations));
}

} // namespace voxc::glsl
