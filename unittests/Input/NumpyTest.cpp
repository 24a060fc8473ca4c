// NumPy arrays, alone and in archives.
#include "Input/InputTesting.h"

#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <numeric>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string npy(const std::string &type, const std::string &order, const std::string &shape,
                const std::string &data, bool isVersion1 = true) {
  std::string fields = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  fields.resize((fields.size() / 16 + 1) * 16, ' ');
  fields.back() = '\n';
  std::string head =
      std::string("\x93NUMPY") + (isVersion1 ? '\1' : '\2') + '\0' + static_cast<char>(fields.size());
  head += std::string(isVersion1 ? 1 : 3, '\0');
  return head + fields + data;
}

std::string number(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i)
    text += static_cast<char>(value >> 8 * i);
  return text;
}

/// An archive of files, deflated or stored, as zipfile of Python writes it.
std::string zip(const std::vector<std::pair<std::string, std::string>> &files, bool isDeflated) {
  std::string archive, directory;
  for (const auto &[name, content] : files) {
    std::string packed = content;
    if (isDeflated) {
      z_stream stream{};
      EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
      packed.resize(deflateBound(&stream, content.size()));
      stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(content.data()));
      stream.avail_in = static_cast<uInt>(content.size());
      stream.next_out = reinterpret_cast<Bytef *>(packed.data());
      stream.avail_out = static_cast<uInt>(packed.size());
      EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
      packed.resize(packed.size() - stream.avail_out);
      deflateEnd(&stream);
    }
    const std::string method = number(isDeflated ? 8 : 0, 2);
    // NumPy writes the sizes of local heads in 64 bits.
    const std::string extra =
        number(1, 2) + number(16, 2) + number(content.size(), 8) + number(packed.size(), 8);
    directory += number(0x02014b50, 4) + number(20, 2) + number(20, 2) + number(0, 2) + method +
                 number(0, 8) + number(packed.size(), 4) + number(content.size(), 4) +
                 number(name.size(), 2) + number(0, 12) + number(archive.size(), 4) + name;
    archive += number(0x04034b50, 4) + number(45, 2) + number(0, 2) + method + number(0, 8) + number(~0u, 4) +
               number(~0u, 4) + number(name.size(), 2) + number(extra.size(), 2) + name + extra + packed;
  }
  return archive + directory + number(0x06054b50, 4) + number(0, 4) + number(files.size(), 2) +
         number(files.size(), 2) + number(directory.size(), 4) + number(archive.size(), 4) + number(0, 2);
}

class Numpy : public OpenedInputs {
protected:
  Numpy() { options_.colourMap = "labels"; }
};

using Words = std::vector<std::uint32_t>;
const std::string kSixBytes = "\1\2\3\4\5\6";
const Words kUpToSix{1, 2, 3, 4, 5, 6};

TEST_F(Numpy, ArraysAreZYX) {
  EXPECT_EQ(words("a.npy", npy("|u1", "False", "(1, 2, 3)", kSixBytes)), kUpToSix);
  EXPECT_EQ(extent_, (Int3{3, 2, 1}));
  EXPECT_EQ(words("a.npy", npy("|u1", "False", "(1, 2, 3)", kSixBytes, false)), kUpToSix);
  EXPECT_EQ(words("a.npy", npy("|u1", "True", "(1, 2, 3)", "\1\4\2\5\3\6")), kUpToSix);
  EXPECT_EQ(words("a.npy", npy(">i2", "False", "(3, 1, 1)", std::string("\0\1\0\2\1\0", 6))),
            (Words{1, 2, 256}));
  EXPECT_EQ(words("a.npy", npy("|b1", "False", "(2,)", std::string("\1\0", 2))), (Words{1, 0}));
  EXPECT_EQ(words("a.npy", npy("|u1", "False", "(2, 1, 1, 3)", kSixBytes)),
            (Words{rgba(1, 2, 3), rgba(4, 5, 6)}));
  EXPECT_EQ(words("a.npy", npy("|u1", "False", "(3, 1, 1, 2)", kSixBytes)), (Words{1, 2}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("3 volumes")));
  options_.volume = 3;
  EXPECT_EQ(words("a.npy", npy("|u1", "False", "(3, 1, 1, 2)", kSixBytes)), (Words{5, 6}));
}

TEST_F(Numpy, ArchivesHaveSeveral) {
  for (const bool isDeflated : {false, true}) {
    options_.grid.clear();
    const std::string archive = zip({{"times.npy", npy("<f8", "False", "(1,)", std::string(8, '\0'))},
                                     {"first.npy", npy("|u1", "False", "(1, 2, 3)", kSixBytes)},
                                     {"other.npy", npy("|u1", "False", "(1, 1, 2)", "\7\10")}},
                                    isDeflated);
    EXPECT_EQ(words("a.npz", archive), kUpToSix);
    EXPECT_THAT(warnings_,
                ElementsAre("the array 'first' is taken, and left out are times (1), other (1, 1, 2) "
                            "(--grid NAME takes one of them)"));
    options_.grid = "other";
    EXPECT_EQ(words("a.npz", archive), (Words{7, 8}));
    EXPECT_THAT(provenance_, HasSubstr("grid=other"));
    options_.grid = "none";
    EXPECT_THAT(problem("a.npz", archive),
                HasSubstr("it has no array 'none'; there are times (1), first (1, 2, 3)"));
    for (std::size_t size = 0; size < archive.size(); size += 7)
      EXPECT_NE(problem("b.npz", archive.substr(0, size)), "none");
  }
}

TEST_F(Numpy, WhatIsBrokenIsAnError) {
  EXPECT_THAT(problem("a.npy", "nonsense"), HasSubstr("does not begin as NumPy arrays do"));
  EXPECT_THAT(problem("a.npy", npy("<c8", "False", "(1, 1, 1)", "12345678")), HasSubstr("of the type <c8"));
  EXPECT_THAT(problem("a.npy", npy("|O", "False", "(1, 1, 1)", "12345678")), HasSubstr("of the type |O"));
  EXPECT_THAT(problem("a.npy", npy("|u1", "False", "(1, 2, 4)", kSixBytes)),
              HasSubstr("takes 8 bytes, but there are 6"));
  EXPECT_THAT(problem("a.npy", npy("|u1", "False", "(0, 2, 4)", kSixBytes)), HasSubstr("has no value"));
  EXPECT_THAT(problem("a.npy", npy("|u1", "False", "(999999999999, 999999999999, 4)", kSixBytes)),
              HasSubstr("more than any"));
}

} // namespace
} // namespace voxc
