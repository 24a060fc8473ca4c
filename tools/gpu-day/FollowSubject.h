// How long a tracer takes to follow edits: what of them has to be copied to the device.
#pragma once

#include "common/Json.h"
#include "voxc/Support/Error.h"
#include "voxc/Trace/Kernel.h"
#include "voxc/Volume/Volume.h"

#include <string>

namespace voxc::gpu {

/// Lets a tracer on the device follow edits that change 64, 4096 and 262,144 words at the volume's end and
/// four in its head: for each number the microseconds of the median call, which waits for the copy. Null
/// where kernels of whole loops are not for the device. Errors: those of the device, and of a volume with
/// fewer words (`Input`).
Expected<tool::Json> measureFollowing(const std::string &device, const Kernel &kernel, const Volume &volume);

} // namespace voxc::gpu
