// The option that says in which order rays are taken.
#include "common/OrderOption.h"

namespace voxc::tool {

void addOrderArgument(const CommandLine &command, std::string &order) {
  command
      .add("--order", order,
           "Take rays as given, or binned by octant, origin and direction; auto (default) bins those that "
           "are many and scattered, where a processor traces them")
      .takes("ORDER")
      .oneOf({kAutoOrder, "given", "binned"});
}

} // namespace voxc::tool
