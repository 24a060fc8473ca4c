// Hard rays on a device.
#include "LatticeSubject.h"

#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace voxc::gpu {
namespace {

constexpr int kMostEdge = 128; // Products of the lattice's numbers fit 31 bits.
constexpr std::uint32_t kGroupRays = 64;
constexpr std::uint64_t kBatchRays = std::uint64_t{1} << 21; // In 2^15 groups, which every device takes.

/// The words of all voxels, x fastest.
Expected<std::vector<std::uint32_t>> wordsOf(const Volume &volume, int edge) {
  const auto oracle = VOXC_TRY(Oracle::of(volume));
  std::vector<std::uint32_t> words;
  words.reserve(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge * edge));
  for (int z = 0; z < edge; ++z)
    for (int y = 0; y < edge; ++y)
      for (int x = 0; x < edge; ++x)
        words.push_back(oracle.voxel({x, y, z}));
  return words;
}

/// What compare.comp writes.
struct Verdict {
  std::uint32_t hits = 0, wrong = 0, example = 0, unused = 0;
};

/// What a batch has found, and the device's seconds for it: for finding the exact hits, and for the kernel.
struct Batch {
  Verdict verdict;
  double exactSeconds = 0, kernelSeconds = 0;
};

/// One ray that the kernel gets wrong.
Expected<tool::Json> exampleOf(const Gpu &gpu, std::uint32_t number, const GpuBuffer &rays,
                               const GpuBuffer &exact, const GpuBuffer &hits) {
  std::vector<std::byte> all(rays.bytes);
  std::array<std::array<std::uint32_t, 6>, 3> records{};
  const std::array<const GpuBuffer *, 3> buffers = {&rays, &exact, &hits};
  for (std::size_t i = 0; i < records.size(); ++i) {
    VOXC_TRY(gpu.download(*buffers[i], all));
    std::copy_n(reinterpret_cast<const std::uint32_t *>(all.data()) + std::size_t{6} * number, 6,
                records[i].begin());
  }
  // Bits, of float32 too: nothing is lost.
  return tool::Json{{"ray", records[0]}, {"exact", records[1]}, {"found", records[2]}};
}

/// The buffers and programs of a check.
class Check {
public:
  static Expected<Check> make(const Gpu &gpu, const Volume &volume, const Kernel &kernel,
                              const LatticePrograms &programs, int edge);

  /// Draws a batch, traces it and compares.
  Expected<Batch> batch(std::uint64_t number, std::uint32_t seed) const;
  Expected<tool::Json> example(const Verdict &verdict) const {
    return exampleOf(*gpu_, verdict.example, rays_, exact_, hits_);
  }

private:
  Check(const Gpu &gpu, int edge, KernelSubject subject, KernelSubject::Way way, Program lattice,
        Program compare)
      : gpu_(&gpu), edge_(edge), subject_(std::move(subject)), way_(std::move(way)),
        lattice_(std::move(lattice)), compare_(std::move(compare)) {}
  Expected<void> makeBuffers(std::span<const std::uint32_t> words);

  const Gpu *gpu_;
  int edge_;
  KernelSubject subject_;
  KernelSubject::Way way_;
  Program lattice_, compare_;
  GpuBuffer cells_, rays_, exact_, hits_, verdict_;
};

Expected<Check> Check::make(const Gpu &gpu, const Volume &volume, const Kernel &kernel,
                            const LatticePrograms &programs, int edge) {
  const auto words = VOXC_TRY(wordsOf(volume, edge));
  auto lattice = VOXC_TRY(Program::make(gpu, programs.lattice, 3, 4));
  auto compare = VOXC_TRY(Program::make(gpu, programs.compare, 3, 1));
  auto subject = VOXC_TRY(KernelSubject::make(gpu, volume, {}));
  auto way = VOXC_TRY(subject.makeWay(kernel, kWorkgroupSize, kBatchRays, true));
  Check check(gpu, edge, std::move(subject), std::move(way), std::move(lattice), std::move(compare));
  VOXC_TRY(check.makeBuffers(words));
  return check;
}

