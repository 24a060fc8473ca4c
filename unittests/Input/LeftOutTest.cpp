// What files of voxels have that is not used: each is one warning.
#include "Input/DenseTesting.h"
#include "Input/VoxBytes.h"

#include "voxc/Input/Input.h"
#include "voxc/Input/NumberedPaths.h"

#include <gmock/gmock.h>
#include <png.h>

namespace voxc {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class LeftOut : public OpenedInputs {
protected:
  LeftOut() { options_.colourMap = "labels"; }

  std::vector<std::string> warningsOf(const std::string &name, const std::string &content) {
    voxels(name, content);
    return warnings_;
  }
};

std::string nrrdOfSix(const std::string &fields, const std::string &data,
                      const std::string &encoding = "raw") {
  return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 1\nencoding: " + encoding + "\n" + fields + "\n" +
         data;
}

const std::string kData = "\1\2\3\4\5\6";

TEST_F(LeftOut, WhatIsPackedBehindSamples) {
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("", gzipped(kData), "gzip")), IsEmpty());
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("", gzipped(kData + "7"), "gzip")),
              ElementsAre("more is packed behind the samples, and is left out"));
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("", gzipped(kData) + "78", "gzip")),
              ElementsAre("2 bytes are left out behind the compressed data"));
  EXPECT_THAT(
      warningsOf("a.nrrd", nrrdOfSix("", gzipped(kData.substr(0, 2)) + gzipped(kData.substr(2)), "gzip")),
      IsEmpty());
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("", "1 2 3 4 5 6\n", "ascii")), IsEmpty());
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("", "1 2 3 4 5 6 7", "ascii")),
              ElementsAre(HasSubstr("more is packed")));
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("", "010203040506 x", "hex")),
              ElementsAre(HasSubstr("behind the samples its data in hexadecimal")));
}

TEST_F(LeftOut, KeysOfNrrd) {
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("Segment0_Name:=bone\nmine:=1\n", kData)),
              ElementsAre(HasSubstr("nothing is used but that there are segments: 'Segment0_Name', 'mine'")));
}

TEST_F(LeftOut, FieldsOfNrrdThatAreThereTwice) {
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("content: one\ncontent: two\n", kData)), IsEmpty());
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("sizes: 1 2 3\n", kData)),
              ElementsAre("its field 'sizes' is there more than once; the last holds"));
  EXPECT_EQ(extent_, (Int3{1, 2, 3}));
  EXPECT_THAT(warningsOf("a.nrrd", nrrdOfSix("centers: cell cell cell\ncenterings: node node node\n", kData)),
              ElementsAre(HasSubstr("its field 'centerings' is there more than once")));
}

TEST_F(LeftOut, LinesOfNrrdThatEndByCarriageReturns) {
  std::string head = nrrdOfSix("", "");
  std::ranges::replace(head, '\n', '\r');
  EXPECT_EQ(voxels("a.nrrd", head + "\n\2\3\4\5\6").size(), 6u);
  EXPECT_THAT(warnings_, IsEmpty());
}

/// A version 1 header of 3 x 2 x 1 bytes; `more` extensions behind it.
std::string nifti(const std::string &more) {
  std::string bytes(352, '\0');
  const auto put = [&](std::size_t at, const std::string &text) { bytes.replace(at, text.size(), text); };
  put(0, bytesOf<std::int32_t>({348}));
  put(344, std::string("n+1\0", 4));
  put(40, bytesOf<std::int16_t>({3, 3, 2, 1, 1, 1, 1, 1}));
  put(70, bytesOf<std::int16_t>({2, 8}));
  put(76, bytesOf<float>({1, 1, 1, 1}));
  put(108, bytesOf<float>({static_cast<float>(352 + more.size())}));
  bytes[348] = more.empty() ? '\0' : '\1';
  return bytes + more;
}

TEST_F(LeftOut, ExtensionsAndSurplusOfNifti) {
  EXPECT_THAT(warningsOf("a.nii", nifti("") + kData), IsEmpty());
  EXPECT_THAT(warningsOf("a.nii", nifti(bytesOf<std::int32_t>({16, 6}) + "a remark") + kData),
              ElementsAre("extensions of its header are not used"));
  EXPECT_THAT(warningsOf("a.nii.gz", gzipped(nifti("") + kData)), IsEmpty());
  EXPECT_THAT(warningsOf("a.nii.gz", gzipped(nifti("") + kData) + "7"),
              ElementsAre("1 byte is left out behind the compressed data"));
  EXPECT_THAT(warningsOf("a.nii.gz", gzipped(nifti("") + kData + "7")),
              ElementsAre(HasSubstr("more is packed")));
}

TEST_F(LeftOut, QformThatTellsAnotherPlace) {
  std::string header = nifti("");
  const auto put = [&](std::size_t at, const std::string &text) { header.replace(at, text.size(), text); };
  put(252, bytesOf<std::int16_t>({1, 1}));
  put(280, bytesOf<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}));
  EXPECT_THAT(warningsOf("a.nii", header + kData), IsEmpty());
  put(268, bytesOf<float>({5}));
  EXPECT_THAT(warningsOf("a.nii", header + kData),
              ElementsAre(HasSubstr("its qform puts the samples elsewhere")));
  // Unless it is in force.
  put(252, bytesOf<std::int16_t>({0}));
  EXPECT_THAT(warningsOf("a.nii", header + kData), IsEmpty());
}

