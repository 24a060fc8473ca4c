// Printing a plan as text: the construction code in C++ and the intersection kernel in GLSL.
#pragma once

#include "voxc/Plan/Plan.h"

#include <string>
#include <string_view>

namespace voxc {

/// construct.cpp: one function a level; needs only `voxc_construct.h` beside it.
std::string emitConstruct(const Plan &plan);

/// intersect.glsl: a complete compute shader; one function a level, a unit and a root function.
std::string emitIntersect(const Plan &plan);

/// The text of voxc_construct.h, the one header that construct.cpp includes.
std::string_view constructHeader();

} // namespace voxc
