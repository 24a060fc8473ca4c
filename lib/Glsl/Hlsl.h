// HLSL of shader model 5, and what a module has to become before it is printed in it.
#pragma once

#include "Glsl/Printer.h"

namespace voxc::glsl {

/// Of a module that `forHlsl` has made ready, and `verify` before that.
class Hlsl : public Printer {
protected:
  std::string type(const std::string &name) const override;
  std::string bare(const Expression &expression) const override;
  int rank(const Expression &expression) const override;
  std::string beforeFunction(const Declaration &function) const override;
  std::string beforeGlobal(const std::string &qualifiers) const override;

private:
  std::string call(const Expression &expression) const;
};

/// Makes statements of what HLSL would evaluate whether it is asked for or not, and functions of the
/// constructors of structs, which it lacks. The module is verified.
void forHlsl(Module &module);

} // namespace voxc::glsl
