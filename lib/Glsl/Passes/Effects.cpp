// Which functions do more than give a value.
#include "Glsl/Passes.h"
#include "Glsl/Types.h"
#include "Glsl/Visit.h"

#include <algorithm>

namespace voxc::glsl {
namespace {

/// Its parameters and variables. All else that it writes to stands outermost, be it in the module or in the
/// text around it.
Names localsOf(const Declaration &function) {
  Names names;
  for (const Parameter &parameter : function.parameters)
    names.insert(parameter.name);
  for (const Statement &statement : function.body)
    forEachStatement(statement, [&](const Statement &inner) {
      for (const Variable &variable : inner.variables)
        names.insert(variable.name);
    });
  return names;
}

bool writesOut(const Declaration &function) {
  return std::ranges::any_of(function.parameters, [](const Parameter &parameter) {
    return parameter.passing == Passing::Out || parameter.passing == Passing::InOut;
  });
}

bool hasEffects(const Declaration &function, const Names &known) {
  bool has = writesOut(function);
  const Names locals = localsOf(function);
  forEachExpression(function, [&](const Expression &expression) {
    has |= expression.kind == Expression::Kind::Call && known.contains(expression.text);
    if (expression.kind == Expression::Kind::Assignment || expression.kind == Expression::Kind::Postfix)
      has |= !locals.contains(rootOf(expression.operands[0]));
  });
  return has;
}

} // namespace

Names functionsWithEffects(const Module &module) {
  Names names;
  for (std::size_t before = names.size() + 1; before != names.size();) {
    before = names.size();
    for (const Declaration &declaration : module.declarations)
      if (declaration.kind == Declaration::Kind::Function && hasEffects(declaration, names))
        names.insert(declaration.name);
  }
  return names;
}

} // namespace voxc::glsl
