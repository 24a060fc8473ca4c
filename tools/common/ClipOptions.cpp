// The options that cut away what is not to be seen.
#include "ClipOptions.h"

#include "CameraOptions.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

namespace voxc::tool {
namespace {

/// So many numbers, parted by commas; nothing if the text is something else.
template <std::size_t count> std::optional<std::array<double, count>> numbersOf(std::string_view text) {
  std::array<double, count> numbers{};
  const char *at = text.data();
  const char *const end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [rest, problem] = std::from_chars(at, end, numbers[i]);
    const bool isLast = i + 1 == count;
    if (problem != std::errc{} || !std::isfinite(numbers[i]) || (rest == end) != isLast)
      return std::nullopt;
    if (!isLast && *rest != ',')
      return std::nullopt;
    at = rest + 1;
  }
  return numbers;
}

/// Takes the word away that says that numbers are in the units of the model.
bool takeModelUnits(std::string_view &text) {
  const bool isInModel = text.starts_with(kModelUnits);
  if (isInModel)
    text.remove_prefix(std::strlen(kModelUnits));
  return isInModel;
}

Expected<void> addBox(std::string_view text, const Transform &voxelToModel, Clip &clip) {
  const std::string written(text);
  const bool isInModel = takeModelUnits(text);
  const auto box = numbersOf<6>(text);
  if (!box)
    return Error::usage(
        "--clip-box \"" + written +
        "\" should be two corners, X0,Y0,Z0,X1,Y1,Z1, in voxels or after model: in the units of "
        "the model");
  const glm::dvec3 low((*box)[0], (*box)[1], (*box)[2]), high((*box)[3], (*box)[4], (*box)[5]);
  for (int axis = 0; axis < 3; ++axis)
    if (!(low[axis] < high[axis]))
      return Error::usage("--clip-box \"" + written +
                          "\" holds nothing: its first corner should be below the "
                          "second on each axis");
  Clip kept;
  kept.keepBox(low, high);
  for (const ClipPlane &plane : kept.planes)
    clip.planes.push_back(isInModel ? inVoxels(plane, voxelToModel) : plane);
  return {};
}

Expected<void> addPlane(std::string_view text, const Transform &voxelToModel, Clip &clip) {
  const std::string written(text);
  const bool isInModel = takeModelUnits(text);
  const auto numbers = numbersOf<4>(text);
  const glm::dvec3 normal = numbers ? glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]) : glm::dvec3(0);
  if (normal == glm::dvec3(0))
    return Error::usage(
        "--clip-plane \"" + written +
        "\" should be NX,NY,NZ,D, a direction and a number, in voxels or after model: in the units "
        "of the model");
  const ClipPlane plane{normal, (*numbers)[3]};
  clip.planes.push_back(isInModel ? inVoxels(plane, voxelToModel) : plane);
  return {};
}

} // namespace

void addClipOptions(const CommandLine &command, ClipOptions &options) {
  const OptionGroup group(command, "Picture");
  command
      .add("--clip-box", options.box,
           "Show only what lies between two corners, in voxels, or after 'model:' in the units of the model; "
           "inner voxels show at the cut")
      .takes("[model:]X0,Y0,Z0,X1,Y1,Z1");
  command
      .add("--clip-plane", options.planes,
           "Cut away where NX x + NY y + NZ z is less than D; may be given several times")
      .takes("[model:]NX,NY,NZ,D")
      .repeated();
}

Expected<Clip> clipOf(const ClipOptions &options, const Transform &voxelToModel) {
  Clip clip;
  if (!options.box.empty())
    VOXC_TRY(addBox(options.box, voxelToModel, clip));
  for (const std::string &plane : options.planes)
    VOXC_TRY(addPlane(plane, voxelToModel, clip));
  return clip;
}

} // namespace voxc::tool
