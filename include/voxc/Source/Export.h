// Writing a volume to files of any kind: as grids, points, models, surfaces or pictures, or itself.
#pragma once

#include "voxc/Source/Rounding.h"
#include "voxc/Support/EnumText.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

struct ExportOptions;

/// A kind of file that an optional component writes.
struct OtherExport {
  std::string_view ending; ///< With its dot.
  Expected<void> (*write)(const Volume &volume, const std::string &path, const ExportOptions &options);
};

/// The plane in which slices lie.
enum class SlicePlane {
  Z,        ///< One for each z: x to the right, y downwards. Pictures as inputs are read so.
  Y,        ///< One for each y: x to the right, z downwards.
  X,        ///< One for each x: z to the right, y downwards.
  Axial,    ///< By the axes of a scan, in the units of the model: x to the right, y upwards, from low z on.
  Coronal,  ///< x to the right, z upwards, from low y on.
  Sagittal, ///< y to the right, z upwards, from low x on.
};

template <>
inline constexpr std::array<std::string_view, 6> kEnumNames<SlicePlane> = {"z",     "y",       "x",
                                                                           "axial", "coronal", "sagittal"};

/// How a volume is exported.
struct ExportOptions {
  SaveOptions save; ///< Of a .hvx file; its `progress` and `memory` of every kind.
  /// A kind that holds too few colours gets those that stand best for the volume's, rather than to fail.
  bool lossy = false;
  SlicePlane slices = SlicePlane::Z; ///< Of pictures.
  /// A .glb has its colours in a texture, a texel for each face of a voxel, rather than one a vertex: faces
  /// of several colours are merged, and triangles share whole edges, so that no gap is between them. All
  /// faces are in memory meanwhile.
  bool texture = false;
  std::vector<OtherExport> otherKinds; ///< Asked before the kinds known here.
};

/// What an export made.
struct Exported {
  std::uint64_t files = 1;         ///< That were written; several of a pattern.
  std::uint64_t rectangles = 0;    ///< Of a surface: what its faces were merged to.
  std::optional<ColourError> loss; ///< Set if `lossy` changed colours: by how much.
  /// What of the attributes the file does not hold, and what lies behind a set of files from before; one
  /// sentence each.
  std::vector<std::string> warnings;
};

/// A kind of file that volumes are exported to.
struct ExportFormat {
  std::string_view ending; ///< With its dot.
  std::string_view holds;  ///< What is in the file, as text.
};

/// All kinds, in the order of messages and tables.
std::vector<ExportFormat> exportFormats();

/// Writes the voxels of `volume` to `path`, by its ending:
/// - .raw: uint32 RGBA, x fastest, then y, then z, of the input's extent;
/// - .ply: binary points, int x y z, uchar red green blue alpha, one a voxel in Morton order;
/// - .vox: MagicaVoxel, models of up to 256 cells a side in a scene graph, at most 255 colours; of a pattern
///   such as scene%d.vox a file for each cube of 1024 cells a side, with colours of its own;
/// - .vti: VTK image data, a colour for each cell of the input's extent, and where they lie;
/// - .nvdb: a NanoVDB grid of RGBA8 values, active where there are voxels;
/// - .glb: the faces between voxels and empty cells as a mesh, merged, with a colour a vertex or a texture;
/// - .png: a picture for each slice in the plane `options.slices`; `path` is a pattern with %d or %04d in
/// place
///   of its number, unless there is but one;
/// - .vdb: OpenVDB grids, where `otherKinds` has what writes them;
/// - .hvx: the volume itself, as `Volume::save` writes it.
/// Each file is written under a temporary name and renamed. Errors: another ending; `Usage`,
/// `options.save.compress` for what is no .hvx; more than the kind, its file or the disk can hold; as
/// `decode` and `save`.
Expected<Exported> exportVoxels(const Volume &volume, const std::string &path,
                                const ExportOptions &options = {});

} // namespace voxc
