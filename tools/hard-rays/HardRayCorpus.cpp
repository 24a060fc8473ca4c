// Lines of a corpus of hard rays, written and read.
#include "hard-rays/HardRayCorpus.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <span>
#include <sstream>

namespace voxc::tool {

namespace {

/// Of a line's hit.
constexpr int kHitWords = 5;

std::string hexFloat(float value) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", double{value});
  return text;
}

/// Reads one word as a float, hexadecimal or not: streams do not know how.
bool readFloat(std::istream &words, float &value) {
  std::string word;
  if (!(words >> word))
    return false;
  char *end = nullptr;
  value = std::strtof(word.c_str(), &end);
  return *end == '\0';
}

bool readExtent(std::istream &words, Int3 &extent) {
  char first = 0, second = 0;
  if (!(words >> extent.x >> first >> extent.y >> second >> extent.z))
    return false;
  constexpr int kMost = 1 << kMaxLog2Extent;
  return first == 'x' && second == 'x' && std::min({extent.x, extent.y, extent.z}) > 0 &&
         std::max({extent.x, extent.y, extent.z}) <= kMost;
}

bool readHit(std::istream &words, Hit &hit) {
  hit = {};
  return words >> hit.voxel[0] >> hit.voxel[1] >> hit.voxel[2] >> std::hex >> hit.rgba &&
         readFloat(words, hit.t);
}

bool readRay(std::istream &words, CorpusRay &ray) {
  if (!(words >> ray.scene) || !readExtent(words, ray.extent))
    return false;
  for (float(*half)[3] : {&ray.ray.origin, &ray.ray.direction})
    for (float &component : *half)
      if (!readFloat(words, component))
        return false;
  // Bounds make a line two words longer.
  const std::string rest(std::istreambuf_iterator<char>(words), {});
  std::istringstream counted(rest), last(rest);
  const auto left = std::distance(std::istream_iterator<std::string>(counted), {});
  if (left == kHitWords + 2) {
    ray.bounds.emplace();
    if (!readFloat(last, ray.bounds->tmin) || !readFloat(last, ray.bounds->tmax))
      return false;
  }
  std::string surplus;
  return readHit(last, ray.exact) && !(last >> surplus);
}

} // namespace

std::string hitText(const Hit &hit) {
  char text[80];
  std::snprintf(text, sizeof text, "%d %d %d %08x %a", hit.voxel[0], hit.voxel[1], hit.voxel[2], hit.rgba,
                double{hit.t});
  return text;
}

std::string corpusLine(const CorpusRay &ray) {
  std::string line = ray.scene + ' ' + std::to_string(ray.extent.x) + 'x' + std::to_string(ray.extent.y) +
                     'x' + std::to_string(ray.extent.z);
  for (const float *half : {ray.ray.origin, ray.ray.direction})
    for (const float component : std::span(half, 3))
      line += ' ' + hexFloat(component);
  if (ray.bounds)
    line += ' ' + hexFloat(ray.bounds->tmin) + ' ' + hexFloat(ray.bounds->tmax);
  return line + ' ' + hitText(ray.exact);
}

Expected<std::vector<CorpusRay>> parseCorpus(std::string_view text, const std::string &name) {
  std::vector<CorpusRay> rays;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos)
      continue;
    std::istringstream words(line);
    CorpusRay ray{};
    if (!readRay(words, ray))
      return Error::input(name + ", line " + std::to_string(number) +
                          ": a line is SCENE WxHxD, six components, TMIN TMAX if there are bounds, and the "
                          "exact hit as X Y Z RGBA T");
    rays.push_back(std::move(ray));
  }
  return rays;
}

} // namespace voxc::tool
