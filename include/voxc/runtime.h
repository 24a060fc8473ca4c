// All of the runtime: volumes, kernels, tracers and pictures, without LLVM.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/IR/Query.h"
#include "voxc/Render/Picture.h"
#include "voxc/Render/Render.h"
#include "voxc/Render/View.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/Version.h"
#include "voxc/Trace/CpuKernel.h"
#include "voxc/Trace/Face.h"
#include "voxc/Trace/InstancedTracer.h"
#include "voxc/Trace/Kernel.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/PagedVolume.h"
#include "voxc/Volume/Volume.h"
