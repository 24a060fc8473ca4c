// What C++ spells in its own way.
#include "Glsl/Cpp.h"

namespace voxc::glsl {

std::string Cpp::literal(const std::string &text) const {
  const bool isHex = text.starts_with("0x");
  const bool isFloat =
      !isHex && text.find_first_of(".eE") != std::string::npos && text != "true" && text != "false";
  return isFloat && text.back() != 'f' && text.back() != 'F' ? text + "f" : text;
}

std::string Cpp::parameter(const Parameter &parameter) const {
  const std::string before = parameter.passing == Passing::Const ? "const " : "";
  const std::string reference = parameter.passing != Passing::In ? " &"
                                : parameter.type.ends_with('*')  ? ""
                                                                 : " ";
  return before + type(parameter.type) + reference + parameter.name;
}

std::string Cpp::beforeLocal(const std::string &qualifiers) const {
  return qualifiers == "precise" ? "" : Printer::beforeLocal(qualifiers);
}

std::string Cpp::beforeGlobal(const std::string &qualifiers) const {
  return qualifiers == "const" ? beforeConstant() : Printer::beforeGlobal(qualifiers);
}

std::string CppHeader::beforeFunction(const Declaration &function) const {
  return function.isSeldom ? "[[gnu::noinline, gnu::cold, maybe_unused]] static " : "static inline ";
}

} // namespace voxc::glsl
