// What HLSL spells in its own way.
#include "Glsl/Hlsl.h"

#include "Glsl/Passes.h"
#include "Glsl/Spelling.h"
#include "Glsl/Types.h"
#include "Glsl/Visit.h"

#include <array>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;

/// Functions of one argument, or more, that have another name.
constexpr std::array<Spelling, 7> kNames = {{{"floatBitsToUint", "asuint"},
                                             {"floatBitsToInt", "asint"},
                                             {"uintBitsToFloat", "asfloat"},
                                             {"intBitsToFloat", "asfloat"},
                                             {"roundEven", "round"},
                                             {"fma", "mad"},
                                             {"not", "!"}}};

/// Those that give what is an int in GLSL as a uint.
constexpr std::array<Spelling, 3> kBits = {
    {{"bitCount", "countbits"}, {"findMSB", "firstbithigh"}, {"findLSB", "firstbitlow"}}};

constexpr std::array<std::string_view, 12> kReserved = {"point",  "line",   "sample",   "linear",
                                                        "pass",   "half",   "out",      "string",
                                                        "vector", "matrix", "register", "texture"};

/// Whether == or != of two vectors, which HLSL has for each component.
bool comparesVectors(const Expression &expression) {
  return (expression.is(Kind::Binary, "==") || expression.is(Kind::Binary, "!=")) &&
         shapeOf(expression.operands[0].type).size > 1;
}

/// Of a number for all components of a vector, which is a cast.
bool isSplat(const Expression &call) {
  return shapeOf(call.text).size > 1 && call.operands.size() == 1 && shapeOf(call.operands[0].type).size == 1;
}

} // namespace

std::string Hlsl::type(const std::string &name) const {
  const Shape shape = shapeOf(name);
  return shape.size > 1 ? std::string(shape.component) + std::to_string(shape.size) : name;
}

int Hlsl::rank(const Expression &expression) const {
  const bool isCast = expression.kind == Kind::Call && isSplat(expression);
  const bool isComparison = expression.kind == Kind::Call && !comparisonOf(expression.text).empty();
  return isCast                        ? kPrefixRank
         : isComparison                ? rankOfSign(comparisonOf(expression.text))
         : comparesVectors(expression) ? kPostfixRank
                                       : Printer::rank(expression);
}

std::string Hlsl::bare(const Expression &expression) const {
  if (comparesVectors(expression))
    return (expression.text == "==" ? "all(" : "any(") + Printer::bare(expression) + ")";
  return expression.kind == Kind::Call ? call(expression) : Printer::bare(expression);
}

std::string Hlsl::call(const Expression &call) const {
  const std::vector<Expression> &operands = call.operands;
  if (isSplat(call))
    return "(" + type(call.text) + ")" + text(operands[0], kPrefixRank);
  if (const std::string_view sign = comparisonOf(call.text); !sign.empty())
    return text(operands[0], rankOfSign(sign)) + " " + std::string(sign) + " " +
           text(operands[1], rankOfSign(sign) + 1);
  if (const std::string_view name = spelled(kNames, call.text); !name.empty())
    return std::string(name) + "(" + list(operands) + ")";
  if (const std::string_view name = spelled(kBits, call.text); !name.empty())
    return type(call.type) + "(" + std::string(name) + "(" + list(operands) + "))";
  return Printer::bare(call);
}

std::string Hlsl::beforeFunction(const Declaration &) const { return ""; }

std::string Hlsl::beforeGlobal(const std::string &qualifiers) const {
  return qualifiers == "const" ? "static const " : "static " + qualifiers;
}

namespace {

/// Traversal made_traversal(int3 cell, ..): a function for each struct that is made of its members.
Declaration maker(const Declaration &structure, const std::string &name) {
  Declaration function;
  function.kind = Declaration::Kind::Function;
  function.notes.above = {""};
  function.type = structure.name;
  function.name = name;
  Statement made;
  made.kind = Statement::Kind::Declaration;
  made.variables.push_back({structure.name, "made"});
  function.body.push_back(std::move(made));
  const Expression whole = {Kind::Name, "made", {}, false, structure.name};
  for (const Variable &member : structure.variables) {
    function.parameters.push_back({Passing::In, member.type, member.name});
    Statement put;
    put.kind = Statement::Kind::Expression;
    const Expression value = {Kind::Name, member.name, {}, false, member.type};
    put.expressions.push_back(
        {Kind::Assignment, "=", {{Kind::Member, member.name, {whole}, false, member.type}, value}});
    function.body.push_back(std::move(put));
  }
  Statement result;
  result.kind = Statement::Kind::Return;
  result.expressions.push_back(whole);
  function.body.push_back(std::move(result));
  return function;
}

void nameConstructors(Module &module) {
  Names called;
  for (const Declaration &declaration : module.declarations)
    forEachExpression(declaration, [&](const Expression &expression) {
      if (expression.kind == Kind::Call)
        called.insert(expression.text);
    });
  std::vector<Declaration> declarations;
  Names structures;
  for (Declaration &declaration : module.declarations) {
    const bool isMade = declaration.kind == Declaration::Kind::Structure && called.contains(declaration.name);
    declarations.push_back(std::move(declaration));
    if (!isMade)
      continue;
    structures.insert(declarations.back().name);
    declarations.push_back(maker(declarations.back(), "make_" + declarations.back().name));
  }
  module.declarations = std::move(declarations);
  for (Declaration &declaration : module.declarations)
    forEachExpression(declaration, [&](Expression &expression) {
      if (expression.kind == Kind::Call && structures.contains(expression.text))
        expression.text.insert(0, "make_");
    });
}

} // namespace

void forHlsl(Module &module) {
  unfold(module, Unfolding::Effects);
  renameReserved(module, kReserved);
  nameConstructors(module);
}

} // namespace voxc::glsl
