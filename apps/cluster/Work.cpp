// Looking from the volume down to the parts.
#include "cluster/Work.h"

namespace voxc::tool::cluster {

MissingWork::MissingWork(const MergeTree &tree, const Stands &stands) : levels_(tree.levels()) {
  look(tree, tree.root(), stands);
}

void MissingWork::look(const MergeTree &tree, const WorkItem &item, const Stands &stands) {
  if (stands(item))
    return;
  levels_[item.level].push_back(item.index);
  if (item.level > 0)
    for (const WorkItem &child : tree.childrenOf(item))
      look(tree, child, stands);
}

} // namespace voxc::tool::cluster
