// Formats in C, and what is emitted for them.
#include "C/FormatHandle.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Plan/Plan.h"

#include <cstdlib>

using namespace voxc;
using namespace voxc::c;

namespace {

/// A copy that `voxc_free` takes.
template <typename Value> Value *copyOf(const Value *values, std::size_t count) {
  auto *const copy = static_cast<Value *>(std::malloc(std::max<std::size_t>(count, 1) * sizeof(Value)));
  if (!copy)
    throw std::bad_alloc();
  std::copy_n(values, count, copy);
  return copy;
}

char *copyOf(const std::string &text) { return copyOf(text.c_str(), text.size() + 1); }

} // namespace

voxc_error *voxc_format_parse(const char *text, const char *passes, voxc_format **format) {
  return guarded([&]() -> Expected<void> {
    auto parsed = VOXC_TRY(parseFormat(text));
    VOXC_TRY(runPasses(parsed, namesIn(textOr(passes, ""))));
    *format = new voxc_format(std::move(parsed));
    return {};
  });
}

voxc_error *voxc_format_of_volume(const voxc_volume *volume, voxc_format **format) {
  return guarded([&]() -> Expected<void> {
    *format = new voxc_format(volume->volume->format());
    return {};
  });
}

void voxc_format_free(voxc_format *format) { delete format; }

const char *voxc_format_text(const voxc_format *format) { return format->text.c_str(); }

const char *voxc_format_ir(const voxc_format *format) { return format->ir.c_str(); }

void voxc_format_extent(const voxc_format *format, int32_t extent[3]) {
  const Int3 size = format->format.extent();
  extent[0] = size.x, extent[1] = size.y, extent[2] = size.z;
}

voxc_error *voxc_emit_glsl(const voxc_format *format, char **text) {
  return guarded([&]() -> Expected<void> {
    const auto plan = VOXC_TRY(makePlan(format->format, {}));
    *text = copyOf(emitIntersect(plan));
    return {};
  });
}

voxc_error *voxc_compile_spirv(const voxc_format *format, uint32_t **words, size_t *count) {
  return guarded([&]() -> Expected<void> {
    const auto kernel = VOXC_TRY(compileKernel(format->format));
    *words = copyOf(kernel.spirv.data(), kernel.spirv.size());
    *count = kernel.spirv.size();
    return {};
  });
}
