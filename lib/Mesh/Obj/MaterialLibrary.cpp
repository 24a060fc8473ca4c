// Statements of .mtl files.
#include "Mesh/Obj/MaterialLibrary.h"

#include "Mesh/ColourScale.h"
#include "Support/Text.h"

#include <algorithm>
#include <set>

namespace voxc {

namespace {

/// About how light falls; in lower case.
constexpr std::array<std::string_view, 8> kMtlPassedOver{"ka",    "ks", "ns",        "ni",
                                                         "illum", "tf", "sharpness", "interpolation"};

/// Words in the order that a sentence has them.
std::string listed(const std::set<std::string> &words) {
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

class MtlReader {
public:
  MtlReader(std::string library, std::string folder, std::map<std::string, MtlMaterial> &materials,
            Warnings &warnings)
      : library_(std::move(library)), folder_(std::move(folder)), materials_(materials), warnings_(warnings) {
  }

  void read(std::string_view text) {
    TextLines lines(text);
    while (const auto line = lines.next()) {
      rest_ = trimmed(*line);
      line_ = lines.number();
      readStatement(takeWord(rest_));
    }
    for (const MtlMaterial *material : read_)
      if (!material->ambientImage.empty() && material->ambientImage != material->texture.image)
        unused_.insert("map_Ka");
    if (!earlier_.empty())
      warnings_.add("the material library '" + library_ +
                    "' has materials of a library before it, which hold: " + listed(earlier_));
    if (!repeated_.empty())
      warnings_.add("the material library '" + library_ +
                    "' says again what was said before; the last holds of " + listed(repeated_));
    if (!unused_.empty())
      warnings_.add("of the material library '" + library_ + "' these are not used: " + listed(unused_));
  }

private:
  static constexpr std::size_t kLongestWord = 32;
  static constexpr std::size_t kMostUnused = 16;
  static constexpr std::size_t kMostRepeated = 8;

  struct Statement {
    std::string_view word;
    void (MtlReader::*read)();
  };

  /// Programs write the words in letters of any case.
  void readStatement(std::string_view word) {
    static constexpr std::array<Statement, 11> kStatements{{{"newmtl", &MtlReader::beginMaterial},
                                                            {"kd", &MtlReader::readColour},
                                                            {"d", &MtlReader::readOpacity},
                                                            {"tr", &MtlReader::readTransparency},
                                                            {"map_kd", &MtlReader::readColourMap},
                                                            {"map_d", &MtlReader::readMask},
                                                            {"map_ka", &MtlReader::readAmbientMap},
                                                            {"ke", &MtlReader::readEmission},
                                                            {"map_ke", &MtlReader::readEmissionMap},
                                                            {"pm", &MtlReader::readMetallic},
                                                            {"pr", &MtlReader::readRoughness}}};
    if (word.empty() || word.starts_with('#'))
      return;
    const std::string lower = lowerCase(word.substr(0, kLongestWord));
    const auto *statement = std::ranges::find(kStatements, lower, &Statement::word);
    if (statement == kStatements.end())
      return passOver(word, lower);
    if (!material_ && lower != "newmtl")
      return warn("stands before any newmtl");
    if (lower != "newmtl" && !said_.insert(lower).second)
      note(std::string(word.substr(0, kLongestWord)) + " of '" + name_ + "'", repeated_);
    (this->*statement->read)();
  }

  /// Shares of which there are none mean nothing.
  void passOver(std::string_view word, const std::string &lower) {
    if (std::ranges::find(kMtlPassedOver, lower) != kMtlPassedOver.end() || unused_.size() == kMostUnused)
      return;
    bool isNothing = true;
    for (std::string_view number = takeWord(rest_); !number.empty() && isNothing; number = takeWord(rest_))
      isNothing = parseNumber(number) == 0.0;
    if (!isNothing)
      unused_.insert(std::string(word.substr(0, kLongestWord)));
  }

  void beginMaterial() {
    name_ = trimmed(rest_);
    said_.clear();
    const auto [entry, isNew] = materials_.try_emplace(name_);
    const bool isEarlier = !isNew && !read_.contains(&entry->second);
    if (!isNew)
      note("'" + name_ + "'", isEarlier ? earlier_ : repeated_);
    material_ = isEarlier ? &leftOut_ : &entry->second;
    *material_ = {};
    material_->folder = folder_;
    if (!isEarlier)
      read_.insert(material_);
  }

  static void note(std::string what, std::set<std::string> &notes) {
    if (notes.size() < kMostRepeated)
      notes.insert(std::move(what));
  }

  /// One number is grey.
  std::optional<std::array<double, 3>> takeColour() {
    const auto red = parseNumber(takeWord(rest_));
    const auto green = parseNumber(takeWord(rest_));
    const auto blue = parseNumber(takeWord(rest_));
    if (red)
      return std::array{*red, green.value_or(*red), blue.value_or(*red)};
    warn("has no colour in numbers");
    return std::nullopt;
  }

  void readColour() {
    const auto colour = takeColour();
    if (!colour)
      return;
    ColourScale scale;
    for (const double channel : *colour)
      scale.add(channel);
    // Of so few numbers 2 may well be a light.
    const double whole = scale.largest() > 2 ? scale.whole() : 1;
    if (whole != 1)
      warn("has a colour above 1, which is taken as one that counts to " +
           std::to_string(static_cast<std::uint64_t>(whole)));
    for (std::size_t i = 0; i < colour->size(); ++i)
      material_->colour[i] = static_cast<float>((*colour)[i] / whole);
  }

  void readEmission() {
    constexpr double kMostLight = 1e9;
    const auto colour = takeColour();
    if (!colour)
      return;
    std::array<float, 3> &emission = material_->emission.emplace();
    for (std::size_t i = 0; i < emission.size(); ++i)
      emission[i] = (*colour)[i] > 0 ? static_cast<float>(std::min((*colour)[i], kMostLight)) : 0;
  }

  void readMetallic() { readShare(material_->metallic); }
  void readRoughness() { readShare(material_->roughness); }

  void readShare(std::optional<float> &share) {
    const auto number = parseNumber(takeWord(rest_));
    if (!number)
      return warn("has no number");
    if (!(*number >= 0 && *number <= 1))
      warn("has a share that is not from 0 to 1, and is cut there");
    share = *number > 0 ? static_cast<float>(std::min(*number, 1.0)) : 0;
  }

  void readOpacity() {
    std::string_view word = takeWord(rest_);
    if (lowerCase(word) == "-halo")
      word = takeWord(rest_);
    const auto opacity = parseNumber(word);
    if (!opacity)
      return warn("has no number");
    material_->colour[3] = static_cast<float>(*opacity);
    material_->hasOpacity = true;
  }

  void readTransparency() {
    const auto transparency = parseNumber(takeWord(rest_));
    if (!transparency)
      warn("has no number");
    else if (!material_->hasOpacity)
      material_->colour[3] = static_cast<float>(1 - *transparency);
  }

  void readColourMap() { material_->texture = readImage(); }
  void readMask() { material_->alphaMask = readImage(); }
  void readEmissionMap() { material_->emissionTexture = readImage(); }
  void readAmbientMap() { material_->ambientImage = readImage().image; }

  MtlTexture readImage() {
    MtlTexture texture = readTexture(rest_, unused_);
    if (texture.image.empty())
      warn("names no image");
    return texture;
  }

  void warn(const std::string &what) {
    warnings_.add("line " + std::to_string(line_) + " of the material library '" + library_ + "' " + what);
  }

  std::string library_;
  std::string folder_;
  std::map<std::string, MtlMaterial> &materials_;
  Warnings &warnings_;
  MtlMaterial *material_ = nullptr;
  std::set<const MtlMaterial *> read_;
  std::set<std::string> unused_;   ///< Statements and options.
  std::set<std::string> repeated_; ///< Materials, and statements of one, that were there before.
  std::set<std::string> earlier_;  ///< Materials that a library before this one has,
  MtlMaterial leftOut_;            ///< and what this one says of them.
  std::string name_;               ///< Of the material,
  std::set<std::string> said_;     ///< and its statements.
  std::string_view rest_;
  std::uint64_t line_ = 0;
};

} // namespace

void readMtl(std::string_view text, const std::string &library, const std::string &folder,
             std::map<std::string, MtlMaterial> &materials, Warnings &warnings) {
  if (const auto encoding = wideEncoding(text); !encoding.empty())
    return warnings.add("the material library '" + library + "' is not used: " + isWideText(encoding));
  MtlReader(library, folder, materials, warnings).read(text);
}

} // namespace voxc
