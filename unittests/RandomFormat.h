// Random formats, under the names that tests know them by.
#pragma once

#include "voxc/Passes/Pass.h"
#include "voxc/Passes/RandomFormat.h"

namespace voxc::test {

using voxc::pick;
using voxc::randomFormat;
using voxc::randomFormatText;

} // namespace voxc::test
