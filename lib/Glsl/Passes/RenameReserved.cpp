// Names that a language keeps to itself.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include <algorithm>

namespace voxc::glsl {

void renameReserved(Module &module, std::span<const std::string_view> reserved) {
  const auto rename = [&](std::string &name) {
    if (std::ranges::find(reserved, name) != reserved.end())
      name += '_';
  };
  for (Declaration &declaration : module.declarations) {
    for (Parameter &parameter : declaration.parameters)
      rename(parameter.name);
    for (Variable &variable : declaration.variables)
      rename(variable.name);
    for (Statement &statement : declaration.body)
      forEachStatement(statement, [&](Statement &inner) {
        for (Variable &variable : inner.variables)
          rename(variable.name);
      });
    forEachExpression(declaration, [&](Expression &expression) {
      if (expression.kind == Expression::Kind::Name || expression.kind == Expression::Kind::Member)
        rename(expression.text);
    });
  }
}

} // namespace voxc::glsl
