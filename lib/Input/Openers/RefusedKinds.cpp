// Kinds of files that are known and not read: what would be right.
#include "Input/Openers/Openers.h"

#include "Support/Text.h"

#include <array>
#include <string_view>

namespace voxc {

namespace {

struct RefusedKind {
  std::string_view ending;
  std::string_view what;   ///< "is ...",
  std::string_view advice; ///< and what to do.
};

constexpr std::string_view kAsMesh = "save it as .glb or .obj, for example by Blender";
constexpr std::string_view kFromCad = "save it as .stl or .obj, for example by FreeCAD";
constexpr std::string_view kAsPoints = "save it as .ply, for example by CloudCompare";
constexpr std::string_view kAsImage = "make image data of it (.vti) by ParaView's filter 'Resample To Image'";
constexpr std::string_view kAsScan = "save it as .nrrd or .nii, for example by 3D Slicer";
constexpr std::string_view kAsSlices = "save it as .png or .tif";
constexpr std::string_view kAsArray = "save the array as .npy, for example by NumPy";
constexpr std::string_view kAsVox = "save it as .vox, for example by Goxel";
constexpr std::string_view kAsSchem = "save it as .schem, for example by Amulet";

/// What is packed comes last: the kinds that are read may be so.
constexpr auto kRefused = std::to_array<RefusedKind>({
    {".laz", "points that LASzip compressed", "save it as .las or .ply, for example by CloudCompare"},
    {".e57", "a scan of E57", "save it as .ply or .las, for example by CloudCompare"},
    {".xyz", "a text of points", kAsPoints},
    {".pts", "a text of points", kAsPoints},
    {".ptx", "a text of points", kAsPoints},
    {".pcd", "points of PCL", kAsPoints},
    {".vtk", "a legacy file of VTK", "save it as image data in XML (.vti), for example by ParaView"},
    {".pvti", "image data of VTK in several files", "save it as one .vti, for example by ParaView"},
    {".vtu", "an unstructured grid of VTK", kAsImage},
    {".vts", "a structured grid of VTK", kAsImage},
    {".vtr", "a rectilinear grid of VTK", kAsImage},
    {".vtp", "a surface of VTK", "save it as .ply or .stl, for example by ParaView"},
    {".mcstructure", "a structure of Minecraft's Bedrock Edition", kAsSchem},
    {".mca", "a region of a Minecraft world",
     "save the part that you want as .schem, for example by Amulet or WorldEdit"},
    {".nbt", "a structure of Minecraft", kAsSchem},
    {".qb", "a model of Qubicle", kAsVox},
    {".kv6", "a model of Voxlap", kAsVox},
    {".gox", "a model of Goxel", kAsVox},
    {".usd", "a scene of USD", kAsMesh},
    {".usda", "a scene of USD", kAsMesh},
    {".usdc", "a scene of USD", kAsMesh},
    {".usdz", "a scene of USD", kAsMesh},
    {".blend", "a file of Blender", "export it as .glb or .obj by Blender"},
    {".abc", "a scene of Alembic", kAsMesh},
    {".3mf", "a model of 3MF", kAsMesh},
    {".step", "a model of a CAD program", kFromCad},
    {".stp", "a model of a CAD program", kFromCad},
    {".iges", "a model of a CAD program", kFromCad},
    {".igs", "a model of a CAD program", kFromCad},
    {".ifc", "a model of a building", kFromCad},
    {".dcm", "a slice of DICOM", "make .nii.gz of its series by dcm2niix"},
    {".mha", "a scan of MetaImage", kAsScan},
    {".mhd", "a scan of MetaImage", kAsScan},
    {".mgz", "a scan of FreeSurfer", "make .nii.gz of it by mri_convert"},
    {".mgh", "a scan of FreeSurfer", "make .nii.gz of it by mri_convert"},
    {".mrc", "a map of electrons", kAsScan},
    {".am", "a lattice of Amira", kAsScan},
    {".jpg", "a picture of JPEG, whose samples are not exact", kAsSlices},
    {".jpeg", "a picture of JPEG, whose samples are not exact", kAsSlices},
    {".bmp", "a picture of BMP", kAsSlices},
    {".h5", "a file of HDF5", kAsArray},
    {".hdf5", "a file of HDF5", kAsArray},
    {".zarr", "an array of Zarr", kAsArray},
    {".mat", "a file of MATLAB", kAsArray},
    {".gz", "packed by gzip", "unpack it, for example by gunzip"},
    {".zip", "packed by zip", "unpack it, for example by unzip"},
    {".zst", "packed by Zstandard", "unpack it, for example by unzstd"},
    {".xz", "packed by XZ", "unpack it, for example by unxz"},
    {".bz2", "packed by bzip2", "unpack it, for example by bunzip2"},
});

} // namespace

std::optional<Error> refusalOf(const std::string &path) {
  const std::string name = lowerCase(path);
  for (const RefusedKind &kind : kRefused)
    if (name.ends_with(kind.ending))
      return Error::input("'" + path + "' is " + std::string(kind.what) + ", which voxc does not read; " +
                          std::string(kind.advice));
  return std::nullopt;
}

} // namespace voxc
