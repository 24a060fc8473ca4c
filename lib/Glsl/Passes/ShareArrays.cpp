// Arrays of functions become columns of arrays that a workgroup shares.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;

/// Takes the array's declaration out of a function.
std::optional<Variable> takeArray(Declaration &function, std::string_view array) {
  std::optional<Variable> taken;
  std::erase_if(function.body, [&](Statement &statement) {
    const bool isIt = statement.kind == Statement::Kind::Declaration && statement.variables.size() == 1 &&
                      statement.variables[0].name == array && statement.variables[0].sizes.size() == 1;
    if (isIt)
      taken = std::move(statement.variables[0]);
    return isIt;
  });
  return taken;
}

Expression nameOf(std::string name) { return {Kind::Name, std::move(name)}; }

/// array[i] becomes shared[i][gl_LocalInvocationIndex].
void index(Declaration &function, std::string_view array, const std::string &shared) {
  forEachExpression(function, [&](Expression &expression) {
    const bool isElement = expression.kind == Kind::Index && expression.operands[0].kind == Kind::Name &&
                           expression.operands[0].text == array;
    if (!isElement)
      return;
    expression.operands[0].text = shared;
    Expression row = expression;
    expression = {Kind::Index, "", {std::move(row), nameOf("gl_LocalInvocationIndex")}};
  });
}

Declaration declarationOf(Variable variable, const std::string &name) {
  variable.name = name;
  variable.sizes.push_back({Kind::Member, "x", {nameOf("gl_WorkGroupSize")}});
  Declaration declaration = {.kind = Declaration::Kind::Variable, .qualifiers = "shared"};
  declaration.variables.push_back(std::move(variable));
  return declaration;
}

} // namespace

void shareArrays(Module &module, std::string_view array) {
  std::vector<Declaration> result;
  for (Declaration &function : module.declarations) {
    if (std::optional<Variable> variable = takeArray(function, array)) {
      const std::string shared =
          std::string(array) + function.name.substr(std::min(function.name.find('_'), function.name.size()));
      index(function, array, shared);
      Declaration declaration = declarationOf(std::move(*variable), shared);
      declaration.leads = function.leads;
      std::swap(declaration.notes, function.notes); // Comments on both stand above the first.
      result.push_back(std::move(declaration));
      function.notes.above.insert(function.notes.above.begin(), "");
    }
    result.push_back(std::move(function));
  }
  module.declarations = std::move(result);
}

} // namespace voxc::glsl
