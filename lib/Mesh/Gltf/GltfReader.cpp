// The reading of a glTF model from its container to its instances.
#include "Mesh/Gltf/GltfReader.h"

#include "Mesh/Gltf/GltfExtensions.h"
#include "Mesh/Gltf/GltfFile.h"
#include "Mesh/Gltf/GltfNodes.h"
#include "Support/ResidentGrowth.h"
#include "Support/Text.h"

namespace voxc {

namespace {

void checkVersion(GltfContext &context) {
  const GltfObject asset = context.root.object("asset");
  const std::string version(asset.text("version"));
  if (version.empty())
    context.problem.set("it has no asset.version, so it is no glTF");
  else if (!version.starts_with("2."))
    context.problem.set("it is glTF " + version + "; only glTF 2 is read");
  else if (const std::string least(asset.text("minVersion")); !least.empty() && least != "2.0")
    context.problem.set("it needs a reader of glTF " + least + "; glTF 2.0 is read");
}

/// One sentence for all that has no place in voxels.
void warnOfUnused(GltfContext &context) {
  if (context.root.list("cameras").size() != 0)
    context.unused.insert("cameras");
  std::string names;
  for (const std::string &name : context.unused)
    names += (names.empty() ? "" : ", ") + name;
  if (!names.empty())
    context.warnings.add("of the model these are not used: " + names.substr(0, 400));
}

void readModel(GltfContext &context) {
  checkVersion(context);
  checkGltfExtensions(context);
  if (context.problem)
    return;
  GltfBuffers buffers(context);
  GltfAccessors accessors(context, buffers);
  GltfMaterials materials(context, buffers);
  GltfPoses poses(context, buffers, accessors);
  GltfMeshes meshes(context, buffers, accessors, materials, poses);
  readGltfNodes(context, meshes, accessors, poses);
  if (context.root.list("animations").size() != 0)
    context.warnings.add("animations are not applied: the model is read as it stands without them");
  warnOfUnused(context);
  context.scene.loaderPeakBytes += materials.libraryPeakBytes();
}

} // namespace

Expected<TriangleScene> readGltf(const MeshInput &input) {
  const auto parts = VOXC_TRY(splitGltf(input.file->bytes()));
  const ResidentGrowth growth;
  const auto document = VOXC_TRY(JsonDocument::parse(parts.json));
  TriangleScene scene;
  scene.loaderPeakBytes = growth.bytes();
  Warnings warnings;
  Problem problem;
  GltfContext context{GltfObject(document.root(), "", problem),
                      parts.binary,
                      input.file->bytes().size(),
                      GltfUris(input.folder(), warnings),
                      input.memory,
                      scene,
                      warnings,
                      problem,
                      input.wantsMetal};
  if (parts.others != 0)
    warnings.add(countedAre(parts.others, "byte") +
                 " left out, of chunks that are not known or behind the last chunk");
  readModel(context);
  if (problem)
    return problem.error();
  scene.warnings = warnings.take();
  scene.storage.push_back(input.file);
  return scene;
}

} // namespace voxc
