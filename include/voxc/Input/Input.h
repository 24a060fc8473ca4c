// Opening an INPUT as it is written on a command line (docs/command-line.md).
#pragma once

#include "voxc/Input/Units.h"
#include "voxc/Mesh/MeshSource.h"
#include "voxc/Source/Interior.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

struct Input;
struct InputOptions;

/// A kind of input, and what opens it.
struct InputKind {
  std::string_view mark; ///< A prefix if it ends in a colon, else an ending in lower case.
  /// Takes what follows the prefix, or a path, and options with a memory.
  Expected<Input> (*open)(const std::string &rest, const InputOptions &options);
  std::string_view holds = "";      ///< Such as "a mesh".
  bool mayHaveSeveralFiles = false; ///< What it reads besides its own is in `Input::files`.
};

/// One thing that an input says of itself.
struct InputFact {
  std::string name;            ///< Such as "spacing"; words with blanks between.
  std::string text;            ///< To people; may be several lines.
  std::vector<double> numbers; ///< The same to programs; none where it is a text alone.
};

/// What the words of voxels are, of a mesh or of MagicaVoxel models.
enum class MaterialWords {
  Colours,           ///< What is seen.
  Emission,          ///< The light that the surface gives off, in sRGB; black where there is none.
  EmissionStrength,  ///< How many times as bright it is: `strengthOfWord` decodes it.
  MetallicRoughness, ///< How clear it is in the first byte, how rough in the second and how metallic in the
                     ///< third, of 255, by the nearest texel.
};

/// How an input becomes voxels.
struct InputOptions {
  int resolution = 0; ///< Voxels on a mesh's longest axis; 0: what the format holds.
  /// The side of a voxel of a mesh, of points or of a scan, which becomes such cubes; 0: by the resolution,
  /// and scans have the voxels that they are stored with.
  Length voxelSize;
  double unit = 0; ///< Metres of a step of 1 in the model; 0: what the file says of it.
  /// A point of the model that the planes between voxels go through, on each axis.
  std::optional<std::array<double, 3>> align;
  Int3 formatExtent{1 << 9, 1 << 9, 1 << 9};   ///< What the format holds; an input must fit into it.
  std::optional<std::array<double, 6>> bounds; ///< x0, y0, z0, x1, y1, z1: crops a mesh, in model units.
  bool isUpKnown = false;                      ///< `zUp` was said, and holds whatever the kind of file.
  bool zUp = false; ///< The up of a mesh or a dense volume is +z: it is turned to +y.
  /// What nobody says of a dense volume is found: its threshold by its histogram, a window in which it is not
  /// black, and which axis points up by its kind of file (+z in NIfTI files). A warning says if most is
  /// solid.
  bool isAutomatic = false;
  std::optional<double> threshold; ///< Samples of a dense volume from here up are voxels; default: all but 0.
  /// The words of a dense volume are its samples as they are: int32 of whole numbers, the float32 of others.
  /// A level set and values that are no numbers stay what they are.
  bool keepsSamples = false;
  /// How a dense volume's samples look: grey, heat, dusk or polar; or "labels": words are the samples, or the
  /// numbers of a MagicaVoxel model's colours, whole numbers below 2^16 that say what is there.
  std::string colourMap = "grey";
  std::optional<std::array<double, 2>> window; ///< The samples that the colour map's ends stand for; default:
                                               ///< the least and the greatest.
  int volume = 0;   ///< Which of several volumes in one scan, from 1 on; 0: the first, with a warning.
  std::string grid; ///< The name of a grid of a .nvdb or .vdb file; empty: the first that can be a shape.
  Coverage coverage = Coverage::Conservative; ///< Which voxels a triangle of a mesh takes.
  ColourRule colour = ColourRule::Mean;       ///< Which colour a texture of a mesh gives to a voxel.
  MaterialWords materialWords =
      MaterialWords::Colours;          ///< Error if the input is of a kind without the others.
  Interior interior = Interior::Keep;  ///< What becomes of the inside: `dropInterior`, `fillInterior`, and of
                                       ///< a mesh `fillMesh`.
  std::uint32_t fillWord = 0xffffffff; ///< Of the voxels that are added to the inside.
  bool crop = false; ///< Moves the smallest box around all voxels to the origin; then it must fit.
  /// Only voxels in boxes [box[0], box[1]) of these will be asked for, unless there is none: others may look
  /// empty, which lets a mesh be opened sooner. None may be given where the inside is changed or the border
  /// cropped.
  std::vector<std::array<Int3, 2>> regions;
  unsigned threads = 1;   ///< That find the inside; 0: as many as the machine has.
  bool describe = false;  ///< `Input::facts` are wanted, for which every sample is looked at.
  bool reference = false; ///< Meshes are voxelized by the simple, slow voxelizer: to check the other.
  std::shared_ptr<WorkingMemory> memory; ///< For what is sorted or inflated; null: `createDefault()`.
  bool boxOfAllFrames = false;       ///< The box of an animation is that of all its frames, not of one alone.
  std::vector<InputKind> otherKinds; ///< What optional components read; asked before the kinds known here.
  Progress progress;

  /// What an input may take before it is cropped.
  Int3 mostExtent() const {
    constexpr int kMost = 1 << kMaxLog2Extent;
    return crop ? Int3{kMost, kMost, kMost} : formatExtent;
  }
};

/// An opened input.
struct Input {
  std::unique_ptr<VoxelSource> source;
  std::uint64_t triangles = 0;       ///< Of a mesh, after instancing; else 0.
  double loadSeconds = 0;            ///< Reading the file.
  double binSeconds = 0;             ///< Sorting triangles or points into chunks.
  std::uint64_t loaderPeakBytes = 0; ///< Memory that a library took beside the bound while it read.
  MaterialWords words = MaterialWords::Colours; ///< What the words are.
  std::string provenance;                       ///< The options that matter, for `VolumeInfo::provenance`.
  std::vector<std::string> warnings;            ///< One sentence each.
  std::vector<std::string> notes;               ///< What was done as asked for; one sentence each.
  std::vector<std::string> files;               ///< That were read besides the one which is named, where its
                                                ///< content names them: materials, textures, samples.
  Interior interior = Interior::Keep;           ///< What was done with the inside,
  std::uint64_t interiorVoxels = 0;             ///< how many voxels were left out or added,
  double interiorSeconds = 0;                   ///< and how long it took to find them.
  std::vector<InputFact> facts;                 ///< What was asked for by `InputOptions::describe`.
  std::size_t frames = 1;                       ///< Of the animation that it is one frame of.
  bool isCropped = false;
  Int3 cropLow; ///< The voxel that became (0, 0, 0).
};

/// Opens a mesh (.obj .glb .gltf .ply .stl), points (.ply without faces, .las), a volume (.hvx), MagicaVoxel
/// models
/// (.vox), blocks of Minecraft (.schem .litematic .schematic), dense volumes (.vti .nrrd .nhdr .nii .nii.gz
/// .binvox, "raw:WxHxD:TYPE:FILE"), "grid:WxHxD:FILE", or "builtin:NAME[:N]" (N: `resolution`, else the
/// format's longest axis). "F.vox#N" is frame N of an animation, from 1 on. Errors: unknown kind (naming
/// those there are), unreadable, broken, or larger than the format.
Expected<Input> openInput(const std::string &input, const InputOptions &options);

/// Whether the input is of a kind that may name other files, by its name alone; false if it is of no known
/// kind.
bool mayHaveSeveralFiles(const std::string &input, const InputOptions &options);

} // namespace voxc
