// What opens each kind of input; the table in Input.cpp says which takes what.
#pragma once

#include "voxc/Input/Input.h"

#include <functional>
#include <string>

namespace voxc {

/// Each takes what follows the prefix of its kind, or the path of a file, and options with a memory.
Expected<Input> openBuiltin(const std::string &text, const InputOptions &options);
Expected<Input> openGrid(const std::string &text, const InputOptions &options);
Expected<Input> openMesh(const std::string &path, const InputOptions &options);
/// The same for a mesh that `load` reads.
using LoadScene = std::function<Expected<TriangleScene>(
    const std::string &path, const std::shared_ptr<WorkingMemory> &memory, const Progress &progress)>;
Expected<Input> openMeshBy(const LoadScene &load, const std::string &path, const InputOptions &options);
Expected<Input> openPly(const std::string &path, const InputOptions &options);
Expected<Input> openVolume(const std::string &path, const InputOptions &options);
Expected<Input> openMagicaVoxel(const std::string &path, const InputOptions &options);
/// Schematics of Minecraft (.schem, .litematic, .schematic).
Expected<Input> openMinecraft(const std::string &path, const InputOptions &options);
Expected<Input> openBinvox(const std::string &path, const InputOptions &options);
Expected<Input> openNrrd(const std::string &path, const InputOptions &options);
Expected<Input> openNifti(const std::string &path, const InputOptions &options);
/// A PNG picture, or a pattern of them.
Expected<Input> openSlices(const std::string &path, const InputOptions &options);
Expected<Input> openNanoVdb(const std::string &path, const InputOptions &options);
/// A NumPy array (.npy), or one of an archive (.npz).
Expected<Input> openNumpy(const std::string &path, const InputOptions &options);
/// VTK's image data (.vti).
Expected<Input> openVtk(const std::string &path, const InputOptions &options);
/// Points of laser scans (.las).
Expected<Input> openLas(const std::string &path, const InputOptions &options);
/// What is wrong with a file of a kind that is known and not read, and what would be right; nothing if its
/// kind is not known.
std::optional<Error> refusalOf(const std::string &path);
Expected<Input> openRaw(const std::string &text, const InputOptions &options);

} // namespace voxc
