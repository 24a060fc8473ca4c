// Grids with a mask of their cells and slots of words: what the kinds of them share.
#pragma once

#include "Masks.h"

#include "voxc/Layout/SlotKind.h"

#include <cstdint>
#include <span>
#include <string>

namespace voxc {

inline constexpr RuntimeClass kMaskedGrid = {"voxc_masked.h", "MaskedGrid"};
inline constexpr RuntimeClass kEditedMasked = {"voxc_edited_masked.h", "EditedMasked"};

/// Words of the mask, and of one slot if there are any.
std::uint64_t maskedLeastWords(const Stratum &stratum);
std::uint64_t maskedWordsWith(const Stratum &stratum, std::uint64_t slots, std::uint64_t octants);
std::uint64_t maskedSize(const WordReader &words, const Stratum &stratum, std::uint64_t node);
bool checkMasked(WordReader &words, const Stratum &stratum, std::uint64_t node, bool lowest);
std::uint64_t countMasked(WordReader &words, const Stratum &stratum, std::uint64_t node, int layer);
bool relocateMasked(std::span<std::uint32_t> words, const Stratum &stratum, bool holdsVoxels,
                    Relocation relocation);

/// The cell of a bit that is set. `earlier`: the voxels of a lowest grid that come before it.
Child maskedCell(const WordReader &words, const Stratum &stratum, const Masks &masks, std::uint64_t node,
                 std::uint64_t index, std::uint64_t earlier);

/// What a model of speed needs to know of masks that are read by the word.
std::uint64_t maskLine(const Stratum &stratum, std::uint64_t cell);
std::optional<std::uint64_t> maskedSlotLine(const Stratum &stratum, std::uint64_t cell);

} // namespace voxc
