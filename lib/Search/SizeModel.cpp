// How many words a format takes.
//
// Words follow from the lowest level up. What matters is whether equal cubes have equal values in the cells
// above: voxels do, and so does a level that shares all its equal nodes, over cells that do. Any other level
// writes each sub-volume anew, so that nothing above can be equal.
#include "voxc/Search/SizeModel.h"

#include "TreeForms.h"

#include "voxc/Layout/SlotKind.h"

#include <map>
#include <numeric>
#include <string>
#include <tuple>

namespace voxc {

std::uint64_t Price::words() const {
  return std::accumulate(levelWords.begin(), levelWords.end(), otherWords);
}

/// What formats have in common.
class SizeModel::Tables {
public:
  explicit Tables(const SceneDag &dag) : dag_(dag) {}

  const std::vector<std::uint64_t> &cells(int bottom, int top) {
    auto &cells = cells_[{bottom, top}];
    if (cells.empty())
      cells = countCells(dag_, bottom, top);
    return cells;
  }

  TreeForms &forms(const TreeShape &shape) {
    auto &forms = forms_[{shape.bottom, shape.branch, shape.ranked}];
    if (!forms)
      forms = std::make_unique<TreeForms>(dag_, shape);
    return *forms;
  }

  /// Of trees whose cells have equal values where they are equal, and which share so.
  const TreeCount &tree(const TreeShape &shape, int top, Sharing sharing) {
    const auto [entry, isNew] = trees_.try_emplace({shape.bottom, shape.branch, shape.ranked, top, sharing});
    if (isNew)
      entry->second = sharing == Sharing::Level       ? forms(shape).shared(top)
                      : sharing == Sharing::SubVolume ? forms(shape).sharedInEach(top)
                                                      : forms(shape).unshared(top);
    return entry->second;
  }

private:
  const SceneDag &dag_;
  std::map<std::tuple<int, int>, std::vector<std::uint64_t>> cells_;
  std::map<std::tuple<int, int, bool>, std::unique_ptr<TreeForms>> forms_;
  std::map<std::tuple<int, int, bool, int, Sharing>, TreeCount> trees_;
};

namespace {

/// The height of sub-volumes: of those that are no cubes, of the cube around.
int topOf(const Stratum &stratum) { return stratum.log2Cell + maxComponent(stratum.log2Size()); }

/// The words of trees.
std::uint64_t wordsOf(const Stratum &stratum, const TreeCount &count) {
  const std::uint64_t slots = count.inner + (stratum.implied ? 0 : count.leaves);
  if (stratum.hasRecords()) // A record for each child, and one for each root.
    return stratum.slots->wordsWith(stratum, 1, 0) * (count.roots + slots);
  const std::uint64_t least = stratum.slots->wordsWith(stratum, 0, 0);
  return least * count.nodes + (stratum.slots->wordsWith(stratum, 1, 0) - least) * slots +
         (stratum.hasLeafWords() ? count.values : 0);
}

} // namespace

std::uint64_t SizeModel::occurrencesAt(int height) const {
  const auto occurrences = dag_.occurrences(height);
  return std::accumulate(occurrences.begin(), occurrences.end(), std::uint64_t{0});
}

namespace {

/// True if the values of voxels apart may stand in another order than that of Morton, and so take other
/// words.
bool ordersValuesOtherwise(const Layout &layout) {
  const Stratum &last = layout.strata.back();
  return layout.ranksVoxels() && last.slots->ordersVoxelsByRows && last.log2Children() > 3;
}

} // namespace

SizeModel::SizeModel(const SceneDag &dag) : dag_(dag), tables_(std::make_unique<Tables>(dag)) {}

SizeModel::~SizeModel() = default;
SizeModel::SizeModel(SizeModel &&) noexcept = default;

/// The words of an array of grids that are cubes of 2^height voxels a side.
std::uint64_t SizeModel::arrayWords(const SlotKind &slots, int height, bool shares) const {
  const auto &octants = tables_->cells(height - 1, height);
  const auto occurrences = dag_.occurrences(height);
  std::uint64_t grids = 0, full = 0;
  for (std::size_t number = 0; number < octants.size(); ++number) {
    grids += shares ? 1 : occurrences[number];
    full += octants[number] * (shares ? 1 : occurrences[number]);
  }
  return slots.array->words(grids, full);
}

Expected<Price> SizeModel::price(const Layout &layout, std::uint64_t valueWords) {
  const int side = maxComponent(layout.log2Extent());
  if (side > dag_.log2Side() || (side < dag_.log2Side() && dag_.count(side) > 1))
    return Error::input("the scene needs 2^" + std::to_string(dag_.log2Side()) +
                        " voxels a side, but the format has 2^" + std::to_string(side));
  Price price;
  price.levelWords.resize(layout.strata.size());
  price.otherWords = layout.headWords() + (layout.ranksVoxels() ? valueWords : 0);
  price.exact = !ordersValuesOtherwise(layout) && !layout.padsNodes();
  if (dag_.isEmpty())
    return price;
  bool equalCells = true; // Whether equal cubes have equal values in the stratum's cells.
  for (std::size_t i = layout.strata.size(); i-- > 0;) {
    const Stratum &stratum = layout.strata[i];
    const bool shares = equalCells && stratum.sharing == Sharing::Level;
    const int top = topOf(stratum);
    std::uint64_t &words = price.levelWords[i];
    if (stratum.depth == 0) {
      const std::uint64_t cells = shares ? dag_.count(top) : occurrencesAt(top);
      words = wordsOf(stratum, {.roots = cells, .values = cells});
    } else if (stratum.isGrid()) {
      const auto &cells = tables_->cells(stratum.log2Cell, top);
      // Grids without octants have as few counts as these say.
      const bool countsOctants = stratum.slots->countsOctants(stratum);
      const auto &octants = tables_->cells(stratum.log2Cell + (countsOctants ? 1 : 0), top);
      const auto occurrences = dag_.occurrences(top);
      for (std::size_t number = 0; number < cells.size(); ++number)
        words += stratum.slots->wordsWith(stratum, stratum.implied ? 0 : cells[number], octants[number]) *
                 (shares ? 1 : occurrences[number]);
      price.exact &= !stratum.slots->lookUpLoops;
    } else {
      price.exact &= !stratum.slots->sharesMore;
      const TreeShape shape{stratum.log2Cell, std::max(stratum.log2Shape.x, 1), stratum.ranked};
      words = wordsOf(stratum, equalCells ? tables_->tree(shape, top, stratum.sharing)
                                          : treeOfUniqueCells(dag_, shape, top));
    }
    if (stratum.inArray()) {
      const std::uint64_t numbers = shares ? dag_.count(top) : occurrencesAt(top);
      if (const int bits = stratum.numberBits; numbers >> bits != 0)
        return Error::input("there are " + std::to_string(numbers) +
                            " sub-volumes to be numbered, more than " + std::to_string(bits) +
                            " bits can number");
      words = arrayWords(*stratum.slots, top, shares);
    }
    equalCells = shares;
  }
  return price;
}

} // namespace voxc
