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
    while (replaceOnce(expression))
      ; // What takes its place may be such a call itself.
  }

  bool replaceOnce(Expression &expression) const {
    if (expression.kind != Kind::Call)
      return false;
    const auto found = functions_.find({expression.text, expression.operands.size()});
    if (found == functions_.end())
      return false;
    const std::vector<Parameter> &parameters = found->second.parameters;
    Expression value = found->second.body[0].expressions[0];
    fold(value, numbersAmong(expression.operands, parameters));
    substitute(value, parameters, expression.operands);
    value.isGrouped = false;
    const bool isOfIntegers = std::ranges::all_of(parameters, [](const Parameter &parameter) {
      return parameter.type == "uint" || parameter.type == "int";
    });
    if (isOfIntegers)
      forEachExpression(value, [](Expression &inner) { straighten(inner); });
    expression = std::move(value);
    return true;
  }

  /// The parameters that are numbers here.
  static Constants numbersAmong(const std::vector<Expression> &arguments,
                                const std::vector<Parameter> &parameters) {
    Constants numbers;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      if (arguments[i].kind == Kind::Literal)
        numbers[parameters[i].name] = arguments[i].text;
    return numbers;
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

  /// Arguments in place of parameters, once: what an argument names may be called as a parameter is. The
  /// printer puts parentheses where they are needed.
  static void substitute(Expression &value, const std::vector<Parameter> &parameters,
                         const std::vector<Expression> &arguments) {
    const auto parameter = std::ranges::find(parameters, value.text, &Parameter::name);
    if (value.kind == Kind::Name && parameter != parameters.end()) {
      Expression argument = arguments[static_cast<std::size_t>(parameter - parameters.begin())];
      argument.isGrouped = false;
      value = std::move(argument);
      return;
    }
    for (Expression &operand : value.operands)
      substitute(operand, parameters, arguments);
  }

  std::map<std::pair<std::string, std::size_t>, Declaration> functions_;
};

} // namespace

void inlineValues(Module &module) { Inliner().run(module); }

} // namespace voxc::glsl
