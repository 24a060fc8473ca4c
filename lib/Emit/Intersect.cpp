// Printing a plan as intersect.glsl: a compute shader around the functions of the kernel.
#include "KernelFunctions.h"
#include "Names.h"

#include "voxc/Emit/Emit.h"

#include "Glsl/Print.h"

#include <vector>

namespace voxc {
namespace {

std::string preamble(const Plan &plan) {
  std::string text = "#version 460\n// intersect.glsl: " + std::string(answers(plan.query)) +
                     " volumes of the format " + plan.layout.format + ".\n// The digest of its storage is " +
                     hexadecimal(plan.layout.storageDigest) + ", and that of a volume must be the same.\n";
  if (plan.addressing == Addressing::Segments)
    text +=
        "#extension GL_EXT_buffer_reference : require\n#extension GL_EXT_buffer_reference_uvec2 : require\n";
  // SPIR-V's capability and execution mode RoundingModeRTE. An extension is not declared: 1.4 has them, and
  // spirv-opt leaves modules of extensions that it does not know alone.
  if (plan.arithmetic == Arithmetic::Nearest)
    text += "#extension GL_EXT_spirv_intrinsics : require\n"
            "// Sums and products of float32 are rounded to nearest.\n"
            "spirv_execution_mode(capabilities = [4467], 4462, 32);\n";
  return text;
}

/// What stands behind the functions: how a ray, or a point, is taken from its buffer and answered.
std::vector<const char *> around(const Plan &plan) {
  if (plan.isOfPoints())
    return {"records/device", "point/answer", "point/dispatch"};
  return {"continue_traversal", "bounds", "records/device", "buffers", "dispatch"};
}

} // namespace

std::string emitIntersect(const Plan &plan) {
  KernelBuilder builder(plan);
  addVolumeSize(builder);
  builder.add("interface");
  if (plan.stopsAboveVoxels())
    builder.add("detail/spread");
  builder.add("memory/" + std::string(toString(plan.addressing)));
  if (plan.addressing == Addressing::Paged)
    builder.add("paging");
  addKernelFunctions(builder);
  for (const char *const path : around(plan))
    builder.add(path);
  auto module = std::move(builder).specialised({"main"});
  if (module)
    glsl::lead(*module);
  return module ? preamble(plan) + glsl::print(*module) : "#error " + module.error().message + "\n";
}

} // namespace voxc
