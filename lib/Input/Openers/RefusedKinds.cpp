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

constexpr std::array<RefusedKind, 10> kRefused{
    {{".laz", "points that LASzip compressed", "save it as .las or .ply, for example by CloudCompare"},
     {".e57", "a scan of E57", "save it as .ply or .las, for example by CloudCompare"},
     {".vtk", "a legacy file of VTK", "save it as image data in XML (.vti), for example by ParaView"},
     {".pvti", "image data of VTK in several files", "save it as one .vti, for example by ParaView"},
     {".vtu", "an unstructured grid of VTK",
      "make image data of it (.vti) by ParaView's filter 'Resample To Image'"},
     {".vts", "a structured grid of VTK",
      "make image data of it (.vti) by ParaView's filter 'Resample To Image'"},
     {".vtr", "a rectilinear grid of VTK",
      "make image data of it (.vti) by ParaView's filter 'Resample To Image'"},
     {".vtp", "a surface of VTK", "save it as .ply or .stl, for example by ParaView"},
     {".mcstructure", "a structure of Minecraft's Bedrock Edition",
      "save it as .schem, for example by Amulet"},
     {".mca", "a region of a Minecraft world",
      "save the part that you want as .schem, for example by Amulet or WorldEdit"}}};

} // namespace

Expected<Input> refuseInput(const std::string &path, const InputOptions &) {
  const std::string name = lowerCase(path);
  for (const RefusedKind &kind : kRefused)
    if (name.ends_with(kind.ending))
      return Error::input("'" + path + "' is " + std::string(kind.what) + ", which voxc does not read; " +
                          std::string(kind.advice));
  return Error::input("'" + path + "' is no kind of input that is read");
}

} // namespace voxc
