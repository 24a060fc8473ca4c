// voxc_batches.h: batches of rays, in packets and one by one, until all are done. `VOXC_SYMBOL` is what the
// kernel is called.
#pragma once

#include "voxc_exact.h"

#if VOXC_PARTS & VOXC_PART_OF_BATCHES
namespace {

// Traces one ray, as fast as it goes without others.
[[gnu::noinline]] uint trace_alone(const Rays &rays, uint ray_number, bool goes_on, const Prepared *prepared,
                                   uint lane) {
  return trace_lane(rays.kernel<Lanes>(), ray_number, goes_on, prepared, lane);
}

// Traces the rays of a list, `count` at most LANES.
void trace_rays(const Rays &rays, const uint *list, uint count, bool goes_on, const Prepared *prepared,
                uint *outcomes) {
  if (LANES > 1 && rays.in_packets && count > 1)
    return trace_packet(rays, list, count, goes_on, prepared, outcomes);
  for (uint lane = 0; lane < count; lane++)
    if (list[lane] != NONE)
      outcomes[lane] = trace_alone(rays, list[lane], goes_on, prepared, lane);
}

#if VOXC_PARTS & VOXC_PART_OF_PACKETS
bool are_worth_packets(uint) { return true; }
#else
// To compile packets takes as long as to trace so many rays one by one.
constexpr uint WORTH_PACKETS = 1 << 18;

bool are_worth_packets(uint count) {
  static uint traced = 0;
  if (__atomic_load_n(&traced, __ATOMIC_RELAXED) >= WORTH_PACKETS)
    return true;
  __atomic_fetch_add(&traced, count, __ATOMIC_RELAXED);
  return false;
}
#endif

// A packet with less than half of its lanes at work lets them go, where there are enough others to go on
// with.
constexpr uint FEWEST_LANES = LANES / 2;
constexpr uint WORTH_PACKING = 4 * LANES;
// So often: a ray that is let go may not have come further, and after that each does.
constexpr uint MOST_PACKINGS = 16;

// As many as any traversal has.
uint most_steps() { return uint(Lanes::VOLUME_SIZE.x + Lanes::VOLUME_SIZE.y + Lanes::VOLUME_SIZE.z); }

// Tells of a ray whose traversal would not have ended.
void report_nonterminated(const Rays &rays, uint ray_number) {
  for (uint axis = 0; axis < 3; axis++)
    rays.hit_words[6 * ray_number + axis] = 0x80000001u;
}

// Whether exact arithmetic has to say how it goes on.
bool is_pending(uint outcome) { return outcome == PENDING || outcome > UNPREPARED; }

// Traces rays which exact arithmetic has to prepare, in one packet.
void trace_hard(Rays rays, const uint *list, uint count) {
  rays.fewest_lanes = 0;
  Prepared prepared;
  uint numbers[LANES];
  uint left = 0;
  for (uint lane = 0; lane < count; lane++) {
    const bool is_active = prepare(rays, list[lane], prepared, lane);
    numbers[lane] = is_active ? list[lane] : NONE;
    left += is_active;
  }
  for (uint step = 0; step < most_steps() && left > 0; step++) {
    uint outcomes[LANES];
    trace_rays(rays, numbers, count, true, &prepared, outcomes);
    for (uint lane = 0; lane < count; lane++) {
      if (numbers[lane] == NONE)
        continue;
      if (is_pending(outcomes[lane]) && go_on_exactly(rays, numbers[lane], outcomes[lane]))
        continue;
      numbers[lane] = NONE;
      left--;
    }
  }
  for (uint lane = 0; lane < count; lane++)
    if (numbers[lane] != NONE)
      report_nonterminated(rays, numbers[lane]);
}

// Traces rays packet by packet; then those again of which a step had to be resolved, until all are done.
void answer_batch(Rays rays, uint count) {
  // A traversal that is let go looks again where it goes on.
  const bool counts = rays.count_lookups || Lanes::COUNT_WORDS;
  rays.in_packets = are_worth_packets(count);
  uint list[BATCH];
  uint hard[LANES] = {};
  uint hard_count = 0;
  const bool waited = Plan::PAGED && reinterpret_cast<const Pages *>(rays.words)->goes_on != 0;
  uint unfinished = 0;
  for (uint i = 0; i < count; i++)
    if (!waited || int(rays.hit_words[6 * i]) < -1)
      list[unfinished++] = i;
  count = unfinished;
  for (uint step = 0; step <= MOST_PACKINGS + most_steps() && count > 0; step++) {
    const bool packs = rays.in_packets && step < MOST_PACKINGS && count > WORTH_PACKING && !counts;
    uint left = 0;
    for (uint first = 0; first < count; first += LANES) {
      const uint size = min(count - first, LANES);
      if (step == 0)
        fetch_packet(rays,
                     list[first] + 2 * LANES); // Beyond the last: no harm, and often those of the next batch.
      rays.fewest_lanes = packs && size == LANES ? FEWEST_LANES : 0;
      uint outcomes[LANES];
      trace_rays(rays, list + first, size, waited || step > 0, nullptr, outcomes);
      for (uint lane = 0; lane < size; lane++) {
        const uint ray_number = list[first + lane];
        if (outcomes[lane] == DONE)
          continue;
        if (outcomes[lane] == UNPREPARED)
          hard[hard_count++] = ray_number;
        else if (outcomes[lane] == YIELDED || go_on_exactly(rays, ray_number, outcomes[lane]))
          list[left++] = ray_number;
        if (hard_count == LANES) {
          trace_hard(rays, hard, hard_count);
          hard_count = 0;
        }
      }
    }
    count = left;
  }
  trace_hard(rays, hard, hard_count);
  for (uint i = 0; i < count; i++)
    report_nonterminated(rays, list[i]);
}

} // namespace

#include "voxc_kernel_entry.h"
#endif
