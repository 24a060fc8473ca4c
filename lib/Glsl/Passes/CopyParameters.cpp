// Parameters that a function writes to, for languages where these are values.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

namespace voxc::glsl {
namespace {

/// What a function writes to, by itself or by what it calls.
Names writtenIn(const Declaration &function, const Module &module) {
  Names written;
  forEachExpression(function, [&](const Expression &expression) {
    const bool steps = expression.text == "++" || expression.text == "--";
    if (expression.kind == Expression::Kind::Assignment || (steps && !expression.operands.empty()))
      written.emplace(rootOf(expression.operands[0]));
    if (expression.kind != Expression::Kind::Call)
      return;
    for (const Declaration &called : module.declarations)
      for (std::size_t i = 0; called.name == expression.text && i < called.parameters.size(); ++i)
        if (const Passing passing = called.parameters[i].passing;
            passing == Passing::Out || passing == Passing::InOut)
          written.emplace(rootOf(expression.operands[i]));
  });
  return written;
}

} // namespace

void copyParameters(Module &module) {
  for (Declaration &function : module.declarations) {
    if (function.parameters.empty())
      continue;
    const Names written = writtenIn(function, module);
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
