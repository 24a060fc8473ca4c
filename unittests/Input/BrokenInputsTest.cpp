// Broken files of every kind of voxel input: each is refused with its own sentence, and none can do harm.
#include "Source/SourceTesting.h"
#include "TestLength.h"
#include "VoxBytes.h"

#include "voxc/Input/Input.h"

#include <random>

namespace voxc {
namespace {

struct Broken {
  const char *what;
  const char *name; ///< Its ending says its kind.
  std::string content;
  std::string message; ///< Behind "'FILE' is not a usable ... file: ".
};

const std::string kModel = modelChunks(1, 1, 1, {{0, 0, 0, 1}});

std::string graph(const std::string &nodes) { return voxBytes(kModel + nodes); }

/// One frame with an attribute.
std::string turned(const char *rotation) {
  return graph(transformChunk(0, 1, {{"_r", rotation}}) + shapeChunk(1, 0));
}

/// 21 groups that have each other twice: 2^20 shapes.
std::string doubledGroups() {
  std::string nodes;
  for (std::uint32_t i = 0; i < 21; ++i)
    nodes += groupChunk(i, {i + 1, i + 1});
  return graph(nodes + shapeChunk(21, 0));
}

const std::vector<Broken> kBrokenVox{
    {"nothing", "a.vox", "", "it does not begin with 'VOX '"},
    {"another kind", "a.vox", "VOXEL file", "it does not begin with 'VOX '"},
    {"no MAIN", "a.vox", "VOX " + wordBytes({150}) + kModel, "its first chunk is not MAIN"},
    {"no model", "a.vox", voxBytes(""), "it has no model"},
    {"a cut file", "a.vox", voxBytes(kModel).substr(0, 60), "a chunk reaches over its end"},
    {"a chunk that lies", "a.vox", voxBytes("SIZE" + wordBytes({0xffffffff, 0}) + "abc"),
     "a chunk reaches over its end"},
    {"children that lie", "a.vox", voxBytes("SIZE" + wordBytes({0, 0xffffffff})),
     "a chunk reaches over its end"},
    {"voxels that lie", "a.vox",
     voxBytes(chunkBytes("SIZE", wordBytes({1, 1, 1})) + chunkBytes("XYZI", wordBytes({0x80000000, 0}))),
     "a chunk XYZI speaks of more than its 8 bytes hold"},
    {"voxels without a size", "a.vox", voxBytes(chunkBytes("XYZI", wordBytes({0}))),
     "it has voxels without a size"},
    {"a model too large", "a.vox", voxBytes(modelChunks(257, 1, 1, {})),
     "a model has 257 cells on an axis; there may be 256"},
    {"a voxel outside", "a.vox", voxBytes(modelChunks(3, 4, 5, {{2, 4, 0, 1}})),
     "the voxel 2, 4, 0 lies outside its model of 3x4x5"},
    {"a short palette", "a.vox", voxBytes(kModel + chunkBytes("RGBA", "abcd")),
     "a chunk RGBA speaks of more than its 4 bytes hold"},
    {"a graph without a root", "a.vox", graph(shapeChunk(1, 0)),
     "its scene graph names the node 0, which it does not have"},
    {"a child that is not there", "a.vox", graph(transformChunk(0, 7, {})),
     "its scene graph names the node 7, which it does not have"},
    {"a model that is not there", "a.vox", graph(shapeChunk(0, 3)), "its scene graph names the model 3 of 1"},
    {"a node below itself", "a.vox", graph(transformChunk(0, 1, {}) + groupChunk(1, {0})),
     "its node 1 stands below itself"},
    {"nodes without end", "a.vox", doubledGroups(),
     "its scene graph, written out, has more than 1048576 nodes"},
    {"two nodes of one number", "a.vox", graph(shapeChunk(0, 0) + shapeChunk(0, 0)),
     "two nodes have the number 0"},
    {"a shape of nothing", "a.vox", graph(chunkBytes("nSHP", wordBytes({0, 0, 0}))),
     "the shape 0 has no model"},
    {"2^31 children", "a.vox", graph(chunkBytes("nGRP", wordBytes({0, 0, 0x80000000, 1}))),
     "a chunk nGRP speaks of more than its 16 bytes hold"},
    {"a text that lies", "a.vox", graph(chunkBytes("nGRP", wordBytes({0, 1, 0xfffffff0, 0, 0}))),
     "a chunk nGRP speaks of more than its 20 bytes hold"},
    {"a rotation of one axis twice", "a.vox", turned("5"), "node 0 has the rotation 5, which is none"},
    {"a rotation beyond bytes", "a.vox", turned("260"), "node 0 has the rotation 260, which is none"},
    {"a scene too large", "a.vox",
     graph(transformChunk(0, 1, {}) + groupChunk(1, {2, 3}) + shapeChunk(2, 0) +
           transformChunk(3, 2, {{"_t", "2147483647 0 0"}})),
     "its scene takes 2147483648 cells on an axis; there may be 2097152"},
};

std::string nrrd(const std::string &fields, const std::string &data = "12345678") {
  return "NRRD0004\n" + fields + "\n" + data;
}

const std::string kEight = "type: uint8\ndimension: 3\nsizes: 2 2 2\n";

const std::vector<Broken> kBrokenNrrd{
    {"nothing", "a.nrrd", "", "it does not begin with 'NRRD000'"},
    {"a header without end", "a.nrrd", "NRRD0004\ntype: uint8\n", "no blank line ends its header"},
    {"no field", "a.nrrd", nrrd(""), "its header needs the fields type, dimension, sizes and encoding"},
    {"a line that is none", "a.nrrd", nrrd("hello\n"), "its line 'hello' is no field"},
    {"no type", "a.nrrd", nrrd("type: block\n"), "its field 'type: block' is not one that voxc reads"},
    {"another encoding", "a.nrrd", nrrd("encoding: zrl\n"),
     "its field 'encoding: zrl' is not one that voxc reads"},
    {"bzip2 that is none", "a.nrrd", nrrd(kEight + "encoding: bzip2\n"), "its bzip2 data is damaged"},
    {"a bomb of bzip2 that is none", "a.nrrd",
     nrrd("type: uint8\ndimension: 3\nsizes: 99999 99999 99999\nencoding: bz2\n"),
     "its data end after 150994944 bytes, but it needs 999970000299999"},
    {"a word among numbers", "a.nrrd", nrrd(kEight + "encoding: text\n", "1 2 3 4 5 six 7 8"),
     "its data have 'six', which is no number of its type"},
    {"a number beyond its type", "a.nrrd", nrrd(kEight + "encoding: ascii\n", "1 2 3 4 5 256 7 8"),
     "its data have '256', which is no number of its type"},
    {"too few numbers", "a.nrrd", nrrd(kEight + "encoding: ascii\n", "1 2 3 4 5 6 7   "),
     "its data end after 7 bytes, but it needs 8"},
    {"digits that are none", "a.nrrd", nrrd(kEight + "encoding: hex\n", "01 02 03 04 05 06 07 0g"),
     "its data in hexadecimal digits have another character between them, or one digit too few"},
    {"digits that skip from the end", "a.nrrd", nrrd(kEight + "encoding: hex\nbyte skip: -1\n"),
     "its byte skip of -1 does not go with samples in digits"},
    {"files that do not share the samples", "a.nhdr",
     nrrd(kEight + "encoding: raw\ndata file: LIST\na\nb\nc\n", ""),
     "its 8 bytes of samples are no multiple of its 3 data files"},
    {"a sequence that is none", "a.nhdr", nrrd(kEight + "encoding: raw\ndata file: a%d.raw 1 4 0\n", ""),
     "its data files go from number 1 to 4 by steps of 0, which is no sequence"},
    {"a pattern of two numbers", "a.nhdr", nrrd(kEight + "encoding: raw\ndata file: a%d%d.raw 1 4 1\n", ""),
     "its data file 'a%d%d.raw' is no pattern that voxc reads; it should have one number such as %d or %03d, "
     "from "
     "0 up"},
    {"sizes that are none", "a.nrrd", nrrd("sizes: 2 two 2\n"),
     "its field 'sizes: 2 two 2' is not one that voxc reads"},
    {"four axes", "a.nrrd", nrrd("type: uint8\ndimension: 4\nsizes: 3 2 2 2\nencoding: raw\n"),
     "its data have 8 bytes, but it needs 24 behind a skip of 0"},
    {"more sizes than axes", "a.nrrd", nrrd("type: uint8\ndimension: 3\nsizes: 3 2 2 2\nencoding: raw\n"),
     "it has 4 sizes, but its dimension is 3; both should be the same, 1 to 16"},
    {"axes that are more than any file has", "a.nrrd",
     nrrd("type: uint8\ndimension: 5\nkinds: space space space list list\nsizes: 2 2 2 9999999999 "
          "9999999999\nencoding: raw\n"),
     "its sizes make no samples at all, or more than any file has"},
    {"an empty axis", "a.nrrd", nrrd("type: uint8\ndimension: 3\nsizes: 2 0 2\nencoding: raw\n"),
     "a grid of 2x0x2 cells is not possible: each axis takes 1 to 2097152"},
    {"an axis too long", "a.nrrd", nrrd("type: uint8\ndimension: 3\nsizes: 2 9999999999 2\nencoding: raw\n"),
     "a grid of 2x2097153x2 cells is not possible: each axis takes 1 to 2097152"},
    {"too few samples", "a.nrrd", nrrd(kEight + "encoding: raw\n", "1234567"),
     "its data have 7 bytes, but it needs 8 behind a skip of 0"},
    {"a skip behind the end", "a.nrrd", nrrd(kEight + "encoding: raw\nbyte skip: 9999999999999\n"),
     "its data have 8 bytes, but it needs 8 behind a skip of 9999999999999"},
    {"more samples than files have", "a.nrrd",
     nrrd("type: double\nendian: little\ndimension: 3\nsizes: 2097152 2097152 2097152\nencoding: raw\n"),
     "a grid of 2097152x2097152x2097152 samples is larger than any file"},
    {"no byte order", "a.nrrd", nrrd("type: short\ndimension: 3\nsizes: 2 2 1\nencoding: raw\n"),
     "its header needs the field endian, since its samples have more than one byte"},
    {"data that are not compressed", "a.nrrd", nrrd(kEight + "encoding: gzip\n"),
     "its compressed data is damaged: incorrect header check"},
    {"a bomb that is none", "a.nrrd",
     nrrd("type: uint8\ndimension: 3\nsizes: 99999 99999 99999\nencoding: gzip\n"),
     "its data end after 1073280 bytes, but it needs 999970000299999"},
    {"a skip before what is compressed", "a.nrrd", nrrd(kEight + "encoding: gzip\nbyte skip: 99999999999\n"),
     "its byte skip of 99999999999 is too large; compressed data may skip 1073741824"},
    {"fewer lines than it skips", "a.nrrd", nrrd(kEight + "encoding: raw\nline skip: 3\n", "a\nb\n"),
     "its data have fewer lines than it skips"},
    {"several data files", "a.nhdr", nrrd(kEight + "encoding: raw\ndata file: LIST\n"),
     "its data file is a LIST, but no names follow"},
    {"a step that is none", "a.nrrd", nrrd("space directions: (1,0,0) some (0,0,1)\n"),
     "its field 'space directions: (1,0,0) some (0,0,1)' is not one that voxc reads"},
};

/// A header of version 1 of 2 x 2 x 2 bytes, with some of its bytes replaced.
std::string nifti(std::size_t at = 0, const std::string &bytes = {}) {
  std::string header(352, '\0');
  const auto put = [&](std::size_t to, const std::string &what) { header.replace(to, what.size(), what); };
  put(0, wordBytes({348}));
  put(344, "n+1");
  put(40, std::string("\3\0\2\0\2\0\2\0", 8));
  put(70, "\2");
  put(108, wordBytes({0x43b00000})); // 352 as a float.
  put(at, bytes);
  return header + "12345678";
}

const std::vector<Broken> kBrokenNifti{
    {"nothing", "a.nii", "", "it does not begin with a NIfTI header"},
    {"a header cut short", "a.nii", nifti().substr(0, 347), "it does not begin with a NIfTI header"},
    {"another magic", "a.nii", nifti(344, "abc"), "it does not begin with a NIfTI header"},
    {"samples elsewhere", "a.nii", nifti(344, "ni1"),
     "its samples are in a file of its name that ends in .img, which is not there"},
    {"complex samples", "a.nii", nifti(70, std::string("\40\0", 2)),
     "its samples are of the type 32, which is neither a number of 8 to 64 bits nor a colour of bytes"},
    {"too few colours", "a.nii", nifti(70, std::string("\200\0", 2)),
     "it has 360 bytes, but its samples take 24 behind byte 352"},
    {"no axis", "a.nii", nifti(40, std::string("\0\0", 2)), "it has 0 axes; there may be 1 to 7"},
    {"an empty axis", "a.nii", nifti(44, std::string("\0\0", 2)),
     "axis 2 has 0 samples, which no volume has"},
    {"an axis of less than nothing", "a.nii", nifti(46, "\377\377"),
     "axis 3 has -1 samples, which no volume has"},
    {"too few samples", "a.nii", nifti().substr(0, 359),
     "it has 359 bytes, but its samples take 8 behind byte 352"},
    {"samples inside the header", "a.nii", nifti(108, wordBytes({0x42000000})),
     "its samples begin at byte 32.000000, which is inside the header or too far behind it"},
    {"samples at no number", "a.nii", nifti(108, wordBytes({0x7fc00000})),
     "its samples begin at byte nan, which is inside the header or too far behind it"},
    {"an infinite scale", "a.nii", nifti(112, wordBytes({0x7f800000})),
     "its samples are scaled by a number that is not finite"},
    {"compressed nothing", "a.nii.gz", "\x1f\x8b", "its compressed data ends too soon"},
    {"damaged compression", "a.nii.gz", "\x1f\x8b\x08 damaged beyond repair",
     "its compressed data is damaged: unknown header flags set"},
};

std::string binvox(const std::string &header, const std::string &runs) {
  return "#binvox 1\n" + header + "data\n" + runs;
}

const std::vector<Broken> kBrokenBinvox{
    {"nothing", "a.binvox", "", "it does not begin with '#binvox 1'"},
    {"no data", "a.binvox", "#binvox 1\ndim 2 2 2\n", "no line 'data' ends its header"},
    {"no size", "a.binvox", binvox("", ""),
     "a grid of 0x0x0 cells is not possible: each axis takes 1 to 2097152"},
    {"a size that is none", "a.binvox", binvox("dim 2 x 2\n", ""), "its line 'dim 2 x 2' makes no sense"},
    {"a size of less than nothing", "a.binvox", binvox("dim 2 -2 2\n", ""),
     "its line 'dim 2 -2 2' makes no sense"},
    {"a scale that is none", "a.binvox", binvox("dim 2 2 2\nscale nan\n", ""),
     "its line 'scale nan' makes no sense"},
    {"too few runs", "a.binvox", binvox("dim 2 2 2\n", "\1\4"), "its runs end after 4 of 8 voxels"},
    {"a run too long", "a.binvox", binvox("dim 2 2 2\n", "\1\4\1\5"), "its last run reaches over its end"},
    {"a claim of much", "a.binvox", binvox("dim 2097152 2097152 2097152\n", "\1\377"),
     "its 2 bytes of runs cannot hold 9223372036854775808 voxels"},
};

class BrokenInputs : public testing::TestWithParam<const std::vector<Broken> *> {
protected:
  TemporaryFolder folder_;
};

TEST_P(BrokenInputs, EndWithTheirOwnSentence) {
  for (const Broken &broken : *GetParam()) {
    const std::string path = folder_.file(broken.name, broken.content);
    const auto input = openInput(path, {});
    ASSERT_FALSE(input) << broken.what;
    EXPECT_EQ(input.error().kind, ErrorKind::Input) << broken.what;
    const std::string &message = input.error().message;
    EXPECT_EQ(message.substr(0, path.size() + 2), "'" + path + "'") << broken.what;
    EXPECT_EQ(message.substr(std::min(message.find(" file: ") + 7, message.size())), broken.message)
        << broken.what;
  }
}

/// There is nothing wrong with the file then.
TEST(LargeInputs, AMagicaVoxelSceneLargerThanTheFormatIsNotBroken) {
  TemporaryFolder folder;
  const std::string path =
      folder.file("a.vox", graph(transformChunk(0, 1, {}) + groupChunk(1, {2, 3}) + shapeChunk(2, 0) +
                                 transformChunk(3, 2, {{"_t", "0 512 0"}})));
  const auto input = openInput(path, {});
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().kind, ErrorKind::Input);
  EXPECT_EQ(input.error().message,
            "'" + path + "' takes 1x1x513 voxels, but the format holds 512x512x512; enlarge the format");
}

/// Changed, cut and lengthened files of each kind are read or refused; what is read can be walked through.
TEST_P(BrokenInputs, AndAllThatIsNearThemDoNoHarm) {
  std::mt19937 random(11);
  InputOptions options;
  options.formatExtent = {1 << 12, 1 << 12, 1 << 12};
  int opened = 0;
  for (int round = 0; round < test::rounds(600); ++round) {
    const Broken &broken = (*GetParam())[random() % GetParam()->size()];
    std::string content = broken.content;
    for (unsigned changes = random() % 6; changes > 0 && !content.empty(); --changes) {
      const std::size_t at = random() % content.size();
      switch (random() % 4) {
      case 0:
        content[at] = static_cast<char>(random());
        break;
      case 1:
        content.resize(at);
        break;
      case 2:
        content.insert(at, content.substr(random() % content.size(), random() % 12));
        break;
      default:
        content[at] = static_cast<char>(content[at] ^ 1 << random() % 8);
      }
    }
    auto input = openInput(folder_.file(broken.name, content), options);
    if (!input) {
      EXPECT_FALSE(input.error().message.empty());
      continue;
    }
    ++opened;
    const Int3 extent = input->source->extent();
    if (std::max({extent.x, extent.y, extent.z}) <= 64)
      voxelsOf(*input->source);
  }
  RecordProperty("opened", opened);
}

INSTANTIATE_TEST_SUITE_P(Vox, BrokenInputs, testing::Values(&kBrokenVox));
INSTANTIATE_TEST_SUITE_P(Nrrd, BrokenInputs, testing::Values(&kBrokenNrrd));
INSTANTIATE_TEST_SUITE_P(Nifti, BrokenInputs, testing::Values(&kBrokenNifti));
INSTANTIATE_TEST_SUITE_P(Binvox, BrokenInputs, testing::Values(&kBrokenBinvox));

TEST(BrokenRaw, SaysWhatWouldBeRight) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.raw", "12345678");
  const auto problem = [&](const std::string &text) {
    const auto input = openInput(text, {});
    return input ? "no error" : input.error().message;
  };
  EXPECT_EQ(problem("raw:2x2x2:uint16le:" + path),
            "'" + path + "' has 8 bytes, but a grid of 2x2x2 such samples has 16");
  EXPECT_EQ(
      problem("raw:2x2x2:int:" + path),
      "'int' is no type of samples; there are int8 uint8 int16le int16be uint16le uint16be int32le int32be "
      "uint32le uint32be int64le int64be uint64le uint64be float32le float32be float64le float64be");
  EXPECT_EQ(
      problem("raw:2x2:uint8:x"),
      "'raw:2x2:uint8:x' is no volume; write its size, type and file as in raw:64x33x32:uint8:FILE.raw");
  EXPECT_EQ(
      problem("raw:2x2x2:uint8"),
      "'raw:2x2x2:uint8' is no volume; write its size, type and file as in raw:64x33x32:uint8:FILE.raw");
  EXPECT_EQ(problem("raw:2097152x2097152x2097152:uint8:" + path),
            "a grid of 2097152x2097152x2097152 samples is larger than any file");
}

} // namespace
} // namespace voxc
