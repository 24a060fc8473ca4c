// NRRD headers: the fields held against each other.
#include "Input/Dense/NrrdHeader.h"

#include "Input/Dense/DenseVolume.h"
#include "Input/Dense/NrrdAxes.h"
#include "voxc/Input/Units.h"
#include "voxc/Support/NumberedPath.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace voxc {

namespace {

using Vector = std::array<double, 3>;

/// Spaces of patients: whether +x goes to the left in a mirrored one.
struct SpaceName {
  std::string_view name;
  bool isLeftHanded;
};

constexpr std::array<SpaceName, 6> kPatientSpaces{{{"right-anterior-superior", false},
                                                   {"ras", false},
                                                   {"left-posterior-superior", false},
                                                   {"lps", false},
                                                   {"left-anterior-superior", true},
                                                   {"las", true}}};

void readSpace(const NrrdFields &fields, NrrdHeader &header) {
  header.hasSpace = !fields.space.empty();
  const std::string_view space = std::string_view(fields.space).substr(0, fields.space.rfind("-time"));
  for (const SpaceName &row : kPatientSpaces)
    if (row.name == space) {
      header.isUpZ = true;
      header.isLeftHanded = row.isLeftHanded;
    }
  const bool isOne = !fields.units.empty() && std::ranges::all_of(fields.units, [&](const auto &unit) {
    return unit == fields.units[0];
  });
  header.unit = isOne ? metresOf(fields.units[0]).value_or(0) : 0;
}

std::optional<Vector> vectorOf(const std::vector<double> &numbers) {
  return numbers.size() == 3 ? std::optional(Vector{numbers[0], numbers[1], numbers[2]}) : std::nullopt;
}

/// The step from one sample of an axis to the next: its spacing, or what its ends say.
std::optional<double> stepOf(const NrrdFields &fields, std::size_t axis) {
  const std::size_t count = fields.sizes.size();
  if (fields.spacings.size() == count)
    return std::isfinite(fields.spacings[axis]) ? std::optional(fields.spacings[axis]) : std::nullopt;
  const bool isOfNodes = fields.centers.size() == count && fields.centers[axis] == "node";
  const std::int64_t steps = fields.sizes[axis] - (isOfNodes ? 1 : 0);
  if (fields.mins.size() != count || fields.maxs.size() != count || steps < 1)
    return std::nullopt;
  const double step = (fields.maxs[axis] - fields.mins[axis]) / static_cast<double>(steps);
  return std::isfinite(step) ? std::optional(step) : std::nullopt;
}

void readPlace(const NrrdFields &fields, const std::array<int, 3> &order, NrrdHeader &header) {
  std::array<Vector, 3> steps{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  bool isOther = !fields.origin.empty() && fields.origin.size() != 3, isZero = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto from = static_cast<std::size_t>(std::max(order[axis], 0));
    if (order[axis] < 0)
      continue;
    if (fields.directions.size() == fields.sizes.size()) {
      const auto step = vectorOf(fields.directions[from]);
      steps[axis] = step.value_or(steps[axis]);
      isOther |= !step;
    } else if (const auto step = stepOf(fields, from)) {
      isZero |= *step == 0;
      steps[axis][axis] = *step == 0 ? 1 : *step;
    }
  }
  if (isZero)
    header.warnings.push_back("its spacings have a 0, which is taken as 1");
  if (isOther)
    header.warnings.push_back("its space does not have three axes; where its samples lie in it is left out");
  const auto origin = isOther ? std::nullopt : vectorOf(fields.origin);
  header.hasSpace &= !isOther;
  header.sampleToModel =
      mapOfSteps(steps, origin.value_or(Vector{steps[0][0] / 2, steps[1][1] / 2, steps[2][2] / 2}));
}

/// A pattern with its first number, its last one and its step: "slice%03d.raw 1 99 2".
struct Pattern {
  std::string name;
  std::array<std::int64_t, 3> numbers{};
};

std::optional<Pattern> patternOf(std::string_view text) {
  std::vector<std::int64_t> numbers;
  // Numbers are at the end, and names may have blanks; a fourth is the dimension of a file's samples.
  while (numbers.size() < 4) {
    const std::size_t blank = text.find_last_of(" \t");
    std::int64_t number = 0;
    if (blank == std::string_view::npos)
      break;
    const std::string_view word = text.substr(blank + 1);
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
    if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size())
      break;
    numbers.insert(numbers.begin(), number);
    text = text.substr(0, blank);
    text = text.substr(0, text.find_last_not_of(" \t") + 1);
  }
  if (text.find('%') == std::string_view::npos || numbers.size() < 3)
    return std::nullopt;
  return Pattern{std::string(text), {numbers[0], numbers[1], numbers[2]}};
}

