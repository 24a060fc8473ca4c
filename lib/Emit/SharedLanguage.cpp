// The macros of text that is GLSL and C++ at once.
#include "Emit/SharedLanguage.h"

namespace voxc {

std::string SharedLanguage::parameter(const glsl::Parameter &parameter) const {
  static constexpr const char *kMacros[] = {"", "VOXC_IN", "VOXC_OUT", "VOXC_INOUT"};
  const std::string macro = kMacros[static_cast<std::size_t>(parameter.passing)];
  return macro + (macro.empty() ? parameter.type : "(" + parameter.type + ")") + " " + parameter.name;
}

std::string SharedLanguage::beforeFunction(const glsl::Declaration &function) const {
  return function.isSeldom ? "VOXC_SELDOM " : "VOXC_FUNCTION ";
}

std::string SharedLanguage::beforeLocal(const std::string &qualifiers) const {
  return qualifiers == "precise" ? "VOXC_PRECISE " : Printer::beforeLocal(qualifiers);
}

} // namespace voxc
