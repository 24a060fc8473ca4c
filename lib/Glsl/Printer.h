// The printer of trees. What it prints is GLSL; a language that spells something in another way derives from
// it.
#pragma once

#include "Glsl/Operators.h"
#include "Glsl/Tree.h"

#include <string>
#include <vector>

namespace voxc::glsl {

/// PrintDeclaration.cpp, PrintStatement.cpp and PrintExpression.cpp, as the parser's parts are.
class Printer {
public:
  virtual ~Printer() = default;

  std::string print(const Module &module);

  /// An expression to which nothing is near, without parentheses around it.
  std::string alone(const Expression &expression) const { return bare(expression); }

  /// An expression, in parentheses where something that binds closer stands around it.
  std::string text(const Expression &expression, int leastRank = kAssignmentRank) const;

protected:
  // What languages spell in ways of their own.

  /// Called before anything of a module, and before anything of a function, is printed.
  virtual void begin(const Module &) {}
  virtual void beginFunction(const Declaration &) {}
  /// A type by its name in GLSL.
  virtual std::string type(const std::string &name) const { return name; }
  /// A number, true, or false.
  virtual std::string literal(const std::string &text) const { return text; }
  /// An expression without the parentheses around it.
  virtual std::string bare(const Expression &expression) const;
  /// The rank of what `bare` makes of an expression.
  virtual int rank(const Expression &expression) const;
  virtual std::string parameter(const Parameter &parameter) const;
  /// The line of a function up to its body.
  virtual std::string head(const Declaration &function) const;
  /// What stands before the type that a function returns, with a blank behind it.
  virtual std::string beforeFunction(const Declaration &function) const;
  /// "const", "precise" or "", of a variable in a function, with a blank behind it.
  virtual std::string beforeLocal(const std::string &qualifiers) const;
  /// The same of one outside of functions.
  virtual std::string beforeGlobal(const std::string &qualifiers) const;
  /// Variables of one type as a function declares them, without the semicolon behind them.
  virtual std::string variables(const std::vector<Variable> &variables) const;
  /// A member of a struct, and a variable outside of functions, with what ends them.
  virtual std::string member(const Variable &member) const;
  virtual std::string global(const Declaration &variable) const;
  virtual std::string structureEnd() const { return "};"; }
  virtual void statement(const Statement &statement, int depth);

  std::string list(const std::vector<Expression> &expressions) const;
  std::string initial(const Variable &variable) const;
  void body(const std::vector<Statement> &statements, bool isBraced, int depth);
  void above(const Notes &notes, int depth);
  void line(int depth, const std::string &text, const std::string &behind = "");

private:
  void declaration(const Declaration &declaration);
  void block(const Declaration &declaration);
  void structure(const Declaration &declaration);
  void function(const Declaration &declaration);
  void branch(const Statement &statement, int depth);
  std::string simple(const Statement &statement) const;

  std::string text_;
};

/// "a, b, c".
std::string joined(const std::vector<std::string> &parts);

} // namespace voxc::glsl
