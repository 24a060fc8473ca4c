// Bytes as characters of a page, and two texts as one.
#include "page/Packed.h"
#include "page/Merged.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>

namespace voxc::page {
namespace {

/// What page-runtime/unpack.js does.
std::string bytesOf(const std::string &text, std::size_t size) {
  std::string bytes;
  unsigned held = 0;
  int bits = 0;
  const auto put = [&](unsigned seven) {
    held = (held << 7 | seven) & 0x7fff;
    if ((bits += 7) >= 8)
      bytes += static_cast<char>(held >> (bits -= 8));
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 128) {
      put(byte);
      continue;
    }
    const unsigned pair = ((byte & 0x1fu) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3fu)) - 0x100;
    put(std::array{0u, 13u, 60u}[pair >> 7]);
    put(pair & 127);
  }
  return bytes.substr(0, size);
}

TEST(Packed, TextBringsBackTheBytes) {
  std::mt19937 random(1);
  for (std::size_t size = 0; size < 400; ++size) {
    std::string bytes(size, '\0');
    for (char &byte : bytes)
      byte = static_cast<char>(size % 3 == 0 ? 0 : random());
    const std::string text = sevenBitText(bytes);
    EXPECT_EQ(bytesOf(text, size), bytes);
    EXPECT_EQ(text.find_first_of(std::string("\0\r<", 3)), text.npos);
    EXPECT_LE(text.size(), size * 8 / 7 + 2);
  }
}

TEST(Packed, PlanesAreThoseOfEachBlock) {
  std::vector<std::uint32_t> words(kBlockWords + 2);
  for (std::size_t i = 0; i < words.size(); ++i)
    words[i] = static_cast<std::uint32_t>(i * 0x01020304u);
  const std::string planes = planesOf(words);
  ASSERT_EQ(planes.size(), words.size() * 4);
  for (const std::size_t i :
       {std::size_t{0}, std::size_t{77}, kBlockWords - 1, kBlockWords, kBlockWords + 1}) {
    const std::size_t begin = i < kBlockWords ? 0 : kBlockWords, count = i < kBlockWords ? kBlockWords : 2;
    for (std::size_t rank = 0; rank < 4; ++rank)
      EXPECT_EQ(static_cast<unsigned char>(planes[4 * begin + rank * count + i - begin]),
                words[i] >> 8 * rank & 255);
  }
}

std::string without(const std::string &text, char mark) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    if (text[begin] != mark)
      result += text.substr(begin + 1, end - begin - 1);
    begin = end;
  }
  return result;
}

TEST(Merged, HasBothTexts) {
  const std::string a = "one\ntwo\nthree\nfour\n", b = "zero\none\nthree\n4\n";
  const std::string both = merged(a, b);
  EXPECT_EQ(both, "+zero\n one\n-two\n three\n-four\n+4\n");
  EXPECT_EQ(without(both, '+'), a);
  EXPECT_EQ(without(both, '-'), b);
  EXPECT_EQ(merged("", "x\n"), "+x\n");
  EXPECT_EQ(merged("x\n", ""), "-x\n");
}

} // namespace
} // namespace voxc::page
