// The nodes of trees over a scene.
#include "TreeForms.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {
namespace {

/// Two words for each set of children, and two for each child at most.
constexpr std::size_t kMaskWords = 4;
using NodeWords = std::array<std::uint32_t, kMaskWords + 2 * 64>;

/// Calls visit(place, number of the child) for each child of a node of 2^branch children an axis.
template <typename Visit>
void visitChildren(const SceneDag &dag, int height, std::size_t number, int branch, unsigned place,
                   const Visit &visit) {
  const SceneDag::Node node = dag.node(height, number);
  std::uint32_t mask = node.mask;
  for (const std::uint32_t child : node.children) {
    const unsigned at = 8 * place + static_cast<unsigned>(std::countr_zero(mask));
    mask &= mask - 1;
    if (branch == 1)
      visit(at, child);
    else
      visitChildren(dag, height - 1, child, branch - 1, at, visit);
  }
}

} // namespace

void TreeCount::add(const TreeCount &other, std::uint64_t times) {
  roots += other.roots * times;
  nodes += other.nodes * times;
  inner += other.inner * times;
  leaves += other.leaves * times;
  values += other.values * times;
}

TreeForms::TreeForms(const SceneDag &dag, const TreeShape &shape)
    : dag_(dag), shape_(shape), forms_(static_cast<std::size_t>(layerOf(dag.log2Side())) + 1) {
  forms_[0].resize(dag.count(shape.bottom));
  for (std::size_t number = 0; number < forms_[0].size(); ++number)
    forms_[0][number] = {true, static_cast<std::uint32_t>(number)};
  if (shape.ranked)
    for (int layer = 0; layer <= layers(); ++layer)
      voxels_.push_back(countCells(dag, 0, heightOf(layer)));
  for (int layer = 1; layer <= layers(); ++layer)
    makeLayer(layer);
}

void TreeForms::makeLayer(int layer) {
  auto &forms = forms_[static_cast<std::size_t>(layer)];
  forms.resize(dag_.count(heightOf(layer)));
  for (std::size_t number = 0; number < forms.size(); ++number)
    forms[number] = join(layer, number);
}

TreeForms::Form TreeForms::join(int layer, std::size_t number) {
  const auto below = static_cast<std::size_t>(layer) - 1;
  NodeWords words{};
  std::size_t count = kMaskWords;
  NodeKind kind{.layer = layer};
  Form first;
  bool equalLeaves = true;
  visitChildren(dag_, heightOf(layer), number, shape_.branch, 0, [&](unsigned place, std::uint32_t child) {
    const Form form = forms_[below][child];
    words[place / 32] |= 1u << place % 32;
    if (form.leaf)
      words[2 + place / 32] |= 1u << place % 32;
    ++(form.leaf ? kind.leaves : kind.inner);
    if (count == kMaskWords)
      first = form;
    equalLeaves &= form.leaf && form.number == first.number;
    words[count++] = form.number;
    if (shape_.ranked) // Leaves of voxels have no slots, and so no counts.
      words[count++] =
          form.leaf && shape_.bottom == 0 ? 0 : static_cast<std::uint32_t>(voxels_[below][child]);
  });
  if (equalLeaves && kind.leaves == 1u << 3 * shape_.branch)
    return first;
  const std::uint32_t known = table_.intern(std::span(words).first(count), words_, begins_);
  if (known == kinds_.size())
    kinds_.push_back(kind);
  return {false, known};
}

/// Of a sub-volume that is one leaf, but for its root.
TreeCount TreeForms::wholeRoot() const {
  return {.nodes = 1, .leaves = std::uint64_t{1} << 3 * shape_.branch};
}

TreeCount TreeForms::shared(int top) const {
  TreeCount count{.values = dag_.count(shape_.bottom)};
  const int layer = layerOf(top);
  for (const NodeKind &kind : kinds_)
    if (kind.layer <= layer)
      count.add({.nodes = 1, .inner = kind.inner, .leaves = kind.leaves});
  for (const Form &form : forms_[static_cast<std::size_t>(layer)])
    if (form.leaf)
      count.add(wholeRoot());
  count.roots = dag_.count(top);
  return count;
}

