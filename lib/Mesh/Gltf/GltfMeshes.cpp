// Primitives: positions, indices, and the attributes that colour them.
#include "Mesh/Gltf/GltfMeshes.h"

#include <algorithm>
#include <array>

namespace voxc {

namespace {

using Type = AttributeView::Type;

constexpr std::uint64_t kModes = 7;
constexpr std::uint64_t kTriangles = 4;

/// To read a primitive again takes about as long as to move so many vertices.
constexpr std::uint64_t kRowsOfPrimitive = 64;

/// What rounding leaves of a colour of 1.
constexpr double kMostLight = 1.001;

/// What may stand in an index.
bool isIndexType(Type type) { return type == Type::Uint8 || type == Type::Uint16 || type == Type::Uint32; }

/// Normals are of every model, and mean nothing; the other attributes are used where something asks for them.
bool isKnownAttribute(std::string_view name) {
  static constexpr std::array<std::string_view, 3> kPlain{"POSITION", "NORMAL", "TANGENT"};
  static constexpr std::array<std::string_view, 3> kNumbered{"TEXCOORD_", "JOINTS_", "WEIGHTS_"};
  return name == "COLOR_0" || std::ranges::find(kPlain, name) != kPlain.end() ||
         std::ranges::any_of(kNumbered, [&](std::string_view known) { return name.starts_with(known); });
}

bool isFloat(Type type) { return type == Type::Float32 || type == Type::Float64; }

/// True if a skin moves one of them; others beside it stay where they are.
bool hasJoints(const GltfList &primitives) {
  for (std::size_t i = 0; i < primitives.size(); ++i)
    if (const GltfObject attributes = primitives[i].object("attributes");
        attributes.has("JOINTS_0") && attributes.has("WEIGHTS_0"))
      return true;
  return false;
}

} // namespace

GltfMeshes::GltfMeshes(GltfContext &context, GltfBuffers &buffers, GltfAccessors &accessors,
                       GltfMaterials &materials, GltfPoses &poses)
    : context_(context), buffers_(buffers), accessors_(accessors), materials_(materials),
      list_(context.root.list("meshes")), poses_(poses), known_(list_.size()) {}

GltfMeshes::Parts GltfMeshes::parts(std::size_t mesh) {
  std::optional<Parts> &known = known_[mesh];
  if (!known)
    known = readParts(mesh, nullptr);
  return *known;
}

GltfMeshes::Parts GltfMeshes::parts(std::size_t mesh, const GltfPose &pose) { return readParts(mesh, &pose); }

GltfMeshes::Parts GltfMeshes::readParts(std::size_t mesh, const GltfPose *pose) {
  const GltfList primitives = list_[mesh].list("primitives");
  Parts parts;
  if (pose && !poses_.spend(list_[mesh], kRowsOfPrimitive * primitives.size()))
    return parts;
  parts.begin = static_cast<std::uint32_t>(context_.scene.parts.size());
  for (std::size_t i = 0; i < primitives.size() && !context_.problem; ++i)
    readPrimitive(primitives[i], pose);
  if (pose && pose->joints && !context_.problem && !hasJoints(primitives))
    context_.warnings.add(
        list_[mesh].name() +
        " has a skin, but no primitive with JOINTS_0 and WEIGHTS_0: the skin moves nothing");
  parts.end = static_cast<std::uint32_t>(context_.scene.parts.size());
  return parts;
}

void GltfMeshes::noteAttributes(const GltfObject &attributes) {
  for (const std::string_view name : attributes.keys())
    if (!isKnownAttribute(name))
      context_.unused.insert(std::string(name));
}

void GltfMeshes::checkSurplus(const GltfObject &primitive, const MeshPart &part) {
  const std::uint64_t corners = (part.indices ? part.indices : part.positions).count;
  const std::uint64_t each = part.mode == PrimitiveMode::Triangles ? 3
                             : part.mode == PrimitiveMode::Lines   ? 2
                                                                   : 1;
  if (corners % each != 0)
    context_.warnings.add(primitive.name() + " has " + std::to_string(corners) +
                          " corners; those behind its last whole " + (each == 3 ? "triangle" : "line") +
                          " are left out");
}

void GltfMeshes::readPrimitive(const GltfObject &primitive, const GltfPose *pose) {
  MeshPart part;
  const std::uint64_t mode = primitive.count("mode").value_or(kTriangles);
  if (mode >= kModes) {
    primitive.problem("has the mode " + std::to_string(mode) + "; there are 0 to 6");
    return;
  }
  part.mode = static_cast<PrimitiveMode>(mode);
  const GltfObject attributes = primitive.object("attributes");
  if (!attributes.has("POSITION")) {
    context_.warnings.add(primitive.name() + " has no positions and is left out");
    return;
  }
  draco_.reset();
  if (const GltfObject draco = primitive.extension("KHR_draco_mesh_compression")) {
    draco_ = DracoMesh::decode(context_, buffers_, draco);
    part.mode = PrimitiveMode::Triangles; // Strips are written out.
    if (!draco_)
      return;
  }
  noteAttributes(attributes);
  part.positions = attribute(attributes, "POSITION", 3, 3, part);
  part.indices = draco_ ? draco_->indices() : readIndices(primitive);
  checkSurplus(primitive, part);
  const GltfMaterials::Use use = materials_.use(primitive);
  part.material = use.material;
  const Material &material = context_.scene.materials[use.material];
  part.uvs = readUvs(attributes, material.texture, use.uvSet, part);
  part.emissionUvs = readUvs(attributes, material.emissionTexture, use.emissionUvSet, part);
  part.metalUvs = readUvs(attributes, material.metalTexture, use.metalUvSet, part);
  readColours(attributes, part);
  if (pose && !context_.problem)
    applyPose(primitive, *pose, part);
  const bool hasIndices = draco_ || primitive.has("indices");
  const bool isEmpty = part.positions.count == 0 || (hasIndices && part.indices.count == 0);
  if (!context_.problem && !isEmpty)
    context_.scene.parts.push_back(part);
}

AttributeView GltfMeshes::readUvs(const GltfObject &attributes, const TextureUse &texture, std::uint64_t set,
                                  const MeshPart &part) {
  if (texture.texture < 0)
    return {};
  const std::string name = "TEXCOORD_" + std::to_string(set);
  if (!attributes.has(name))
    context_.warnings.add(attributes.name() + " has no " + name + ", which a texture takes: it is left out");
  return attribute(attributes, name, 2, 2, part);
}

void GltfMeshes::applyPose(const GltfObject &primitive, const GltfPose &pose, MeshPart &part) {
  const std::vector<GltfMorph> morphs = morphsOf(primitive, pose, part);
  const std::vector<GltfJointSet> sets =
      pose.joints ? jointSetsOf(primitive.object("attributes"), part) : std::vector<GltfJointSet>();
  if (!context_.problem && part.positions && (pose.joints || !morphs.empty()))
    part.positions = poses_.positions(primitive, part.positions, pose, morphs, sets);
}

std::vector<GltfMorph> GltfMeshes::morphsOf(const GltfObject &primitive, const GltfPose &pose,
                                            const MeshPart &part) {
  std::vector<GltfMorph> morphs;
  const GltfList targets = primitive.list("targets");
  for (std::size_t i = 0; i < std::min(targets.size(), pose.weights.size()); ++i) {
    if (pose.weights[i] == 0)
      continue;
    const GltfObject target = targets[i];
    // What is compressed is the primitive, and not its targets.
    const auto index = target.index("POSITION", accessors_.list());
    const AttributeView deltas =
        index ? checked(target, "POSITION", *index, accessors_.view(*index), {3, 3}, part) : AttributeView();
    if (deltas)
      morphs.push_back({deltas, pose.weights[i]});
    if (target.has("COLOR_0") || target.has("TEXCOORD_0") || target.has("TEXCOORD_1"))
      context_.warnings.add("morph targets of colours and texture coordinates are not applied");
  }
  return morphs;
}

std::vector<GltfJointSet> GltfMeshes::jointSetsOf(const GltfObject &attributes, const MeshPart &part) {
  std::vector<GltfJointSet> sets;
  for (std::size_t i = 0; !context_.problem; ++i) {
    const std::string end = "_" + std::to_string(i);
    GltfJointSet set{attribute(attributes, "JOINTS" + end, 4, 4, part),
                     attribute(attributes, "WEIGHTS" + end, 4, 4, part)};
    if (!set.joints || !set.weights)
      break;
    if (set.joints.type != Type::Uint8 && set.joints.type != Type::Uint16)
      attributes.problem("has joints that are not whole numbers from 0 to 65535");
    // Integers of weights are fractions and those of joints are not, whether their accessors say so or not.
    set.weights.normalized = !isFloat(set.weights.type);
    set.joints.normalized = false;
    sets.push_back(set);
  }
  return sets;
}

void GltfMeshes::readColours(const GltfObject &attributes, MeshPart &part) {
  part.colours = attribute(attributes, "COLOR_0", 3, 4, part);
  if (isFloat(part.colours.type) && areAboveOne(attributes, part.colours))
    context_.warnings.add(attributes.name() + " has a COLOR_0 above 1, which is cut there");
  // Integers of colours are fractions whether the accessor says so or not.
  part.colours.normalized = !isFloat(part.colours.type);
}

bool GltfMeshes::areAboveOne(const GltfObject &attributes, const AttributeView &colours) {
  const auto accessor = attributes.index("COLOR_0", accessors_.list());
  if (!colours || !accessor || !aboveOne_.insert(*accessor).second)
    return false;
  for (std::uint64_t row = 0; row < colours.count; ++row)
    if (std::ranges::max(readRow<3>(colours, row)) > kMostLight)
      return true;
  return false;
}

AttributeView GltfMeshes::rowsOf(const std::string &name, std::size_t index) const {
  AttributeView view = draco_ ? draco_->attribute(name) : AttributeView();
  if (!view)
    return accessors_.view(index);
  view.normalized = accessors_.list()[index].flag("normalized");
  return view;
}

AttributeView GltfMeshes::attribute(const GltfObject &attributes, const std::string &name,
                                    std::uint8_t fewest, std::uint8_t most, const MeshPart &part) {
  const auto index = attributes.index(name, accessors_.list());
  return index ? checked(attributes, name, *index, rowsOf(name, *index), {fewest, most}, part)
               : AttributeView();
}

AttributeView GltfMeshes::checked(const GltfObject &attributes, const std::string &name, std::size_t index,
                                  const AttributeView &view, std::array<std::uint8_t, 2> components,
                                  const MeshPart &part) const {
  const std::string accessor = accessors_.list()[index].name();
  if (view && (view.components < components[0] || view.components > components[1]))
    attributes.problem("uses " + accessor + " as " + name + ", but it has " +
                       std::to_string(view.components) + " components");
  else if (part.positions && view.count < part.positions.count)
    attributes.problem("uses " + accessor + " as " + name + ", but it has " + std::to_string(view.count) +
                       " rows for " + std::to_string(part.positions.count) + " positions");
  return view;
}

AttributeView GltfMeshes::readIndices(const GltfObject &primitive) {
  const auto index = primitive.index("indices", accessors_.list());
  if (!index)
    return {};
  const AttributeView view = accessors_.view(*index);
  if (view && (view.components != 1 || !isIndexType(view.type)))
    primitive.problem("has indices that are not whole numbers from 0 on");
  return view;
}

} // namespace voxc
