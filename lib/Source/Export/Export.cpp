// Exporting volumes: the table of kinds.
#include "voxc/Source/Export.h"

#include "Source/Export/VoxelLooks.h"
#include "Source/Export/Writers.h"
#include "Support/PathEnding.h"
#include "Support/Platform/Path.h"

#include <array>
#include <filesystem>

namespace voxc {

namespace {

std::uint64_t gridSize(const Volume &volume) {
  const Int3 extent = volume.info().extent;
  return static_cast<std::uint64_t>(extent.x) * static_cast<std::uint64_t>(extent.y) *
         static_cast<std::uint64_t>(extent.z);
}

/// What is compressed takes at least a thousandth.
std::uint64_t gridThousands(const Volume &volume) { return gridSize(volume) / 1024; }

std::uint64_t voxelCount(const Volume &volume) { return volume.info().voxels; }

/// Of a kind whose size is known when it is written.
std::uint64_t unknownSize(const Volume &) { return 0; }

struct ExportKind {
  ExportFormat format;
  const char *unit;        ///< What the file is made of,
  std::uint64_t bytesEach; ///< and how large each of them is.
  std::uint64_t (*count)(const Volume &volume);
  WriteExport *write;     ///< Null: the kind is no single file of voxels.
  bool endsFirst = false; ///< Its file begins with what is known last, and cannot go into a pipe.
};

constexpr std::array<ExportKind, 9> kKinds{
    {{{".hvx", "the volume itself, stored again"}, "", 1, unknownSize, nullptr},
     {{".raw", "a dense grid of uint32 RGBA"}, "cells", 4, gridSize, writeGrid},
     {{".ply", "a point for each voxel"}, "points", 16, voxelCount, writePoints},
     {{".vox", "MagicaVoxel models, at most 255 colours a file, of which scene%d.vox makes several"},
      "voxels",
      4,
      voxelCount,
      writeMagicaVoxel},
     {{".vti", "image data of VTK, a colour for each cell"},
      "thousands of cells",
      4,
      gridThousands,
      writeVtkImage,
      true},
     {{".nvdb", "a NanoVDB grid of RGBA8 values"}, "", 1, unknownSize, writeNanoVdb},
     {{".vdb", "OpenVDB grids of density and colour, where voxc was built with it"},
      "",
      1,
      unknownSize,
      nullptr},
     {{".glb", "the visible faces as a mesh, merged"}, "", 1, unknownSize, writeSurface, true},
     {{".png", "a picture for each z, as in s%04d.png"}, "", 1, unknownSize, nullptr}}};

std::string knownEndings() {
  std::string endings;
  for (const ExportKind &kind : kKinds)
    endings += (endings.empty() ? "" : ", ") + std::string(kind.format.ending);
  return endings;
}

/// Refuses what does not fit on the disk before filling it: a small volume may stand for 2^63 voxels.
Expected<void> checkSpace(const ExportKind &kind, const Volume &volume, const std::string &path) {
  const std::uint64_t count = kind.count(volume);
  std::error_code unknown;
  const auto whole = std::filesystem::absolute(platform::pathFrom(path), unknown);
  const auto space =
      unknown ? std::filesystem::space_info() : std::filesystem::space(whole.parent_path(), unknown);
  if (unknown || count <= space.available / kind.bytesEach)
    return {};
  return Error::environment(std::to_string(count) + " " + kind.unit + " of " +
                            std::to_string(kind.bytesEach) + " bytes do not fit beside '" + path +
                            "', where " + std::to_string(space.available) + " bytes are free");
}

Expected<void> writeFile(const ExportKind &kind, const Volume &volume, const std::string &path,
                         const ExportOptions &options, Exported &exported) {
  const bool isRegular = VOXC_TRY(OutputFile::isRegularAt(path));
  if (kind.endsFirst && !isRegular)
    return Error::input("a " + std::string(kind.format.ending) +
                        " file begins with what is known last; write it to a file, not to a pipe");
  VOXC_TRY(checkSpace(kind, volume, path));
  auto file = VOXC_TRY(OutputFile::create(path));
  VOXC_TRY(kind.write(volume, file, options, exported));
  return file.commit();
}

Expected<void> write(const ExportKind &kind, const Volume &volume, const std::string &path,
                     const ExportOptions &options, Exported &exported) {
  if (const auto pattern = NumberedPath::parse(path); pattern && kind.write == writeMagicaVoxel)
    return writeMagicaVoxelParts(volume, *pattern, options, exported);
  if (options.texture)
    return writeFile(
        {kind.format, kind.unit, kind.bytesEach, kind.count, writeTexturedSurface, kind.endsFirst}, volume,
        path, options, exported);
  if (kind.write)
    return writeFile(kind, volume, path, options, exported);
  if (kind.format.ending == ".png")
    return writeSlices(volume, path, options, exported);
  if (kind.format.ending == ".vdb")
    return Error::environment(
        "'" + path +
        "' is an OpenVDB file, which this build does not write; build voxc with VOXC_OPENVDB=ON");
  return volume.save(path, options.save);
}

} // namespace

std::vector<ExportFormat> exportFormats() {
  std::vector<ExportFormat> formats;
  formats.reserve(std::size(kKinds));
  for (const ExportKind &kind : kKinds)
    formats.push_back(kind.format);
  return formats;
}

namespace {

/// A .hvx file has all attributes, and .vox and .glb those that are materials.
void tellAttributes(const Volume &volume, const std::string &ending, Exported &exported) {
  const bool holdsLooks = ending == ".vox" || ending == ".glb";
  if (ending == ".hvx")
    return;
  if (std::string left = attributesLeftOut(volume, holdsLooks, ending); !left.empty())
    exported.warnings.push_back(std::move(left));
}

} // namespace

Expected<Exported> exportVoxels(const Volume &volume, const std::string &path, const ExportOptions &options) {
  const std::string ending = pathEnding(path);
  if (options.save.compress && ending != ".hvx")
    return Error::usage("'" + path +
                        "' is no volume that could be compressed; only a file that ends in .hvx is");
  if (options.texture && ending != ".glb")
    return Error::usage("'" + path + "' has no texture; only a file that ends in .glb may have one");
  VOXC_TRY(options.save.progress.check());
  for (const OtherExport &other : options.otherKinds)
    if (other.ending == ending) {
      VOXC_TRY(other.write(volume, path, options));
      Exported exported;
      tellAttributes(volume, ending, exported);
      return exported;
    }
  for (const ExportKind &kind : kKinds) {
    if (kind.format.ending != ending)
      continue;
    Exported exported;
    VOXC_TRY(write(kind, volume, path, options, exported));
    tellAttributes(volume, ending, exported);
    return exported;
  }
  return Error::input("'" + path + "' is no kind of export that is known; it ends in " + knownEndings() +
                      ", or of a page in .html");
}

} // namespace voxc
