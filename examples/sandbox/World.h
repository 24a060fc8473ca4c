// A world of voxels: what is done to it, and what is seen of it.
#pragma once

#include <voxc/Construct/EditableVolume.h>
#include <voxc/Render/Render.h>
#include <voxc/Trace/Tracer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

// What a frame came to.
struct FrameCosts {
  double editSeconds = 0;        // Of all edits,
  double followSeconds = 0;      // of bringing them to the device,
  double traceSeconds = 0;       // and of the picture.
  std::uint64_t copiedBytes = 0; // To the device.
  int edits = 0;
};

class World {
public:
  // Hills of 256 x 128 x 256 voxels. `device` is a part of the name of one of Vulkan's, or "cpu".
  static voxc::Expected<World> create(const std::string &device);

  // The first voxel that a ray meets, exactly; none if it meets none.
  std::optional<voxc::Hit> shoot(const voxc::Ray &ray);
  // One edit of the frame.
  voxc::Expected<void> edit(voxc::VoxelChange &change);
  // A state to come back to.
  voxc::EditableVolume::Snapshot save() { return volume_.snapshot(); }
  void load(const voxc::EditableVolume::Snapshot &state) { volume_.restore(state); }

  // Brings the edits of the frame to the device, and takes a picture.
  voxc::Expected<voxc::Picture> show(const voxc::Camera &camera);
  // What the last frame came to; the next one begins at 0.
  FrameCosts takeCosts();

  // How many of these rays do not hit, exactly, what they hit in a world that is built of the same voxels.
  voxc::Expected<int> wrongHits(const std::vector<voxc::Ray> &rays);

  std::uint64_t words() const { return volume_.words(); }
  std::uint64_t voxels() const { return volume_.voxels(); }

private:
  World(voxc::EditableVolume volume, std::unique_ptr<voxc::Tracer> tracer, std::string device)
      : volume_(std::move(volume)), tracer_(std::move(tracer)), device_(std::move(device)) {}
  voxc::Expected<void> follow();

  voxc::EditableVolume volume_;
  std::shared_ptr<const voxc::Volume> shown_; // What the tracer traces.
  std::unique_ptr<voxc::Tracer> tracer_;
  std::string device_;
  FrameCosts costs_;
};
