// The elements of a .vti file, by expat. What is inline is remembered by its place in the file: nothing is
// copied.
#include "Input/Vtk/VtiFile.h"

#include "Support/Text.h"

#include <expat.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

namespace voxc {

namespace {

constexpr std::size_t kMostPieces = 4096;
constexpr std::size_t kMostArrays = 1 << 16;
constexpr int kMostXmlDepth = 64;

constexpr std::array<std::pair<std::string_view, SampleType>, 10> kVtkTypes{
    {{"Int8", SampleType::Int8},
     {"UInt8", SampleType::Uint8},
     {"Int16", SampleType::Int16},
     {"UInt16", SampleType::Uint16},
     {"Int32", SampleType::Int32},
     {"UInt32", SampleType::Uint32},
     {"Int64", SampleType::Int64},
     {"UInt64", SampleType::Uint64},
     {"Float32", SampleType::Float32},
     {"Float64", SampleType::Float64}}};

class VtiParser {
public:
  VtiParser(std::string_view text, const Progress &progress)
      : text_(text), progress_(progress), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {}

  Expected<VtiFile> read() {
    if (!parser_)
      return Error::environment("there is no memory to read XML");
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), onBegin, onEnd);
    XML_SetCharacterDataHandler(parser_.get(), onText);
    XML_SetStartDoctypeDeclHandler(parser_.get(), onDoctype);
    VOXC_TRY(parse());
    if (!isImage_)
      return Error::input("its XML has no element VTKFile");
    if (file_.pieces.empty())
      return Error::input("it has no element Piece, so that there are no samples");
    return std::move(file_);
  }

private:
  using Attributes = const XML_Char **;

  Expected<void> parse() {
    constexpr std::size_t kStep = std::size_t{1} << 24;
    for (std::size_t done = 0; !isStopped_; done += kStep) {
      const std::size_t now = std::min(kStep, text_.size() - std::min(done, text_.size()));
      const bool isLast = done + now >= text_.size();
      const XML_Status status = XML_Parse(parser_.get(), text_.data() + std::min(done, text_.size()),
                                          static_cast<int>(now), isLast);
      if (problem_)
        return *problem_;
      if (isStopped_)
        break;
      if (progress_.stopped())
        return Error::interrupted();
      if (status != XML_STATUS_OK)
        return Error::input("its XML is broken in line " +
                            std::to_string(XML_GetCurrentLineNumber(parser_.get())) + ": " +
                            XML_ErrorString(XML_GetErrorCode(parser_.get())));
      if (isLast)
        break;
    }
    return {};
  }

  static VtiParser &self(void *user) { return *static_cast<VtiParser *>(user); }
  static void onBegin(void *user, const XML_Char *name, Attributes attributes) {
    self(user).begin(name, attributes);
  }
  static void onEnd(void *user, const XML_Char *) { self(user).end(); }
  static void onText(void *user, const XML_Char *text, int count) {
    self(user).takeText({text, static_cast<std::size_t>(count)});
  }
  static void onDoctype(void *user, const XML_Char *, const XML_Char *, const XML_Char *, int) {
    self(user).fail("it has a DOCTYPE, which no VTK file has");
  }

  void stop() {
    isStopped_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }
  void fail(std::string message) {
    if (!problem_)
      problem_ = Error::input(std::move(message));
    stop();
  }

  static std::string_view valueOf(Attributes attributes, std::string_view name,
                                  std::string_view otherwise = "") {
    for (; *attributes; attributes += 2)
      if (attributes[0] == name)
        return attributes[1];
    return otherwise;
  }

  /// Fills numbers; false if an attribute is there and has another count of them.
  template <typename Number, std::size_t Count>
  bool fill(Attributes attributes, std::string_view name, std::span<Number, Count> numbers) {
    std::string_view text = valueOf(attributes, name);
    if (text.empty())
      return true;
    for (Number &number : numbers) {
      const std::string_view word = takeWord(text);
      if constexpr (std::is_same_v<Number, double>) {
        const auto parsed = parseNumber(word);
        number = parsed.value_or(0);
        if (!parsed || !(std::abs(number) <= 1e300))
          return false;
      } else {
        const auto parsed = parseInteger(word);
        number = parsed.value_or(0);
        if (!parsed)
          return false;
      }
    }
    return trimmed(text).empty();
  }
  template <typename Number, std::size_t Count>
  void require(Attributes attributes, std::string_view name, std::span<Number, Count> numbers) {
    if (!fill(attributes, name, numbers))
      fail("its attribute " + std::string(name) + " is '" +
           std::string(valueOf(attributes, name).substr(0, 80)) + "'; it should have " +
           std::to_string(numbers.size()) + " finite numbers");
  }

  void begin(std::string_view name, Attributes attributes) {
    if (++depth_ > kMostXmlDepth)
      return fail("its elements lie more than " + std::to_string(kMostXmlDepth) + " deep in each other");
    if (name == "VTKFile")
      beginFile(attributes);
    else if (!isImage_)
      fail("its XML begins with the element " + std::string(name.substr(0, 40)) +
           "; a VTK file begins with VTKFile");
    else if (name == "ImageData" && depth_ == 2)
      beginImage(attributes);
    else if (name == "Piece" && depth_ == 3)
      beginPiece(attributes);
    else if ((name == "PointData" || name == "CellData") && depth_ == 4 && !file_.pieces.empty())
      beginData(name == "CellData", attributes);
    else if (name == "DataArray" || name == "Array")
      beginArray(attributes);
    else if (name == "AppendedData" && depth_ == 2)
      beginAppended(attributes);
    else if (name == "FieldData")
      place_ = Place::Field;
  }

