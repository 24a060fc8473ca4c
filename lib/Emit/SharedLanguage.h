// Text that is GLSL and C++ at once, by macros that shaders-runtime/header/languages/shared.begin defines for
// either.
#pragma once

#include "Glsl/Printer.h"

namespace voxc {

class SharedLanguage : public glsl::Printer {
protected:
  std::string parameter(const glsl::Parameter &parameter) const override;
  std::string beforeFunction(const glsl::Declaration &function) const override;
  std::string beforeLocal(const std::string &qualifiers) const override;
};

} // namespace voxc
