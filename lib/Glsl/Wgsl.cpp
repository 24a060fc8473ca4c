// What WGSL spells in its own way.
#include "Glsl/Wgsl.h"

#include "Glsl/Spelling.h"
#include "Glsl/Types.h"
#include "Glsl/Visit.h"

#include <algorithm>
#include <array>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;

constexpr std::array<Spelling, 5> kComponents = {
    {{"float", "f32"}, {"int", "i32"}, {"uint", "u32"}, {"bool", "bool"}, {"double", "f64"}}};

/// Those that give what is an int in GLSL in the type of their argument.
constexpr std::array<Spelling, 3> kBits = {
    {{"bitCount", "countOneBits"}, {"findMSB", "firstLeadingBit"}, {"findLSB", "firstTrailingBit"}}};

/// Those that take bits for those of another type.
constexpr std::array<std::string_view, 4> kCasts = {"floatBitsToUint", "floatBitsToInt", "uintBitsToFloat",
                                                    "intBitsToFloat"};

/// Of what leaves call their variables, the words that WGSL keeps.
constexpr std::array<std::string_view, 24> kReserved = {
    "from",   "of",     "move",   "pass",   "self",  "final",  "get",    "set",
    "ref",    "common", "target", "where",  "with",  "using",  "shared", "trait",
    "module", "meta",   "public", "static", "super", "active", "as",     "is"};

bool isComparison(const Expression &expression) {
  return expression.kind == Kind::Call && !comparisonOf(expression.text).empty();
}

/// uint(bitCount(a)) of a uint, which a count of bits is here without being asked.
bool isCountAsItIs(const Expression &call) {
  return call.operands.size() == 1 && call.operands[0].kind == Kind::Call &&
         !spelled(kBits, call.operands[0].text).empty() && call.operands[0].operands[0].type == call.text;
}

bool isBitwise(std::string_view sign) { return sign == "&" || sign == "|" || sign == "^"; }
bool isShift(std::string_view sign) { return sign == "<<" || sign == ">>"; }
bool isEquality(std::string_view sign) { return sign == "==" || sign == "!="; }

} // namespace

void Wgsl::begin(const Module &module) {
  functions_.clear();
  for (const Declaration &declaration : module.declarations)
    if (declaration.kind == Declaration::Kind::Function)
      functions_[declaration.name] = &declaration;
}

void Wgsl::beginFunction(const Declaration &function) {
  pointers_.clear();
  for (const Parameter &parameter : function.parameters)
    if (parameter.passing == Passing::Out || parameter.passing == Passing::InOut)
      pointers_.insert(parameter.name);
  written_ = writtenIn(function, functions_);
}

std::string Wgsl::type(const std::string &name) const {
  const Shape shape = shapeOf(name);
  const std::string component(spelled(kComponents, shape.component));
  return shape.size == 0   ? name
         : shape.size == 1 ? component
                           : "vec" + std::to_string(shape.size) + "<" + component + ">";
}

std::string Wgsl::typeOf(const Variable &variable) const {
  std::string type = this->type(variable.type);
  for (auto size = variable.sizes.rbegin(); size != variable.sizes.rend(); ++size)
    type.insert(0, "array<").append(", ").append(text(*size)).append(">");
  return type;
}

std::string Wgsl::parameter(const Parameter &parameter) const {
  const std::string type = this->type(parameter.type);
  return parameter.name + ": " + (pointers_.contains(parameter.name) ? "ptr<function, " + type + ">" : type);
}

std::string Wgsl::head(const Declaration &function) const {
  std::vector<std::string> parameters;
  parameters.reserve(function.parameters.size());
  for (const Parameter &one : function.parameters)
    parameters.push_back(parameter(one));
  const std::string result = function.type == "void" ? "" : " -> " + type(function.type);
  return "fn " + function.name + "(" + joined(parameters) + ")" + result;
}

std::string Wgsl::member(const Variable &member) const { return member.name + ": " + typeOf(member) + ","; }

