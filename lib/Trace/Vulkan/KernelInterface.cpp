// How a kernel meets the outside, as data.
#include "voxc/Trace/KernelInterface.h"

#include "Capabilities.h"
#include "Trace/Kernel/Spirv.h"
#include "TracePipeline.h"

#include "voxc/Trace/BoundedRay.h"

#include <algorithm>
#include <cstddef>

namespace voxc {
namespace {

const std::vector<KernelField> kRay = {{"origin", "float32[3]", offsetof(Ray, origin)},
                                       {"direction", "float32[3]", offsetof(Ray, direction)}};

const std::vector<KernelField> kBoundedRay = {{"origin", "float32[3]", offsetof(BoundedRay, origin)},
                                              {"tmin", "float32", offsetof(BoundedRay, tmin)},
                                              {"direction", "float32[3]", offsetof(BoundedRay, direction)},
                                              {"tmax", "float32", offsetof(BoundedRay, tmax)}};

KernelBinding rays(bool bounded) {
  if (bounded)
    return {0, "rays", "read", {}, 0, kBoundedRay, sizeof(BoundedRay)};
  return {0, "rays", "read", {}, 0, kRay, sizeof(Ray)};
}

const std::vector<KernelField> kHit = {{"voxel", "int32[3]", offsetof(Hit, voxel)},
                                       {"rgba", "uint32", offsetof(Hit, rgba)},
                                       {"t", "float32", offsetof(Hit, t)},
                                       {"steps", "uint32", offsetof(Hit, steps)}};

const std::vector<KernelField> kListHeader = {{"groups", "uint32[3]", 0}, {"count", "uint32", 12}};
constexpr std::uint32_t kListHeaderBytes = deferredListBytes(0);

const std::vector<KernelField> kTile = {{"first_ray", "uint32", offsetof(RayTile, first)},
                                        {"ray_count", "uint32", offsetof(RayTile, rayCount)},
                                        {"task", "uint32", offsetof(RayTile, task)}};

KernelBinding words(Addressing addressing) {
  if (addressing == Addressing::Segments)
    return {2, "words", "read", {}, 0, {{"segment_address", "uint64", 0}}, 8};
  return {2, "words", "read", {}, 0, {{"word", "uint32", 0}}, 4};
}

/// Adds the feature behind each capability of a module.
Expected<std::vector<std::string_view>> featuresOf(const Kernel &kernel) {
  std::vector<std::string_view> features;
  Expected<void> known;
  const auto look = [&](const spirv::Instruction &instruction) {
    if (instruction.opcode != spirv::kOpCapability || instruction.operands.empty() ||
        isEverywhere(instruction.operands[0]))
      return;
    const std::string_view feature = featureOf(instruction.operands[0]);
    if (feature.empty())
      known = Error::input("this kernel needs SPIR-V's capability " +
                           std::to_string(instruction.operands[0]) + ", which no kernel of voxc does");
    else if (std::ranges::find(features, feature) == features.end())
      features.push_back(feature);
  };
  VOXC_TRY(spirv::forEachInstruction(kernel.spirv, look));
  if (!known)
    return known.error();
  return features;
}

} // namespace

Expected<KernelInterface> interfaceOf(const Kernel &kernel) {
  if (kernel.addressing == Addressing::Texels)
    return Error::usage(
        "a kernel that reads words as texels is for voxc's own tracers: compile one with addressing=buffer");
  auto features = VOXC_TRY(featuresOf(kernel));
  KernelInterface result;
  result.bindings = {rays(kernel.bounded),
                     {1, "hits", "read write", {}, 0, kHit, sizeof(Hit)},
                     words(kernel.addressing),
                     {3, "deferred", "read write", kListHeader, kListHeaderBytes, {{"ray", "uint32", 0}}, 4}};
  result.pushConstants = kTile;
  result.pushConstantBytes = sizeof(RayTile);
  result.constants = {
      {0, "COUNT_LOOKUPS", "bool", "false"}, {1, "SPREAD", "float32", "0"},
      {2, "COUNT_WORDS", "bool", "false"},   {3, "EXACT_FALLBACK", "bool", "true"},
      {6, "COMES_NEAR", "bool", "true"},     {7, "gl_WorkGroupSize.x", "uint32", "64"},
  };
  result.features = std::move(features);
  return result;
}

} // namespace voxc
