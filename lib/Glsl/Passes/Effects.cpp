// Which functions do more than give a value.
#include "Glsl/Passes.h"
#include "Glsl/Types.h"
#include "Glsl/Visit.h"

#include <algorithm>

namespace voxc::glsl {
namespace {

Names variablesOutermost(const Module &module) {
  Names names;
  for (const Declaration &declaration : module.declarations)
    if (declaration.kind == Declaration::Kind::Variable || declaration.kind == Declaration::Kind::Block)
      for (const Variable &variable : declaration.variables)
        names.insert(variable.name);
  return names;
}

bool writesOut(const Declaration &function) {
  return std::ranges::any_of(function.parameters, [](const Parameter &parameter) {
    return parameter.passing == Passing::Out || parameter.passing == Passing::InOut;
  });
}

bool hasEffects(const Declaration &function, const Names &outermost, const Names &known) {
  bool has = writesOut(function);
  forEachExpression(function, [&](const Expression &expression) {
    has |= expression.kind == Expression::Kind::Call && known.contains(expression.text);
    if (expression.kind == Expression::Kind::Assignment || expression.kind == Expression::Kind::Postfix)
      has |= outermost.contains(rootOf(expression.operands[0]));
  });
  return has;
}

} // namespace

Names functionsWithEffects(const Module &module) {
  const Names outermost = variablesOutermost(module);
  Names names;
  for (std::size_t before = names.size() + 1; before != names.size();) {
    before = names.size();
    for (const Declaration &declaration : module.declarations)
      if (declaration.kind == Declaration::Kind::Function && hasEffects(declaration, outermost, names))
        names.insert(declaration.name);
  }
  return names;
}

} // namespace voxc::glsl