std::string Wgsl::global(const Declaration &variable) const {
  const Variable &one = variable.variables[0];
  return (variable.qualifiers == "const" ? "const " : "var<private> ") + one.name + ": " + typeOf(one) +
         initial(one) + ";";
}

/// A statement each.
std::string Wgsl::variables(const std::vector<Variable> &variables) const {
  std::string text;
  for (const Variable &one : variables) {
    const bool isFixed = !written_.contains(one.name) && !one.initial.empty();
    const std::string type = isFixed ? "" : ": " + typeOf(one);
    text +=
        (text.empty() ? "" : "; ") + std::string(isFixed ? "let " : "var ") + one.name + type + initial(one);
  }
  return text;
}

int Wgsl::rank(const Expression &expression) const {
  if (isComparison(expression))
    return rankOfSign(comparisonOf(expression.text));
  const bool isCall = expression.kind == Kind::Conditional ||
                      (expression.kind == Kind::Binary && isEquality(expression.text) &&
                       shapeOf(expression.operands[0].type).size > 1);
  const bool isPointer = expression.kind == Kind::Name && pointers_.contains(expression.text);
  return isCall ? kPostfixRank : isPointer ? kPrefixRank : Printer::rank(expression);
}

std::string Wgsl::bare(const Expression &expression) const {
  const std::vector<Expression> &operands = expression.operands;
  switch (expression.kind) {
  case Kind::Name:
    return (pointers_.contains(expression.text) ? "*" : "") + expression.text;
  case Kind::Call:
    return call(expression);
  case Kind::Binary:
    return binary(expression);
  case Kind::Assignment:
    return assignment(expression);
  case Kind::Conditional:
    return "select(" + list({operands[2], operands[1], operands[0]}) + ")";
  default:
    return Printer::bare(expression);
  }
}

/// A value beside one of another size: a number becomes a vector.
std::string Wgsl::beside(const Expression &expression, const std::string &type, int leastRank) const {
  const bool isNumber = shapeOf(expression.type).size == 1 && shapeOf(type).size > 1;
  return isNumber ? this->type(type) + "(" + alone(expression) + ")" : text(expression, leastRank);
}

std::string Wgsl::call(const Expression &call) const {
  const std::vector<Expression> &operands = call.operands;
  if (call.text == "VOXC_LOAD")
    return load_ + "(" + list(operands) + ")";
  if (call.text == "VOXC_INDEX")
    return text(operands[0]);
  if (const std::string_view sign = comparisonOf(call.text); !sign.empty())
    return text(operands[0], kPostfixRank) + " " + std::string(sign) + " " + text(operands[1], kPostfixRank);
  if (const std::string_view name = spelled(kBits, call.text); !name.empty()) {
    const std::string count = std::string(name) + "(" + list(operands) + ")";
    return operands[0].type == call.type ? count : type(call.type) + "(" + count + ")";
  }
  if (isCountAsItIs(call))
    return std::string(spelled(kBits, operands[0].text)) + "(" + list(operands[0].operands) + ")";
  if (std::ranges::find(kCasts, call.text) != kCasts.end())
    return "bitcast<" + type(call.type) + ">(" + list(operands) + ")";
  if (call.text == "mix" && shapeOf(operands[2].type).component == "bool")
    return "select(" + list(operands) + ")";
  if (call.text == "not")
    return "!" + text(operands[0], kPrefixRank);
  if (const auto found = functions_.find(call.text); found != functions_.end()) {
    std::vector<std::string> arguments;
    arguments.reserve(operands.size());
    for (std::size_t i = 0; i < operands.size(); ++i)
      arguments.push_back(argument(operands[i], found->second->parameters[i]));
    return call.text + "(" + joined(arguments) + ")";
  }
  std::vector<std::string> arguments; // Of a function of the language all have one type.
  arguments.reserve(operands.size());
  const bool isBuiltin = !builtinType(call.text, call.type).empty();
  for (const Expression &operand : operands)
    arguments.push_back(isBuiltin ? beside(operand, call.type, kAssignmentRank) : alone(operand));
  return type(call.text) + "(" + joined(arguments) + ")";
}

