// Names and types, from the first declaration to the last.
#include "Glsl/Verify.h"

#include "Glsl/Operators.h"
#include "Glsl/Print.h"
#include "Glsl/Types.h"

#include <algorithm>
#include <map>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;

class Verifier {
public:
  explicit Verifier(std::span<const External> externals) {
    for (const External &external : externals)
      globals_.emplace(external.name, external.type);
  }

  Expected<void> verify(Module &module) {
    for (Declaration &declaration : module.declarations) {
      this->declaration(declaration);
      if (!problem_.empty())
        return Error::input(nameOf(declaration) + ": " + problem_);
    }
    return {};
  }

private:
  static std::string nameOf(const Declaration &declaration) {
    return declaration.kind == Declaration::Kind::Variable ? declaration.variables[0].name : declaration.name;
  }

  void declaration(Declaration &declaration) {
    using Outer = Declaration::Kind;
    switch (declaration.kind) {
    case Outer::Variable:
      variable(declaration.variables[0], globals_);
      break;
    case Outer::Structure:
      for (Variable &member : declaration.variables)
        variable(member, members_[declaration.name]);
      structs_[declaration.name] = &declaration;
      break;
    case Outer::Block: // Its members are outermost, and also those of what its address leads to.
      for (Variable &member : declaration.variables) {
        variable(member, globals_);
        variable(member, members_[declaration.name]);
      }
      structs_[declaration.name] = &declaration;
      break;
    case Outer::Function:
      function(declaration);
      break;
    case Outer::Directive:
    case Outer::Remark:
    case Outer::Layout:
      break;
    }
  }

  void function(Declaration &declaration) {
    locals_.clear();
    result_ = declaration.type;
    for (const Parameter &parameter : declaration.parameters)
      locals_[parameter.name] = parameter.type;
    for (Statement &inner : declaration.body)
      statement(inner);
    functions_.emplace(declaration.name, &declaration);
  }

  using Names = std::map<std::string, std::string, std::less<>>;

  /// Arrays are of the type of their elements with "[]" for each dimension.
  void variable(Variable &variable, Names &names) {
    std::string type = variable.type;
    for (Expression &size : variable.sizes) {
      if (size.kind != Kind::Literal || !size.text.empty()) // Else it is open.
        index(size);
      type += "[]";
    }
    for (Expression &initial : variable.initial)
      expect(initial, type);
    names[variable.name] = type;
  }

  void index(Expression &expression) {
    if (const std::string &found = type(expression); found != "int" && found != "uint")
      fail(expression, "is no index");
  }

  void statement(Statement &statement) {
    if (statement.qualifiers == "unroll")
      fail(statement.expressions[0], "has no bounds that are numbers, in a loop to unroll");
    for (Statement &begin : statement.begin)
      this->statement(begin);
    for (Variable &one : statement.variables)
      variable(one, locals_);
    const bool isCondition = statement.kind == Statement::Kind::If ||
                             statement.kind == Statement::Kind::While ||
                             statement.kind == Statement::Kind::For;
    for (Expression &value : statement.expressions)
      if (isCondition)
        expect(value, "bool");
      else if (statement.kind == Statement::Kind::Return)
        expect(value, result_);
      else
        type(value);
    for (Expression &step : statement.step)
      type(step);
    for (auto *const some : {&statement.body, &statement.otherwise})
      for (Statement &inner : *some)
        this->statement(inner);
  }

  static bool isFloat(std::string_view component) { return component == "float" || component == "double"; }

  /// Floats become doubles by themselves, which only GLSL and C++ have.
  static bool converts(std::string_view from, std::string_view to) {
    const Shape a = shapeOf(from), b = shapeOf(to);
    return from == to || (a.component == "float" && b.component == "double" && a.size == b.size);
  }

  void fail(const Expression &where, const std::string &what) {
    if (problem_.empty())
      problem_ = "'" + print(where) + "' " + what;
  }

  void expect(Expression &expression, const std::string &wanted) {
    if (const std::string &found = type(expression); !converts(found, wanted))
      fail(expression, "is of type '" + found + "' where '" + wanted + "' is wanted");
  }

  const std::string &type(Expression &expression) {
    if (problem_.empty())
      expression.type = find(expression);
    return expression.type;
  }

  std::string find(Expression &expression) {
    std::vector<Expression> &operands = expression.operands;
    for (Expression &operand : operands)
      type(operand);
    switch (expression.kind) {
    case Kind::Literal:
      return ofLiteral(expression.text);
    case Kind::Name:
      return ofName(expression);
    case Kind::Call:
      return ofCall(expression);
    case Kind::Member:
      return ofMember(expression);
    case Kind::Index:
      return ofIndex(expression);
    case Kind::Prefix:
    case Kind::Postfix:
      return operands[0].type;
    case Kind::Binary:
      return ofBinary(expression, expression.text);
    case Kind::Conditional:
      expect(operands[0], "bool");
      expect(operands[2], operands[1].type);
      return operands[1].type;
    case Kind::Assignment:
      return ofAssignment(expression);
    }
    return "";
  }

