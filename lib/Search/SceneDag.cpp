// Reading a source into a graph of different cubes, brick by brick in Morton order.
#include "voxc/Search/SceneDag.h"

#include "InternTable.h"
#include "OctantMask.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

namespace voxc {
namespace {

constexpr int kLog2Brick = 3;
constexpr std::uint32_t kEmpty = ~0u; ///< The number of no cube.
constexpr unsigned kBricksBetweenReports = 1024;

int log2SideFor(Int3 extent) {
  const auto longest = static_cast<std::uint32_t>(std::max({extent.x, extent.y, extent.z, 1}));
  return static_cast<int>(std::bit_width(longest - 1));
}

} // namespace

SceneDag::Node SceneDag::Layer::node(std::size_t number) const {
  const std::uint64_t begin = begins[number];
  const std::uint32_t mask = words[begin];
  return {mask, std::span(words).subspan(begin + 1, octantsIn(mask))};
}

/// From the root down: a child is there as often as all its parents.
void SceneDag::countOccurrences() {
  for (Layer &layer : layers_)
    layer.occurrences.assign(layer.count(), 0);
  if (!isEmpty())
    layers_.back().occurrences[0] = 1;
  for (std::size_t height = layers_.size() - 1; height > 0; --height)
    for (std::size_t number = 0; number < layers_[height].count(); ++number)
      for (const std::uint32_t child : layers_[height].node(number).children)
        layers_[height - 1].occurrences[child] += layers_[height].occurrences[number];
}

/// Equal shapes of a layer as one. `numbers` are those of the layer below, then of this one.
SceneDag::Layer SceneDag::shapeOf(const Layer &layer, std::vector<std::uint32_t> &numbers) const {
  Layer shape;
  InternTable table;
  std::vector<std::uint32_t> mine(layer.count());
  std::vector<std::uint32_t> words;
  for (std::size_t number = 0; number < mine.size(); ++number) {
    const Node node = layer.node(number);
    words.assign(1, node.mask);
    for (const std::uint32_t child : node.children)
      words.push_back(numbers[child]);
    mine[number] = table.intern(words, shape.words, shape.begins);
  }
  numbers = std::move(mine);
  return shape;
}

SceneDag SceneDag::shape() const {
  SceneDag dag;
  std::vector<std::uint32_t> numbers(layers_.front().count(), 0);
  dag.layers_.push_back({.words = {1}, .begins = {0}});
  if (isEmpty())
    dag.layers_.front() = {};
  for (std::size_t height = 1; height < layers_.size(); ++height)
    dag.layers_.push_back(shapeOf(layers_[height], numbers));
  dag.countOccurrences();
  return dag;
}

class SceneDagBuilder {
public:
  SceneDagBuilder(VoxelSource &source, const SceneDag::Options &options, const Progress &progress)
      : source_(source), options_(options), progress_(progress) {}

  Expected<SceneDag> run() {
    const int log2Side = std::max({options_.log2Side, log2SideFor(source_.extent()), kLog2Brick});
    dag_.layers_.resize(static_cast<std::size_t>(log2Side) + 1);
    tables_.resize(dag_.layers_.size());
    read({{0, 0, 0}, log2Side});
    if (error_)
      return *error_;
    dag_.countOccurrences();
    return std::move(dag_);
  }

private:
  /// The number of a cube, or `kEmpty`.
  std::uint32_t read(const Cube &cube) {
    if (error_ || source_.empty(cube))
      return kEmpty;
    if (cube.log2Side == kLog2Brick)
      return readBrick(cube);
    std::array<std::uint32_t, 8> children;
    const int half = cube.log2Side - 1;
    for (unsigned child = 0; child < 8; ++child)
      children[child] = read({cube.low + mortonCell(child) * (1 << half), half});
    return join(cube.log2Side, children);
  }

  std::uint32_t readBrick(const Cube &cube) {
    if (bricks_++ % kBricksBetweenReports == 0)
      report(cube);
    if (auto done = source_.read(cube, voxels_.data()); !done) {
      error_ = error_ ? error_ : done.error();
      return kEmpty;
    }
    if (options_.look)
      options_.look(voxels_);
    return ofVoxels(voxels_.data(), kLog2Brick);
  }

  std::uint32_t ofVoxels(const std::uint32_t *voxels, int height) {
    if (height == 0)
      return *voxels == 0 ? kEmpty : ofVoxel(*voxels);
    std::array<std::uint32_t, 8> children;
    for (unsigned child = 0; child < 8; ++child)
      children[child] = ofVoxels(voxels + (child << 3 * (height - 1)), height - 1);
    return join(height, children);
  }

  std::uint32_t ofVoxel(std::uint32_t colour) {
    const std::uint32_t word = options_.detail == SceneDag::Detail::Colours ? colour : 1;
    return intern(0, {&word, 1});
  }

  std::uint32_t join(int height, const std::array<std::uint32_t, 8> &children) {
    std::array<std::uint32_t, 9> words{};
    std::size_t count = 1;
    for (unsigned child = 0; child < 8; ++child) {
      if (children[child] == kEmpty)
        continue;
      words[0] |= 1u << child;
      words[count++] = children[child];
    }
    return words[0] == 0 ? kEmpty : intern(height, std::span(words).first(count));
  }

  std::uint32_t intern(int height, std::span<const std::uint32_t> words) {
    SceneDag::Layer &layer = dag_.layers_[static_cast<std::size_t>(height)];
    const std::size_t before = layer.count();
    const std::uint32_t number =
        tables_[static_cast<std::size_t>(height)].intern(words, layer.words, layer.begins);
    nodes_ += layer.count() - before;
    if (nodes_ > options_.mostNodes)
      error_ = Error::environment(
          "the scene has more than " + std::to_string(options_.mostNodes) +
          " different cubes, the most that are looked at; a lower resolution would have less");
    return number;
  }

  void report(const Cube &cube) {
    const double codes = static_cast<double>(std::uint64_t{1} << 3 * dag_.log2Side());
    progress_.at("read", static_cast<double>(mortonCode(cube.low)) / codes);
    if (!error_ && progress_.stopped())
      error_ = Error::interrupted();
  }

  VoxelSource &source_;
  const SceneDag::Options &options_;
  const Progress &progress_;
  SceneDag dag_;
  std::vector<InternTable> tables_; ///< By height.
  std::array<std::uint32_t, 512> voxels_{};
  std::uint64_t bricks_ = 0;
  std::size_t nodes_ = 0; ///< Of all heights.
  std::optional<Error> error_;
};

Expected<SceneDag> SceneDag::build(VoxelSource &source, const Options &options, const Progress &progress) {
  return SceneDagBuilder(source, options, progress).run();
}

} // namespace voxc
