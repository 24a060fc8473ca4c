// VTK image data: every way of storing numbers, several arrays and pieces, and where samples lie.
#include "Input/InputTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Words = std::vector<std::uint32_t>;

std::string base64(const std::string &bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += at + i <= bytes.size() ? kLetters[bits >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

std::string deflated(const std::string &bytes) {
  std::string out(compressBound(bytes.size()), '\0');
  uLongf size = out.size();
  EXPECT_EQ(compress(reinterpret_cast<Bytef *>(out.data()), &size,
                     reinterpret_cast<const Bytef *>(bytes.data()), bytes.size()),
            Z_OK);
  out.resize(size);
  return out;
}

std::string number(std::uint64_t value, int bytes, bool isBig) {
  std::string text;
  for (int i = 0; i < bytes; ++i)
    text += static_cast<char>(value >> 8 * i);
  if (isBig)
    std::ranges::reverse(text);
  return text;
}

/// How a file stores its numbers.
struct Storage {
  std::string format = "ascii"; ///< Or "binary", "raw" and "base64", the last two appended.
  bool isBig = false;
  bool isLong = false; ///< Its headers are UInt64.
  bool isPacked = false;

  /// Numbers of 16 bits as they stand in the file, and what comes before them.
  std::string data(const std::vector<int> &numbers) const {
    std::string text, bytes, head;
    for (const int value : numbers) {
      text += std::to_string(value) + " ";
      bytes += number(static_cast<std::uint64_t>(value), 2, isBig);
    }
    if (format == "ascii")
      return text;
    const int size = isLong ? 8 : 4;
    if (!isPacked) {
      const std::string all = number(bytes.size(), size, isBig) + bytes;
      return format == "raw" ? all : base64(all);
    }
    constexpr std::size_t kBlock = 8;
    std::string packed, sizes;
    for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
      const std::string block = deflated(bytes.substr(at, kBlock));
      sizes += number(block.size(), size, isBig);
      packed += block;
    }
    head = number((bytes.size() + kBlock - 1) / kBlock, size, isBig) + number(kBlock, size, isBig) +
           number(bytes.size() % kBlock, size, isBig) + sizes;
    // VTK ends the base 64 of the head before that of the blocks begins.
    return format == "raw" ? head + packed : base64(head) + base64(packed);
  }
};

/// A file of points with these numbers, in two arrays of which the second is active.
std::string imageOf(const Storage &storage, const std::string &extent, const std::vector<int> &numbers,
                    const std::string &place = "") {
  const bool isAppended = storage.format == "raw" || storage.format == "base64";
  const std::vector<std::string> data{storage.data(std::vector<int>(numbers.size(), 9)),
                                      storage.data(numbers)};
  std::string arrays, appended;
  const std::vector<std::string> names{"nine", "it"};
  for (std::size_t i = 0; i < 2; ++i) {
    arrays += "<DataArray type=\"Int16\" Name=\"" + names[i] + "\" format=\"" +
              (isAppended ? "appended" : storage.format) + "\" offset=\"" + std::to_string(appended.size()) +
              "\">" +
              (isAppended ? "<InformationKey name=\"L2\">1 2</InformationKey>" : "\n " + data[i] + "\n") +
              "</DataArray>";
    appended += data[i];
  }
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" byte_order=\"" +
         std::string(storage.isBig ? "BigEndian" : "LittleEndian") + "\"" +
         (storage.isLong ? " header_type=\"UInt64\"" : "") +
         (storage.isPacked ? " compressor=\"vtkZLibDataCompressor\"" : "") + "><ImageData WholeExtent=\"" +
         extent + "\" " + place + "><Piece Extent=\"" + extent + "\"><PointData Scalars=\"it\">" + arrays +
         "</PointData></Piece></ImageData>" +
         (isAppended
              ? "<AppendedData encoding=\"" + storage.format + "\">\n _" + appended + "\n</AppendedData>"
              : "") +
         "</VTKFile>";
}

/// A file of one piece, or several, with whatever stands in its ImageData.
std::string fileOf(const std::string &extent, const std::string &inside, const std::string &more = "") {
  return "<VTKFile type=\"ImageData\"" + more + "><ImageData WholeExtent=\"" + extent + "\">" + inside +
         "</ImageData></VTKFile>";
}
std::string pieceOf(const std::string &extent, const std::string &kind, const std::string &arrays) {
  return "<Piece Extent=\"" + extent + "\"><" + kind + ">" + arrays + "</" + kind + "></Piece>";
}
std::string arrayOf(const std::string &type, const std::string &numbers, const std::string &more = "") {
  return "<DataArray type=\"" + type + "\" " + more + ">" + numbers + "</DataArray>";
}

class Vtk : public OpenedInputs {
protected:
  Vtk() { options_.colourMap = "labels"; }
};

TEST_F(Vtk, NumbersAreReadHoweverTheyAreStored) {
  const std::vector<int> numbers{1, 2, 300, 4, 0, 6};
  const Words expected{1, 2, 300, 4, 0, 6};
  for (const char *format : {"ascii", "binary", "raw", "base64"})
    for (int i = 0; i < 8; ++i) {
      const Storage storage{format, (i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
      options_.grid.clear();
      const std::string image = imageOf(storage, "0 2 5 6 -7 -7", numbers);
      EXPECT_EQ(words("a.vti", image), expected) << format << i;
      EXPECT_EQ(extent_, (Int3{3, 2, 1}));
      EXPECT_THAT(warnings_,
                  ElementsAre("the array 'it' is taken, and left out are nine (--grid NAME takes one "
                              "of them)"));
      // What is cut off is an error, and nothing worse. The last bytes are the ends of elements.
      for (std::size_t size = 0; size + 60 < image.size(); size += 29)
        EXPECT_NE(problem("b.vti", image.substr(0, size)), "none") << format << i << " " << size;
      options_.grid = "nine";
      EXPECT_EQ(words("a.vti", image), Words(6, 9));
      EXPECT_THAT(warnings_, IsEmpty());
      EXPECT_THAT(provenance_, HasSubstr("grid=nine"));
    }
  options_.grid = "none";
  EXPECT_THAT(problem("a.vti", imageOf({}, "0 2 0 1 0 0", numbers)),
              HasSubstr("it has no array 'none'; there are nine, it"));
}

TEST_F(Vtk, SamplesLieWhereTheFileSays) {
  words("a.vti",
        imageOf({}, "2 4 0 1 -1 -1", {1, 2, 3, 4, 5, 6}, R"(Origin="10 20 30" Spacing="0.5 0.5 2")"));
  // The first point is the middle of the first voxel.
  EXPECT_EQ(map_ * glm::dvec4(0.5, 0.5, 0.5, 1), glm::dvec3(11, 20, 28));
  EXPECT_EQ(map_ * glm::dvec4(1.5, 0.5, 1.5, 1), glm::dvec3(11.5, 20, 30));
  const std::string cells = pieceOf("2 4 0 1 0 1", "CellData", arrayOf("UInt8", "7 8"));
  EXPECT_EQ(words("a.vti", fileOf("2 4 0 1 0 1\" Origin=\"1 1 1", cells)), (Words{7, 8}));
  EXPECT_EQ(map_ * glm::dvec4(0, 0, 0, 1), glm::dvec3(3, 1, 1));
  // Turned by a quarter: x goes along y of the model.
  words("a.vti", imageOf({}, "0 2 0 1 0 0", {1, 2, 3, 4, 5, 6}, R"(Direction="0 -1 0 1 0 0 0 0 1")"));
  EXPECT_EQ(map_ * glm::dvec4(2.5, 0.5, 0.5, 1), glm::dvec3(0, 2, 0));
  EXPECT_EQ(map_ * glm::dvec4(0.5, 1.5, 0.5, 1), glm::dvec3(-1, 0, 0));
  options_.isAutomatic = true;
  words("a.vti", imageOf({}, "0 2 0 1 0 0", {1, 2, 3, 4, 5, 6}, R"(Spacing="1 1 3")"));
  EXPECT_THAT(warnings_, testing::Contains(HasSubstr("its voxels are 1 x 1 x 3 and no cubes")));
  EXPECT_THAT(problem("a.vti", imageOf({}, "0 2 0 1 0 0", {1, 2, 3, 4, 5, 6},
                                       R"(Spacing="1e200 1 1" Direction="1e200 0 0 0 1 0 0 0 1")")),
              HasSubstr("together lead beyond all numbers"));
  EXPECT_THAT(problem("a.vti", imageOf({}, "0 2 0 1 0 0", {1, 2, 3, 4, 5, 6}, R"(Spacing="1 nan 3")")),
              HasSubstr("its attribute Spacing is '1 nan 3'; it should have 3 finite numbers"));
}

TEST_F(Vtk, BytesByThreesAndFoursAreColours) {
  const std::string four = arrayOf("UInt8", "1 2 3 4 0 0 0 0", R"(NumberOfComponents="4")");
  EXPECT_EQ(words("a.vti", fileOf("0 2 0 1 0 1", pieceOf("0 2 0 1 0 1", "CellData", four))),
            (Words{rgba(1, 2, 3, 4), 0}));
  const std::string three = arrayOf("UInt8", "1 2 3 0 0 0", R"(NumberOfComponents="3")");
  const std::string file = fileOf("0 1 0 0 0 0", pieceOf("0 1 0 0 0 0", "PointData", three));
  EXPECT_EQ(words("a.vti", file), (Words{rgba(1, 2, 3), 0}));
  EXPECT_THAT(warnings_, IsEmpty());
  options_.volume = 2;
  EXPECT_EQ(words("a.vti", file), (Words{2, 0}));
  options_.volume = 0;
  const std::string vectors = arrayOf("Float32", "1 2 3 4 5 6", R"(NumberOfComponents="3")");
  EXPECT_EQ(words("a.vti", fileOf("0 1 0 0 0 0", pieceOf("0 1 0 0 0 0", "PointData", vectors))),
            (Words{1, 4}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("it holds 3 volumes or components")));
}

TEST_F(Vtk, PiecesTileTheExtent) {
  const auto two = [](const std::string &first, const std::string &second, const std::string &kind) {
    return fileOf("0 4 0 1 0 1", pieceOf(first, kind, arrayOf("UInt8", "1 2 5 6")) +
                                     pieceOf(second, kind, arrayOf("UInt8", "3 4 7 8")));
  };
  const std::string cells =
      fileOf("0 4 0 2 0 1", pieceOf("2 4 0 2 0 1", "CellData", arrayOf("UInt8", "3 4 7 8")) +
                                pieceOf("0 2 0 2 0 1", "CellData", arrayOf("UInt8", "1 2 5 6")));
  EXPECT_EQ(words("a.vti", cells), (Words{1, 2, 3, 4, 5, 6, 7, 8}));
  // Neighbours share points.
  const std::string points =
      fileOf("0 2 0 1 0 0", pieceOf("0 1 0 1 0 0", "PointData", arrayOf("UInt8", "1 2 4 5")) +
                                pieceOf("1 2 0 1 0 0", "PointData", arrayOf("UInt8", "2 3 5 6")));
  EXPECT_EQ(words("a.vti", points), (Words{1, 2, 3, 4, 5, 6}));
  EXPECT_THAT(problem("a.vti", two("0 2 0 1 0 1", "1 3 0 1 0 1", "CellData")),
              HasSubstr("or in another piece"));
  EXPECT_THAT(problem("a.vti", two("0 1 0 1 0 1", "2 4 0 1 0 1", "CellData")),
              HasSubstr("its pieces have 3 of the 4 cells"));
  EXPECT_THAT(problem("a.vti", two("0 2 0 1 0 1", "2 5 0 1 0 1", "CellData")),
              HasSubstr("lies outside of the whole extent"));
}

TEST_F(Vtk, WhatIsWrittenComesBack) {
  options_.colourMap = "grey";
  const Voxels two{{mortonCode({0, 0, 0}), 0x01020304}, {mortonCode({2, 1, 69}), 0xffffffff}};
  Voxels many; // More than one block.
  for (int i = 0; i < 80; ++i)
    many[mortonCode({i, 79 - i, i})] = 0xff000000u + static_cast<unsigned>(i);
  const Transform turned = transformOfRows({0.5, 0, 0, 7, 0, 0, -0.25, -3, 0, 2, 0, 1});
  for (const Transform &map : {Transform(), turned}) {
    ASSERT_TRUE(exportVoxels(denseVolume(two, {3, 2, 70}, map), folder_.path("two.vti")));
    EXPECT_EQ(take(openInput(folder_.path("two.vti"), options_)), two);
    EXPECT_EQ(extent_, (Int3{3, 2, 70}));
    EXPECT_EQ(rowsOf(map_), rowsOf(map));
    EXPECT_THAT(warnings_, IsEmpty());
    ASSERT_TRUE(exportVoxels(denseVolume(many, {80, 80, 80}, map), folder_.path("many.vti")));
    EXPECT_EQ(take(openInput(folder_.path("many.vti"), options_)), many);
  }
}

TEST_F(Vtk, WhatIsNotReadIsSaid) {
  const auto withType = [](const std::string &type) {
    return fileOf("0 1 0 0 0 0", pieceOf("0 1 0 0 0 0", "PointData", arrayOf(type, "1 2", "Name=\"it\"")));
  };
  EXPECT_EQ(words("a.vti", withType("Int64")), (Words{1, 2}));
  EXPECT_THAT(problem("a.vti", withType("Bit")), HasSubstr("it has no array of numbers; there are it"));
  const std::string piece = pieceOf("0 1 0 0 0 0", "PointData", arrayOf("UInt8", "1 2"));
  EXPECT_EQ(
      words("a.vti", fileOf("0 1 0 0 0 0", "<FieldData>" + arrayOf("Float64", "3", R"(Name="TimeValue")") +
                                               "</FieldData>" + piece)),
      (Words{1, 2}));
  EXPECT_THAT(warnings_, ElementsAre("its field data are left out: TimeValue"));
  EXPECT_THAT(problem("a.vti", fileOf("0 1 0 0 0 0",
                                      pieceOf("0 1 0 0 0 0", "PointData",
                                              arrayOf("UInt8", "AAAA", R"(format="binary")")),
                                      " compressor=\"vtkLZ4DataCompressor\"")),
              HasSubstr("its data are compressed by vtkLZ4DataCompressor; voxc reads those of "
                        "vtkZLibDataCompressor, and those without"));
  EXPECT_THAT(problem("a.vti", R"(<VTKFile type="UnstructuredGrid"></VTKFile>)"),
              HasSubstr("it holds UnstructuredGrid; voxc reads ImageData"));
  EXPECT_THAT(problem("a.vti", "<svg/>"), HasSubstr("a VTK file begins with VTKFile"));
  EXPECT_THAT(problem("a.vti", "<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile/>"), HasSubstr("DOCTYPE"));
  EXPECT_THAT(problem("a.vti", "nonsense"), HasSubstr("its XML is broken in line 1"));
  EXPECT_THAT(
      problem("a.vti", fileOf("0 1 0 0 0 0", pieceOf("0 1 0 0 0 0", "PointData", arrayOf("UInt8", "1 2 3")))),
      HasSubstr("has more numbers than the 2"));
  EXPECT_THAT(problem("a.vti",
                      fileOf("0 2097150 0 2097150 0 2097150",
                             pieceOf("0 2097150 0 2097150 0 2097150", "PointData", arrayOf("UInt8", "1 2")))),
              HasSubstr("is larger than any file"));
}

} // namespace
} // namespace voxc
