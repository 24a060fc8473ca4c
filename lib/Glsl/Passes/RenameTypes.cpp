// Types that have another name here.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

namespace voxc::glsl {

void renameTypes(Module &module, const std::map<std::string, std::string, std::less<>> &names) {
  const auto rename = [&](std::string &type) {
    if (const auto found = names.find(type); found != names.end())
      type = found->second;
  };
  for (Declaration &declaration : module.declarations) {
    rename(declaration.type);
    for (Parameter &parameter : declaration.parameters)
      rename(parameter.type);
    for (Variable &variable : declaration.variables)
      rename(variable.type);
    for (Statement &statement : declaration.body)
      forEachStatement(statement, [&](Statement &inner) {
        for (Variable &variable : inner.variables)
          rename(variable.type);
      });
    forEachExpression(declaration, [&](Expression &expression) {
      if (expression.kind == Expression::Kind::Call)
        rename(expression.text);
    });
  }
}

} // namespace voxc::glsl
