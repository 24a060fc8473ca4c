// The optional components that this build has.
#pragma once

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"

#include <vector>

namespace voxc {

/// The kinds of files that optional components read; for `InputOptions::otherKinds`. Empty in a build without
/// any.
std::vector<InputKind> componentInputs();

/// The kinds of files that they write; for `ExportOptions::otherKinds`.
std::vector<OtherExport> componentExports();

/// Whether the components for OpenVDB and for assimp are there.
bool hasOpenVdb();
bool hasAssimp();

} // namespace voxc
