// Rays, figures and checks, from files to files.
#include "Commands.h"

#include "CudaSubject.h"
#include "FollowSubject.h"
#include "KernelSubject.h"
#include "Mapped.h"
#include "PeerSubject.h"
#include "RaySets.h"

#include "common/CameraFile.h"
#include "common/Files.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

namespace voxc::gpu {
namespace {

namespace fs = std::filesystem;
using tool::Json;

/// The cameras of a file whose names are that of the scene, or begin with it and a dash; all if there are
/// none.
Expected<std::vector<std::string>> namesOfCameras(const Options &options) {
  auto names = tool::cameraNames(options.cameras);
  if (!names)
    return names;
  std::vector<std::string> own;
  std::ranges::copy_if(*names, std::back_inserter(own), [&](const std::string &name) {
    return name == options.scene || name.starts_with(options.scene + "-");
  });
  return own.empty() ? names : own;
}

} // namespace

Expected<void> makeRays(const Options &options) {
  const auto volume = VOXC_TRY(Volume::load(options.volume, {.trusted = true}));
  const auto names = VOXC_TRY(namesOfCameras(options));
  int width = 0, height = 0;
  if (std::sscanf(options.size.c_str(), "%dx%d", &width, &height) != 2 || width < 1 || height < 1 ||
      width > tool::kMaxPictureSide || height > tool::kMaxPictureSide)
    return Error::usage("--size is '" + options.size + "'; it should be WxH, pixels of a picture");
  std::vector<NamedCamera> cameras;
  for (const std::string &name : names) {
    const auto of = VOXC_TRY(tool::readCamera(options.cameras, name));
    cameras.push_back(
        {name, cameraFromAngles(volume.info().extent, of.position, of.pitch, of.yaw, of.fov, width, height)});
  }
  return makeRaySets(volume, cameras, options.output);
}

Expected<void> makeDistances(const Options &options) {
  if (options.side < 1 || options.side > tool::kMaxPictureSide)
    return Error::usage("--side is " + std::to_string(options.side) + "; it should be 1 to " +
                        std::to_string(tool::kMaxPictureSide) + " pixels");
  const auto volume = Volume::load(options.volume, {.trusted = true});
  return volume ? makeDistanceSets(*volume, options.side, options.output) : volume.error();
}

namespace {

/// The sets of a folder, by their names.
std::vector<std::string> setsOf(const Options &options) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::directory_entry &entry : fs::directory_iterator(options.folder, ignored))
    if (const std::string name = entry.path().stem().string();
        entry.path().extension() == ".rays" &&
        (options.only.empty() || std::ranges::find(options.only, name) != options.only.end()))
      names.push_back(name);
  std::ranges::sort(names);
  return names;
}

/// The rays of a folder on the device, with the files that they come from.
struct Brought {
  std::vector<MappedBytes> files;
  std::vector<RaysThere> sets;
};

Expected<Brought> bringSets(const Gpu &gpu, const Options &options) {
  Brought brought;
  for (const std::string &name : setsOf(options)) {
    const std::string path = (fs::path(options.folder) / name).string();
    for (const char *const ending : {".rays", ".hits"}) {
      auto file = VOXC_TRY(MappedBytes::open(path + ending));
      brought.files.push_back(std::move(file));
    }
    const std::size_t last = brought.files.size() - 1;
    const auto rays = brought.files[last - 1].as<Ray>();
    const auto hits = brought.files[last].as<Hit>();
    if (rays.size() != hits.size())
      return Error::input("'" + path + ".hits' has not as many records as its rays");
    if (rays.empty())
      continue; // Of a camera that sees nothing no ray goes on.
    auto set = VOXC_TRY(bringRays(gpu, name, rays, hits, kPeerColumns));
    brought.sets.push_back(std::move(set));
  }
  if (brought.sets.empty())
    return Error::input("folder '" + options.folder + "' has no rays");
  return brought;
}

Json deviceJson(const GpuFacts &facts) {
  return {{"name", facts.name},
          {"driver", facts.driver},
          {"vulkan", facts.api},
          {"memory_bytes", facts.memoryBytes},
          {"processor", facts.isProcessor}};
}

/// Of NAME.KIND.spv or NAME.KIND.ptx.
std::string kindOf(const std::string &path) { return fs::path(path).stem().extension().string().erase(0, 1); }

