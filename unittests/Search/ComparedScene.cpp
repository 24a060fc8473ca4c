// Pricing and building.
#include "ComparedScene.h"

#include "Source/SourceTesting.h"

#include "voxc/Source/Sources.h"

#include <algorithm>
#include <bit>

namespace voxc::test {
namespace {

std::vector<std::uint32_t> gridOf(VoxelSource &source) {
  const Int3 extent = source.extent();
  std::vector<std::uint32_t> words(static_cast<std::size_t>(extent.x * extent.y * extent.z));
  for (const auto &[code, word] : voxelsOf(source)) {
    const Int3 cell = mortonCell(code);
    words[static_cast<std::size_t>(cell.x + extent.x * (cell.y + extent.y * cell.z))] = word;
  }
  return words;
}

std::unique_ptr<SceneDag> read(VoxelSource &grid, int log2Side, SceneValues *values) {
  const auto look = [&](std::span<const std::uint32_t> cells) {
    if (values)
      values->add(cells);
  };
  auto dag = SceneDag::build(*grid.view(),
                             {.detail = SceneDag::Detail::Colours, .log2Side = log2Side, .look = look});
  EXPECT_TRUE(dag) << dag.error().message;
  return std::make_unique<SceneDag>(std::move(*dag));
}

} // namespace

ComparedScene::ComparedScene(std::string name, VoxelSource &source)
    : name_(std::move(name)), grid_(makeGridSource(source.extent(), gridOf(source))) {
  auto values = SceneValues::create(WorkingMemory::createDefault());
  EXPECT_TRUE(values) << values.error().message;
  auto dag = read(*grid_, 0, &*values);
  const auto cheapest = values->finish();
  EXPECT_TRUE(cheapest) << cheapest.error().message;
  values_ = *cheapest;
  const std::size_t grids = dag->shape().count(std::min(dag->log2Side(), 2));
  traits_ = {.oneColour = values->isOne(),
             .paletteBits = values_.paletteBits,
             .visible = values->isVisible(),
             .pointerBits = std::clamp(static_cast<int>(std::bit_width(grids)), 8, 24)};
}

SizeModel &ComparedScene::sizeModel(int log2Side, bool byColours) {
  Graphs &graphs = graphs_[log2Side];
  if (!graphs.colours) {
    graphs.colours = read(*grid_, log2Side, nullptr);
    graphs.shape = std::make_unique<SceneDag>(graphs.colours->shape());
    graphs.sizeModels = {std::make_unique<SizeModel>(*graphs.shape),
                         std::make_unique<SizeModel>(*graphs.colours)};
  }
  return *graphs.sizeModels[byColours ? 1 : 0];
}

std::optional<Price> ComparedScene::price(const Format &format) {
  const Int3 extent = grid_->extent(), most = format.extent();
  if (extent.x > most.x || extent.y > most.y || extent.z > most.z)
    return std::nullopt;
  const Layout layout = layoutOf(format);
  const bool isApart = layout.values == Values::Apart, varies = kindOf(layout.payload).varies;
  if (isApart && varies && (layout.payload == Payload::Palette) != (values_.paletteBits > 0))
    return std::nullopt;
  auto price = sizeModel(maxComponent(format.log2Extent()), varies && !isApart)
                   .price(layout, varies ? values_.words : 0);
  EXPECT_TRUE(price) << name_ << ": " << price.error().message << "\n" << printIr(format);
  return price && price->words() <= kMostComparedWords ? std::optional(*price) : std::nullopt;
}

bool ComparedScene::claimsExactness(const Format &format) {
  const auto priced = price(format);
  return priced && priced->exact;
}

bool ComparedScene::compare(const Format &format, const Constructor &constructor) {
  const auto priced = price(format);
  if (!priced)
    return false;
  const auto built = constructor.build(*grid_->view());
  EXPECT_TRUE(built) << name_ << ": " << built.error().message << "\n" << printIr(format);
  if (!built)
    return false;
  const auto words = static_cast<double>(built->volume.words().size());
  EXPECT_NEAR(static_cast<double>(priced->words()), words, priced->exact ? 0 : words / 2) << name_ << "\n"
                                                                                          << printIr(format);
  return priced->exact;
}

} // namespace voxc::test
