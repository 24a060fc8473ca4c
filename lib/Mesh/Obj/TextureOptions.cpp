// Options of textures, and what each means.
#include "Mesh/Obj/TextureOptions.h"

#include "Support/Text.h"

#include <algorithm>
#include <vector>

namespace voxc {

namespace {

constexpr std::size_t kMostNumbers = 3;

/// What stands behind an option.
struct Arguments {
  std::string_view word; ///< If it is no number.
  std::vector<double> numbers;
};

using Take = void (*)(const Arguments &, MtlTexture &);

void takeClamp(const Arguments &arguments, MtlTexture &texture) {
  texture.clamp = lowerCase(arguments.word) == "on";
}

void takeScale(const Arguments &arguments, MtlTexture &texture) {
  for (std::size_t i = 0; i < std::min<std::size_t>(2, arguments.numbers.size()); ++i)
    texture.scale[i] = static_cast<float>(arguments.numbers[i]);
}

void takeOffset(const Arguments &arguments, MtlTexture &texture) {
  for (std::size_t i = 0; i < std::min<std::size_t>(2, arguments.numbers.size()); ++i)
    texture.offset[i] = static_cast<float>(arguments.numbers[i]);
}

struct OptionRow {
  std::string_view name;
  bool takesNumbers; ///< Up to three of them, else one word.
  Take take;         ///< Null: it says nothing about colours, but for where `isPlain` is false.
  bool (*isPlain)(const Arguments &);
};

bool always(const Arguments &) { return true; }
bool isOff(const Arguments &arguments) { return lowerCase(arguments.word) != "on"; }
bool isSrgb(const Arguments &arguments) {
  const std::string space = lowerCase(arguments.word);
  return space.find("srgb") != std::string::npos || space == "auto";
}
bool isGain(const Arguments &arguments) {
  return arguments.numbers.size() == 2 && arguments.numbers[0] == 0 && arguments.numbers[1] == 1;
}
bool areZero(const Arguments &arguments) {
  return std::ranges::all_of(arguments.numbers, [](double number) { return number == 0; });
}
/// m is the matte, which is alpha.
constexpr std::string_view kChannels = "rgbm";
bool isChannel(const Arguments &arguments) {
  return arguments.word.size() == 1 && kChannels.find(arguments.word) != std::string_view::npos;
}
void takeChannel(const Arguments &arguments, MtlTexture &texture) {
  if (isChannel(arguments))
    texture.channel = static_cast<std::uint8_t>(kChannels.find(arguments.word));
}
bool never(const Arguments &) { return false; }

constexpr std::array<OptionRow, 14> kOptions{{{"-clamp", false, takeClamp, always},
                                              {"-s", true, takeScale, always},
                                              {"-o", true, takeOffset, always},
                                              {"-t", true, nullptr, areZero},
                                              {"-mm", true, nullptr, isGain},
                                              {"-boost", true, nullptr, always},
                                              {"-bm", true, nullptr, always},
                                              {"-texres", true, nullptr, always},
                                              {"-blendu", false, nullptr, always},
                                              {"-blendv", false, nullptr, always},
                                              {"-cc", false, nullptr, isOff},
                                              {"-imfchan", false, takeChannel, isChannel},
                                              {"-colorspace", false, nullptr, isSrgb},
                                              {"-type", false, nullptr, never}}};

/// Takes up to three numbers, or one word.
Arguments takeArguments(std::string_view &text, bool areNumbers) {
  Arguments arguments;
  while (arguments.numbers.size() < kMostNumbers) {
    std::string_view after = text;
    const auto number = parseNumber(takeWord(after));
    if (!number || trimmed(after).empty())
      break; // The image may be called so.
    arguments.numbers.push_back(*number);
    text = after;
  }
  if (arguments.numbers.empty() && !areNumbers)
    arguments.word = takeWord(text);
  return arguments;
}

} // namespace

MtlTexture readTexture(std::string_view text, std::set<std::string> &unused) {
  MtlTexture texture;
  text = trimmed(text);
  while (text.starts_with('-')) {
    std::string_view rest = text;
    const std::string option = lowerCase(takeWord(rest));
    const auto *known = std::ranges::find(kOptions, option, &OptionRow::name);
    const bool isKnown = known != kOptions.end();
    if (trimmed(rest).empty() && !isKnown)
      break; // A name that begins with a dash.
    const Arguments arguments = takeArguments(rest, isKnown && known->takesNumbers);
    if (!isKnown && texture.otherwise.empty())
      texture.otherwise = text;
    if (isKnown && known->take)
      known->take(arguments, texture);
    if (!isKnown || !known->isPlain(arguments))
      unused.insert(option);
    rest = trimmed(rest);
    text = rest.empty() && !isKnown ? arguments.word : rest;
    if (rest.empty())
      break;
  }
  texture.image = text;
  return texture;
}

} // namespace voxc