Expected<void> readPattern(const Pattern &pattern, NrrdHeader &header) {
  const auto path = NumberedPath::parse(pattern.name);
  const auto [first, last, step] = pattern.numbers;
  if (!path || first < 0 || last < 0)
    return Error::input(
        "its data file '" + pattern.name +
        "' is no pattern that voxc reads; it should have one number such as %d or %03d, from 0 up");
  if (step == 0 || (step > 0) != (last >= first) || (last - first) / step >= 1 << kMaxLog2Extent)
    return Error::input("its data files go from number " + std::to_string(first) + " to " +
                        std::to_string(last) + " by steps of " + std::to_string(step) +
                        ", which is no sequence");
  for (std::int64_t number = first; step > 0 ? number <= last : number >= last; number += step)
    header.dataFiles.push_back((*path)(static_cast<std::uint64_t>(number)));
  return {};
}

Expected<void> readFiles(const NrrdFields &fields, NrrdHeader &header) {
  if (fields.dataFile.starts_with("LIST")) {
    if (fields.dataFiles.empty())
      return Error::input("its data file is a LIST, but no names follow");
    header.dataFiles = fields.dataFiles;
  } else if (const auto pattern = patternOf(fields.dataFile)) {
    VOXC_TRY(readPattern(*pattern, header));
  } else if (!fields.dataFile.empty()) {
    header.dataFiles = {fields.dataFile};
  }
  if (!header.dataFiles.empty() && header.bytes % header.dataFiles.size() != 0)
    return Error::input("its " + std::to_string(header.bytes) + " bytes of samples are no multiple of its " +
                        std::to_string(header.dataFiles.size()) + " data files");
  return {};
}

/// What programs write for themselves, such as the names and colours of segments.
std::string saysKeys(const std::vector<std::string> &keys) {
  constexpr std::size_t kMostNames = 4;
  std::string names;
  for (std::size_t i = 0; i < std::min(keys.size(), kMostNames); ++i)
    names += (i == 0 ? "'" : ", '") + keys[i] + "'";
  const bool hasMore = keys.size() > kMostNames;
  return "of its key/value pairs nothing is used but that there are segments: " + names +
         (hasMore ? " and " + std::to_string(keys.size() - kMostNames) + " more" : "");
}

} // namespace

Expected<NrrdHeader> readNrrdHeader(std::string_view &text, bool picksVolume) {
  const auto fields = VOXC_TRY(readNrrdFields(text));
  if (!fields.type || fields.sizes.empty() || !fields.encoding)
    return Error::input("its header needs the fields type, dimension, sizes and encoding");
  NrrdHeader header;
  header.encoding = *fields.encoding;
  const bool isText = header.encoding == NrrdEncoding::Text;
  if (byteSize(*fields.type) > 1 && fields.endian.empty() && !isText)
    return Error::input("its header needs the field endian, since its samples have more than one byte");
  // Numbers in digits are made samples of this machine's order.
  header.layout = {*fields.type, isText ? std::endian::native == std::endian::big : fields.endian == "big"};
  std::array<int, 3> order{};
  VOXC_TRY(fillAxes(fields, picksVolume, header, order));
  header.lineSkip = fields.lineSkip;
  header.byteSkip = fields.byteSkip;
  if (header.byteSkip < 0 && (isText || header.encoding == NrrdEncoding::Hex))
    return Error::input("its byte skip of -1 does not go with samples in digits");
  header.areLabels = fields.hasSegments;
  readSpace(fields, header);
  readPlace(fields, order, header);
  VOXC_TRY(readFiles(fields, header));
  if (!fields.keys.empty())
    header.warnings.push_back(saysKeys(fields.keys));
  for (const std::string &name : fields.twice)
    header.warnings.push_back("its field '" + name + "' is there more than once; the last holds");
  for (const std::string &name : fields.unknown)
    header.warnings.push_back("its field '" + name + "' is not known to voxc, and is left out");
  return header;
}

} // namespace voxc
