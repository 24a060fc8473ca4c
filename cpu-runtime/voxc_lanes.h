// voxc_lanes.h: functions of which voxc's own compiler makes one for several rays, a lane of wide registers
// each. Others compile them as they stand, for one.
#pragma once

// A kernel can be compiled in parts, each when one of its functions is first called. VOXC_PARTS is the sum of
// those that are compiled here: all, where it is not defined.
#define VOXC_PART_OF_BATCHES 1 // What is called for rays, and goes through them one by one.
#define VOXC_PART_OF_PACKETS 2
#define VOXC_PART_OF_EXACTNESS 4 // Exact arithmetic, which few rays need.
#ifdef VOXC_PARTS
#define VOXC_PART_FUNCTION extern "C" [[gnu::noinline]] // One that another part calls.
#else
#define VOXC_PARTS 7
#define VOXC_PART_FUNCTION [[gnu::noinline]]
#endif

namespace voxc::glsl {

#if defined(VOXC_PACKETS) && defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512BW__) &&       \
    defined(__AVX512VL__)
#ifdef VOXC_NARROW_PACKETS
constexpr unsigned int LANES = 16;
#else
constexpr unsigned int LANES =
    32; // Two registers for each value: where one waits for what it reads, the other has work to do.
#endif
#elif defined(VOXC_PACKETS) && defined(__AVX2__)
constexpr unsigned int LANES = 8;
#elif defined(VOXC_PACKETS) && defined(__aarch64__)
constexpr unsigned int LANES = 4; // A register of NEON each; of two for each value most would lie in memory.
#else
constexpr unsigned int LANES = 1;
#endif

#ifdef VOXC_PACKETS
// The number of a lane. A function that calls this is made one of `lanes` lanes, a constant.
extern "C" [[gnu::const]] unsigned int voxc_lane_number(unsigned int lanes);
// How many lanes are at work where this is called. What is given changes from call to call, so that each is
// made.
extern "C" [[gnu::const]] unsigned int voxc_lanes_at_work(int changing);
[[gnu::always_inline]] inline unsigned int lane_number(unsigned int lanes) { return voxc_lane_number(lanes); }
[[gnu::always_inline]] inline unsigned int lanes_at_work(int changing) {
  return voxc_lanes_at_work(changing);
}
#else
inline unsigned int lane_number(unsigned int) { return 0; }
inline unsigned int lanes_at_work(int) { return 1; }
#endif

} // namespace voxc::glsl