  void beginFile(Attributes attributes) {
    isImage_ = true;
    const std::string_view type = valueOf(attributes, "type");
    if (type != "ImageData")
      return fail("it holds " + (type.empty() ? "no type of data" : std::string(type.substr(0, 40))) +
                  "; voxc reads ImageData, and ParaView's filter 'Resample To Image' makes that of others");
    file_.isBigEndian = valueOf(attributes, "byte_order") == "BigEndian";
    const std::string_view header = valueOf(attributes, "header_type", "UInt32");
    if (header != "UInt32" && header != "UInt64")
      return fail("its header_type is " + std::string(header.substr(0, 40)) +
                  "; it should be UInt32 or UInt64");
    file_.headerBytes = header == "UInt64" ? 8 : 4;
    file_.compressor = valueOf(attributes, "compressor");
  }

  void beginImage(Attributes attributes) {
    if (valueOf(attributes, "WholeExtent").empty())
      return fail("its element ImageData has no WholeExtent");
    require(attributes, "WholeExtent", std::span(file_.whole));
    require(attributes, "Origin", std::span(file_.origin));
    require(attributes, "Spacing", std::span(file_.spacing));
    require(attributes, "Direction", std::span(file_.direction));
  }

  void beginPiece(Attributes attributes) {
    if (file_.pieces.size() >= kMostPieces)
      return fail("it has more than " + std::to_string(kMostPieces) + " pieces");
    VtkPiece &piece = file_.pieces.emplace_back();
    piece.extent = file_.whole;
    require(attributes, "Extent", std::span(piece.extent));
  }

  void beginData(bool isOfCells, Attributes attributes) {
    place_ = isOfCells ? Place::Cells : Place::Points;
    (isOfCells ? file_.cellScalars : file_.pointScalars) = valueOf(attributes, "Scalars");
  }

  void beginArray(Attributes attributes) {
    if (++arrays_ > kMostArrays)
      return fail("it has more than " + std::to_string(kMostArrays) + " arrays");
    const std::string name(valueOf(attributes, "Name"));
    if (place_ == Place::Field)
      file_.fieldArrays.push_back(name);
    if (place_ != Place::Points && place_ != Place::Cells)
      return;
    VtkArray &array = file_.pieces.back().arrays.emplace_back();
    array.name = name;
    array.typeName = valueOf(attributes, "type");
    array.isOfCells = place_ == Place::Cells;
    for (const auto &[typeName, type] : kVtkTypes)
      if (typeName == array.typeName)
        array.type = type;
    require(attributes, "NumberOfComponents", std::span<std::int64_t, 1>(&array.components, 1));
    const std::string_view format = valueOf(attributes, "format", "ascii");
    array.format = format == "appended" ? VtkFormat::Appended
                   : format == "binary" ? VtkFormat::Binary
                                        : VtkFormat::Ascii;
    std::int64_t offset = 0;
    require(attributes, "offset", std::span<std::int64_t, 1>(&offset, 1));
    if (offset < 0 || array.components < 1)
      return fail("its array '" + name.substr(0, 80) + "' has a negative offset, or no components");
    array.offset = static_cast<std::uint64_t>(offset);
    array.text = {};
    arrayDepth_ = depth_;
  }

  /// What follows need be no XML: raw bytes behind the first underscore.
  void beginAppended(Attributes attributes) {
    file_.isAppendedBase64 = valueOf(attributes, "encoding") == "base64";
    const auto at = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())) +
                    static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()));
    const std::size_t mark = text_.find('_', std::min(at, text_.size()));
    if (mark == std::string_view::npos)
      return fail("its appended data do not begin with an underscore");
    file_.appended = text_.substr(mark + 1);
    stop();
  }

  void takeText(std::string_view text) {
    if (depth_ != arrayDepth_ || trimmed(text).empty())
      return;
    const auto at = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get()));
    std::string_view &known = file_.pieces.back().arrays.back().text;
    const std::size_t begin = known.empty() ? at : static_cast<std::size_t>(known.data() - text_.data());
    known = text_.substr(std::min(begin, text_.size()), at + text.size() - begin);
  }

  void end() {
    if (depth_ == arrayDepth_)
      arrayDepth_ = 0;
    else if (arrayDepth_ == 0 && depth_ <= 4)
      place_ = Place::None;
    --depth_;
  }

  enum class Place { None, Points, Cells, Field };

  std::string_view text_;
  const Progress &progress_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  VtiFile file_;
  Place place_ = Place::None;
  int depth_ = 0;
  int arrayDepth_ = 0; ///< Of the array whose text comes; 0: of none.
  std::size_t arrays_ = 0;
  bool isImage_ = false;
  bool isStopped_ = false;
  std::optional<Error> problem_;
};

} // namespace

Expected<VtiFile> readVtiFile(std::string_view text, const Progress &progress) {
  return VtiParser(text, progress).read();
}

} // namespace voxc
