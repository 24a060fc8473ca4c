// What follows from the strata of a layout.
#include "voxc/Layout/Layout.h"

#include "voxc/Layout/Rgb565.h"
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace voxc {
namespace {

/// In the order of `Payload`.
constexpr std::array<PayloadKind, kEnumNames<Payload>.size()> kPayloadKinds = {
    {{.varies = true, .inPlace = true, .hit = "rgba8", .blocks = "colours"},
     {.inPlace = true, .hit = "occupancy"},
     {.inPlace = true, .oneColour = true, .hit = "constant"},
     {.varies = true, .mostBits = 16, .hit = "rgba8", .blocks = "palette"},
     {.varies = true, .code = toRgb565, .decode = ofRgb565, .hit = "rgb565", .blocks = "colours"},
     {.varies = true, .inPlace = true, .mostBits = 16, .labels = true, .hit = "rgba8", .blocks = "palette"}}};

} // namespace

const PayloadKind &kindOf(Payload payload) { return kPayloadKinds[static_cast<std::size_t>(payload)]; }

std::string Layout::payloadText() const {
  const std::string name(toString(payload));
  return payloadBits == 0 ? name : name + "(" + std::to_string(payloadBits) + ")";
}

bool Layout::setPayload(std::string_view text) {
  const std::size_t open = std::min(text.find('('), text.size());
  const auto kind = fromString<Payload>(text.substr(0, open));
  if (!kind)
    return false;
  int bits = 0;
  if (open < text.size()) {
    const auto [end, problem] = std::from_chars(text.data() + open + 1, text.data() + text.size(), bits);
    if (problem != std::errc() || std::string_view(end, text.data() + text.size()) != ")")
      return false;
  }
  const int most = kindOf(*kind).mostBits;
  if (bits < std::min(most, 1) || bits > most)
    return false;
  payload = *kind;
  payloadBits = bits;
  return true;
}

void Layout::complete() {
  const bool areAlike = !kindOf(payload).varies || values == Values::Apart;
  for (std::size_t i = 0; i < strata.size(); ++i) {
    Stratum &stratum = strata[i];
    stratum.lowest = holdsVoxels(i);
    stratum.ranked = values == Values::Apart;
    stratum.implied =
        stratum.lowest && areAlike && stratum.depth > 0 && stratum.slots && stratum.slots->hasChildMask;
    auto *const above = i > 0 ? std::get_if<Numbers>(&strata[i - 1].encoding) : nullptr;
    stratum.numberBits = above ? above->bits : 0;
    stratum.arrayHead = above ? static_cast<int>(headWords()) - 1 : 0;
    if (above) {
      above->leadsTo = stratum.slots;
      above->arrayHead = stratum.arrayHead;
    }
  }
}

bool Layout::hasArray() const { return std::ranges::any_of(strata, &Stratum::numbers); }

std::uint64_t Layout::headWords() const {
  const bool hasSecond = values == Values::Apart || hasOneColour();
  return granuleAfter(1 + (hasSecond ? 1 : 0) + (hasArray() ? 1 : 0));
}

Int3 Layout::log2Extent() const {
  const Stratum &top = strata.front();
  const Int3 size = top.log2Size();
  return {size.x + top.log2Cell, size.y + top.log2Cell, size.z + top.log2Cell};
}

Ref Layout::placeMask() const {
  int bits = 32;
  for (const Stratum &stratum : strata)
    bits = std::min(bits, stratum.slots->placeBits);
  return static_cast<Ref>((std::uint64_t{1} << bits) - 1);
}

std::uint64_t Layout::maxWords() const {
  int log2 = 32;
  for (const Stratum &stratum : strata)
    log2 = std::min({log2, stratum.log2Reach(), stratum.slots->placeBits});
  return granuleAfter(1) << log2;
}

std::size_t Layout::stratumOfPart(int log2Side) const {
  for (std::size_t i = 0; i + 1 < strata.size(); ++i)
    if (log2Side > strata[i].log2Cell)
      return i;
  return strata.size() - 1;
}

int Layout::partSide(int log2Side) const {
  const int whole = maxComponent(log2Extent());
  const Stratum &stratum = strata[stratumOfPart(log2Side)];
  const int step = std::max(stratum.log2Shape.x, 1);
  // Construction goes through the cells of a grid by cubes of any size, through a tree by its nodes.
  if (stratum.isGrid() || stratum.depth == 0)
    return std::min(log2Side, whole);
  const int above = (log2Side - stratum.log2Cell + step - 1) / step * step;
  return std::min(stratum.log2Cell + above, whole);
}

} // namespace voxc
