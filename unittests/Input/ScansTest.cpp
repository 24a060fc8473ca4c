// Scans as programs write them: encodings and axes of NRRD, orders and pairs of NIfTI, labels and colours.
#include "Input/InputTesting.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bzlib.h>
#include <cstring>
#include <numeric>

namespace voxc {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string bzipped(std::string bytes) {
  auto size = static_cast<unsigned>(bytes.size() + 1000);
  std::string out(size, '\0');
  EXPECT_EQ(
      BZ2_bzBuffToBuffCompress(out.data(), &size, bytes.data(), static_cast<unsigned>(bytes.size()), 9, 0, 0),
      BZ_OK);
  return out.substr(0, size);
}

class Scans : public OpenedInputs {
protected:
  Scans() { options_.colourMap = "labels"; }

  /// 1, 2, 3 ... in 4 x 3 x 2 bytes.
  static std::string bytes(int count = 24) {
    std::string bytes(static_cast<std::size_t>(count), '\0');
    std::iota(bytes.begin(), bytes.end(), '\1');
    return bytes;
  }
  static std::vector<std::uint32_t> upTo(std::uint32_t most, std::uint32_t step = 1,
                                         std::uint32_t first = 1) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = first; i <= most; i += step)
      numbers.push_back(i);
    return numbers;
  }
};

std::string nrrdScan(const std::string &fields, const std::string &data = {}) {
  return "NRRD0005\ntype: uint8\n" + fields + "\n" + data;
}

const std::string kThree = "dimension: 3\nsizes: 4 3 2\n";

TEST_F(Scans, NrrdOfEveryEncoding) {
  std::string digits, hex, shorts;
  for (int i = 1; i <= 24; ++i) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), i % 5 == 0 ? "%02x\n" : "%02X", static_cast<unsigned>(i));
    hex += text.data();
    digits += std::to_string(i) + (i % 7 == 0 ? "\n" : i % 3 == 0 ? ", " : " ");
    shorts += std::string{'\0', static_cast<char>(i)};
  }
  const auto expected = upTo(24);
  for (const char *const name : {"text", "txt", "ascii", "ASCII"})
    EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: " + name + "\n", digits)), expected) << name;
  EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: hex\n", hex)), expected);
  EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: bzip2\n", bzipped(bytes()))), expected);
  const std::string members = bzipped(bytes().substr(0, 5)) + bzipped(bytes().substr(5));
  EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: bz2\n", members)), expected);
  EXPECT_EQ(
      words("a.nrrd", nrrdScan(kThree + "encoding: gzip\nbyte skip: -1\n", gzipped("header" + bytes()))),
      expected);
  EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: bz2\nbyte skip: -1\n", bzipped("header" + bytes()))),
            expected);
  EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: bz2\nbyte skip: 3\n", bzipped("abc" + bytes()))),
            expected);
  EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: txt\nline skip: 1\n", "9 9 9\n" + digits)),
            expected);
  // Numbers in digits have no byte order, and may be of any type.
  EXPECT_EQ(words("a.nrrd", "NRRD0004\ntype: float\n" + kThree + "encoding: txt\n\n" + digits), expected);
  EXPECT_EQ(words("a.nrrd", "NRRD0004\ntype: unsigned short int\nendian: big\n" + kThree +
                                "encoding: gz\n\n" + gzipped(shorts)),
            expected);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Scans, NrrdInSeveralFiles) {
  for (int i = 0; i < 4; ++i) {
    folder_.file("slab " + std::to_string(i) + ".raw", bytes().substr(static_cast<std::size_t>(6 * i), 6));
    folder_.file("z" + std::to_string(i) + ".gz",
                 gzipped(bytes().substr(static_cast<std::size_t>(6 * i), 6)));
  }
  const auto expected = upTo(24);
  EXPECT_EQ(words("a.nhdr", nrrdScan(kThree + "encoding: raw\ndata file: slab %d.raw 0 3 1\n")), expected);
  EXPECT_EQ(words("a.nhdr", nrrdScan(kThree + "encoding: raw\ndata file: slab %d.raw 0 3 1 2\n")), expected);
  EXPECT_EQ(words("a.nhdr", nrrdScan(kThree + "encoding: gzip\ndatafile: z%01d.gz 0 3 1")), expected);
  EXPECT_EQ(words("a.nhdr",
                  nrrdScan(kThree + "encoding: raw\ndata file: LIST\nslab 0.raw\nslab 1.raw\r\nslab 2.raw\n"
                                    "slab 3.raw\n")),
            expected);
  EXPECT_THAT(files_, ElementsAre(folder_.path("slab 0.raw"), folder_.path("slab 1.raw"),
                                  folder_.path("slab 2.raw"), folder_.path("slab 3.raw")));
  const auto back = words("a.nhdr", nrrdScan(kThree + "encoding: raw\ndata file: slab %d.raw 3 0 -1\n"));
  ASSERT_EQ(back.size(), 24u);
  EXPECT_EQ(back.front(), 19u);
  EXPECT_EQ(back.back(), 6u);
  folder_.file("a.nhdr", nrrdScan(kThree + "encoding: raw\ndata file: slab %d.raw 1 4 1\n"));
  EXPECT_THAT(problem("a.nhdr"), HasSubstr("slab 4.raw"));
}

