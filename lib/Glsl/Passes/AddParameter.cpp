// A parameter for a function and for all that lead to it.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

namespace voxc::glsl {
namespace {

bool callsAny(const Declaration &function, const Names &names) {
  bool calls = false;
  forEachExpression(function, [&](const Expression &expression) {
    calls |= expression.kind == Expression::Kind::Call && names.contains(expression.text);
  });
  return calls;
}

/// The function, and all that come to it.
Names callersOf(const Module &module, std::string_view function) {
  Names names = {std::string(function)};
  for (std::size_t before = 0; before != names.size();) {
    before = names.size();
    for (const Declaration &declaration : module.declarations)
      if (callsAny(declaration, names))
        names.insert(declaration.name);
  }
  return names;
}

} // namespace

void addParameter(Module &module, std::string_view function, const Parameter &parameter) {
  const Names takers = callersOf(module, function);
  for (Declaration &declaration : module.declarations) {
    if (takers.contains(declaration.name))
      declaration.parameters.insert(declaration.parameters.begin(), parameter);
    forEachExpression(declaration, [&](Expression &expression) {
      if (expression.kind == Expression::Kind::Call && takers.contains(expression.text))
        expression.operands.insert(expression.operands.begin(),
                                   {Expression::Kind::Name, parameter.name, {}, false, parameter.type});
    });
  }
}

} // namespace voxc::glsl
