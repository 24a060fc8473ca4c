// The shaders of a page, in the languages of what browsers draw by.
#pragma once

#include "common/Json.h"
#include "voxc/IR/Format.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>

namespace voxc::page {

/// The text of a file of page-runtime, without comments on lines of their own and without what stands before
/// and behind lines.
std::string tersely(std::string_view path);

/// Texts by their names, for page-runtime/script/webgl.js and webgpu.js: those of WebGL 2 in "essl", and of a
/// page that holds its words those of WebGPU in "wgsl". `isCut`: the scene has planes. Error: that of a plan.
Expected<tool::Json> makeShaders(const Format &format, bool isStreamed, bool isCut);

} // namespace voxc::page
