template <bool COUNT_LOOKUPS>
void trace_all(const uint *words, const uint *rays, uint *hits, unsigned long long count) {
  for (unsigned long long i = 0; i < count; ++i)
    Kernel<COUNT_LOOKUPS>{words, rays + 6 * i, hits + 6 * i}.main();
}

} // namespace

// Traces `count` rays, six floats each, through the words of a volume into as many hits, six words each.
extern "C" void THE_SYMBOL(const uint *words, const float *rays, uint *hits, unsigned long long count,
                       int count_lookups) {
  const uint *ray_words = reinterpret_cast<const uint *>(rays);
  if (count_lookups)
    trace_all<true>(words, ray_words, hits, count);
  else
    trace_all<false>(words, ray_words, hits, count);
}
