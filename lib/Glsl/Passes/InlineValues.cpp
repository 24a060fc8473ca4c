// Functions that stand for the value they return.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include <algorithm>
#include <map>
#include <utility>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;

class Inliner {
public:
  void run(Module &module) {
    for (Declaration &declaration : module.declarations) {
      for (Variable &variable : declaration.variables)
        forEachExpressionOf(variable, [&](Expression &expression) { replace(expression); });
      for (Statement &statement : declaration.body)
        forEachExpression(statement, [&](Expression &expression) { replace(expression); });
      if (declaration.isInline && declaration.body.size() == 1 &&
          declaration.body[0].kind == Statement::Kind::Return)
        functions_[{declaration.name, declaration.parameters.size()}] = declaration;
    }
    std::erase_if(module.declarations, [](const Declaration &declaration) { return declaration.isInline; });
  }

private:
  /// Calls inside are replaced afterwards, as what stands inside is visited later.
  void replace(Expression &expression) const {
    if (expression.kind != Kind::Call)
      return;
    const auto found = functions_.find({expression.text, expression.operands.size()});
    if (found == functions_.end())
      return;
    Expression value = found->second.body[0].expressions[0];
    forEachExpression(value, [&](Expression &inner) {
      const auto parameter = std::ranges::find(found->second.parameters, inner.text, &Parameter::name);
      if (inner.kind == Kind::Name && parameter != found->second.parameters.end())
        put(inner,
            expression.operands[static_cast<std::size_t>(parameter - found->second.parameters.begin())]);
    });
    value.isGrouped = false;
    const bool isOfIntegers = std::ranges::all_of(found->second.parameters, [](const Parameter &parameter) {
      return parameter.type == "uint" || parameter.type == "int";
    });
    if (isOfIntegers)
      forEachExpression(value, [](Expression &inner) { straighten(inner); });
    expression = std::move(value);
  }

  /// a + (b + c) of integers becomes a + b + c.
  static void straighten(Expression &sum) {
    while (sum.is(Kind::Binary, "+") && sum.operands[1].is(Kind::Binary, "+") && !sum.operands[1].isGrouped) {
      Expression right = std::move(sum.operands[1]);
      Expression left = {Kind::Binary, "+", {std::move(sum.operands[0]), std::move(right.operands[0])}};
      sum.operands[0] = std::move(left);
      Expression last = std::move(right.operands[1]);
      sum.operands[1] = std::move(last);
    }
  }

  /// An argument in place of a parameter; the printer puts parentheses where they are needed.
  static void put(Expression &name, Expression argument) {
    argument.isGrouped = false;
    name = std::move(argument);
  }

  std::map<std::pair<std::string, std::size_t>, Declaration> functions_;
};

} // namespace

void inlineValues(Module &module) { Inliner().run(module); }

} // namespace voxc::glsl