TEST_F(Scans, NrrdOfFourAxes) {
  const std::string four = "dimension: 4\nencoding: raw\n";
  const auto all = upTo(24);
  // An axis of one sample, wherever it is, and with or without kinds.
  for (const char *const fields :
       {"sizes: 1 4 3 2\nkinds: list domain domain domain\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n",
        "sizes: 4 3 2 1\nkinds: domain domain domain list\n", "sizes: 1 4 3 2\n", "sizes: 4 3 2 1\n"})
    EXPECT_EQ(words("a.nrrd", nrrdScan(four + fields, bytes())), all) << fields;
  EXPECT_EQ(extent_, (Int3{4, 3, 2}));
  // Components beside each other, and volumes one after the other.
  EXPECT_EQ(
      words("a.nrrd", nrrdScan(four + "sizes: 2 4 3 1\nkinds: 2-vector domain domain domain\n", bytes())),
      upTo(24, 2));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("2 volumes")));
  EXPECT_EQ(words("a.nrrd", nrrdScan(four + "sizes: 4 3 1 2\nkinds: domain domain domain list\n", bytes())),
            upTo(12));
  options_.volume = 2;
  EXPECT_EQ(words("a.nrrd"), upTo(24, 1, 13));
  EXPECT_THAT(provenance_, HasSubstr(" volume=2"));
  EXPECT_THAT(warnings_, IsEmpty());
  EXPECT_EQ(words("a.nrrd", nrrdScan(four + "sizes: 2 4 3 1\nkinds: list domain domain domain\n", bytes())),
            upTo(24, 2, 2));
  options_.volume = 3;
  EXPECT_THAT(problem("a.nrrd"), HasSubstr("there is no volume 3; the file has 2"));
}