  static std::string ofLiteral(const std::string &text) {
    if (text == "true" || text == "false")
      return "bool";
    if (text.ends_with('u'))
      return "uint";
    return !text.starts_with("0x") && text.find_first_of(".e") != std::string::npos ? "float" : "int";
  }

  std::string ofName(const Expression &expression) {
    for (const Names *const names : {&locals_, &globals_})
      if (const auto found = names->find(expression.text); found != names->end())
        return found->second;
    fail(expression, "is not declared");
    return "";
  }

  std::string ofCall(Expression &call) {
    if (shapeOf(call.text).isNumeric())
      return call.text;
    if (const auto found = structs_.find(call.text); found != structs_.end())
      return ofConstructor(call, *found->second);
    const auto [begin, end] = functions_.equal_range(call.text);
    for (auto at = begin; at != end; ++at)
      if (takes(*at->second, call))
        return at->second->type;
    std::string first = call.operands.empty() ? "" : call.operands[0].type;
    for (const Expression &operand : call.operands)
      if (shapeOf(first).component == "float" && shapeOf(operand.type).component == "double")
        first = typeOf("double", shapeOf(first).size);
    if (const std::string builtin = builtinType(call.text, first); begin == end && !builtin.empty())
      return builtin;
    if (const auto external = globals_.find(call.text); external != globals_.end())
      return external->second;
    fail(call, begin == end ? "calls what is not declared" : "gives a function what it does not take");
    return "";
  }

  static bool takes(const Declaration &function, const Expression &call) {
    return std::ranges::equal(
        function.parameters, call.operands,
        [](const Parameter &p, const Expression &e) { return converts(e.type, p.type); });
  }

  std::string ofConstructor(Expression &call, const Declaration &structure) {
    if (structure.kind == Declaration::Kind::Structure &&
        !std::ranges::equal(structure.variables, call.operands,
                            [](const Variable &m, const Expression &e) { return converts(e.type, m.type); }))
      fail(call, "does not give a struct all its members");
    return call.text;
  }

  std::string ofMember(const Expression &expression) {
    const std::string &whole = expression.operands[0].type;
    if (const auto found = members_.find(whole); found != members_.end())
      if (const auto member = found->second.find(expression.text); member != found->second.end())
        return member->second;
    std::string swizzle = swizzleOf(whole, expression.text);
    if (swizzle.empty())
      fail(expression, "has no such member, as '" + whole + "'");
    return swizzle;
  }

  std::string ofIndex(Expression &expression) {
    const std::string &whole = expression.operands[0].type;
    index(expression.operands[1]);
    if (whole.ends_with("[]"))
      return whole.substr(0, whole.size() - 2);
    if (shapeOf(whole).size > 1)
      return std::string(shapeOf(whole).component);
    fail(expression, "is no part of an array or a vector");
    return "";
  }

  /// A vector beside a number, or two of one type. Shifts take numbers of bits of any sign.
  std::string ofBinary(Expression &expression, std::string_view sign) {
    const std::string &left = expression.operands[0].type, &right = expression.operands[1].type;
    const Shape a = shapeOf(left), b = shapeOf(right);
    const bool isShift = sign == "<<" || sign == ">>";
    const bool areFloats = isFloat(a.component) && isFloat(b.component);
    const bool fits =
        isShift ? b.component == "int" || b.component == "uint" : a.component == b.component || areFloats;
    const bool isOneSided = (a.size == 1) != (b.size == 1);
    if (!fits || (a.size != b.size && !(isOneSided && a.isNumeric() && b.isNumeric())))
      fail(expression, "has '" + left + "' and '" + right + "' on its sides");
    const int rank = rankOfSign(sign);
    const bool isTruth = rank <= rankOfSign("&&") || rank == rankOfSign("==") || rank == rankOfSign("<");
    return isTruth                                 ? "bool"
           : isShift || a.component == b.component ? std::string(b.size > a.size ? right : left)
                                                   : typeOf("double", std::max(a.size, b.size));
  }

  std::string ofAssignment(Expression &expression) {
    std::vector<Expression> &operands = expression.operands;
    if (expression.text == "=")
      expect(operands[1], operands[0].type);
    else
      ofBinary(expression, std::string_view(expression.text).substr(0, expression.text.size() - 1));
    return operands[0].type;
  }

  Names globals_, locals_;
  std::map<std::string, Names, std::less<>> members_;
  std::map<std::string, const Declaration *, std::less<>> structs_;
  std::multimap<std::string, const Declaration *, std::less<>> functions_;
  std::string result_;
  std::string problem_;
};

} // namespace

Expected<void> verify(Module &module, std::span<const External> externals) {
  return Verifier(externals).verify(module);
}

} // namespace voxc::glsl
