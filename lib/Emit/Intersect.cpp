// Printing a plan as intersect.glsl: a compute shader around the functions of the kernel.
#include "KernelFunctions.h"
#include "RuntimeFile.h"

#include "voxc/Emit/Emit.h"

namespace voxc {
namespace {

std::string preamble(const Plan &plan) {
  std::string text = "#version 460\n// intersect.glsl: first hits of rays with volumes of the format " +
                     toString(plan.format) + ".\n";
  if (plan.addressing == Addressing::Segments)
    text += "#extension GL_EXT_buffer_reference : require\n#extension GL_EXT_buffer_reference_uvec2 : "
            "require\n";
  return text;
}

std::string file(const std::string &path) { return "\n" + std::string(runtimeFile(shaderFiles(), path)); }

} // namespace

std::string emitIntersect(const Plan &plan) {
  return preamble(plan) + volumeSize(plan) + file("interface.glsl") +
         (plan.detail == Detail::Cone ? file("detail/spread.glsl") : "") +
         file("memory/" + std::string(toString(plan.addressing)) + ".glsl") + kernelFunctions(plan) +
         file("dispatch.glsl");
}

} // namespace voxc
