// Packets do for each lane what the function for one does, whatever its branches and loops are.
#include "Jit/Jit.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace voxc {
namespace {

using testing::HasSubstr;

/// A function of one number, once for a lane and once as it stands, so that both can be compared.
std::string programOf(const std::string &body, int lanes) {
  return R"(
using uint = unsigned int;
extern "C" [[gnu::const]] uint voxc_lane_number(uint lanes);
extern "C" [[gnu::const]] uint voxc_lanes_at_work(int changing);
template <bool PACKET> [[gnu::always_inline]] inline uint lanes_at_work(uint changing) {
  return PACKET ? voxc_lanes_at_work(int(changing)) : 1;
}
template <bool PACKET> [[gnu::always_inline]] inline uint result_of(const uint *in, uint number) {
)" + body +
         R"(
}
[[gnu::noinline]] static void packet(const uint *in, uint *out, uint first, uint count) {
  const uint lane = voxc_lane_number()" +
         std::to_string(lanes) + R"();
  if (lane < count)
    out[first + lane] = result_of<true>(in, first + lane);
}
extern "C" void packets(const uint *in, uint *out, uint count) {
  for (uint first = 0; first < count; first += )" +
         std::to_string(lanes) + R"()
    packet(in, out, first, count - first);
}
extern "C" void singles(const uint *in, uint *out, uint count) {
  for (uint i = 0; i < count; ++i)
    out[i] = result_of<false>(in, i);
}
)";
}

using PacketFunction = void (*)(const std::uint32_t *in, std::uint32_t *out, std::uint32_t count);

struct Body {
  const char *name;
  const char *text;
};

constexpr Body kBodies[] = {
    {"straight", "return in[number] * 3u + (in[number] >> 5);"},
    {"branches",
     "uint a = in[number]; if (a & 1u) { a += 7u; if (a & 2u) return a ^ 5u; } else a *= 3u; return a;"},
    {"switch", "switch (in[number] & 7u) { case 0: return 9u; case 1: return in[number]; case 5: return 1u + "
               "in[number & 63u]; "
               "default: return 2u; }"},
    {"loop", "uint a = in[number], s = 0; while (a != 0) { s += a & 1u; a >>= 1; } return s;"},
    {"two ways out", "uint a = in[number] & 0xffffu; for (uint i = 0; i < 40u; i++) { if (a == 1u) return i; "
                     "a = a & 1u ? 3u * a + 1u : a >> 1; if (a > 60000u) return 1000u + a; } return a;"},
    {"nested loops",
     "uint n = in[number], s = 0; for (uint i = 0; i < (n & 7u); i++) { uint k = n >> i; while (k & 3u) { "
     "if ((k & 15u) == 9u) return s + 17u; s += k; k >>= 1; } if (s > 1u << 30) break; s ^= i; } return s;"},
    {"out of two loops", "uint n = in[number]; for (uint i = 0; i < 9u; i++) for (uint j = 0; j < 9u; j++) "
                         "if (((n >> i) & (n >> j) & 31u) == 21u) return 100u * i + j; return ~0u;"},
    {"a loop behind another",
     "uint n = in[number], a = n & 255u; while (a > 9u) a = a / 2u + (a & 1u); uint b = a; "
     "while (b < 100u) b += a + 1u; return a * 1000u + b;"},
    {"division", "uint a = in[number] & 15u; return a == 0u ? 77u : in[number] / a + in[number] % a;"},
    {"gathers", "uint a = number & 63u; for (int i = 0; i < 5; i++) a = in[a] & 63u; return a;"},
    {"what lanes share",
     "uint s = in[3]; if (in[number] & 8u) s += in[7]; return in[5] == 0u ? s : s * in[number];"},
    {"memory of its own",
     "uint path[8]; for (uint i = 0; i < 8u; i++) path[i] = in[(number + i) & 63u]; uint at = "
     "in[number] & 7u, s = 0; for (int i = 0; i < 6; i++) { s = 5u * s + path[at]; path[at] = s; at = s & "
     "7u; } return s;"},
    {"floats", "float f = float(in[number] & 0xffffffu) * 0.37f; float s = 0; while (f > 1.0f) { s += "
               "__builtin_floorf(f); f *= 0.3f; } "
               "return __builtin_bit_cast(uint, s + __builtin_fmaxf(f, 0.25f));"},
    {"doubles",
     "double d = double(in[number]) / 7.0; return in[number] & 2u ? uint(d) : uint(d * 0.5) + 3u;"},
    {"bits", "uint a = in[number]; return __builtin_popcount(a) + (a == 0u ? 32 : __builtin_clz(a)) + "
             "__builtin_ffs(a >> 3);"},
    {"truths",
     "bool a = in[number] & 1u, b = in[number] & 4u; bool c = false; for (int i = 0; i < 4; i++) { "
     "if (a != b) { c = !c; b = in[number] >> i & 1u; } else a = !a; } return c ? 1u + a : 3u + b;"},
    {"lanes at work", "uint n = in[number] & 31u, s = 0; while (n > 0 && lanes_at_work<PACKET>(n) >= 1u) { "
                      "s += n; n--; } return s;"},
};

