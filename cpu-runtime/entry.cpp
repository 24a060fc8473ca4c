} // namespace

// Traces `count` rays, six floats each, through the words of a volume into as many hits, six words each.
extern "C" void THE_SYMBOL(const uint *words, const float *rays, uint *hits, unsigned long long count,
                           int count_lookups, float spread) {
  const uint *ray_words = reinterpret_cast<const uint *>(rays);
  for (unsigned long long i = 0; i < count; ++i)
    Kernel{words, ray_words + 6 * i, hits + 6 * i, count_lookups != 0, spread}.main();
}
