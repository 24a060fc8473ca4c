// Walking the node tree without recursion: a file may nest its nodes as deep as it likes.
#include "Mesh/Gltf/GltfNodes.h"

#include "Mesh/Gltf/GltfTransforms.h"
#include "Support/Text.h"

#include <algorithm>
#include <set>

namespace voxc {

namespace {

/// Instances take a hundred bytes each, and a file can ask for many in few words: as many as it has bytes are
/// plenty, and so many more.
constexpr std::uint64_t kFewInstances = std::uint64_t{1} << 19;

class NodeReader {
public:
  NodeReader(GltfContext &context, GltfMeshes &meshes, GltfAccessors &accessors, GltfPoses &poses)
      : context_(context), meshes_(meshes), accessors_(accessors), poses_(poses),
        nodes_(context.root.list("nodes")), wasReached_(nodes_.size()) {}

  void read() {
    pushRoots();
    while (!pending_.empty() && !context_.problem) {
      const Pending next = pending_.back();
      pending_.pop_back();
      visit(next);
    }
    warnOfOthers();
  }

private:
  struct Pending {
    std::size_t node;
    Transform parent;
  };

  void pushRoots() {
    const GltfList scenes = context_.root.list("scenes");
    if (const auto scene = context_.root.index("scene", scenes))
      pushAll(scenes[*scene].list("nodes"), {});
    else if (scenes.size() == 0)
      pushAllRoots();
    else
      pushScenes(scenes);
    if (scenes.size() > 1 && !context_.root.has("scene"))
      context_.warnings.add("it has " + std::to_string(scenes.size()) +
                            " scenes and does not say which is shown; all are read as one");
  }

  void warnOfOthers() {
    std::uint64_t others = 0, placed = 0;
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      if (nodes_[node].has("mesh"))
        ++(wasReached_[node] ? placed : others);
    if (placed == 0 && meshes_.list().size() != 0 && !context_.problem)
      context_.problem.set(
          others == 0
              ? "its meshes are placed by no node; give each a node in the scene"
              : "all its nodes that have a mesh are hidden, or are not reached from the scene that is shown");
    warnOfMeshes();
    if (others != 0)
      context_.warnings.add("meshes that are hidden or outside of the scene that is shown are left out: " +
                            counted(others, "node"));
  }

  /// Meshes that no node has, hidden or not.
  void warnOfMeshes() {
    std::set<std::uint64_t> named;
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      if (const auto mesh = nodes_[node].count("mesh"))
        named.insert(*mesh);
    const std::uint64_t meshes = meshes_.list().size();
    const std::uint64_t others = meshes - std::min<std::uint64_t>(meshes, named.size());
    if (others != 0)
      context_.warnings.add((others == 1 ? "1 mesh is" : std::to_string(others) + " meshes are") +
                            " left out, which no node has");
  }

  /// Of a node and all below it.
  static bool isHidden(const GltfObject &node) {
    const GltfObject visibility = node.extension("KHR_node_visibility");
    return visibility && visibility.has("visible") && !visibility.flag("visible");
  }

  /// No scene is the default: every node that is no one's child.
  void pushAllRoots() {
    std::vector<bool> isChild(nodes_.size());
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const GltfList children = nodes_[node].list("children");
      for (std::size_t i = 0; i < children.size(); ++i)
        if (const auto child = children.index(i, nodes_))
          isChild[*child] = true;
    }
    for (std::size_t node = nodes_.size(); node-- > 0;)
      if (!isChild[node])
        push(node, {});
  }

  /// The last of a list is pushed first, so that the first is visited first.
  void pushAll(const GltfList &list, const Transform &parent) {
    for (std::size_t i = list.size(); i-- > 0;)
      if (const auto node = list.index(i, nodes_))
        push(*node, parent);
  }

  /// A node may be a root of several scenes, and is read once.
  void pushScenes(const GltfList &scenes) {
    std::set<std::size_t> pushed;
    for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
      const GltfList roots = scenes[scene].list("nodes");
      for (std::size_t i = 0; i < roots.size(); ++i)
        if (const auto node = roots.index(i, nodes_); node && pushed.insert(*node).second)
          push(*node, {});
    }
    std::ranges::reverse(pending_);
  }

  void push(std::size_t node, const Transform &parent) {
    if (isHidden(nodes_[node]))
      return;
    if (wasReached_[node])
      nodes_[node].problem("is reached twice, but nodes make a tree");
    wasReached_[node] = true;
    pending_.push_back({node, parent});
  }

  void visit(const Pending &pending) {
    const GltfObject node = nodes_[pending.node];
    const Transform toModel = compose(pending.parent, readTransform(node));
    if (!isFinite(toModel))
      node.problem("has a transform that is not finite");
    if (const auto mesh = node.index("mesh", meshes_.list()))
      addMesh(node, *mesh, toModel);
    pushAll(node.list("children"), toModel);
  }

  void addMesh(const GltfObject &node, std::size_t mesh, const Transform &toModel) {
    const std::optional<GltfPose> pose = poses_.of(node, meshes_.list()[mesh], toModel);
    if (context_.problem)
      return;
    const GltfMeshes::Parts parts = pose ? meshes_.parts(mesh, *pose) : meshes_.parts(mesh);
    const GltfObject instancing = node.extension("EXT_mesh_gpu_instancing");
    // Joints place what they are bound to, wherever its node stands.
    if (pose && pose->joints) {
      if (instancing)
        context_.warnings.add(node.name() + " has a skin and instances, of which one is read");
      return addInstance(node, parts, {});
    }
    if (!instancing)
      return addInstance(node, parts, toModel);
    for (const std::string_view name : instancing.object("attributes").keys())
      if (name != "TRANSLATION" && name != "ROTATION" && name != "SCALE")
        context_.unused.insert(std::string(name) + " of instances");
    const InstanceTransforms transforms(instancing, accessors_);
    for (std::uint64_t i = 0; i < transforms.count() && !context_.problem; ++i)
      addInstance(node, parts, compose(toModel, transforms.at(i)));
  }

  void addInstance(const GltfObject &node, GltfMeshes::Parts parts, const Transform &toModel) {
    const std::uint64_t most = kFewInstances + context_.fileBytes;
    if (context_.scene.instances.size() + (parts.end - parts.begin) > most)
      return node.problem("and those before it make more than " + std::to_string(most) +
                          " instances of primitives, too many for a file of its size");
    for (std::uint32_t part = parts.begin; part < parts.end; ++part)
      context_.scene.instances.push_back({part, toModel});
  }

  GltfContext &context_;
  GltfMeshes &meshes_;
  GltfAccessors &accessors_;
  GltfPoses &poses_;
  GltfList nodes_;
  std::vector<bool> wasReached_;
  std::vector<Pending> pending_;
};

} // namespace

void readGltfNodes(GltfContext &context, GltfMeshes &meshes, GltfAccessors &accessors, GltfPoses &poses) {
  NodeReader(context, meshes, accessors, poses).read();
}

} // namespace voxc
