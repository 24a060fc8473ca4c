// Following the scene graph, by a stack of its own: a file may nest its nodes as deeply as it likes.
#include "Input/MagicaVoxel/VoxScene.h"

#include "Support/Text.h"

#include <algorithm>
#include <set>

namespace voxc {

namespace {

class SceneBuilder {
public:
  SceneBuilder(const VoxFile &file, VoxScene &scene) : file_(file), scene_(scene) {}

  Expected<void> run() {
    // Copies by reference share nodes, so that a small file may stand for a scene without end.
    constexpr std::uint64_t kMostVisits = std::uint64_t{1} << 20;
    stack_.push_back({0, 0, {}});
    for (std::uint64_t visits = 0; !stack_.empty(); ++visits) {
      if (visits == kMostVisits)
        return Error::input("its scene graph, written out, has more than " + std::to_string(kMostVisits) +
                            " nodes");
      const Step step = stack_.back();
      stack_.pop_back();
      VOXC_TRY(visit(step));
    }
    return {};
  }

  /// What the graph has and the scene has not.
  void warn() const {
    if (scene_.instances.empty())
      return scene_.warnings.push_back("nothing of its scene is to be seen: all models are hidden");
    if (hidden_ != 0)
      scene_.warnings.push_back("hidden parts of its scene are left out: " + counted(hidden_, "node"));
    // Of an animation others may be seen at other times.
    std::set<std::uint32_t> named;
    for (const auto &[number, node] : file_.nodes)
      if (node.kind == VoxNode::Kind::Shape)
        named.insert(node.model);
    if (file_.frames == 1 && named.size() < file_.models.size())
      scene_.warnings.push_back(countedAre(file_.models.size() - named.size(), "model") +
                                " left out, which its scene does not place");
  }

private:
  struct Step {
    std::uint32_t number;
    std::uint32_t depth;
    Placement above;
  };

  Expected<void> visit(const Step &step) {
    const auto found = file_.nodes.find(step.number);
    if (found == file_.nodes.end())
      return Error::input("its scene graph names the node " + std::to_string(step.number) +
                          ", which it does not have");
    if (step.depth > file_.nodes.size())
      return Error::input("its node " + std::to_string(step.number) + " stands below itself");
    const VoxNode &node = found->second;
    if (node.isHidden || file_.hiddenLayers.contains(node.layer)) {
      ++hidden_;
      return {};
    }
    if (node.kind == VoxNode::Kind::Shape)
      return addInstance(node.model, step.above);
    const auto placement = step.above.around(node.placement);
    if (!placement)
      return Error::input("its node " + std::to_string(step.number) + " is moved too far");
    // Backwards, so that the first child is visited first.
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      stack_.push_back({*child, step.depth + 1, *placement});
    return {};
  }

  Expected<void> addInstance(std::uint32_t number, const Placement &placement) {
    if (number >= file_.models.size())
      return Error::input("its scene graph names the model " + std::to_string(number) + " of " +
                          std::to_string(file_.models.size()));
    const VoxModel &model = file_.models[number];
    // A model turns about the middle of its cells, rounded down.
    Placement centred;
    centred.setTranslation({-(model.size[0] / 2), -(model.size[1] / 2), -(model.size[2] / 2)});
    const auto whole = placement.around(centred);
    if (!whole)
      return Error::input("its model " + std::to_string(number) + " is moved too far");
    scene_.instances.push_back({&model, *whole});
    return {};
  }

  const VoxFile &file_;
  VoxScene &scene_;
  std::vector<Step> stack_;
  std::uint64_t hidden_ = 0; ///< Nodes, without those below.
};

/// The box around all instances that have any cells.
Expected<void> findBox(VoxScene &scene) {
  Long3 high{};
  bool any = false;
  for (const VoxInstance &instance : scene.instances) {
    const Long3 &modelSize = instance.model->size;
    if (std::ranges::count(modelSize, 0) != 0)
      continue;
    const Long3 low = instance.placement.moveBox({}, modelSize);
    const Long3 size = instance.placement.turnSize(modelSize);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scene.low[axis] = any ? std::min(scene.low[axis], low[axis]) : low[axis];
      high[axis] = any ? std::max(high[axis], low[axis] + size[axis]) : low[axis] + size[axis];
    }
    any = true;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    scene.size[axis] = any ? high[axis] - scene.low[axis] : 1;
    if (scene.size[axis] > std::int64_t{1} << kMaxLog2Extent)
      return Error::input("its scene takes " + std::to_string(scene.size[axis]) +
                          " cells on an axis; there may be 2097152");
  }
  return {};
}

void warnOfNames(const std::string &sentence, const std::set<std::string> &names, VoxScene &scene) {
  std::string list;
  for (const std::string &name : names)
    list += (list.empty() ? "" : ", ") + name;
  if (!list.empty())
    scene.warnings.push_back(sentence + list);
}

} // namespace

Expected<VoxScene> makeVoxScene(const VoxFile &file, std::optional<std::int32_t> frame) {
  VoxScene scene;
  const bool hasGraph = !file.nodes.empty();
  scene.frames = hasGraph ? file.frames : static_cast<std::int32_t>(file.models.size());
  if (frame && *frame >= scene.frames)
    return Error::input("it has no frame " + std::to_string(std::int64_t{*frame} + 1) + "; there " +
                        (scene.frames == 1 ? "is one" : "are " + std::to_string(scene.frames)));
  if (hasGraph) {
    SceneBuilder builder(file, scene);
    VOXC_TRY(builder.run());
    builder.warn();
  } else {
    scene.instances.push_back({&file.models[static_cast<std::size_t>(frame.value_or(0))], {}});
  }
  if (file.bytesBehind != 0)
    scene.warnings.push_back(countedAre(file.bytesBehind, "byte") +
                             " left out, which lie behind the voxels of its models");
  warnOfNames("chunks that are not known are left out: ", file.unknown, scene);
  warnOfNames("chunks and attributes of its editor, which change no voxel, are not used: ", file.unused,
              scene);
  if (!frame && scene.frames > 1) {
    const std::string count = std::to_string(scene.frames);
    scene.warnings.push_back(
        (hasGraph ? "its scene graph moves in " + count + " frames"
                  : "it holds " + count + " models without a scene graph, the frames of an animation") +
        "; the first is taken, and another by a number behind the name, as in scene.vox#" + count);
  }
  VOXC_TRY(findBox(scene));
  return scene;
}

} // namespace voxc
