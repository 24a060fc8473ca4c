// What openers of dense volumes share.
#pragma once

#include "Input/Dense/DenseVolume.h"
#include "voxc/Support/FunctionRef.h"

#include <memory>
#include <string>
#include <string_view>

namespace voxc {

using ReadDense = FunctionRef<Expected<DenseVolume>(std::shared_ptr<const WatchedFile> file)>;

/// The input of the volume that `read` finds in the file at `path`. What is wrong with the content is an
/// error that names the file and `kind`, such as "NRRD". Errors: the file cannot be opened, those of `read`,
/// those of `makeInput`.
Expected<Input> openDense(const std::string &path, std::string_view kind, const InputOptions &options,
                          ReadDense read);

} // namespace voxc
