// Reading images, and giving each corner of a face its own attributes.
#include "Mesh/Ply/PlyTextures.h"

#include "Mesh/FileBeside.h"
#include "Mesh/KeptArray.h"
#include "Mesh/TextureSet.h"

#include <cstring>
#include <limits>
#include <utility>

namespace voxc {

namespace {

using Look = PlyFaceLooks::Look;

void warnAboutColours(Warnings &warnings) {
  warnings.add("there are colours beside textures, which are not used: the textures have them in themselves");
}

/// True if all vertices have one colour, which then says little.
bool areOneColour(const AttributeView &colours) {
  if (!colours)
    return true;
  const auto first = readRow<4>(colours, 0);
  for (std::uint64_t i = 1; i < colours.count; ++i)
    if (readRow<4>(colours, i) != first)
      return false;
  return true;
}

/// Copies attributes to corners, the triangles in a given order.
class CornerCopier {
public:
  CornerCopier(const MeshPart &part, std::span<const Look> looks, std::span<const std::uint32_t> order,
               const std::shared_ptr<WorkingMemory> &memory, Problem &problem)
      : part_(part), looks_(looks), order_(order), memory_(memory), problem_(problem) {}

  AttributeView positions(TriangleScene &scene) const {
    return part_.positions.type == AttributeView::Type::Float64
               ? rows<double, 3>(part_.positions, kDoubleRows3, scene)
               : rows<float, 3>(part_.positions, kFloatRows3, scene);
  }

  AttributeView vertexUvs(TriangleScene &scene) const {
    return rows<float, 2>(part_.uvs, kFloatRows2, scene);
  }

  AttributeView ownUvs(TriangleScene &scene) const {
    return copy<PlyUv>(kFloatRows2, scene, [&](std::uint32_t triangle, std::size_t corner) {
      return looks_[triangle].uvs[corner];
    });
  }

  AttributeView vertexColours(TriangleScene &scene) const {
    return copy<std::uint32_t>(kColourRows, scene, [&](std::uint32_t triangle, std::size_t corner) {
      std::uint32_t word;
      std::memcpy(&word, part_.colours.data + std::uint64_t{vertex(triangle, corner)} * sizeof word,
                  sizeof word);
      return word;
    });
  }

  AttributeView ownColours(TriangleScene &scene) const {
    return copy<std::uint32_t>(kColourRows, scene,
                               [&](std::uint32_t triangle, std::size_t) { return looks_[triangle].colour; });
  }

private:
  std::uint32_t vertex(std::uint32_t triangle, std::size_t corner) const {
    return readIndex(part_.indices, std::uint64_t{3} * triangle + corner);
  }

  template <typename Row, typename Of>
  AttributeView copy(RowKind kind, TriangleScene &scene, const Of &rowOf) const {
    ScratchArray<Row> copied(memory_);
    for (const std::uint32_t triangle : order_)
      for (std::size_t corner = 0; corner < 3; ++corner)
        problem_.check(copied.push(rowOf(triangle, corner)));
    return keep(std::move(copied), kind, scene);
  }

  template <typename Number, int N>
  AttributeView rows(const AttributeView &view, RowKind kind, TriangleScene &scene) const {
    return copy<std::array<Number, N>>(kind, scene, [&](std::uint32_t triangle, std::size_t corner) {
      const std::array<double, N> row = readRow<N>(view, vertex(triangle, corner));
      std::array<Number, N> numbers;
      for (std::size_t i = 0; i < N; ++i)
        numbers[i] = static_cast<Number>(row[i]);
      return numbers;
    });
  }

