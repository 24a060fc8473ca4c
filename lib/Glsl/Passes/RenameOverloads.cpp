// A name for each function, for languages without overloads.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

namespace voxc::glsl {
namespace {

struct Renamed {
  std::vector<std::string> types;
  std::string name;
};

std::vector<std::string> typesOf(const Declaration &function) {
  std::vector<std::string> types;
  types.reserve(function.parameters.size());
  for (const Parameter &parameter : function.parameters)
    types.push_back(parameter.type);
  return types;
}

std::string nameAfter(const Declaration &function) {
  std::string type = function.parameters.empty() ? "none" : function.parameters.back().type;
  type = type.substr(type.rfind('_') + 1); // Without the prefix of a module.
  std::ranges::transform(type, type.begin(), [](unsigned char c) { return std::tolower(c); });
  return function.name + "_" + type;
}

} // namespace

void renameOverloads(Module &module) {
  std::map<std::string, std::vector<Renamed>> functions;
  for (Declaration &declaration : module.declarations) {
    if (declaration.kind == Declaration::Kind::Function) {
      std::vector<Renamed> &same = functions[declaration.name];
      same.push_back({typesOf(declaration), same.empty() ? declaration.name : nameAfter(declaration)});
      declaration.name = same.back().name;
    }
    forEachExpression(declaration, [&](Expression &expression) {
      const auto found = functions.find(expression.text);
      if (expression.kind != Expression::Kind::Call || found == functions.end())
        return;
      const auto fits = [&](const Renamed &one) {
        return std::ranges::equal(one.types, expression.operands, {}, {}, &Expression::type);
      };
      if (const auto one = std::ranges::find_if(found->second, fits); one != found->second.end())
        expression.text = one->name;
    });
  }
}

} // namespace voxc::glsl
