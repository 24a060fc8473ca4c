// Scenes by name.
#include "hard-rays/HardRayScenes.h"

#include "testing/HardScenes.h"

#include <algorithm>

namespace voxc::tool {

namespace {

constexpr const char *kInput = "input";

Error unknownScene(const std::string &name) {
  std::string names;
  for (const test::HardScene &scene : test::hardScenes({1, 1, 1}))
    names += (names.empty() ? "" : ", ") + scene.name;
  return Error::input("there is no scene '" + name + "'; the scenes are " + names +
                      ", and input if one is given");
}

} // namespace

void HardRayScenes::declare(const CommandLine &command) {
  command.add("INPUT", input_, "One more scene, such as a scan: as INPUT of voxc build").takes("");
  addInputArguments(command, inputArguments_);
  command.add("--scene", chosen_, "This scene alone; may be given several times; input is INPUT")
      .takes("NAME")
      .repeated();
}

Expected<std::vector<std::string>> HardRayScenes::names() const {
  std::vector<std::string> names;
  for (const test::HardScene &scene : test::hardScenes({1, 1, 1}))
    names.push_back(scene.name);
  if (!input_.empty())
    names.emplace_back(kInput);
  for (const std::string &name : chosen_)
    if (std::ranges::find(names, name) == names.end())
      return unknownScene(name);
  return chosen_.empty() ? names : chosen_;
}

Expected<std::unique_ptr<VoxelSource>> HardRayScenes::open(const std::string &name, Int3 extent,
                                                           const Progress &progress) const {
  if (name == kInput && !input_.empty()) {
    InputOptions options = makeInputOptions(inputArguments_, extent);
    options.progress = progress;
    auto input = VOXC_TRY(openInput(input_, options));
    return std::move(input.source);
  }
  for (const test::HardScene &scene : test::hardScenes(extent))
    if (scene.name == name)
      return scene.source();
  return unknownScene(name);
}

} // namespace voxc::tool