  const MeshPart &part_;
  std::span<const Look> looks_;
  std::span<const std::uint32_t> order_;
  const std::shared_ptr<WorkingMemory> &memory_;
  Problem &problem_;
};

/// Where the triangles of each texture begin, from none on, if they stand together; and where the last end.
std::vector<std::uint64_t> beginsOf(std::span<const Look> looks, std::size_t materials) {
  std::vector<std::uint64_t> begins(materials + 1);
  for (const Look &look : looks)
    ++begins[static_cast<std::size_t>(look.texture + 1) + 1];
  for (std::size_t i = 1; i < begins.size(); ++i)
    begins[i] += begins[i - 1];
  return begins;
}

/// Some rows of a view.
AttributeView rowsOf(AttributeView view, std::uint64_t begin, std::uint64_t end) {
  if (view)
    view.data += begin * view.stride;
  view.count = view ? end - begin : 0;
  return view;
}

void addInstance(const MeshPart &part, TriangleScene &scene) {
  scene.instances.push_back({static_cast<std::uint32_t>(scene.parts.size()), {}});
  scene.parts.push_back(part);
}

bool isTextured(const TriangleScene &scene, std::size_t material) {
  return scene.materials[material].texture.texture >= 0;
}

} // namespace

void addTextures(const PlyHeader &header, const MeshInput &input, TriangleScene &scene, Warnings &warnings,
                 Problem &problem) {
  TextureSet textures(input.memory, scene, warnings);
  FilesBeside files;
  const std::string folder = input.folder();
  scene.materials.emplace_back();
  for (const std::string &name : header.textures) {
    const auto found = files.find(name, std::span(&folder, 1));
    if (found && found->isElsewhere)
      warnings.add("the texture '" + name + "' is not there; '" + found->path +
                   "' beside the model is taken");
    const auto texture = textures.readFile(found ? found->path : pathBelow(folder, name));
    if (!texture)
      return problem.set(texture.error());
    scene.materials.emplace_back().texture.texture = *texture;
  }
  scene.loaderPeakBytes = textures.libraryPeakBytes();
}

void addPart(MeshPart part, TriangleScene &scene, Warnings &warnings) {
  if (!part.positions || !part.indices)
    return;
  part.material = part.uvs && scene.materials.size() > 1 ? 1 : 0;
  if (isTextured(scene, part.material) && part.colours) {
    warnAboutColours(warnings);
    part.colours = {};
  }
  addInstance(part, scene);
}

void addPartsByLook(const MeshPart &part, const PlyFaceLooks &looks,
                    const std::shared_ptr<WorkingMemory> &memory, TriangleScene &scene, Warnings &warnings,
                    Problem &problem) {
  const std::span<const Look> triangles = looks.triangles();
  if (triangles.size() > std::numeric_limits<std::uint32_t>::max())
    return problem.set("it has 2^32 triangles or more");
  const std::vector<std::uint64_t> begins = beginsOf(triangles, scene.materials.size());
  ScratchArray<std::uint32_t> order(memory);
  problem.check(order.resize(triangles.size()));
  if (problem || triangles.empty() || !part.positions)
    return;
  std::vector<std::uint64_t> places(begins);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    order[places[static_cast<std::size_t>(triangles[i].texture + 1)]++] = i;
  const CornerCopier copier(part, triangles, order.span(), memory, problem);
  MeshPart all;
  all.positions = copier.positions(scene);
  if (looks.hasUvs())
    all.uvs = copier.ownUvs(scene);
  else if (part.uvs)
    all.uvs = copier.vertexUvs(scene);
  const bool areFaces = looks.hasColours() && areOneColour(part.colours);
  if (looks.hasColours() && part.colours)
    warnings.add(areFaces ? "faces have colours of their own; the one colour of all vertices is not used"
                          : "vertices have colours; those of faces are not used");
  if (areFaces)
    all.colours = copier.ownColours(scene);
  else if (part.colours)
    all.colours = copier.vertexColours(scene);
  if (problem)
    return;
  bool hidesColours = false;
  for (std::size_t material = 0; material + 1 < begins.size(); ++material) {
    const std::uint64_t begin = 3 * begins[material], end = 3 * begins[material + 1];
    if (begin == end)
      continue;
    MeshPart some;
    some.material = static_cast<std::uint32_t>(material);
    some.positions = rowsOf(all.positions, begin, end);
    const bool textured = isTextured(scene, material);
    hidesColours = hidesColours || (textured && all.colours);
    some.uvs = textured ? rowsOf(all.uvs, begin, end) : AttributeView();
    some.colours = textured ? AttributeView() : rowsOf(all.colours, begin, end);
    addInstance(some, scene);
  }
  if (hidesColours)
    warnAboutColours(warnings);
}

} // namespace voxc
