// Copies of changed words.
#include "FollowSubject.h"

#include "voxc/Support/Stopwatch.h"
#include "voxc/Trace/Tracer.h"

#include <algorithm>
#include <array>
#include <vector>

namespace voxc::gpu {
namespace {

constexpr std::size_t kCalls = 201;
constexpr std::uint64_t kHeadWords = 4;

} // namespace

Expected<tool::Json> measureFollowing(const std::string &device, const Kernel &kernel, const Volume &volume) {
  auto opened = VOXC_TRY(Device::open(device));
  if (opened.info().loops != kernel.loops)
    return tool::Json();
  const auto tracer = VOXC_TRY(createTracer(opened, kernel, volume));
  tool::Json figures = tool::Json::object();
  for (const std::uint64_t words : {64u, 4096u, 262144u}) {
    const std::uint64_t all = volume.words().size();
    if (all < words + kHeadWords)
      return Error::input("the volume has " + std::to_string(all) + " words, too few to change so many");
    const std::array changed = {WordRange{0, kHeadWords}, WordRange{all - words, all}};
    std::vector<double> microseconds;
    for (std::size_t call = 0; call < kCalls; ++call) {
      const Stopwatch watch;
      VOXC_TRY(tracer->follow(volume, changed));
      microseconds.push_back(1e6 * watch.seconds());
    }
    std::ranges::nth_element(microseconds, microseconds.begin() + kCalls / 2);
    figures[std::to_string(words)] = microseconds[kCalls / 2];
  }
  return figures;
}

} // namespace voxc::gpu