/// Processors with gathers, scatters and registers of masks, or without: this one, the least of its kind, and
/// on x86-64 one between, as far as this one can do what it does.
class Packets : public testing::TestWithParam<const char *> {
protected:
  void SetUp() override {
#ifdef __x86_64__
    if (GetParam() == std::string("x86-64-v3") && !__builtin_cpu_supports("avx2"))
      GTEST_SKIP() << "this processor has no AVX2";
#endif
  }
};

constexpr const char *kProcessors[] = {
    "native",
    "",
#ifdef __x86_64__
    "x86-64-v3",
#endif
};
INSTANTIATE_TEST_SUITE_P(Processors, Packets, testing::ValuesIn(kProcessors));

TEST_P(Packets, DoWhatSingleLanesDo) {
  std::mt19937 random(7);
  std::vector<std::uint32_t> in(512);
  for (std::uint32_t &number : in)
    number = random() >> random() % 32;
  for (const Body &body : kBodies)
    for (const int lanes : {4, 8, 16}) {
      const std::string text = programOf(body.text, lanes);
      const auto code = JitCode::compile({{"lanes.cpp", text}},
                                         {.optimisation = 3, .isKernel = true, .processor = GetParam()});
      ASSERT_TRUE(code) << body.name << ": " << code.error().message;
      // 500: the last packet is not full.
      std::vector<std::uint32_t> packets(512, 1), singles(512, 1);
      reinterpret_cast<PacketFunction>(*code->find("packets"))(in.data(), packets.data(), 500);
      reinterpret_cast<PacketFunction>(*code->find("singles"))(in.data(), singles.data(), 500);
      EXPECT_EQ(packets, singles) << body.name << ", " << lanes << " lanes";
    }
}

TEST_P(Packets, CountTheLanesAtWork) {
  const std::string body = "if (in[number] & 1u) return lanes_at_work<PACKET>(number); return 0u;";
  const auto code = JitCode::compile({{"lanes.cpp", programOf(body, 8)}},
                                     {.optimisation = 3, .isKernel = true, .processor = GetParam()});
  ASSERT_TRUE(code) << code.error().message;
  const std::vector<std::uint32_t> in = {1, 0, 1, 1, 0, 0, 0, 0, 0, 1};
  std::vector<std::uint32_t> out(10);
  reinterpret_cast<PacketFunction>(*code->find("packets"))(in.data(), out.data(), 10);
  EXPECT_THAT(out, testing::ElementsAre(3, 0, 3, 3, 0, 0, 0, 0, 0, 1));
}

TEST_P(Packets, RefuseWhatTheyCannotWiden) {
  const std::string body = "return uint(__builtin_readcyclecounter()) + in[number];";
  const auto code =
      JitCode::compile({{"lanes.cpp", programOf(body, 8)}}, {.optimisation = 3, .isKernel = true});
  ASSERT_FALSE(code);
  EXPECT_THAT(code.error().message, HasSubstr("voxc cannot make a packet of"));
  EXPECT_THAT(code.error().message, HasSubstr("readcyclecounter"));
}

} // namespace
} // namespace voxc
