// All that most programs need of the libraries: the runtime, and the compiler from a format to volumes and
// kernels.
#pragma once

#include "voxc/Construct/Constructor.h"
#include "voxc/Construct/Split.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Facts/Facts.h"
#include "voxc/Input/Input.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Source/Export.h"
#include "voxc/Source/Sources.h"
#include "voxc/runtime.h"
