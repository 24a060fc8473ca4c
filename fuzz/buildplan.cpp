// Fuzzes build plans, whose digest is put right: what is read must come back from its own text.
#include "Expect.h"
#include "FuzzedFile.h"

#include "cluster/BuildPlan.h"
#include "cluster/TextDigest.h"

#include <cstdint>
#include <string>

namespace {

using namespace voxc::tool::cluster;
using voxc::fuzz::expect;

constexpr std::string_view kTitle = "voxc build plan 1\n";

/// What a hostile plan would say: a digest that is that of its text.
std::string withRightDigest(std::string_view text) {
  const std::string_view body =
      text.starts_with(kTitle) ? text.substr(std::min(text.find('\n', kTitle.size()), text.size() - 1) + 1)
                               : text;
  return std::string(kTitle) + "digest " + TextDigest().add(body).hex() + "\n" + std::string(body);
}

/// Each item of the tree has cubes, and every part is in one of each level.
void useTree(const BuildPlan &plan) {
  const MergeTree tree = plan.tree();
  for (std::size_t level = 0; level < tree.levels(); ++level) {
    std::uint64_t at = 0;
    for (std::uint64_t index = 0; index < tree.count(level); ++index) {
      const auto share = plan.shareOf({level, index});
      expect(share.begin == at && share.end >= at);
      at = share.end;
    }
    expect(at == plan.cubes.count);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto plan = parsePlan(withRightDigest(voxc::fuzz::textOf(data, size)), "a.plan");
  if (!plan)
    return 0;
  const std::string text = printPlan(*plan);
  const auto again = parsePlan(text, "its own text");
  expect(again && printPlan(*again) == text);
  useTree(*plan);
  return 0;
}
