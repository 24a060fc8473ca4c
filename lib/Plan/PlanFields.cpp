// The tables of what plan text says.
#include "PlanFields.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdio>
#include <utility>

namespace voxc {
namespace {

template <typename Number> bool parseNumber(Number &number, std::string_view text, int base = 10) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  return problem == std::errc() && end == text.data() + text.size();
}

/// What a member of Owner is as text, by its type; values that are as in a new Owner are defaults.
template <typename Owner, auto Member> std::string printMember(const Owner &owner) {
  const auto &value = owner.*Member;
  if (value == Owner{}.*Member)
    return {};
  if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>)
    return std::string(toString(value));
  else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, bool>)
    return value ? "yes" : "no";
  else
    return std::to_string(value);
}

template <typename Owner, auto Member> bool parseMember(Owner &owner, std::string_view text) {
  auto &value = owner.*Member;
  using Value = std::remove_cvref_t<decltype(value)>;
  if constexpr (std::is_enum_v<Value>) {
    const auto found = fromString<Value>(text);
    value = found.value_or(value);
    return found.has_value();
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = text == "yes";
    return text == "yes" || text == "no";
  } else {
    return parseNumber(value, text);
  }
}

/// The names of an enum, with commas between them.
template <typename Enum> struct ListedNames {
  static constexpr std::size_t kLength = [] {
    std::size_t length = 2 * (kEnumNames<Enum>.size() - 1);
    for (const std::string_view name : kEnumNames<Enum>)
      length += name.size();
    return length;
  }();
  static constexpr std::array<char, kLength> kText = [] {
    std::array<char, kLength> text{};
    auto at = text.begin();
    for (const std::string_view name : kEnumNames<Enum>) {
      if (at != text.begin())
        at = std::ranges::copy(std::string_view(", "), at).out;
      at = std::ranges::copy(name, at).out;
    }
    return text;
  }();
};

/// A member that is an enum or says yes or no, and so says itself what it takes.
template <typename Owner, auto Member> constexpr Field<Owner> field(std::string_view name) {
  using Value = std::remove_cvref_t<decltype(std::declval<Owner>().*Member)>;
  std::string_view values = "yes, no";
  if constexpr (std::is_enum_v<Value>)
    values = {ListedNames<Value>::kText.data(), ListedNames<Value>::kLength};
  return {name, printMember<Owner, Member>, parseMember<Owner, Member>, values};
}

/// A member that is a number.
template <typename Owner, auto Member>
constexpr Field<Owner> field(std::string_view name, std::string_view values) {
  return {name, printMember<Owner, Member>, parseMember<Owner, Member>, values};
}

/// An output, printed if it is not the default.
template <bool Outputs::*Output> std::string printOutput(const Plan &plan) {
  const bool isDefault = plan.outputs.*Output == Outputs{}.*Output;
  return isDefault ? "" : plan.outputs.*Output ? "yes" : "no";
}

template <bool Outputs::*Output> bool parseOutput(Plan &plan, std::string_view text) {
  plan.outputs.*Output = text == "yes";
  return text == "yes" || text == "no";
}

template <bool Outputs::*Output> constexpr Field<Plan> output(std::string_view name) {
  return {name, printOutput<Output>, parseOutput<Output>, "yes, no"};
}

std::string printStorage(const Plan &plan) {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx",
                static_cast<unsigned long long>(plan.layout.storageDigest));
  return digits.data();
}

bool parseStorage(Plan &plan, std::string_view text) {
  return text.size() == 16 && parseNumber(plan.layout.storageDigest, text, 16);
}

std::string printPayload(const Plan &plan) { return plan.layout.payloadText(); }

bool parsePayload(Plan &plan, std::string_view text) { return plan.layout.setPayload(text); }

std::string printAlpha(const Plan &plan) {
  return plan.layout.alpha == Alpha::Any ? "" : std::string(toString(plan.layout.alpha));
}

bool parseAlpha(Plan &plan, std::string_view text) {
  const auto alpha = fromString<Alpha>(text);
  plan.layout.alpha = alpha.value_or(Alpha::Any);
  return alpha.has_value();
}

std::string printValues(const Plan &plan) {
  return plan.layout.values == Values::InPlace ? "" : std::string(toString(plan.layout.values));
}

bool parseValues(Plan &plan, std::string_view text) {
  const auto values = fromString<Values>(text);
  plan.layout.values = values.value_or(Values::InPlace);
  return values.has_value();
}

std::string printGranule(const Plan &plan) {
  return plan.layout.log2Granule == 0 ? "" : std::to_string(1 << plan.layout.log2Granule);
}

bool parseGranule(Plan &plan, std::string_view text) {
  unsigned words = 0;
  const bool isNumber = parseNumber(words, text) && std::has_single_bit(words);
  plan.layout.log2Granule = isNumber ? std::bit_width(words) - 1 : 0;
  return isNumber;
}

