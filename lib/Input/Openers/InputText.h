// The texts that inputs are written with, and those that say how an input became voxels.
#pragma once

#include "voxc/Input/Input.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// An error of what is in a file, as one of the file: "'a.vox' is not a usable MagicaVoxel file: ..."; others
/// stay as they are.
Error notUsable(const Error &error, const std::string &path, std::string_view kind);
/// A result whose error is one of the file.
template <typename Value>
Expected<Value> usable(Expected<Value> result, const std::string &path, std::string_view kind) {
  return result ? std::move(result) : notUsable(result.error(), path, kind);
}

/// The longest axis of an extent.
int longestAxis(Int3 extent);

/// "1 x 2 x 3".
std::string byThree(const std::array<double, 3> &numbers);

/// Facts of several numbers, as they are told to people.
InputFact sizeFact(std::string name, Int3 size);
InputFact boxFact(std::string name, const std::array<double, 3> &low, const std::array<double, 3> &high);
InputFact countFact(std::string name, std::uint64_t count);

/// The most voxels that a model may take: what the format holds, unless its resolution is given and it is
/// cropped.
Int3 modelExtent(const InputOptions &options);

/// A whole positive number, and nothing else.
std::optional<int> parseCount(std::string_view text);

/// "WxHxD".
std::optional<Int3> parseExtent(std::string_view text);

/// The shortest text that reads back as the same number.
std::string toText(double value);

/// " up=z" or " up=y".
std::string upProvenance(const InputOptions &options);

/// `provenance` with "key=value" in place of what it said of `key`, or at its end.
std::string withProvenance(const std::string &provenance, std::string_view key, const std::string &value);

/// The side of a voxel in units of the model, 0 where none is asked for; `unit`: metres of the model's, as
/// its file says, or 0. Error: `Usage`, the size has a unit and the model has none.
Expected<double> voxelSide(const InputOptions &options, double unit);

/// " voxel-size=S align=X,Y,Z", as far as that is asked for; `side` in units of the model.
std::string gridProvenance(double side, const InputOptions &options);

/// A text as a word of a provenance: blanks and '%' become %20 and %25.
std::string provenanceWord(std::string_view text);

/// The options that decide the voxels of a model whose longest axis got `resolution` of them.
std::string modelProvenance(std::string_view coverage, int resolution, const InputOptions &options);

} // namespace voxc