TEST_F(Scans, NrrdOfColours) {
  const std::string colours("\1\2\3\0\0\0\7\10\11", 9);
  const std::vector<std::uint32_t> expected{rgba(1, 2, 3), 0, rgba(7, 8, 9)};
  EXPECT_EQ(
      words("a.nrrd",
            nrrdScan("dimension: 4\nencoding: raw\nsizes: 3 3 1 1\nkinds: RGB-color space space space\n",
                     colours)),
      expected);
  EXPECT_EQ(
      words("a.nrrd",
            nrrdScan("dimension: 4\nencoding: raw\nsizes: 3 1 1 3\nkinds: space space space RGB-color\n",
                     std::string("\1\0\7\2\0\10\3\0\11", 9))),
      expected);
  EXPECT_EQ(
      words("a.nrrd",
            nrrdScan("dimension: 4\nencoding: raw\nsizes: 4 2 1 1\nkinds: RGBA-color domain domain domain\n",
                     std::string("\1\2\3\4\0\0\0\0", 8))),
      (std::vector<std::uint32_t>{rgba(1, 2, 3, 4), 0}));
  // 16 bits a channel.
  EXPECT_EQ(words("a.nrrd",
                  "NRRD0004\ntype: ushort\nendian: big\ndimension: 4\nencoding: raw\nsizes: 3 1 1 1\nkinds: "
                  "3-color domain domain domain\n\n" +
                      std::string("\377\377\0\0\2\2", 6)),
            (std::vector<std::uint32_t>{rgba(255, 0, 2)}));
  // Layers of segments are none.
  EXPECT_EQ(words("a.nrrd",
                  nrrdScan("dimension: 4\nencoding: raw\nsizes: 3 2 1 1\nkinds: list domain domain domain\n"
                           "Segment0_ID:=a\n",
                           "\1\2\3\4\5\6")),
            (std::vector<std::uint32_t>{1, 4}));
}

TEST_F(Scans, BytesBehindSamplesAreTold) {
  EXPECT_EQ(words("a.nrrd", nrrdScan(kThree + "encoding: raw\n", bytes() + "abc")), upTo(24));
  EXPECT_THAT(warnings_, ElementsAre("3 bytes are left out, which lie behind the samples"));
  words("a.nrrd", nrrdScan(kThree + "encoding: raw\n", bytes()));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Scans, AxesThatAreNotAtRightAnglesAreTold) {
  options_.isAutomatic = true;
  const std::string space = kThree + "encoding: raw\nspace: right-anterior-superior\nspace directions: ";
  words("a.nrrd", nrrdScan(space + "(1,0,0) (0.6,0.8,0) (0,0,1)\n", bytes()));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("its axes are not at right angles")));
  words("a.nrrd", nrrdScan(space + "(0.8,0.6,0) (-0.6,0.8,0) (0,0,1)\n", bytes()));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Scans, EndsOfAxesSayTheirSpacings) {
  const auto sides = [&](const std::string &more) {
    words("a.nrrd",
          nrrdScan(kThree + "encoding: raw\naxis mins: 0 -3 nan\naxismaxs: 8 3 4\n" + more, bytes()));
    return std::array<double, 3>{map_[0][0], map_[1][1], map_[2][2]};
  };
  EXPECT_EQ(sides(""), (std::array<double, 3>{2, 2, 1}));
  EXPECT_EQ(sides("centers: cell node ???\n"), (std::array<double, 3>{2, 3, 1}));
  EXPECT_EQ(sides("spacings: 5 6 7\n"), (std::array<double, 3>{5, 6, 7}));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Scans, ASpacingOf0IsNone) {
  options_.isAutomatic = true;
  words("a.nrrd", nrrdScan(kThree + "encoding: raw\nspacings: 1 0 1\n", bytes()));
  EXPECT_THAT(warnings_, ElementsAre("its spacings have a 0, which is taken as 1"));
}

TEST_F(Scans, UnknownFieldsAreTold) {
  words("a.nrrd", nrrdScan(kThree + "encoding: raw\nspice: much\ncontent: a scan\n", bytes()));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("'spice' is not known")));
}

/// A NIfTI file of bytes, with a matrix of three rows if there is one.
struct Nifti {
  std::string header = std::string(352, '\0');

  template <typename Value> void put(std::size_t at, std::initializer_list<Value> values) {
    for (const Value value : values) {
      std::memcpy(header.data() + at, &value, sizeof value);
      at += sizeof value;
    }
  }
  explicit Nifti(Int3 extent, std::int16_t type = 2) {
    put<std::int32_t>(0, {348});
    put<std::int16_t>(
        40, {3, std::int16_t(extent.x), std::int16_t(extent.y), std::int16_t(extent.z), 1, 1, 1, 1});
    put<std::int16_t>(70, {type});
    put<float>(76, {1, 1, 1, 1});
    put<float>(108, {352});
    header.replace(344, 4, std::string("n+1\0", 4));
  }
};