Expected<Json> measureVolume(const Gpu &gpu, const Options &options, std::span<const RaysThere> sets,
                             Json &figures) {
  const auto volume = VOXC_TRY(Volume::load(options.volume, {.trusted = true}));
  figures["format"] = toString(volume.format());
  figures["extent"] = {volume.info().extent.x, volume.info().extent.y, volume.info().extent.z};
  figures["voxels"] = volume.info().voxels;
  figures["words"] = volume.words().size();
  figures["bytes"] = volume.words().size_bytes();
  const MeasureOptions how{options.seconds, options.groups, options.atOnce};
  const auto subject = VOXC_TRY(KernelSubject::make(gpu, volume, how));
  // One that a device does not take is told of; the others are measured.
  Json kernels = Json::object();
  const auto keep = [&](const std::string &path, Expected<Json> rows) {
    kernels[kindOf(path)] = rows ? std::move(*rows) : Json{{"failed", rows.error().message}};
  };
  for (const std::string &path : options.kernels) {
    const auto kernel = VOXC_TRY(Kernel::load(path));
    keep(path, subject.measure(kernel, sets));
    if (!options.follows)
      continue;
    auto following = measureFollowing(options.device, kernel, volume);
    kernels[kindOf(path)]["follow_us"] =
        following ? std::move(*following) : Json{{"failed", following.error().message}};
  }
  for (const std::string &path : options.cudas) {
    const auto code = VOXC_TRY(readTextFile(path));
    keep(path, measureCuda(code, volume.words(), sets, options.seconds));
  }
  return kernels;
}

Expected<Json> measureByHand(const Gpu &gpu, const Options &options, std::span<const RaysThere> sets,
                             Json &figures) {
  const auto nodes = VOXC_TRY(MappedBytes::open(options.nodes));
  const auto words = nodes.as<std::uint32_t>();
  if (!options.cudas.empty()) {
    figures["bytes"] = words.size_bytes();
    const auto code = VOXC_TRY(readTextFile(options.cudas.front()));
    auto rows = measureCuda(code, words, sets, options.seconds);
    return rows ? Expected<Json>(Json{{"cuda", std::move(*rows)}}) : rows.error();
  }
  const auto spirv = VOXC_TRY(MappedBytes::open(options.peer));
  auto rows = measurePeer(gpu, spirv.as<std::uint32_t>(), words, sets, options.seconds);
  return rows ? Expected<Json>(Json{{"by hand", std::move(*rows)}}) : rows.error();
}

} // namespace

Expected<void> measure(const Options &options) {
  const auto gpu = VOXC_TRY(Gpu::open(options.device));
  const auto brought = VOXC_TRY(bringSets(gpu, options));
  Json figures{{"scene", options.scene}, {"label", options.label}, {"device", deviceJson(gpu.facts())}};
  auto kernels = VOXC_TRY(options.nodes.empty() ? measureVolume(gpu, options, brought.sets, figures)
                                                : measureByHand(gpu, options, brought.sets, figures));
  figures["kernels"] = std::move(kernels);
  return tool::writeText(options.output, figures.dump(1) + "\n");
}

Expected<void> checkHardRays(const Options &options) {
  const auto gpu = VOXC_TRY(Gpu::open(options.device));
  const auto volume = VOXC_TRY(Volume::load(options.volume, {.trusted = true}));
  const auto lattice = VOXC_TRY(MappedBytes::open((fs::path(options.programs) / "lattice.spv").string()));
  const auto compare = VOXC_TRY(MappedBytes::open((fs::path(options.programs) / "compare.spv").string()));
  Json figures{{"scene", options.scene}, {"label", options.label}, {"device", deviceJson(gpu.facts())}};
  figures["format"] = toString(volume.format());
  std::uint64_t wrong = 0;
  for (const std::string &path : options.kernels) {
    const auto kernel = VOXC_TRY(Kernel::load(path));
    auto checked = checkLattice(gpu, volume, kernel,
                                {lattice.as<std::uint32_t>(), compare.as<std::uint32_t>()}, options.lattice);
    if (checked)
      wrong += (*checked)["wrong"].get<std::uint64_t>();
    figures["lattice"][kindOf(path)] =
        checked ? std::move(*checked) : Json{{"failed", checked.error().message}};
  }
  VOXC_TRY(tool::writeText(options.output, figures.dump(1) + "\n"));
  if (wrong > 0)
    return Error::input(std::to_string(wrong) + " hits are not the exact ones");
  return {};
}

} // namespace voxc::gpu
