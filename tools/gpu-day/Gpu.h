// A Vulkan device that runs compute programs and times each of their dispatches.
#pragma once

#include "Owned.h"

#include "voxc/Support/Error.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::gpu {

/// What is said of a device beside its figures.
struct GpuFacts {
  std::string name, driver, api;
  std::uint64_t memoryBytes = 0;
  bool isProcessor = false;
  bool roundsToNearest = false;       ///< Float32, where a program asks for it.
  std::uint32_t mostGroups = 0;       ///< Of a dispatch.
  std::uint32_t mostInGroup = 0;      ///< Invocations of a workgroup, along x.
  std::uint64_t mostStorageBytes = 0; ///< Of a buffer that a program reads.
  bool hasStatistics = false;         ///< Of pipelines: VK_KHR_pipeline_executable_properties.
};

/// Memory on the device, for all that programs bind.
struct GpuBuffer {
  OwnedMemory memory;
  OwnedBuffer buffer;
  std::uint64_t bytes = 0;
};

class Program;

/// One dispatch of a program, or words written to a buffer.
struct GpuStep {
  const Program *program = nullptr;
  const GpuBuffer *written = nullptr;     ///< Without a program: where `words` are written to.
  std::vector<std::uint32_t> words;       ///< Push constants of the program, or what is written.
  std::uint32_t groupsX = 1, groupsY = 1; ///< Workgroups of the dispatch,
  const GpuBuffer *groups = nullptr;      ///< or the buffer whose first three words say them.
};

/// The device. Everything that was made of it is destroyed before it.
class Gpu {
public:
  /// Opens the first device whose name contains `name`, a GPU before a processor. Error: `Environment`.
  static Expected<Gpu> open(std::string_view name);
  Gpu(Gpu &&) noexcept;
  ~Gpu();

  const GpuFacts &facts() const;

  Expected<GpuBuffer> makeBuffer(std::uint64_t bytes) const;
  Expected<void> upload(const GpuBuffer &buffer, std::span<const std::byte> bytes) const;
  Expected<void> download(const GpuBuffer &buffer, std::span<std::byte> bytes) const;

  /// Runs the steps one after another, each behind the one before, and waits: the seconds of each by the
  /// device's timestamps. Error: `Environment`, as where the device is lost.
  Expected<std::vector<double>> run(std::span<const GpuStep> steps) const;

  struct State;
  State &state() const { return *state_; }

private:
  explicit Gpu(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

} // namespace voxc::gpu
