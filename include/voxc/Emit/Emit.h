// Printing a plan as text: the construction code in C++, and the intersection kernel in GLSL and in C++.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Support/EmbeddedFile.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Who runs what a plan is printed as. Construction code is printed of every plan.
enum class EmitTarget {
  Device,    ///< A device of Vulkan: `emitIntersect`.
  Processor, ///< This processor: `emitIntersectCpp` and `emitIntersectHeader`.
  Functions, ///< The shaders and programs of others: `emitHeader`, `emitCHeader`, `emitRayShader`.
  FirstHits, ///< The same in GLSL ES, where rays may have no bounds.
};

/// Why a finished plan is not one for a target, and what would be right; "" if it is. Emitters ask for one
/// that is.
std::string problemOf(const Plan &plan, EmitTarget target);

/// construct.cpp: a struct of constants a level, of which `constructHeaders()` make code.
std::string emitConstruct(const Plan &plan);

/// edit.cpp: the same, to change a sub-volume. The layout can be edited (`whyNoEdits`).
std::string emitEdit(const Plan &plan);

/// Those of `constructHeaders()` that such a text needs beside it.
std::vector<EmbeddedFile> constructHeadersOf(std::string_view text);

/// intersect.glsl: a complete compute shader; one function a level, a unit and a root function.
std::string emitIntersect(const Plan &plan);

/// Whether a function of both C and C++ may have this name: an identifier of ASCII, no keyword, and not main.
bool isFunctionName(std::string_view name);

/// intersect.cpp: the same functions in C++, one ray at a time, behind one extern "C" function named `symbol`
/// of the type `CpuKernel::Function`. Needs only `intersectHeaders()` beside it. The plan's addressing plays
/// no part: the words lie in one array. `countWords`: the kernel counts the words that each ray reads, and no
/// lookups.
std::string emitIntersectCpp(const Plan &plan, std::string_view symbol, bool countWords = false);

/// dispatch.cpp: defines the function `symbol`, which goes to one of three that are compiled of intersect.cpp
/// for levels of x86-64. Each bears its level behind its name: `symbol`.x86_64_v4, .x86_64_v3, .x86_64.
std::string emitDispatchCpp(std::string_view symbol);

/// intersect.h: declares that function in C, with the format and its storage digest.
std::string emitIntersectHeader(const Plan &plan, std::string_view symbol);

/// What functions for the shaders and programs of others are written in.
enum class HeaderLanguage {
  Shared, ///< GLSL 4.50 and C++20 in one text.
  Glsl,   ///< GLSL 4.50.
  GlslEs, ///< GLSL ES 3.00, the language of WebGL 2.
  Cpp,    ///< C++20.
  Cuda,   ///< CUDA C++20, for devices and hosts.
  Hlsl,   ///< HLSL of shader model 5.
  Wgsl,   ///< WGSL, the language of WebGPU.
};

template <>
inline constexpr std::array<std::string_view, 7> kEnumNames<HeaderLanguage> = {
    "shared", "glsl", "essl", "cpp", "cuda", "hlsl", "wgsl"};

/// Functions that trace rays, for the shaders and programs of others, in a text that says how it is used. All
/// that it declares has a name that begins with `headerPrefix(name)`. `plan` is made with `kHeaderPlan`, of a
/// format that stops at voxels alone; `name` is one that `isHeaderName` takes. In GLSL ES `plan` may be made
/// with `kFirstHitPlan`, and then `first` is the only query.
std::string emitHeader(const Plan &plan, std::string_view name,
                       HeaderLanguage language = HeaderLanguage::Shared);

/// voxc_NAME_c.h: the same functions as declarations in C99; and voxc_NAME_c.cpp, which defines them by what
/// `emitHeader` makes of the same plan and name, as "voxc_NAME.h".
std::string emitCHeader(const Plan &plan, std::string_view name);
std::string emitCDefinitions(const Plan &plan, std::string_view name);

/// Functions of GLSL, of as much of it as kernels are written in, as those of another language. `declared`
/// stands before them: it says in GLSL what text around them has, and is not printed. Error: where they are
/// no such functions.
Expected<std::string> emitFunctions(std::string_view functions, std::string_view declared,
                                    HeaderLanguage language);

/// Functions of GLSL on words with carries that HLSL lacks, which kernels in HLSL begin with.
std::string_view carryFunctions();

/// A shader of a pipeline that traces rays. Each value is a file of shaders-runtime/header.
enum class RayStage { Intersection, ClosestHit };

template <> inline constexpr std::array<std::string_view, 2> kEnumNames<RayStage> = {"rint", "rchit"};

/// voxc_NAME.rint and voxc_NAME.rchit: shaders of GL_EXT_ray_tracing that include what `emitHeader` makes of
/// the same plan and name, as "voxc_NAME.h".
std::string emitRayShader(const Plan &plan, std::string_view name, RayStage stage);

/// Letters, digits, and single underscores between them: GLSL keeps others to itself.
bool isHeaderName(std::string_view name);

/// A name made of the format: "r4_4_4_g8" of "R(4, 4, 4) G(8)".
std::string headerName(const Layout &layout);

/// "voxc_r4_4_4_g8_".
std::string headerPrefix(std::string_view name);

/// "voxc_r4_4_4_g8.h", with the extension of the language.
std::string headerFile(std::string_view name, HeaderLanguage language = HeaderLanguage::Shared);

} // namespace voxc
