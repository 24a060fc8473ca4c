// Printing a plan as intersect.glsl: a compute shader around the functions of the kernel.
#include "KernelFunctions.h"
#include "Names.h"

#include "voxc/Emit/Emit.h"

#include "Glsl/Parse.h"
#include "Glsl/Print.h"

namespace voxc {
namespace {

std::string preamble(const Plan &plan) {
  std::string text = "#version 460\n// intersect.glsl: " + planNames(plan).holes["answers"] +
                     " volumes of the format " + plan.layout.format + ".\n// The digest of its storage is " +
                     planNames(plan).holes["DIGEST"] + ", and that of a volume must be the same.\n";
  if (plan.addressing == Addressing::Segments)
    text += "#extension GL_EXT_buffer_reference : require\n#extension GL_EXT_buffer_reference_uvec2 : "
            "require\n";
  return text;
}

} // namespace

std::string emitIntersect(const Plan &plan) {
  const TemplateNames names = planNames(plan);
  const auto file = [&](const std::string &path) { return "\n" + fillFile(shaderFiles(), path, names); };
  const auto around = [&] {
    if (plan.isOfPoints())
      return file("records.glsl") + file("point/answer.glsl") + file("point/dispatch.glsl");
    if (plan.bounded)
      return file("walk_on.glsl") + file("bounds.glsl") + file("records.glsl") + file("buffers.glsl") +
             file("dispatch.glsl");
    return file("records.glsl") + file("buffers.glsl") + file("walk_on.glsl") + file("dispatch.glsl");
  };
  const std::string text = preamble(plan) + volumeSize(plan) + file("interface.glsl") +
                           (plan.stopsAboveVoxels() ? file("detail/spread.glsl") : "") +
                           file("memory/" + std::string(toString(plan.addressing)) + ".glsl") +
                           (plan.addressing == Addressing::Paged ? file("paging.glsl") : "") +
                           kernelFunctions(plan) + around();
  const auto module = glsl::parse(text);
  return module ? glsl::print(*module) : "#error " + module.error().message + "\n";
}

} // namespace voxc
