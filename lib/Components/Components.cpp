// What a build has of optional components. No other file asks for them.
#include "voxc/Components/Components.h"

#ifdef VOXC_HAS_OPENVDB
#include "voxc/OpenVdb/OpenVdb.h"
#endif
#ifdef VOXC_HAS_ASSIMP
#include "voxc/Assimp/Assimp.h"
#endif

namespace voxc {

std::vector<InputKind> componentInputs() {
  std::vector<InputKind> kinds;
#ifdef VOXC_HAS_OPENVDB
  kinds.push_back(openVdbKind());
#endif
#ifdef VOXC_HAS_ASSIMP
  for (const InputKind &kind : assimpKinds())
    kinds.push_back(kind);
#endif
  return kinds;
}

std::vector<OtherExport> componentExports() {
#ifdef VOXC_HAS_OPENVDB
  return {openVdbExport()};
#else
  return {};
#endif
}

bool hasOpenVdb() {
#ifdef VOXC_HAS_OPENVDB
  return true;
#else
  return false;
#endif
}

bool hasAssimp() {
#ifdef VOXC_HAS_ASSIMP
  return true;
#else
  return false;
#endif
}

} // namespace voxc
