// What CUDA C++ spells in its own way.
#include "Glsl/Cuda.h"

#include "Glsl/Passes.h"
#include "Glsl/Types.h"
#include "Glsl/Visit.h"

#include <array>
#include <utility>

namespace voxc::glsl {

std::string Cuda::parameter(const Parameter &parameter) const {
  const bool isValue = parameter.passing == Passing::Const;
  return CppHeader::parameter({isValue ? Passing::In : parameter.passing, parameter.type, parameter.name});
}

std::string Cuda::beforeFunction(const Declaration &function) const {
  return std::string(function.isSeldom ? "VOXC_SELDOM " : "") + "VOXC_DEVICE static inline ";
}

/// Known when it is compiled, so that a device needs no variable of the host.
std::string Cuda::beforeGlobal(const std::string &qualifiers) const {
  return qualifiers == "const" ? "constexpr " : CppHeader::beforeGlobal(qualifiers);
}

namespace {

/// const ivec3 SIZE = ivec3(4); becomes ivec3 SIZE() { return ivec3(4); }.
Declaration functionOf(Declaration constant) {
  Variable &variable = constant.variables[0];
  Declaration function;
  function.kind = Declaration::Kind::Function;
  function.notes = std::move(constant.notes);
  function.type = variable.type;
  function.name = variable.name;
  Statement result;
  result.kind = Statement::Kind::Return;
  result.expressions = std::move(variable.initial);
  function.body.push_back(std::move(result));
  return function;
}

void makeFunctionsOfVectors(Module &module) {
  Names names;
  for (Declaration &declaration : module.declarations) {
    if (declaration.kind == Declaration::Kind::Variable && declaration.qualifiers == "const" &&
        shapeOf(declaration.variables[0].type).size > 1) {
      names.insert(declaration.variables[0].name);
      declaration = functionOf(std::move(declaration));
    }
    forEachExpression(declaration, [&](Expression &expression) {
      if (expression.kind == Expression::Kind::Name && names.contains(expression.text))
        expression.kind = Expression::Kind::Call;
    });
  }
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kRounded = {
    {{"+", "rounded_sum"}, {"-", "rounded_difference"}, {"*", "rounded_product"}}};

void roundEach(Expression &expression) {
  forEachExpression(expression, [](Expression &inner) {
    for (const auto &[sign, function] : kRounded)
      if (inner.is(Expression::Kind::Binary, std::string(sign))) {
        inner.kind = Expression::Kind::Call;
        inner.text = function;
        inner.isGrouped = false;
      }
  });
}

} // namespace

void forCuda(Module &module) {
  makeFunctionsOfVectors(module);
  for (Declaration &declaration : module.declarations)
    for (Statement &statement : declaration.body)
      forEachStatement(statement, [](Statement &inner) {
        if (inner.qualifiers == "precise")
          for (Variable &variable : inner.variables)
            for (Expression &initial : variable.initial)
              roundEach(initial);
      });
}

} // namespace voxc::glsl
