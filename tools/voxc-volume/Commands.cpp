// Conversion, rays, tracing and the comparison with the oracle.
#include "Commands.h"

#include "KernelLibrary.h"

#include "common/RayFile.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Source/Export.h"
#include "voxc/Support/File.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace voxc::tool {
namespace {

using Arguments = std::span<const std::string>;

/// As `voxc verify` has them where it is not asked for others.
constexpr std::uint64_t kSeed = 1;

Expected<std::string> convert(Arguments arguments) {
  const auto volume = VOXC_TRY(Volume::load(arguments[0]));
  const auto exported = VOXC_TRY(exportVoxels(volume, arguments[1]));
  std::string told = std::to_string(volume.info().voxels) + " voxels";
  for (const std::string &warning : exported.warnings)
    told += "; " + warning;
  return told;
}

Expected<std::string> writeRays(Arguments arguments) {
  const auto volume = VOXC_TRY(Volume::load(arguments[0]));
  const std::string &digits = arguments[1];
  std::size_t count = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (failure != std::errc() || end != digits.data() + digits.size())
    return Error::usage("'" + digits + "' is no number of rays");
  const std::vector<Ray> rays = verifyRays(volume.info().extent, count, kSeed);
  const auto bytes = std::as_bytes(std::span(rays));
  if (auto written = writeFile(arguments[2], {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
      !written)
    return written.error();
  return std::to_string(rays.size()) + " rays";
}

Expected<RayFile> readRays(const std::string &path) {
  const auto file = MappedFile::open(path);
  return file ? parseRayFile(file->bytes(), path) : file.error();
}

Expected<std::vector<Hit>> hitsOf(const Volume &volume, const std::string &kernelPath, RaySpan rays) {
  const auto kernel = VOXC_TRY(loadKernel(kernelPath));
  auto tracer = VOXC_TRY(createCpuTracer(kernel, volume));
  std::vector<Hit> hits(rays.size());
  const auto report = tracer->trace(rays, hits);
  return report ? Expected<std::vector<Hit>>(std::move(hits)) : report.error();
}

Expected<std::string> trace(Arguments arguments) {
  const auto volume = VOXC_TRY(Volume::load(arguments[0]));
  const auto file = VOXC_TRY(readRays(arguments[2]));
  const auto hits = VOXC_TRY(hitsOf(volume, arguments[1], file.rays()));
  const auto bytes = std::as_bytes(std::span(hits));
  if (auto written = writeFile(arguments[3], {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
      !written)
    return written.error();
  return std::to_string(std::ranges::count_if(hits, &Hit::isHit)) + " of " + std::to_string(hits.size()) +
         " rays hit";
}

Expected<std::string> verify(Arguments arguments) {
  const auto volume = VOXC_TRY(Volume::load(arguments[0]));
  const auto file = VOXC_TRY(readRays(arguments[2]));
  const auto hits = VOXC_TRY(hitsOf(volume, arguments[1], file.rays()));
  const auto oracle = VOXC_TRY(Oracle::of(volume));
  const ErrorFigures figures = compare(oracle, file.rays(), hits);
  const std::string rays = std::to_string(figures.rays) + " rays";
  if (!figures.clean())
    return Error::input(std::to_string(figures.differences()) + " of " + rays +
                        " have another hit than the oracle's");
  if (figures.maxUlpDt > 0)
    return Error::input("of " + rays + " all have the oracle's hit, but not all its t");
  return rays + ", " + std::to_string(std::ranges::count_if(hits, &Hit::isHit)) +
         " hits, all as the oracle has them, to the bit of t";
}

constexpr std::array kCommands = {
    Command{"convert", "VOLUME.hvx FILE", "Writes the voxels to a file of the kind that its ending names",
            convert},
    Command{"rays", "VOLUME.hvx COUNT RAYS.bin", "Writes the rays that verify has for a volume", writeRays},
    Command{"trace", "VOLUME.hvx KERNEL RAYS.bin HITS.bin",
            "Traces rays by a kernel that was linked to a library", trace},
    Command{"verify", "VOLUME.hvx KERNEL RAYS.bin", "Traces rays, and compares each hit with an exact oracle",
            verify},
};

} // namespace

std::span<const Command> commands() { return kCommands; }

} // namespace voxc::tool
