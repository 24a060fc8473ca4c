// Ends with 0 if the compiler keeps the rounding of doubles to float32 (cmake/VoxcRounding.cmake): at -O2 g++
// 12 makes one conversion of two neighbours to float32 and back, and takes that for none, since it compares
// the lengths of vectors where it should compare the precision of their numbers.
#include <array>

namespace {

using Pair = std::array<double, 2>;
using Triple = std::array<double, 3>;

[[gnu::noinline]] void roundPair(const Pair &from, Pair &to) {
  to = {static_cast<float>(from[0]), static_cast<float>(from[1])};
}

[[gnu::noinline]] void roundTriple(const Triple &from, double origin, double scale, Triple &to) {
  const std::array<float, 3> narrow{static_cast<float>(from[0]), static_cast<float>(from[1]),
                                    static_cast<float>(from[2])};
  to = {(narrow[0] - origin) * scale, (narrow[1] - origin) * scale, (narrow[2] - origin) * scale};
}

[[gnu::noinline]] void roundMany(const double *from, double *to, int count) {
  for (int i = 0; i < count; ++i)
    to[i] = static_cast<float>(from[i]);
}

} // namespace

int main(int arguments, char **) {
  const double tenth = 0.1 * arguments; // Not known to the compiler; float32 has no such number.
  volatile float narrow = static_cast<float>(tenth);
  const double rounded = narrow;

  Pair pair{};
  roundPair({tenth, tenth}, pair);
  Triple triple{1, 1, 1};
  roundTriple({tenth, tenth, tenth}, rounded, 1e9, triple);
  std::array<double, 37> from, to{};
  from.fill(tenth);
  roundMany(from.data(), to.data(), 37);

  bool kept = pair == Pair{rounded, rounded} && triple == Triple{};
  for (const double number : to)
    kept = kept && number == rounded;
  return kept ? 0 : 1;
}