TEST_F(LeftOut, BytesBehindAnArray) {
  const std::string fields = "{'descr': '|u1', 'fortran_order': False, 'shape': (1, 2, 3), }   \n";
  const std::string head =
      std::string("\x93NUMPY\1\0", 8) + static_cast<char>(fields.size()) + std::string(1, '\0') + fields;
  EXPECT_THAT(warningsOf("a.npy", head + kData), IsEmpty());
  EXPECT_THAT(warningsOf("a.npy", head + kData + "78"), ElementsAre(HasSubstr("2 bytes are left out")));
}

TEST_F(LeftOut, WhatBinvoxDoesNotSay) {
  options_.colourMap = "grey";
  const auto binvox = [](const std::string &lines, const std::string &runs) {
    return "#binvox 1\ndim 2 2 2\n" + lines + "data\n" + runs;
  };
  EXPECT_THAT(warningsOf("a.binvox", binvox("scale 1\n# by hand\n\n", "\1\10")), IsEmpty());
  EXPECT_THAT(warningsOf("a.binvox", binvox("colour red\nwhat\n", "\1\10")),
              ElementsAre(HasSubstr("its line 'colour' is not known"), HasSubstr("its line 'what'")));
  EXPECT_THAT(warningsOf("a.binvox", binvox("", "\1\10\1\1")),
              ElementsAre(HasSubstr("2 bytes are left out")));
  EXPECT_THAT(warningsOf("a.binvox", binvox("", "\7\4\1\4")),
              ElementsAre(HasSubstr("other numbers than 0 and 1")));
}

TEST_F(LeftOut, VoxelsOfAModelThatAreThereTwice) {
  options_.colourMap = "";
  const auto model = [&](std::initializer_list<VoxCell> cells) {
    return warningsOf("a.vox", voxBytes(modelChunks(2, 2, 2, cells)));
  };
  EXPECT_THAT(model({{0, 0, 0, 1}, {1, 1, 1, 2}, {0, 0, 0, 1}}), IsEmpty());
  EXPECT_THAT(model({{0, 0, 0, 1}, {1, 1, 1, 2}, {0, 0, 0, 3}, {1, 1, 1, 3}}),
              ElementsAre("2 voxels are left out, which a model has before in another colour"));
}

TEST_F(LeftOut, WhatOnlyTheEditorOfAModelShows) {
  options_.colourMap = "";
  const std::string model = modelChunks(1, 1, 1, {{0, 0, 0, 1}});
  const auto layer = [&](const char *key, const char *value) {
    return chunkBytes("LAYR", wordBytes({0}) + dictionaryBytes({{key, value}}) + wordBytes({0xffffffff}));
  };
  EXPECT_THAT(warningsOf("a.vox", voxBytes(model + layer("_hidden", "0"))), IsEmpty());
  EXPECT_THAT(warningsOf("a.vox", voxBytes(model + layer("_name", "walls") + chunkBytes("IMAP", "1") +
                                           chunkBytes("NOTE", "") + chunkBytes("rOBJ", ""))),
              ElementsAre(HasSubstr("are not used: IMAP, NOTE, _name, rOBJ")));
}

class LeftOutSlices : public LeftOut {
protected:
  /// A grey picture of 2 x 2.
  std::string png(const std::string &chunks = "") {
    png_image image;
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 2;
    image.format = PNG_FORMAT_GRAY;
    png_alloc_size_t size = 0;
    const std::array<unsigned char, 4> cells{1, 2, 3, 4};
    png_image_write_to_memory(&image, nullptr, &size, 0, cells.data(), 0, nullptr);
    std::string bytes(size, '\0');
    png_image_write_to_memory(&image, bytes.data(), &size, 0, cells.data(), 0, nullptr);
    constexpr std::size_t kBehindHeader = 33;
    return bytes.insert(kBehindHeader, chunks);
  }
  static std::string chunk(const std::string &type, const std::string &data) {
    const auto crc = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef *>((type + data).data()), static_cast<uInt>(4 + data.size())));
    return bytesOf<std::uint32_t>({static_cast<std::uint32_t>(data.size())}, true) + type + data +
           bytesOf<std::uint32_t>({crc}, true);
  }
};

TEST_F(LeftOutSlices, FilesThatAreNearlyOfThePattern) {
  for (const char *name : {"s07.png", "s08.png", "s9.png", "S10.png", "t11.png", "s1x.png"})
    folder_.file(name, png());
  words("s%02d.png");
  EXPECT_EQ(extent_.z, 2);
  EXPECT_THAT(warnings_, Contains(HasSubstr("2 files are left out that differ from")));
  EXPECT_THAT(saysBesides(folder_.path("t%d.png")), IsEmpty());
  EXPECT_THAT(saysBesides(folder_.path("s07.png")), IsEmpty());
  EXPECT_THAT(saysBesides(folder_.path("S%d.png")), ElementsAre(HasSubstr("3 files are left out")));
}

TEST_F(LeftOutSlices, WhatPicturesHave) {
  EXPECT_THAT(warningsOf("a.png", png()), Not(Contains(HasSubstr("left out"))));
  EXPECT_THAT(warningsOf("a.png", png() + "123"), Contains(HasSubstr("3 bytes are left out")));
  const auto sides = [&](std::uint32_t x, std::uint32_t y) {
    return png(chunk("pHYs", bytesOf<std::uint32_t>({x, y}, true) + "\1"));
  };
  EXPECT_THAT(warningsOf("a.png", sides(500, 500)), Not(Contains(HasSubstr("squares"))));
  EXPECT_THAT(warningsOf("a.png", sides(1000, 500)),
              Contains(HasSubstr("no squares (1 : 2, width to height)")));
  EXPECT_THAT(warningsOf("a.png", png(chunk("acTL", bytesOf<std::uint32_t>({2, 0}, true)))),
              Contains(HasSubstr("it is an animation")));
}

} // namespace
} // namespace voxc