TreeCount TreeForms::unshared(int top) const {
  TreeCount count;
  for (int layer = 1; layer <= layerOf(top); ++layer) {
    const bool isRoot = heightOf(layer) == top;
    const auto occurrences = dag_.occurrences(heightOf(layer));
    const auto &forms = forms_[static_cast<std::size_t>(layer)];
    for (std::size_t number = 0; number < forms.size(); ++number) {
      if (!forms[number].leaf) {
        const NodeKind &kind = kinds_[forms[number].number];
        count.add({.nodes = 1, .inner = kind.inner, .leaves = kind.leaves}, occurrences[number]);
      } else if (isRoot) {
        count.add(wholeRoot(), occurrences[number]);
      }
      if (isRoot)
        count.roots += occurrences[number];
    }
  }
  return count;
}

namespace {

/// Visits what one sub-volume is made of, each thing once.
class DistinctTraversal {
public:
  DistinctTraversal(std::size_t nodes, std::size_t values) : nodes_(nodes), values_(values) {}

  /// Begins another sub-volume.
  void begin() { ++mark_; }
  bool isNewNode(std::uint32_t number) { return isNew(nodes_[number]); }
  bool isNewValue(std::uint32_t number) { return isNew(values_[number]); }

private:
  bool isNew(std::uint32_t &mark) { return std::exchange(mark, mark_) != mark_; }

  std::vector<std::uint32_t> nodes_; ///< By whom each was last come to.
  std::vector<std::uint32_t> values_;
  std::uint32_t mark_ = 0;
};

} // namespace

TreeCount TreeForms::sharedInEach(int top) const {
  DistinctTraversal traversal(kinds_.size(), dag_.count(shape_.bottom));
  std::vector<std::uint32_t> open; // Nodes that are to be gone through.
  TreeCount all;
  const auto &forms = forms_[static_cast<std::size_t>(layerOf(top))];
  for (std::size_t number = 0; number < forms.size(); ++number) {
    traversal.begin();
    TreeCount count{.roots = 1};
    if (forms[number].leaf) {
      count.add(wholeRoot());
      count.values = 1;
    } else if (traversal.isNewNode(forms[number].number)) {
      open.push_back(forms[number].number);
    }
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      count.add({.nodes = 1, .inner = kinds_[at].inner, .leaves = kinds_[at].leaves});
      const std::uint32_t *const words = words_.data() + begins_[at];
      std::size_t child = kMaskWords;
      for (unsigned place = 0; place < 64; ++place) {
        if ((words[place / 32] >> place % 32 & 1) == 0)
          continue;
        if ((words[2 + place / 32] >> place % 32 & 1) != 0)
          count.values += traversal.isNewValue(words[child]) ? 1 : 0;
        else if (traversal.isNewNode(words[child]))
          open.push_back(words[child]);
        child += shape_.ranked ? 2 : 1;
      }
    }
    all.add(count, dag_.occurrences(top)[number]);
  }
  return all;
}

TreeCount treeOfUniqueCells(const SceneDag &dag, const TreeShape &shape, int top) {
  TreeCount count;
  for (int height = shape.bottom + shape.branch; height <= top; height += shape.branch) {
    const bool isLowest = height == shape.bottom + shape.branch;
    for (std::size_t number = 0; number < dag.count(height); ++number) {
      const std::uint64_t occurrences = dag.occurrences(height)[number];
      count.nodes += occurrences;
      visitChildren(dag, height, number, shape.branch, 0,
                    [&](unsigned, std::uint32_t) { (isLowest ? count.leaves : count.inner) += occurrences; });
      count.roots += height == top ? occurrences : 0;
    }
  }
  count.values = count.leaves;
  return count;
}

std::vector<std::uint64_t> countCells(const SceneDag &dag, int bottom, int top) {
  std::vector<std::uint64_t> cells(dag.count(bottom), 1);
  for (int height = bottom + 1; height <= top; ++height) {
    std::vector<std::uint64_t> above(dag.count(height));
    for (std::size_t number = 0; number < above.size(); ++number)
      for (const std::uint32_t child : dag.node(height, number).children)
        above[number] += cells[child];
    cells = std::move(above);
  }
  return cells;
}

} // namespace voxc