TEST_F(Scans, NiftiOfEveryOrderOfStorageIsOneScene) {
  // The scene: 4 to the right, 3 to the front, 2 up, its samples numbered.
  const std::array<int, 3> sizes{4, 3, 2};
  std::array<int, 3> order{0, 1, 2};
  options_.isAutomatic = true;
  std::vector<std::uint32_t> expected;
  do {
    for (int mirrored = 0; mirrored < 8; ++mirrored) {
      std::array<int, 3> extent{};
      std::array<float, 12> rows{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto to = static_cast<std::size_t>(order[axis]);
        extent[axis] = sizes[to];
        const bool isBack = (mirrored >> axis & 1) != 0;
        rows[4 * to + axis] = isBack ? -2.0f : 2.0f;
        rows[4 * to + 3] = isBack ? 2.0f * float(sizes[to] - 1) : 0.0f;
      }
      Nifti file({extent[0], extent[1], extent[2]});
      file.put<std::int16_t>(254, {1});
      std::memcpy(file.header.data() + 280, rows.data(), sizeof rows);
      std::string samples;
      std::array<int, 3> at{};
      for (at[2] = 0; at[2] < extent[2]; ++at[2])
        for (at[1] = 0; at[1] < extent[1]; ++at[1])
          for (at[0] = 0; at[0] < extent[0]; ++at[0]) {
            std::array<int, 3> place{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
              const auto to = static_cast<std::size_t>(order[axis]);
              place[to] = (mirrored >> axis & 1) != 0 ? extent[axis] - 1 - at[axis] : at[axis];
            }
            samples += static_cast<char>(1 + place[0] + 4 * (place[1] + 3 * place[2]));
          }
      const auto found = words("a.nii", file.header + samples);
      if (expected.empty())
        expected = found;
      EXPECT_EQ(found, expected) << order[0] << order[1] << order[2] << ' ' << mirrored;
      // Turned upright: x to the right, y up, z to the back. The first voxel is that of the right, front
      // corner.
      EXPECT_EQ(extent_, (Int3{4, 2, 3}));
      EXPECT_EQ(found.front(), 1u + 4 * 2);
      const glm::dvec3 point = map_ * glm::dvec4(0.5, 0.5, 0.5, 1);
      EXPECT_EQ(point, glm::dvec3(0, 4, 0));
    }
  } while (std::ranges::next_permutation(order).found);
}

TEST_F(Scans, NiftiPairsAndAnalyze) {
  Nifti file({4, 3, 2});
  file.put<float>(108, {0});
  file.header.replace(344, 4, std::string("ni1\0", 4));
  folder_.file("pair.hdr", file.header.substr(0, 348));
  folder_.file("pair.img", bytes());
  EXPECT_EQ(words("pair.hdr"), upTo(24));
  EXPECT_THAT(files_, ElementsAre(folder_.path("pair.img")));
  EXPECT_EQ(words("pair.img"), upTo(24));
  EXPECT_THAT(files_, ElementsAre(folder_.path("pair.hdr")));
  folder_.file("packed.hdr.gz", gzipped(file.header.substr(0, 348)));
  folder_.file("packed.img.gz", gzipped(bytes()));
  EXPECT_EQ(words("packed.hdr.gz"), upTo(24));
  EXPECT_EQ(words("packed.img.gz"), upTo(24));
  file.header.replace(344, 4, std::string(4, '\0'));
  file.put<std::int16_t>(254, {1}); // What is no field of Analyze files.
  file.put<float>(112, {0.5f});
  folder_.file("OLD.HDR", file.header.substr(0, 348));
  folder_.file("OLD.IMG", bytes());
  options_.isAutomatic = true;
  options_.isUpKnown = true;
  EXPECT_EQ(words("OLD.HDR"), upTo(24));
  EXPECT_THAT(notes_, Contains(HasSubstr("does not say how the axes lie")));
  folder_.file("alone.img", bytes());
  EXPECT_THAT(problem("alone.img"), HasSubstr("lacks its header"));
}