constexpr std::array<Field<Plan>, 26> kPlanFields = {{
    {"storage", printStorage, parseStorage, "16 hexadecimal digits"},
    {"payload", printPayload, parsePayload,
     "rgba8, occupancy, constant, palette(1) to palette(16), rgb565, material(1) to material(16)"},
    {"alpha", printAlpha, parseAlpha, "any, positive"},
    {"values", printValues, parseValues, "in-place, apart"},
    {"granule", printGranule, parseGranule, "a number of words, a power of two"},
    field<Plan, &Plan::addressing>("addressing"),
    field<Plan, &Plan::levelTraversal>("levels"),
    field<Plan, &Plan::stack>("stack"),
    field<Plan, &Plan::precision>("precision"),
    field<Plan, &Plan::steps>("steps"),
    field<Plan, &Plan::detail>("detail"),
    field<Plan, &Plan::query>("query"),
    output<&Outputs::voxel>("voxel"),
    output<&Outputs::t>("t"),
    output<&Outputs::face>("face"),
    output<&Outputs::colour>("colour"),
    output<&Outputs::index>("index"),
    field<Plan, &Plan::loops>("loops"),
    field<Plan, &Plan::arithmetic>("arithmetic"),
    field<Plan, &Plan::packing>("packing"),
    field<Plan, &Plan::bounded>("bounds"),
    field<Plan, &Plan::speculative>("speculative"),
    field<Plan, &Plan::spanFaces>("span-faces"),
    field<Plan, &Plan::compare>("compare"),
    field<Plan, &Plan::packetWidth>("packet-width"),
    field<Plan, &Plan::defersValues>("defers-values"),
}};

using S = PlannedStratum;

/// A member of an encoding, which strata of other kinds of slots do not have.
template <typename Part, auto Member> std::string printPart(const S &stratum) {
  const auto *const part = std::get_if<Part>(&stratum.encoding);
  return part ? printMember<Part, Member>(*part) : "";
}

template <typename Part, auto Member> bool parsePart(S &stratum, std::string_view text) {
  if (!std::holds_alternative<Part>(stratum.encoding))
    stratum.encoding = Part{};
  return parseMember<Part, Member>(std::get<Part>(stratum.encoding), text);
}

template <typename Part> bool takesPart(const S &stratum) { return takes(*stratum.slots, Part{}); }

template <typename Part, auto Member> constexpr Field<S> part(std::string_view name) {
  using Value = std::remove_cvref_t<decltype(std::declval<Part>().*Member)>;
  return {name,
          printPart<Part, Member>,
          parsePart<Part, Member>,
          {ListedNames<Value>::kText.data(), ListedNames<Value>::kLength},
          takesPart<Part>};
}

template <typename Part, auto Member>
constexpr Field<S> part(std::string_view name, std::string_view values) {
  return {name, printPart<Part, Member>, parsePart<Part, Member>, values, takesPart<Part>};
}

/// What a level shares, by the name and the values that its kind has for it.
std::string printSharing(const S &stratum) { return stratum.sharing == Sharing::Level ? "level" : ""; }

template <Sharing Default> bool parseSharing(S &stratum, std::string_view text) {
  stratum.sharing = text == "level" ? Sharing::Level : Default;
  return text == "level" || text == (Default == Sharing::None ? "none" : "sub-volume");
}

bool isGrid(const S &stratum) { return stratum.isGrid(); }
bool sharesNodes(const S &stratum) { return stratum.slots->sharing == Sharing::SubVolume; }

constexpr std::array<Field<S>, 18> kStratumFields = {{
    field<S, &S::depth>("depth", "a number of layers"),
    field<S, &S::log2Cell>("cell", "log2 of the voxels along a cell's side"),
    part<Leaves, &Leaves::place>("leaves"),
    part<Distances, &Distances::metric>("metric"),
    part<Distances, &Distances::reach>("reach", "a number of cells"),
    part<Distances, &Distances::place>("distances"),
    part<Numbers, &Numbers::bits>("pointers", "a number of bits"),
    part<Numbers, &Numbers::counts>("counts"),
    {"share", printSharing, parseSharing<Sharing::None>, "none, level", isGrid},
    {"dedup", printSharing, parseSharing<Sharing::SubVolume>, "sub-volume, level", sharesNodes},
    field<S, &S::descent>("traversal"),
    field<S, &S::stops>("stops"),
    field<S, &S::sampled>("sampled"),
    field<S, &S::lookUp>("lookup"),
    field<S, &S::readsValues>("reads-values"),
    field<S, &S::voxelSteps>("voxel-steps"),
    field<S, &S::bricks>("bricks"),
    field<S, &S::looksAhead>("looks-ahead"),
}};

} // namespace

std::span<const Field<Plan>> planFields() { return kPlanFields; }
std::span<const Field<PlannedStratum>> stratumFields() { return kStratumFields; }

} // namespace voxc
