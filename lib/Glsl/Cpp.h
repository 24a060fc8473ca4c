// C++: functions as members of a class, or of a namespace.
#pragma once

#include "Glsl/Printer.h"

namespace voxc::glsl {

/// Kernels as the body of a class, beside cpu-runtime/voxc_glsl.h: `inout` and `out` parameters are
/// references, `const` ones references to const; constants are static members; numbers with a point or an
/// exponent are floats. A module for it has no swizzles of several components, no arrays as parameters or
/// results (a struct carries one) and no macros but OUT_OF_LINE.
class Cpp : public Printer {
protected:
  std::string literal(const std::string &text) const override;
  std::string parameter(const Parameter &parameter) const override;
  /// C++ is compiled so that nothing is contracted or reordered: it has no word for `precise`.
  std::string beforeLocal(const std::string &qualifiers) const override;
  std::string beforeGlobal(const std::string &qualifiers) const override;
  /// What stands before a constant.
  virtual std::string beforeConstant() const { return "static inline const "; }
};

/// The same as functions of a namespace.
class CppHeader : public Cpp {
protected:
  std::string beforeFunction(const Declaration &function) const override;
  std::string beforeConstant() const override { return "const "; }
};

} // namespace voxc::glsl
