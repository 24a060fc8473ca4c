// Statements of .mtl files.
#include "Mesh/Obj/MaterialLibrary.h"

#include "Support/Text.h"

#include <algorithm>
#include <vector>

namespace voxc {

namespace {

/// Options of textures that take one word, and those that take up to three numbers.
constexpr std::array<std::string_view, 7> kWordOptions{"-blendu", "-blendv",  "-cc", "-clamp",
                                                       "-texres", "-imfchan", "-bm"};
constexpr std::array<std::string_view, 5> kNumberOptions{"-o", "-s", "-t", "-mm", "-boost"};

template <std::size_t N> bool isOneOf(const std::array<std::string_view, N> &list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
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
  }

private:
  struct Statement {
    std::string_view word;
    void (MtlReader::*read)();
  };

  void readStatement(std::string_view word) {
    static constexpr std::array<Statement, 6> kStatements{{{"newmtl", &MtlReader::beginMaterial},
                                                           {"Kd", &MtlReader::readColour},
                                                           {"d", &MtlReader::readOpacity},
                                                           {"Tr", &MtlReader::readTransparency},
                                                           {"map_Kd", &MtlReader::readColourMap},
                                                           {"map_d", &MtlReader::readMask}}};
    for (const Statement &statement : kStatements)
      if (statement.word == word) {
        if (material_ || word == "newmtl")
          (this->*statement.read)();
        else
          warn("stands before any newmtl");
      }
  }

  void beginMaterial() { material_ = &(materials_[std::string(trimmed(rest_))] = {}); }

  /// One number is grey.
  void readColour() {
    const auto red = parseNumber(takeWord(rest_));
    const auto green = parseNumber(takeWord(rest_));
    const auto blue = parseNumber(takeWord(rest_));
    if (!red)
      return warn("has no colour in numbers");
    const std::array<double, 3> colour{*red, green.value_or(*red), blue.value_or(*red)};
    for (std::size_t i = 0; i < colour.size(); ++i)
      material_->colour[i] = static_cast<float>(colour[i]);
  }

  void readOpacity() {
    std::string_view word = takeWord(rest_);
    if (word == "-halo")
      word = takeWord(rest_);
    if (const auto opacity = parseNumber(word))
      material_->colour[3] = static_cast<float>(*opacity);
    else
      warn("has no number");
  }

  void readTransparency() {
    if (const auto transparency = parseNumber(takeWord(rest_)))
      material_->colour[3] = static_cast<float>(1 - *transparency);
    else
      warn("has no number");
  }

  void readColourMap() { material_->texture = readTexture(); }
  void readMask() { material_->alphaMask = readTexture(); }

  MtlTexture readTexture() {
    MtlTexture texture;
    while (rest_ = trimmed(rest_), rest_.starts_with('-')) {
      std::string_view after = rest_;
      const std::string_view option = takeWord(after);
      if (isOneOf(kWordOptions, option)) {
        const std::string_view value = takeWord(after);
        texture.clamp = option == "-clamp" ? value == "on" : texture.clamp;
      } else if (isOneOf(kNumberOptions, option)) {
        readNumbers(option, after, texture);
      } else {
        break; // A name that begins with a dash.
      }
      rest_ = after;
    }
    if (rest_.empty())
      warn("names no image");
    else
      texture.image = pathOf(rest_);
    return texture;
  }

  static void readNumbers(std::string_view option, std::string_view &after, MtlTexture &texture) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::string_view next = after;
      const auto number = parseNumber(takeWord(next));
      if (!number)
        return;
      after = next;
      if (i < 2 && option == "-o")
        texture.offset[i] = static_cast<float>(*number);
      if (i < 2 && option == "-s")
        texture.scale[i] = static_cast<float>(*number);
    }
  }

  std::string pathOf(std::string_view name) const {
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    return path.starts_with('/') ? path : folder_ + path;
  }

  void warn(const std::string &what) {
    warnings_.add("line " + std::to_string(line_) + " of the material library '" + library_ + "' " + what);
  }

  std::string library_;
  std::string folder_;
  std::map<std::string, MtlMaterial> &materials_;
  Warnings &warnings_;
  MtlMaterial *material_ = nullptr;
  std::string_view rest_;
  std::uint64_t line_ = 0;
};

} // namespace

void readMtl(std::string_view text, const std::string &library, const std::string &folder,
             std::map<std::string, MtlMaterial> &materials, Warnings &warnings) {
  MtlReader(library, folder, materials, warnings).read(text);
}

} // namespace voxc
