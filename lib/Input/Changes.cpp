// The inside of an input, and its border.
#include "Input/Changes.h"

#include "Input/Openers/InputText.h"
#include "voxc/Source/Crop.h"
#include "voxc/Support/Stopwatch.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>

namespace voxc {

namespace {

std::string listed(Int3 cell, const char *between) {
  return std::to_string(cell.x) + between + std::to_string(cell.y) + between + std::to_string(cell.z);
}

/// "rrggbbaa".
std::string digitsOf(std::uint32_t word) {
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%02x%02x%02x%02x", word & 255, word >> 8 & 255, word >> 16 & 255,
                word >> 24);
  return text.data();
}

bool has(const std::string &provenance, const std::string &word) {
  return (" " + provenance + " ").find(" " + word + " ") != std::string::npos;
}

/// Was the same done with the inside of a volume when it was built?
bool isSaid(const std::string &provenance, Interior interior) {
  return has(provenance, interior == Interior::Drop ? "interior=drop" : "interior=fill");
}

Expected<void> changeInside(Input &input, const InputOptions &options) {
  constexpr std::uint32_t kMostLabel = 0xffff;
  if (options.interior == Interior::Fill && has(input.provenance, "colour-map=labels") &&
      options.fillWord > kMostLabel)
    return Error::usage("the inside of labels is filled with a label, its four bytes from the lowest on: "
                        "--fill-colour 05000000 is label 5");
  const Stopwatch finding;
  const InteriorOptions means{options.memory, options.threads, options.progress};
  auto changed = VOXC_TRY(options.interior == Interior::Drop
                              ? dropInterior(std::move(input.source), means)
                              : fillInterior(std::move(input.source), options.fillWord, means));
  input.source = std::move(changed.source);
  input.interior = options.interior;
  input.interiorVoxels = changed.voxels;
  input.interiorSeconds = finding.seconds();
  return {};
}

/// Tells what was made of the inside.
void tellInside(Input &input, Interior interior, const InputOptions &options) {
  const std::string voxels = std::to_string(input.interiorVoxels) + " voxels ";
  if (interior == Interior::Drop) {
    input.provenance = withProvenance(input.provenance, "interior", "drop");
    input.notes.push_back(
        voxels +
        "that no ray from outside comes to are left out; rays that begin among them do not find them");
    return;
  }
  input.provenance = withProvenance(input.provenance, "interior", "fill");
  input.provenance = withProvenance(input.provenance, "fill-colour", digitsOf(options.fillWord));
  input.notes.push_back(voxels + "are added inside");
}

Expected<void> cropBorder(Input &input, const InputOptions &options) {
  const Int3 before = input.source->extent();
  auto cropped = VOXC_TRY(crop(std::move(input.source), options.progress));
  input.source = std::move(cropped.source);
  input.isCropped = true;
  input.cropLow = cropped.low;
  if (before == input.source->extent())
    return {};
  input.provenance = withProvenance(input.provenance, "crop", listed(input.cropLow, ","));
  input.notes.push_back("voxel (" + listed(input.cropLow, ", ") +
                        ") of the input is now voxel (0, 0, 0), and " + listed(input.source->extent(), "x") +
                        " of " + listed(before, "x") + " are left");
  return {};
}

} // namespace

Expected<void> applyChanges(Input &input, const InputOptions &options) {
  // A solid by the centres of cells is filled, whether that was asked for or not.
  const Interior interior = options.interior == Interior::Keep ? input.interior : options.interior;
  if (interior != Interior::Keep && !isSaid(input.provenance, interior)) {
    // The inside of a mesh is filled where its triangles are at hand.
    if (input.interior != interior)
      VOXC_TRY(changeInside(input, options));
    tellInside(input, interior, options);
  }
  return options.crop ? cropBorder(input, options) : Expected<void>();
}

} // namespace voxc
