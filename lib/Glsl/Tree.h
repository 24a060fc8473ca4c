// Kernels as trees: the part of GLSL that leaves and kernels are written in, with its comments.
//
// The text of this IR is GLSL itself: `parse` reads it (Glsl/Parse.h), printers write it for each language
// (Glsl/Print.h), and passes between the two map a Module to another (Glsl/Passes.h).
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace voxc::glsl {

/// What stands in the text around a thing, and means nothing to a compiler.
struct Notes {
  std::vector<std::string> above; ///< Whole lines of comments, "//" included; "" is an empty line.
  std::string behind;             ///< The comment that ends its line, or "".
};

/// A value. By kind, what `text` is, and what the operands are:
struct Expression {
  enum class Kind {
    Literal,     ///< A number as it is written, or true, or false.
    Name,        ///< Of a variable or a constant.
    Call,        ///< A function's name, or a type's, and its arguments.
    Member,      ///< A member's name, or a swizzle, of what.
    Index,       ///< "": which, and the index.
    Prefix,      ///< An operator, and to what it is applied.
    Postfix,     ///< ++ or --, likewise.
    Binary,      ///< An operator, its left side, its right one.
    Conditional, ///< "": the condition, and the value of either case.
    Assignment,  ///< = or an operator with it, to what, and what.
  };

  Kind kind = Kind::Literal;
  std::string text = {};
  std::vector<Expression> operands = {};
  bool isGrouped = false; ///< It stands in parentheses, whether these are needed or not.
  std::string type = {};  ///< By its name; "" before `verify` (Glsl/Verify.h) has told it.

  bool is(Kind other, const std::string &otherText) const { return kind == other && text == otherText; }
};

/// A variable, a constant, or a member of a struct or a block. Several that one statement declares have the
/// same type.
struct Variable {
  std::string type;
  std::string name;
  std::vector<Expression> sizes =
      {}; ///< Of an array, of each dimension; one without operands and text: open.
  std::vector<Expression> initial = {}; ///< One, or none.
  Notes notes = {};
};

struct Statement {
  enum class Kind { Block, Declaration, Expression, If, While, For, Return, Break, Continue };

  Kind kind = Kind::Block;
  Notes notes = {};
  std::string qualifiers = {};          ///< Of a declaration: "const", "precise", or "". Of a loop: "unroll".
  std::vector<Variable> variables = {}; ///< Of a declaration.
  /// The expression; the condition of if and while; what is returned, if anything. Of a loop with for: the
  /// condition and the step, each as a vector of one or none would be, so that both may be absent.
  std::vector<Expression> expressions = {};
  std::vector<Expression> step = {};
  std::vector<Statement> begin = {}; ///< Of a loop with for: a declaration or an expression, or none.
  std::vector<Statement> body = {};  ///< Of a block, of a loop; what follows where a condition holds.
  bool isBraced = false;             ///< The body stands in braces.
  std::vector<Statement> otherwise = {};
  bool isElseBraced = false;
};

/// How an argument comes to a function and back.
enum class Passing { In, Const, Out, InOut };

struct Parameter {
  Passing passing = Passing::In;
  std::string type = {};
  std::string name = {};
};

/// What stands outermost.
struct Declaration {
  enum class Kind {
    Directive, ///< A line of the preprocessor: `name`.
    Remark,    ///< A comment of its own: the notes.
    Variable,  ///< `qualifiers` and one variable.
    Structure, ///< `name`, with members.
    Block,     ///< Words outside of the kernel, with qualifiers and members.
    Layout,    ///< Qualifiers alone: layout(local_size_x = 64) in.
    Function,
  };

  Kind kind = Kind::Remark;
  Notes notes = {};
  std::string qualifiers = {}; ///< As they are written: "const", "layout(std430, set = 0) readonly buffer".
  std::string name = {};
  std::vector<Variable> variables = {}; ///< Members; or the one variable.
  std::string type = {};                ///< That a function returns.
  std::vector<Parameter> parameters = {};
  std::vector<Statement> body = {};
  bool isSeldom = false;    ///< A function that is seldom called: OUT_OF_LINE.
  bool isInline = false;    ///< A function that stands for the value it returns: INLINE.
  bool isPrototype = false; ///< A function without its body.
  bool leads = false;       ///< It is what the module is for: `lead` (Glsl/Passes.h) puts it first.
  bool isElsewhere = false; ///< In text before the module's: it is not printed.
};

struct Module {
  std::vector<Declaration> declarations;
};

} // namespace voxc::glsl
