// Where rays begin, as far as a look at some of them tells: which variant of a kernel traces them fastest.
#pragma once

#include "TracePipeline.h"

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/BoundedRay.h"

namespace voxc {

/// `Anywhere` if one of a thousand of the rays begins farther away than float32 tells of a volume of that
/// extent (shaders-runtime/near.glsl). Others among them are traced right, and slower.
Origins originsOf(const RaySpan &rays, Int3 extent);

} // namespace voxc