/// Of a pointer the pointer, and else the address of what is written to.
std::string Wgsl::argument(const Expression &argument, const Parameter &parameter) const {
  if (parameter.passing != Passing::Out && parameter.passing != Passing::InOut)
    return alone(argument);
  const bool isPointer = argument.kind == Kind::Name && pointers_.contains(argument.text);
  return isPointer ? argument.text : "&" + text(argument, kPrefixRank);
}

/// Operands of operators on bits stand in parentheses, but for those of the same one. So does what && has
/// beside ||.
std::string Wgsl::binary(const Expression &expression) const {
  const std::string &sign = expression.text;
  const Expression &left = expression.operands[0], &right = expression.operands[1];
  if (isShift(sign))
    return beside(left, expression.type, kPrefixRank) + " " + sign + " " + shiftOf(right, expression.type);
  const int own = Printer::rank(expression);
  const bool isTight = isBitwise(sign) || sign == "||";
  const int least = isTight                                      ? kPrefixRank
                    : isEquality(sign) || own == rankOfSign("<") ? rankOfSign("+")
                                                                 : own;
  const int leastLeft = isTight && left.is(Kind::Binary, sign) ? own : least;
  const bool fits = !isBitwise(sign) || shapeOf(left.type).size == shapeOf(right.type).size;
  const std::string text = (fits ? this->text(left, leastLeft) : beside(left, expression.type, leastLeft)) +
                           " " + sign + " " +
                           (fits ? this->text(right, isTight ? least : std::max(least, own + 1))
                                 : beside(right, expression.type, least));
  const bool isVector = isEquality(sign) && shapeOf(left.type).size > 1;
  return isVector ? (sign == "==" ? "all(" : "any(") + text + ")" : text;
}

/// The number of bits by which a value is shifted: a uint, or one for each component.
std::string Wgsl::shiftOf(const Expression &by, const std::string &shifted) const {
  const int size = shapeOf(by.type).size, wanted = shapeOf(shifted).size;
  std::string number = text(by, kPrefixRank);
  if (by.kind == Kind::Literal)
    number += number.ends_with('u') ? "" : "u";
  else if (shapeOf(by.type).component != "uint")
    number = type(glsl::typeOf("uint", size)) + "(" + alone(by) + ")";
  return size < wanted ? type(glsl::typeOf("uint", wanted)) + "(" + number + ")" : number;
}

std::string Wgsl::assignment(const Expression &expression) const {
  const Expression &to = expression.operands[0], &value = expression.operands[1];
  const bool isShifted = expression.text == "<<=" || expression.text == ">>=";
  return text(to, kPrefixRank) + " " + expression.text + " " +
         (isShifted ? shiftOf(value, to.type) : text(value));
}

namespace {

/// A select needs no parentheses, and bodies need braces.
void tidy(Module &module) {
  for (Declaration &declaration : module.declarations) {
    forEachExpression(declaration, [](Expression &expression) {
      expression.isGrouped &= expression.kind != Kind::Conditional;
    });
    for (Statement &statement : declaration.body)
      forEachStatement(statement, [](Statement &inner) {
        inner.isBraced |= !inner.body.empty();
        const bool isChain = inner.otherwise.size() == 1 && inner.otherwise[0].kind == Statement::Kind::If &&
                             !inner.isElseBraced;
        inner.isElseBraced |= !inner.otherwise.empty() && !isChain;
      });
  }
}

} // namespace

void forWgsl(Module &module) {
  renameOverloads(module);
  unfold(module, Unfolding::Calls);
  renameReserved(module, kReserved);
  copyParameters(module);
  tidy(module);
}

} // namespace voxc::glsl
