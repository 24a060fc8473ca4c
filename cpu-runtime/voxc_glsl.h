// voxc_glsl.h: the built-in functions of GLSL that kernels call, in C++. Freestanding; for Clang 17 and GCC
// 12, or later ones.
#pragma once

#include "voxc_vector.h"

// Kernels want all functions in their loops, in registers, but for those that are seldom called.
#define OUT_OF_LINE [[gnu::noinline, gnu::cold]]
#ifdef __clang__
#define VOXC_BEGIN_INLINE _Pragma("clang attribute push(__attribute__((always_inline)), apply_to = function)")
#define VOXC_END_INLINE _Pragma("clang attribute pop")
#else
#define VOXC_BEGIN_INLINE
#define VOXC_END_INLINE
#endif

// A function of GCC's and Clang's, or what nvcc calls it on a device.
#if defined(__CUDA_ARCH__) && !defined(__clang__)
#define VOXC_BUILTIN(name, on_device) on_device
#else
#define VOXC_BUILTIN(name, on_device) __builtin_##name
#endif

namespace voxc::glsl {

template <typename T>
concept Number = __is_same(T, float) || __is_same(T, double) || __is_same(T, int) || __is_same(T, uint);

// Scalars. A NaN gives way to a number, as on every device that we know.
VOXC_INLINE float min(float a, float b) { return VOXC_BUILTIN(fminf, fminf)(a, b); }
VOXC_INLINE float max(float a, float b) { return VOXC_BUILTIN(fmaxf, fmaxf)(a, b); }
VOXC_INLINE double min(double a, double b) { return VOXC_BUILTIN(fmin, fmin)(a, b); }
VOXC_INLINE double max(double a, double b) { return VOXC_BUILTIN(fmax, fmax)(a, b); }
VOXC_INLINE int min(int a, int b) { return b < a ? b : a; }
VOXC_INLINE int max(int a, int b) { return a < b ? b : a; }
VOXC_INLINE uint min(uint a, uint b) { return b < a ? b : a; }
VOXC_INLINE uint max(uint a, uint b) { return a < b ? b : a; }
template <Number T> VOXC_INLINE T clamp(T value, Scalar<T> least, Scalar<T> most) {
  return min(max(value, least), most);
}
VOXC_INLINE float abs(float a) { return VOXC_BUILTIN(fabsf, fabsf)(a); }
VOXC_INLINE double abs(double a) { return VOXC_BUILTIN(fabs, fabs)(a); }
VOXC_INLINE int abs(int a) { return a < 0 ? -a : a; }
template <Number T> VOXC_INLINE T sign(T a) { return T(T(0) < a) - T(a < T(0)); }
VOXC_INLINE float floor(float a) { return VOXC_BUILTIN(floorf, floorf)(a); }
VOXC_INLINE double floor(double a) { return VOXC_BUILTIN(floor, floor)(a); }
VOXC_INLINE float ceil(float a) { return VOXC_BUILTIN(ceilf, ceilf)(a); }
VOXC_INLINE float trunc(float a) { return VOXC_BUILTIN(truncf, truncf)(a); }
VOXC_INLINE float roundEven(float a) { return VOXC_BUILTIN(roundevenf, rintf)(a); }
VOXC_INLINE float sqrt(float a) { return VOXC_BUILTIN(sqrtf, sqrtf)(a); }
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
VOXC_INLINE float fma(float a, float b, float c) { return VOXC_BUILTIN(fmaf, fmaf)(a, b, c); }
#else
// Where the sum is no float32, it may be rounded twice.
VOXC_INLINE float fma(float a, float b, float c) { return float(double(a) * double(b) + double(c)); }
#endif
VOXC_INLINE bool isnan(float a) { return VOXC_BUILTIN(isnan, isnan)(a); }
VOXC_INLINE bool isinf(float a) { return VOXC_BUILTIN(isinf, isinf)(a); }
VOXC_INLINE float ldexp(float a, int exponent) { return VOXC_BUILTIN(ldexpf, ldexpf)(a, exponent); }
template <typename T> VOXC_INLINE T mix(T a, T b, bool takesB) { return takesB ? b : a; }

VOXC_INLINE uint floatBitsToUint(float a) { return __builtin_bit_cast(uint, a); }
VOXC_INLINE int floatBitsToInt(float a) { return __builtin_bit_cast(int, a); }
VOXC_INLINE float uintBitsToFloat(uint a) { return __builtin_bit_cast(float, a); }
VOXC_INLINE float intBitsToFloat(int a) { return __builtin_bit_cast(float, a); }

// Bits. The position of a bit that is not there is -1.
VOXC_INLINE int bitCount(uint a) { return VOXC_BUILTIN(popcount, __popc)(a); }
VOXC_INLINE int findLSB(uint a) { return VOXC_BUILTIN(ffs, __ffs)(int(a)) - 1; }
VOXC_INLINE int findMSB(uint a) { return a == 0 ? -1 : 31 - VOXC_BUILTIN(clz, __clz)(a); }
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
  template <typename T> VOXC_INLINE Vector3<T> name(const Vector3<T> &v) {                                   \
    return {name(v.x), name(v.y), name(v.z)};                                                                \
  }
#define VOXC_BINARY(name)                                                                                    \
  template <typename T> VOXC_INLINE Vector3<T> name(const Vector3<T> &a, const Vector3<T> &b) {              \
    return {name(a.x, b.x), name(a.y, b.y), name(a.z, b.z)};                                                 \
  }                                                                                                          \
  template <typename T> VOXC_INLINE Vector3<T> name(const Vector3<T> &a, Scalar<T> b) {                      \
    return {name(a.x, b), name(a.y, b), name(a.z, b)};                                                       \
  }
#define VOXC_COMPARISON(name, op)                                                                            \
  template <typename T> VOXC_INLINE bvec3 name(const Vector3<T> &a, const Vector3<T> &b) {                   \
    return {a.x op b.x, a.y op b.y, a.z op b.z};                                                             \
  }

VOXC_UNARY(sign)
VOXC_UNARY(sqrt)
VOXC_UNARY(abs)
VOXC_UNARY(floor)
VOXC_UNARY(ceil)
VOXC_UNARY(trunc)
VOXC_UNARY(roundEven)
VOXC_BINARY(min)
VOXC_BINARY(max)
VOXC_COMPARISON(lessThan, <)
VOXC_COMPARISON(lessThanEqual, <=)
VOXC_COMPARISON(greaterThan, >)
VOXC_COMPARISON(greaterThanEqual, >=)
VOXC_COMPARISON(equal, ==)
VOXC_COMPARISON(notEqual, !=)

#undef VOXC_UNARY
#undef VOXC_BINARY
#undef VOXC_COMPARISON

template <typename T, typename Bound>
VOXC_INLINE Vector3<T> clamp(const Vector3<T> &value, Bound least, Bound most) {
  return min(max(value, least), most);
}
template <typename T>
VOXC_INLINE Vector3<T> mix(const Vector3<T> &a, const Vector3<T> &b, const bvec3 &takesB) {
  return {takesB.x ? b.x : a.x, takesB.y ? b.y : a.y, takesB.z ? b.z : a.z};
}

VOXC_INLINE float length(const vec3 &v) { return sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

VOXC_INLINE bool all(const bvec3 &v) { return v.x & v.y & v.z; }
VOXC_INLINE bool any(const bvec3 &v) { return v.x | v.y | v.z; }
template <typename T> VOXC_INLINE bool operator==(const Vector3<T> &a, const Vector3<T> &b) {
  return all(equal(a, b));
}
template <typename T> VOXC_INLINE bool operator!=(const Vector3<T> &a, const Vector3<T> &b) {
  return !(a == b);
}

VOXC_INLINE uvec3 floatBitsToUint(const vec3 &v) {
  return {floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z)};
}
VOXC_INLINE ivec3 floatBitsToInt(const vec3 &v) {
  return {floatBitsToInt(v.x), floatBitsToInt(v.y), floatBitsToInt(v.z)};
}
VOXC_INLINE vec3 uintBitsToFloat(const uvec3 &v) {
  return {uintBitsToFloat(v.x), uintBitsToFloat(v.y), uintBitsToFloat(v.z)};
}

} // namespace voxc::glsl
