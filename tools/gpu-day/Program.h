// A compute program: SPIR-V, the constants that it is specialised for, and the buffers that it binds.
#pragma once

#include "Gpu.h"

namespace voxc::gpu {

struct ProgramConstant {
  std::uint32_t id, value;
};

/// What a driver says of a program that it has compiled, as "Register Count": 64.
struct ProgramFigure {
  std::string name;
  double value;
};

/// A program on a device, with the buffers that it is bound to.
class Program {
public:
  /// Of SPIR-V with so many storage buffers in set 0 and so many words of push constants. Error:
  /// `Environment`, where the driver refuses it.
  static Expected<Program> make(const Gpu &gpu, std::span<const std::uint32_t> spirv, std::uint32_t bindings,
                                std::uint32_t pushWords, std::span<const ProgramConstant> constants = {});

  /// Binds these buffers from now on, to bindings 0, 1 and so on. Nothing may be running.
  void bind(std::span<const GpuBuffer *const> buffers) const;
  /// Records the program with its buffers and these push constants.
  void record(VkCommandBuffer commands, std::span<const std::uint32_t> words) const;

  /// Those of the driver; none where it says nothing.
  std::vector<ProgramFigure> figures() const;

private:
  const Gpu::State *state_ = nullptr;
  OwnedSetLayout setLayout_;
  OwnedLayout layout_;
  OwnedPipeline pipeline_;
  OwnedPool pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

} // namespace voxc::gpu
