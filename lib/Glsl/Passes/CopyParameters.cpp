// Parameters that a function writes to, for languages where these are values.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

namespace voxc::glsl {
Names writtenIn(const Declaration &function,
                const std::map<std::string, const Declaration *, std::less<>> &functions) {
  Names written;
  forEachExpression(function, [&](const Expression &expression) {
    const bool steps = expression.text == "++" || expression.text == "--";
    if (expression.kind == Expression::Kind::Assignment || (steps && !expression.operands.empty()))
      written.emplace(rootOf(expression.operands[0]));
    const auto called = functions.find(expression.text);
    if (expression.kind != Expression::Kind::Call || called == functions.end())
      return;
    for (std::size_t i = 0; i < expression.operands.size(); ++i)
      if (const Passing passing = called->second->parameters[i].passing;
          passing == Passing::Out || passing == Passing::InOut)
        written.emplace(rootOf(expression.operands[i]));
  });
  return written;
}

void copyParameters(Module &module) {
  std::map<std::string, const Declaration *, std::less<>> functions;
  for (const Declaration &declaration : module.declarations)
    if (declaration.kind == Declaration::Kind::Function)
      functions[declaration.name] = &declaration;
  for (Declaration &function : module.declarations) {
    if (function.parameters.empty())
      continue;
    const Names written = writtenIn(function, functions);
    std::vector<Statement> copies;
    for (Parameter &parameter : function.parameters) {
      if (parameter.passing != Passing::In || !written.contains(parameter.name))
        continue;
      Statement copy;
      copy.kind = Statement::Kind::Declaration;
      const std::string given = "given_" + parameter.name;
      copy.variables.push_back(
          {parameter.type, parameter.name, {}, {{Expression::Kind::Name, given, {}, false, parameter.type}}});
      copies.push_back(std::move(copy));
      parameter.name = given;
    }
    function.body.insert(function.body.begin(), copies.begin(), copies.end());
  }
}

} // namespace voxc::glsl
