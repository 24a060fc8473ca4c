// A kernel's facts: written, read back, and looked for in modules that lie.
#include "voxc/Trace/Kernel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace voxc {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kModuleProcessed = 330;

std::uint32_t instructionWord(std::size_t words, std::uint32_t opcode) {
  return static_cast<std::uint32_t>(words << 16 | opcode);
}

std::vector<std::uint32_t> header() { return {0x07230203, 0x00010500, 0, 1, 0}; }

/// A module that holds one string, as OpModuleProcessed.
std::vector<std::uint32_t> moduleWith(const std::string &text) {
  std::vector<std::uint32_t> module = header();
  std::vector<std::uint32_t> literal(text.size() / 4 + 1);
  std::memcpy(literal.data(), text.data(), text.size());
  module.push_back(instructionWord(literal.size() + 1, kModuleProcessed));
  module.insert(module.end(), literal.begin(), literal.end());
  return module;
}

std::string problemOf(std::vector<std::uint32_t> module) {
  auto kernel = Kernel::fromSpirv(std::move(module));
  return kernel ? "" : kernel.error().message;
}

TEST(KernelFacts, ComeBackAsTheyWereWritten) {
  for (Addressing addressing : {Addressing::Buffer, Addressing::Segments}) {
    auto module = moduleWith(kernelFacts({{}, 0x00c0ffee12345678, addressing, Loops::Whole}));
    auto kernel = Kernel::fromSpirv(module);
    ASSERT_TRUE(kernel) << kernel.error().message;
    EXPECT_EQ(kernel->storageDigest, 0x00c0ffee12345678u);
    EXPECT_EQ(kernel->addressing, addressing);
    EXPECT_EQ(kernel->loops, Loops::Whole);
    EXPECT_EQ(kernel->spirv, module);
  }
}

TEST(KernelFacts, AreTheDocumentedText) {
  EXPECT_EQ(kernelFacts({{}, 0xab, Addressing::Buffer, Loops::Cut}),
            "voxc kernel 3 storage=00000000000000ab addressing=buffer loops=cut arithmetic=any");
  EXPECT_EQ(kernelFacts({{}, ~0ull, Addressing::Segments, Loops::Whole}),
            "voxc kernel 3 storage=ffffffffffffffff addressing=segments loops=whole arithmetic=any");
}

TEST(KernelFacts, TellOfBounds) {
  Kernel kernel{{}, 5, Addressing::Buffer, Loops::Whole, Arithmetic::Ieee, true};
  EXPECT_TRUE(kernelFacts(kernel).ends_with(" arithmetic=ieee bounds=yes"));
  EXPECT_TRUE(Kernel::fromSpirv(moduleWith(kernelFacts(kernel)))->bounded);
  kernel.bounded = false;
  EXPECT_FALSE(Kernel::fromSpirv(moduleWith(kernelFacts(kernel)))->bounded);
}

TEST(KernelFacts, AreFoundAmongOtherInstructions) {
  std::vector<std::uint32_t> module = moduleWith("client vulkan100");
  std::vector<std::uint32_t> facts = moduleWith(kernelFacts({{}, 7, Addressing::Buffer, Loops::Cut}));
  module.insert(module.end(), facts.begin() + 5, facts.end());
  module.push_back(instructionWord(1, 253));
  auto kernel = Kernel::fromSpirv(module);
  ASSERT_TRUE(kernel) << kernel.error().message;
  EXPECT_EQ(kernel->storageDigest, 7u);
}

TEST(KernelFacts, OfOtherVersionsAreRefused) {
  EXPECT_THAT(problemOf(moduleWith("voxc kernel 1 storage=0000000000000000 addressing=buffer")),
              HasSubstr("version 1"));
}

TEST(KernelFacts, MustBeWellFormed) {
  for (const char *facts :
       {"voxc kernel 3", "voxc kernel 3 storage=12 addressing=buffer loops=cut arithmetic=any",
        "voxc kernel 3 storage=000000000000000g addressing=buffer loops=cut arithmetic=any",
        "voxc kernel 3 storage=-000000000000001 addressing=buffer loops=cut arithmetic=any",
        "voxc kernel 3 storage=0000000000000000", "voxc kernel 3 addressing=buffer loops=cut arithmetic=any",
        "voxc kernel 3 storage=0000000000000000 addressing=texture loops=cut arithmetic=any",
        "voxc kernel 3 storage=0000000000000000 addressing=buffer",
        "voxc kernel 3 storage=0000000000000000 addressing=buffer loops=some arithmetic=any",
        "voxc kernel 3 storage=0000000000000000 addressing=buffer loops=cut arithmetic=any more",
        "voxc kernel 3 storage=0000000000000000 addressing=buffer loops=cut arithmetic=any bounds=no"})
    EXPECT_THAT(problemOf(moduleWith(facts)), HasSubstr("description is broken")) << facts;
}

TEST(HostileModule, IsNoSpirv) {
  EXPECT_THAT(problemOf({}), HasSubstr("not SPIR-V"));
  EXPECT_THAT(problemOf({0x7f, 2, 3, 4, 5}), HasSubstr("not SPIR-V"));
  EXPECT_THAT(problemOf({0x03022307, 0, 0, 0, 0}), HasSubstr("big-endian"));
}

TEST(HostileModule, EndsTooEarly) {
  std::vector<std::uint32_t> whole = moduleWith(kernelFacts({{}, 1, Addressing::Buffer, Loops::Cut}));
  for (std::size_t words = 0; words < whole.size(); ++words)
    EXPECT_NE(problemOf({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(words)}), "") << words;
}

TEST(HostileModule, HasAnInstructionOfNoWords) {
  std::vector<std::uint32_t> module = header();
  module.push_back(instructionWord(0, kModuleProcessed));
  EXPECT_THAT(problemOf(module), HasSubstr("word 5 has no words"));
}

TEST(HostileModule, HasAnInstructionBeyondTheEnd) {
  std::vector<std::uint32_t> module = header();
  module.push_back(instructionWord(0xffff, kModuleProcessed));
  EXPECT_THAT(problemOf(module), HasSubstr("only 1 are left"));
}

TEST(HostileModule, HasAStringWithoutEnd) {
  std::vector<std::uint32_t> module = moduleWith(kernelFacts({{}, 1, Addressing::Buffer, Loops::Cut}));
  // Every byte of the last word is a character now, and another instruction follows.
  module.back() = 0x20202020;
  module.push_back(instructionWord(1, 253));
  EXPECT_THAT(problemOf(module), HasSubstr("not made by voxc"));
}

TEST(KernelFile, IsRefusedIfItsSizeIsNoMultipleOfAWord) {
  std::string path = (std::filesystem::path(testing::TempDir()) / "voxc-odd.spv").string();
  std::ofstream(path, std::ios::binary) << "\x03\x02\x23\x07...";
  auto kernel = Kernel::load(path);
  std::filesystem::remove(path);
  ASSERT_FALSE(kernel);
  EXPECT_THAT(kernel.error().message, HasSubstr("no multiple of 4"));
}

TEST(KernelFile, MustExist) {
  auto kernel = Kernel::load("no-such-folder/kernel.spv");
  ASSERT_FALSE(kernel);
  EXPECT_EQ(kernel.error().kind, ErrorKind::Input);
}

} // namespace
} // namespace voxc