TEST_F(Scans, BytesBehindSamplesOfNiftiAreTold) {
  EXPECT_EQ(words("a.nii", Nifti({4, 3, 2}).header + bytes() + "ab"), upTo(24));
  EXPECT_THAT(warnings_, ElementsAre("2 bytes are left out, which lie behind the samples"));
  Nifti twice({4, 3, 2});
  twice.put<std::int16_t>(40, {4, 4, 3, 2, 2});
  words("a.nii", twice.header + bytes() + bytes());
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("it holds 2 volumes")));
}

TEST_F(Scans, NiftiOfColoursAndOfSeveralVolumes) {
  EXPECT_EQ(words("a.nii", Nifti({2, 1, 1}, 128).header + "\1\2\3" + std::string(3, '\0')),
            (std::vector<std::uint32_t>{rgba(1, 2, 3), 0}));
  EXPECT_EQ(words("a.nii", Nifti({2, 1, 1}, 2304).header + std::string("\1\2\3\0\4\5\6\377", 8)),
            (std::vector<std::uint32_t>{rgba(1, 2, 3, 0), rgba(4, 5, 6)}));
  Nifti planes({2, 1, 1});
  planes.put<std::int16_t>(40, {5, 2, 1, 1, 1, 3});
  planes.put<std::int16_t>(68, {2003});
  EXPECT_EQ(words("a.nii", planes.header + "\1\2\3\4\5\6"),
            (std::vector<std::uint32_t>{rgba(1, 3, 5), rgba(2, 4, 6)}));
  Nifti several({4, 3, 1});
  several.put<std::int16_t>(40, {4, 4, 3, 1, 2});
  EXPECT_EQ(words("a.nii", several.header + bytes()), upTo(12));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("2 volumes")));
  options_.volume = 2;
  EXPECT_EQ(words("a.nii"), upTo(24, 1, 13));
  EXPECT_EQ(words("a.nii.gz", gzipped(several.header + bytes())), upTo(24, 1, 13));
}

TEST_F(Scans, LabelsAreNotCutByAHistogram) {
  options_ = InputOptions();
  options_.isAutomatic = true;
  const auto count = [&](const std::string &type, const std::string &samples) {
    const auto input = openInput("raw:40x10x10:" + type + ":" + folder_.file("s", samples), options_);
    EXPECT_TRUE(input);
    return voxelsOf(*input->source).size();
  };
  // 1000 of each of four labels, a quarter of which is 0: beside each other, or however they lie.
  std::string labels(4000, '\0'), mixed(4000, '\0'), atlas(4000, '\0'), noisy(4000, '\0'), floats;
  std::uint32_t random = 1;
  for (std::size_t i = 0; i < 4000; ++i) {
    random = random * 1664525 + 1013904223;
    labels[i] = static_cast<char>(i / 1000);
    mixed[i] = static_cast<char>((random >> 24) % 4);
    atlas[i] = static_cast<char>(i / 40);                                 // A hundred, in rows.
    noisy[i] = static_cast<char>((i < 2000 ? 20 : 150) + (random >> 26)); // As measured.
    const float value = static_cast<float>(labels[i]);
    floats.append(reinterpret_cast<const char *>(&value), sizeof value);
  }
  EXPECT_EQ(count("uint8", labels), 3000u);
  EXPECT_EQ(count("float32le", floats), 3000u);
  EXPECT_EQ(count("uint8", mixed), 4000u - static_cast<std::size_t>(std::ranges::count(mixed, '\0')));
  EXPECT_EQ(count("uint8", atlas), 3960u);
  EXPECT_EQ(count("uint8", noisy), 2000u);
}

} // namespace
} // namespace voxc
