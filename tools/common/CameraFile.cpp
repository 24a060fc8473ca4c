// Camera files.
#include "CameraFile.h"

#include "Json.h"

#include "voxc/Support/File.h"

#include <cmath>

namespace voxc::tool {
namespace {

/// The largest number of a camera: far beyond all that can be seen, and small enough to be reckoned with.
constexpr double kMost = 1e12;

std::optional<double> number(const Json &value) {
  if (!value.is_number() || !(std::abs(value.get<double>()) <= kMost))
    return std::nullopt;
  return value.get<double>();
}

std::optional<double> number(const Json &object, const char *key) {
  auto entry = object.find(key);
  return entry == object.end() ? std::nullopt : number(*entry);
}

/// The numbers of an array of exactly so many.
template <std::size_t count>
std::optional<std::array<double, count>> numbers(const Json &object, const char *key) {
  auto entry = object.find(key);
  if (entry == object.end() || !entry->is_array() || entry->size() != count)
    return std::nullopt;
  std::array<double, count> values;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = number((*entry)[i]);
    if (!value)
      return std::nullopt;
    values[i] = *value;
  }
  return values;
}

Error noSuchCamera(const std::string &path, const std::string &name, const Json &cameras) {
  std::string names;
  for (const auto &[key, camera] : cameras.items())
    names += (names.empty() ? "" : ", ") + key;
  return Error::input(path + " has no camera \"" + name + "\"; it has: " + names);
}

Expected<FileCamera> parseCamera(const Json &file, const std::string &name, const std::string &path) {
  const Json &entry = file["cameras"][name];
  const std::string where = path + ": camera \"" + name + "\"";
  if (!entry.is_object())
    return Error::input(where + " should be an object with position, pitch and yaw");
  auto position = numbers<3>(entry, "position");
  auto pitch = number(entry, "pitch");
  auto yaw = number(entry, "yaw");
  if (!position || !pitch || !yaw)
    return Error::input(
        where + " should have a position of 3 numbers, a pitch and a yaw in degrees, none beyond 10^12");
  FileCamera camera{
      .position = {(*position)[0], (*position)[1], (*position)[2]}, .pitch = *pitch, .yaw = *yaw};
  if (entry.contains("fov")) {
    camera.fov = number(entry, "fov").value_or(0);
    if (!(camera.fov > 0 && camera.fov < 180))
      return Error::input(where + " should have a fov between 0 and 180 degrees");
  }
  if (entry.contains("height")) {
    camera.height = number(entry, "height").value_or(0);
    if (!(camera.height > 0))
      return Error::input(where + " should have a height above 0, which makes it orthographic, or none");
  }
  if (!file.contains("size"))
    return camera;
  const auto size = numbers<2>(file, "size");
  const auto isSide = [](double side) { return side >= 1 && side <= kMaxPictureSide; };
  if (!size || !isSide((*size)[0]) || !isSide((*size)[1]))
    return Error::input(path + " should have a size of two numbers from 1 to " +
                        std::to_string(kMaxPictureSide) + ", or none");
  camera.size = {int((*size)[0]), int((*size)[1])};
  return camera;
}

/// The file's object, which has an object "cameras".
Expected<Json> readCameraFile(const std::string &path) {
  auto text = VOXC_TRY(readTextFile(path));
  Json file = Json::parse(text, nullptr, false);
  if (!file.is_object() || !file.contains("cameras") || !file["cameras"].is_object())
    return Error::input(path + " is no camera file: it should be a JSON object with an object \"cameras\"");
  return file;
}

} // namespace

Expected<std::vector<FileCamera>> readCameras(const std::string &path) {
  const auto file = VOXC_TRY(readCameraFile(path));
  std::vector<FileCamera> cameras;
  for (const auto &[name, entry] : file["cameras"].items()) {
    auto camera = VOXC_TRY(parseCamera(file, name, path));
    cameras.push_back(camera);
  }
  return cameras;
}

Expected<std::vector<std::string>> cameraNames(const std::string &path) {
  const auto file = VOXC_TRY(readCameraFile(path));
  std::vector<std::string> names;
  for (const auto &[name, camera] : file["cameras"].items())
    names.push_back(name);
  return names;
}

Expected<FileCamera> readCamera(const std::string &path, const std::string &name) {
  const auto file = VOXC_TRY(readCameraFile(path));
  const Json &cameras = file["cameras"];
  if (!cameras.contains(name))
    return noSuchCamera(path, name, cameras);
  return parseCamera(file, name, path);
}

} // namespace voxc::tool