Expected<void> Check::makeBuffers(std::span<const std::uint32_t> words) {
  struct Room {
    GpuBuffer &buffer;
    std::uint64_t bytes;
  };
  for (const auto &[buffer, bytes] :
       {Room{cells_, words.size_bytes()}, Room{rays_, kBatchRays * sizeof(Ray)},
        Room{exact_, kBatchRays * sizeof(Hit)}, Room{hits_, kBatchRays * sizeof(Hit)},
        Room{verdict_, sizeof(Verdict)}}) {
    buffer = VOXC_TRY(gpu_->makeBuffer(bytes));
  }
  lattice_.bind(std::array{&cells_, &rays_, &exact_});
  compare_.bind(std::array{&exact_, &hits_, &verdict_});
  subject_.bind(way_, rays_, hits_);
  return gpu_->upload(cells_, std::as_bytes(words));
}

Expected<Batch> Check::batch(std::uint64_t number, std::uint32_t seed) const {
  constexpr auto kCount = static_cast<std::uint32_t>(kBatchRays);
  constexpr std::uint32_t kGroups = kCount / kGroupRays;
  const std::uint64_t first = number * kBatchRays;
  // Numbers of rays go round after 2^32; another seed draws others.
  const auto seedNow = seed + static_cast<std::uint32_t>(first >> 32) * 0x9e3779b9u;
  std::vector<GpuStep> steps = {
      {.written = &verdict_, .words = {0, 0, 0, 0}},
      {.program = &lattice_,
       .words = {static_cast<std::uint32_t>(first), kCount, seedNow, static_cast<std::uint32_t>(edge_)},
       .groupsX = kGroups}};
  for (GpuStep &step : way_.stepsOf(kBatchRays, gpu_->facts().mostGroups, false))
    steps.push_back(std::move(step));
  steps.push_back({.program = &compare_, .words = {kCount}, .groupsX = kGroups});
  const auto run = VOXC_TRY(gpu_->run(steps));
  Batch batch{.exactSeconds = run[1], .kernelSeconds = std::accumulate(run.begin() + 2, run.end() - 1, 0.0)};
  VOXC_TRY(gpu_->download(verdict_, std::as_writable_bytes(std::span(&batch.verdict, 1))));
  return batch;
}

} // namespace

Expected<tool::Json> checkLattice(const Gpu &gpu, const Volume &volume, const Kernel &kernel,
                                  const LatticePrograms &programs, const LatticeOptions &options) {
  const Int3 extent = volume.info().extent;
  const int edge = std::max({extent.x, extent.y, extent.z});
  if (edge > kMostEdge)
    return Error::input("the volume has " + std::to_string(edge) +
                        " voxels along an axis; lattice rays are for " + std::to_string(kMostEdge) +
                        " at most");
  const auto check = VOXC_TRY(Check::make(gpu, volume, kernel, programs, edge));
  const Stopwatch watch;
  std::uint64_t rays = 0, hits = 0, wrong = 0;
  double exactSeconds = 0, kernelSeconds = 0;
  tool::Json example;
  while (rays < options.rays && (options.seconds == 0 || watch.seconds() < options.seconds)) {
    const auto batch = VOXC_TRY(check.batch(rays / kBatchRays, options.seed));
    rays += kBatchRays;
    hits += batch.verdict.hits;
    wrong += batch.verdict.wrong;
    exactSeconds += batch.exactSeconds;
    kernelSeconds += batch.kernelSeconds;
    if (batch.verdict.wrong > 0 && example.is_null())
      example = VOXC_TRY(check.example(batch.verdict));
  }
  tool::Json figures{{"rays", rays},
                     {"hits", hits},
                     {"wrong", wrong},
                     {"seconds", watch.seconds()},
                     {"exact_seconds", exactSeconds},
                     {"kernel_seconds", kernelSeconds}};
  if (!example.is_null())
    figures["example"] = std::move(example);
  return figures;
}

} // namespace voxc::gpu
