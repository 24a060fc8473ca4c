// Names of a module's own, beside those of whoever includes it.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

namespace voxc::glsl {
namespace {

class PrefixAdder {
public:
  PrefixAdder(Module &module, std::string_view prefix) : module_(module), prefix_(prefix) {}

  void add() {
    for (const Declaration &declaration : module_.declarations)
      declare(declaration);
    for (Declaration &declaration : module_.declarations)
      rename(declaration);
  }

private:
  void declare(const Declaration &declaration) {
    using Kind = Declaration::Kind;
    if (declaration.kind == Kind::Function || declaration.kind == Kind::Structure)
      names_.insert(declaration.name);
    if (declaration.kind == Kind::Variable)
      names_.insert(declaration.variables[0].name);
  }

  void rename(Declaration &declaration) {
    const bool isStructure = declaration.kind == Declaration::Kind::Structure;
    replace(declaration.type);
    if (declaration.kind != Declaration::Kind::Directive)
      replace(declaration.name);
    locals_.clear();
    for (Parameter &parameter : declaration.parameters) {
      replace(parameter.type);
      locals_.insert(parameter.name);
    }
    for (Variable &variable : declaration.variables) {
      replace(variable.type);
      if (!isStructure)
        replace(variable.name);
      forEachExpressionOf(variable, [&](Expression &expression) { rename(expression); });
    }
    for (Statement &statement : declaration.body)
      forEachStatement(statement, [&](Statement &inner) { rename(inner); });
  }

  /// A name counts as a variable of the function from its declaration on: leaves do not use one for two
  /// things.
  void rename(Statement &statement) {
    for (Variable &variable : statement.variables) {
      replace(variable.type);
      forEachExpressionOf(variable, [&](Expression &expression) { rename(expression); });
      locals_.insert(variable.name);
    }
    for (auto *const some : {&statement.expressions, &statement.step})
      for (Expression &expression : *some)
        forEachExpression(expression, [&](Expression &inner) { rename(inner); });
  }

  void rename(Expression &expression) {
    const bool isName = expression.kind == Expression::Kind::Name && !locals_.contains(expression.text);
    if (isName || expression.kind == Expression::Kind::Call)
      replace(expression.text);
    replace(expression.type);
  }

  void replace(std::string &name) const {
    if (names_.contains(name) && !name.starts_with(prefix_))
      name.insert(0, prefix_);
  }

  Module &module_;
  std::string_view prefix_;
  Names names_;
  Names locals_; ///< Of the function at hand.
};

} // namespace

void addPrefix(Module &module, std::string_view prefix) { PrefixAdder(module, prefix).add(); }

} // namespace voxc::glsl
