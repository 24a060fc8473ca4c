// The scenes that are chosen to hurt, under the names that tests know them by.
#pragma once

#include "voxc/Source/HardScenes.h"
#include "voxc/Source/Sources.h"

namespace voxc::test {

using Scene = HardScene;
using voxc::hardScenes;

} // namespace voxc::test
