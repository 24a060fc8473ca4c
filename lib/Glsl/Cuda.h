// CUDA C++: functions for a device and for its host.
#pragma once

#include "Glsl/Cpp.h"

namespace voxc::glsl {

/// Beside cpu-runtime/voxc_glsl.h, as `CppHeader`. Arguments come by value: a reference to a constant of the
/// host would lead a device nowhere.
class Cuda : public CppHeader {
protected:
  std::string parameter(const Parameter &parameter) const override;
  std::string beforeFunction(const Declaration &function) const override;
  std::string beforeGlobal(const std::string &qualifiers) const override;
};

/// Makes functions of constants that are vectors, which a device could not refer to, and of `precise` sums
/// and products those that are rounded each. The module is verified.
void forCuda(Module &module);

} // namespace voxc::glsl
