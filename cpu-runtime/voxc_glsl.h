// voxc_glsl.h: the built-in functions of GLSL that kernels call, in C++. Freestanding; for Clang 17 and GCC 12, or
// later ones.
#pragma once

#include "voxc_vector.h"

// Kernels want all functions in their loops, in registers, but for those that are seldom called.
#define OUT_OF_LINE [[gnu::noinline, gnu::cold]]
#ifdef __clang__
#define VOXC_BEGIN_INLINE _Pragma("clang attribute push([[gnu::always_inline]], apply_to = function)")
#define VOXC_END_INLINE _Pragma("clang attribute pop")
#else
#define VOXC_BEGIN_INLINE
#define VOXC_END_INLINE
#endif

namespace voxc::glsl {

template <typename T>
concept Number = __is_same(T, float) || __is_same(T, int) || __is_same(T, uint);

// Scalars. A NaN gives way to a number, as on every device that we know.
VOXC_INLINE float min(float a, float b) { return __builtin_fminf(a, b); }
VOXC_INLINE float max(float a, float b) { return __builtin_fmaxf(a, b); }
VOXC_INLINE int min(int a, int b) { return b < a ? b : a; }
VOXC_INLINE int max(int a, int b) { return a < b ? b : a; }
VOXC_INLINE uint min(uint a, uint b) { return b < a ? b : a; }
VOXC_INLINE uint max(uint a, uint b) { return a < b ? b : a; }
template <Number T> VOXC_INLINE T clamp(T value, Scalar<T> least, Scalar<T> most) {
  return min(max(value, least), most);
}
VOXC_INLINE float abs(float a) { return __builtin_fabsf(a); }
VOXC_INLINE double abs(double a) { return __builtin_fabs(a); }
VOXC_INLINE int abs(int a) { return a < 0 ? -a : a; }
template <Number T> VOXC_INLINE T sign(T a) { return T(T(0) < a) - T(a < T(0)); }
VOXC_INLINE float floor(float a) { return __builtin_floorf(a); }
VOXC_INLINE float ceil(float a) { return __builtin_ceilf(a); }
VOXC_INLINE float trunc(float a) { return __builtin_truncf(a); }
VOXC_INLINE float roundEven(float a) { return __builtin_roundevenf(a); }
VOXC_INLINE float sqrt(float a) { return __builtin_sqrtf(a); }
VOXC_INLINE bool isnan(float a) { return __builtin_isnan(a); }
VOXC_INLINE bool isinf(float a) { return __builtin_isinf(a); }
VOXC_INLINE float ldexp(float a, int exponent) { return __builtin_ldexpf(a, exponent); }
template <typename T> VOXC_INLINE T mix(T a, T b, bool takesB) { return takesB ? b : a; }

VOXC_INLINE uint floatBitsToUint(float a) { return __builtin_bit_cast(uint, a); }
VOXC_INLINE int floatBitsToInt(float a) { return __builtin_bit_cast(int, a); }
VOXC_INLINE float uintBitsToFloat(uint a) { return __builtin_bit_cast(float, a); }
VOXC_INLINE float intBitsToFloat(int a) { return __builtin_bit_cast(float, a); }

// Bits. The position of a bit that is not there is -1.
VOXC_INLINE int bitCount(uint a) { return __builtin_popcount(a); }
VOXC_INLINE int findLSB(uint a) { return __builtin_ffs(int(a)) - 1; }
VOXC_INLINE int findMSB(uint a) { return a == 0 ? -1 : 31 - __builtin_clz(a); }
VOXC_INLINE int findMSB(int a) { return findMSB(uint(a < 0 ? ~a : a)); }

// Wide integers.
VOXC_INLINE uint uaddCarry(uint a, uint b, uint &carry) {
  const uint sum = a + b;
  carry = sum < a;
  return sum;
}
VOXC_INLINE uint usubBorrow(uint a, uint b, uint &borrow) {
  borrow = a < b;
  return a - b;
}
VOXC_INLINE void umulExtended(uint a, uint b, uint &high, uint &low) {
  const unsigned long long product = (unsigned long long)a * b;
  high = uint(product >> 32);
  low = uint(product);
}
VOXC_INLINE void imulExtended(int a, int b, int &high, int &low) {
  const long long product = (long long)a * b;
  high = int(product >> 32);
  low = int(product);
}

// Vectors, component by component; a number beside a vector stands for a vector of it.
#define VOXC_UNARY(name)                                                                                     \
  template <typename T, int N> VOXC_INLINE Vector<T, N> name(Vector<T, N> v) {                               \
    return componentwise([](T p, T) { return name(p); }, v, v);                                              \
  }
#define VOXC_BINARY(name)                                                                                    \
  template <typename T, int N> VOXC_INLINE Vector<T, N> name(Vector<T, N> a, Vector<T, N> b) {               \
    return componentwise([](T p, T q) { return name(p, q); }, a, b);                                         \
  }                                                                                                          \
  template <typename T, int N> VOXC_INLINE Vector<T, N> name(Vector<T, N> a, Scalar<T> b) {                  \
    return name(a, Vector<T, N>(b));                                                                         \
  }
#define VOXC_COMPARISON(name, op)                                                                            \
  template <typename T, int N> VOXC_INLINE Vector<bool, N> name(Vector<T, N> a, Vector<T, N> b) {            \
    return vectorOf<bool, N>(a.lanes op b.lanes);                                                            \
  }

#if __has_builtin(__builtin_elementwise_floor) // Clang: all lanes at once.
#define VOXC_UNARY_LANES(name, builtin)                                                                      \
  template <typename T, int N> VOXC_INLINE Vector<T, N> name(Vector<T, N> v) {                               \
    return vectorOf<T, N>(builtin(v.lanes));                                                                 \
  }
#define VOXC_BINARY_LANES(name, builtin)                                                                     \
  template <typename T, int N> VOXC_INLINE Vector<T, N> name(Vector<T, N> a, Vector<T, N> b) {               \
    return vectorOf<T, N>(builtin(a.lanes, b.lanes));                                                        \
  }                                                                                                          \
  template <typename T, int N> VOXC_INLINE Vector<T, N> name(Vector<T, N> a, Scalar<T> b) {                  \
    return name(a, Vector<T, N>(b));                                                                         \
  }
#else
#define VOXC_UNARY_LANES(name, builtin) VOXC_UNARY(name)
#define VOXC_BINARY_LANES(name, builtin) VOXC_BINARY(name)
#endif

VOXC_UNARY(sign)
VOXC_UNARY(sqrt)
VOXC_UNARY_LANES(abs, __builtin_elementwise_abs)
VOXC_UNARY_LANES(floor, __builtin_elementwise_floor)
VOXC_UNARY_LANES(ceil, __builtin_elementwise_ceil)
VOXC_UNARY_LANES(trunc, __builtin_elementwise_trunc)
VOXC_UNARY_LANES(roundEven, __builtin_elementwise_roundeven)
VOXC_BINARY_LANES(min, __builtin_elementwise_min)
VOXC_BINARY_LANES(max, __builtin_elementwise_max)
VOXC_COMPARISON(lessThan, <)
VOXC_COMPARISON(lessThanEqual, <=)
VOXC_COMPARISON(greaterThan, >)
VOXC_COMPARISON(greaterThanEqual, >=)
VOXC_COMPARISON(equal, ==)
VOXC_COMPARISON(notEqual, !=)

// Two results: one returned and one through a reference, or both through references.
#define VOXC_CARRYING(name)                                                                                  \
  template <int N>                                                                                           \
  VOXC_INLINE Vector<uint, N> name(Vector<uint, N> a, Vector<uint, N> b, Vector<uint, N> &second) {          \
    Vector<uint, N> first;                                                                                   \
    for (int i = 0; i < N; ++i)                                                                              \
      first[i] = name(a[i], b[i], second[i]);                                                                \
    return first;                                                                                            \
  }
#define VOXC_EXTENDED(name)                                                                                  \
  template <typename T, int N>                                                                               \
  VOXC_INLINE void name(Vector<T, N> a, Vector<T, N> b, Vector<T, N> &high, Vector<T, N> &low) {             \
    for (int i = 0; i < N; ++i)                                                                              \
      name(a[i], b[i], high[i], low[i]);                                                                     \
  }

VOXC_CARRYING(uaddCarry)
VOXC_CARRYING(usubBorrow)
VOXC_EXTENDED(umulExtended)
VOXC_EXTENDED(imulExtended)

#undef VOXC_CARRYING
#undef VOXC_EXTENDED
#undef VOXC_UNARY
#undef VOXC_UNARY_LANES
#undef VOXC_BINARY
#undef VOXC_BINARY_LANES
#undef VOXC_COMPARISON

template <typename T, int N, typename Bound>
VOXC_INLINE Vector<T, N> clamp(Vector<T, N> value, Bound least, Bound most) {
  return min(max(value, least), most);
}
template <typename T, int N>
VOXC_INLINE Vector<T, N> mix(Vector<T, N> a, Vector<T, N> b, Vector<bool, N> takesB) {
  return vectorOf<T, N>(takesB.lanes ? b.lanes : a.lanes);
}

VOXC_INLINE float length(vec3 v) { return sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

template <int N> VOXC_INLINE bool all(Vector<bool, N> v) {
  int mask = -1;
  for (int i = 0; i < N; ++i)
    mask &= v.lanes[i];
  return mask != 0;
}
template <int N> VOXC_INLINE bool any(Vector<bool, N> v) { return !all(!v); }
template <typename T, int N> VOXC_INLINE bool operator==(Vector<T, N> a, Vector<T, N> b) {
  return all(equal(a, b));
}
template <typename T, int N> VOXC_INLINE bool operator!=(Vector<T, N> a, Vector<T, N> b) { return !(a == b); }

template <int N> VOXC_INLINE Vector<uint, N> floatBitsToUint(Vector<float, N> v) {
  return vectorOf<uint, N>((Lanes<uint, N>)v.lanes);
}
template <int N> VOXC_INLINE Vector<float, N> uintBitsToFloat(Vector<uint, N> v) {
  return vectorOf<float, N>((Lanes<float, N>)v.lanes);
}

} // namespace voxc::glsl
