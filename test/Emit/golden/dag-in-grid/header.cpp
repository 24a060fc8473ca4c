// voxc_r4_4_4_g8_*: rays through volumes of the format R(4, 4, 4) G(8), as functions for C++20.
//
//     bool voxc_r4_4_4_g8_closest(const unsigned int *words, vec3 origin, vec3 direction, float tmin, float tmax,
// voxc_r4_4_4_g8_Hit &hit)
//     bool voxc_r4_4_4_g8_next(const unsigned int *words, vec3 origin, vec3 direction, float tmax, voxc_r4_4_4_g8_Hit
// &hit)
//     bool voxc_r4_4_4_g8_any(const unsigned int *words, vec3 origin, vec3 direction, float tmin, float tmax)
//     vec3 voxc_r4_4_4_g8_normal(const voxc_r4_4_4_g8_Hit &hit)
//     vec3 voxc_r4_4_4_g8_outside(vec3 origin, vec3 direction, const voxc_r4_4_4_g8_Hit &hit)
//
// Rays are in voxels; a direction may have any length, and t counts in it. Vectors are of voxc_r4_4_4_g8_text::vec3,
// with x, y and z. All
// that this text leaves behind has a name that begins with voxc_r4_4_4_g8_ or VOXC_R4_4_4_G8_.
#pragma once

// The digest of the format's storage. The words of a volume are for these functions if its digest equals this one, and
// else lead
// anywhere: compare it with Volume::storageDigest(), or the digest that `voxc info` prints.
#define VOXC_R4_4_4_G8_FORMAT "R(4, 4, 4) G(8)"
#define VOXC_R4_4_4_G8_STORAGE_DIGEST 0xa67ebecd25ab0065ull

#pragma GCC system_header // No warnings: what a format has no use for stands here all the same.

// GLSL's vectors and built-in functions in C++.
namespace voxc_r4_4_4_g8_text {

// voxc_vector.h: the vectors of GLSL that kernels use, in C++: plain structures, since what runs several rays
// at once makes a wide register of each component. Freestanding; for Clang 17 and GCC 12, or later ones.

// What CUDA wants before a function that a device may call.
#ifndef VOXC_DEVICE
#define VOXC_DEVICE
#endif
#define VOXC_INLINE [[gnu::always_inline]] VOXC_DEVICE inline
// Where constants are made.
#define VOXC_CONSTANT [[gnu::always_inline]] VOXC_DEVICE constexpr

namespace voxc::glsl {

using uint = unsigned int;

/// The component of a vector whose number is known when the kernel runs: picked by comparisons, so that
/// vectors need no memory.
template <typename Vector, typename T> struct Component {
  Vector &vector;
  int number;

  VOXC_CONSTANT operator T() const { return static_cast<const Vector &>(vector)[number]; }
  VOXC_CONSTANT Component &operator=(T value) {
    vector.set(number, value);
    return *this;
  }
  VOXC_CONSTANT Component &operator=(const Component &other) { return *this = T(other); }
};

/// Three components. Copied one by one, and never as a block of memory, which optimisers take to pieces less
/// readily.
template <typename T> struct Vector3 {
  T x, y, z;

  Vector3() = default;
  VOXC_CONSTANT explicit Vector3(T all) : x(all), y(all), z(all) {}
  VOXC_CONSTANT Vector3(T x, T y, T z) : x(x), y(y), z(z) {}
  template <typename U>
  VOXC_CONSTANT explicit Vector3(const Vector3<U> &v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}
  VOXC_CONSTANT Vector3(const Vector3 &v) : x(v.x), y(v.y), z(v.z) {}
  VOXC_CONSTANT Vector3 &operator=(const Vector3 &v) {
    x = v.x;
    y = v.y;
    z = v.z;
    return *this;
  }
  VOXC_CONSTANT T operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  VOXC_CONSTANT Component<Vector3, T> operator[](int i) { return {*this, i}; }
  VOXC_CONSTANT void set(int i, T value) {
    x = i == 0 ? value : x;
    y = i == 1 ? value : y;
    z = i == 2 ? value : z;
  }
};

/// Four components, which kernels only keep.
template <typename T> struct Vector4 {
  T x, y, z, w;

  VOXC_CONSTANT Vector4(T x, T y, T z, T w) : x(x), y(y), z(z), w(w) {}
  VOXC_CONSTANT T operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
  VOXC_CONSTANT Component<Vector4, T> operator[](int i) { return {*this, i}; }
  VOXC_CONSTANT void set(int i, T value) {
    x = i == 0 ? value : x;
    y = i == 1 ? value : y;
    z = i == 2 ? value : z;
    w = i == 3 ? value : w;
  }
};

using vec3 = Vector3<float>;
using dvec3 = Vector3<double>;
using ivec3 = Vector3<int>;
using uvec3 = Vector3<uint>;
using bvec3 = Vector3<bool>;
using ivec4 = Vector4<int>;
using uvec4 = Vector4<uint>;

/// A type as a parameter that takes no part in deduction, so that any number converts to it.
template <typename T> struct Plain {
  using Type = T;
};
template <typename T> using Scalar = typename Plain<T>::Type;

#define VOXC_OPERATOR(op)                                                                                    \
  template <typename T> VOXC_INLINE Vector3<T> operator op(const Vector3<T> &a, const Vector3<T> &b) {       \
    return {T(a.x op b.x), T(a.y op b.y), T(a.z op b.z)};                                                    \
  }                                                                                                          \
  template <typename T> VOXC_INLINE Vector3<T> operator op(const Vector3<T> &a, Scalar<T> b) {               \
    return {T(a.x op b), T(a.y op b), T(a.z op b)};                                                          \
  }                                                                                                          \
  template <typename T> VOXC_INLINE Vector3<T> operator op(Scalar<T> a, const Vector3<T> &b) {               \
    return {T(a op b.x), T(a op b.y), T(a op b.z)};                                                          \
  }                                                                                                          \
  template <typename T, typename U> VOXC_INLINE Vector3<T> &operator op##=(Vector3<T> &a, const U & b) {     \
    return a = a op b;                                                                                       \
  }

VOXC_OPERATOR(+)
VOXC_OPERATOR(-)
VOXC_OPERATOR(*)
VOXC_OPERATOR(/)
VOXC_OPERATOR(%)
VOXC_OPERATOR(&)
VOXC_OPERATOR(|)
VOXC_OPERATOR(^)
VOXC_OPERATOR(<<)
VOXC_OPERATOR(>>)

#undef VOXC_OPERATOR

template <typename T> VOXC_INLINE Vector3<T> operator-(const Vector3<T> &v) { return {-v.x, -v.y, -v.z}; }
template <typename T> VOXC_INLINE Vector3<T> operator~(const Vector3<T> &v) { return {~v.x, ~v.y, ~v.z}; }
/// GLSL's function `not`, a word that C++ spells so as well.
VOXC_INLINE bvec3 operator!(const bvec3 &v) { return {!v.x, !v.y, !v.z}; }

} // namespace voxc::glsl

// voxc_glsl.h: the built-in functions of GLSL that kernels call, in C++. Freestanding; for Clang 17 and GCC
// 12, or later ones.


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

using namespace voxc::glsl;

#define VOXC_INDEX (unsigned long long)
#define VOXC_LOAD(volume, index) volume[index]

// Voxels along each axis.
const ivec3 voxc_r4_4_4_g8_VOLUME_SIZE = ivec3(4096, 4096, 4096);

static inline uint voxc_r4_4_4_g8_load_word(const unsigned int *volume, uint place) { return VOXC_LOAD(volume, place); }

// A ray, prepared for the traversal. Its members that are no integers are approximate; what must be exact is asked of
// the ray as given.
struct voxc_r4_4_4_g8_Ray {
  uvec3 given_origin;     // The bits of six float32 taken as exact numbers.
  uvec3 given_direction;
  vec3 origin;            // Where the traversal counts from: the given origin, or where a ray from far away enters.
  // Scaled so that the longest component is in [1, 2). Where a coordinate never changes it is LEAST_COMPONENT: that
  // passes no face before another does. All t are those of this direction, from this origin.
  vec3 direction;
  vec3 inverse;
  vec3 late;              // By how much each t comes late that is counted from there.
  float t_error;          // Absolute error bound of t, apart from a few rounding errors.
  vec3 origin_low;        // The least that is certain of the coordinates at the origin,
  float coordinate_error; // and how much more any coordinate on the way may be, in voxels.
  float cell_margin;      // A coordinate that is at least this far below the next whole number is in its cell.
  bvec3 moves;            // False on an axis whose coordinate never changes.
  bvec3 falls;            // The coordinate falls.
  bool plain;             // As given, it has no numbers but 0 and those whose significand has all its bits.
  ivec3 heading;          // -1 where the coordinate falls, else 1.
  // From a face that the ray passes to the cell behind it: -1 where the coordinate falls, else 0.
  vec3 beyond;
  ivec3 ahead;            // No bits where the coordinate falls, else all: picks the face of a cube that lies ahead.
};

// Empty cubes of 2^log2_side voxels a side: the one around a cell and, `count` a side, those that lie ahead of it.
struct voxc_r4_4_4_g8_EmptySpan {
  int log2_side;
  int count;
};

// How a ray leaves cells through the faces ahead.
struct voxc_r4_4_4_g8_Exit {
  float t;      // About when.
  bvec3 passed; // The axes whose faces it passes.
  bool sure;    // It is known to pass that one first.
};

// Where a ray is: the first cell not yet proved empty. Each step moves it by at least one cell, and never back.
struct voxc_r4_4_4_g8_Traversal {
  ivec3 cell;       // In voxels; outside the volume before and after the traversal.
  int axis;         // The axis on which the ray entered the cell; -1 where it started.
  uint voxel;       // Where the voxel that was hit is to be had, as the lowest level finds it.
  int steps_left;   // There are no more cells on any ray; a traversal with less than 0 is an error of the kernel's.
  // A step over an empty span around ~cell is pending: 32 times its count, and its log2_side. Else NO_PENDING_STEP.
  int pending_step;
  ivec3 begin;      // A traversal ends where it leaves the box of `size` cells from `begin` on.
  ivec3 size;
};

const int voxc_r4_4_4_g8_NO_PENDING_STEP = -1;
const int voxc_r4_4_4_g8_RETRY = -2; // The traversal is to be gone on with, from its cell, by the exact fallback.

const float voxc_r4_4_4_g8_NEVER = 1e30f; // A t that no ray of an ordinary length comes to.

// What is rounded on the way to a t, which is a difference, an inverse and a product. Where devices round to nearest,
// eight roundings: the order of two t is certain beyond 7 roundings of the earlier, and a coordinate within 7 of how
// far it may be from the origin. Else twelve roundings of 2^-23, whichever way each goes: an inverse takes 2.5 of them,
// the order of two t is certain beyond 11, and a coordinate within 9.5.
const float voxc_r4_4_4_g8_ROUNDINGS = 12.0f / 8388608.0f;

// A traversal that is about to begin, or to go on.
static inline voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_traversal_at(ivec3 cell) {
  int most_steps = voxc_r4_4_4_g8_VOLUME_SIZE.x + voxc_r4_4_4_g8_VOLUME_SIZE.y + voxc_r4_4_4_g8_VOLUME_SIZE.z;
  return voxc_r4_4_4_g8_Traversal(cell, -1, 0u, most_steps, voxc_r4_4_4_g8_NO_PENDING_STEP, ivec3(0),
      voxc_r4_4_4_g8_VOLUME_SIZE);
}

// Ends a traversal that takes more steps than any can.
static inline void voxc_r4_4_4_g8_count_step(voxc_r4_4_4_g8_Traversal &traversal) {
  traversal.steps_left--;
  traversal.cell.x |= traversal.steps_left >> 31; // All bits: outside, whatever follows.
}

static inline bool voxc_r4_4_4_g8_is_in_volume(ivec3 cell) {
  return all(lessThan(uvec3(cell), uvec3(voxc_r4_4_4_g8_VOLUME_SIZE)));
}

// Whether a traversal is in the box in which it may find something.
static inline bool voxc_r4_4_4_g8_is_in_reach(const voxc_r4_4_4_g8_Traversal &traversal) {
  return all(lessThan(uvec3(traversal.cell - traversal.begin), uvec3(traversal.size)));
}

// Whether a traversal has more to see here.
static inline bool voxc_r4_4_4_g8_goes_on(const voxc_r4_4_4_g8_Traversal &traversal) {
  return voxc_r4_4_4_g8_is_in_reach(traversal);
}

// The low corner of the aligned cube of 2^log2_side voxels a side around a cell.
static inline ivec3 voxc_r4_4_4_g8_corner_of(ivec3 cell, int log2_side) { return (cell >> log2_side) << log2_side; }

// The low corner of the cube of an empty span around a cell.
static inline ivec3 voxc_r4_4_4_g8_corner_of(const voxc_r4_4_4_g8_Ray &ray, ivec3 cell,
    const voxc_r4_4_4_g8_EmptySpan &span) {
  return voxc_r4_4_4_g8_corner_of(cell, span.log2_side) - (~ray.ahead & ((span.count - 1) << span.log2_side));
}

// The faces of an empty span around a cell that lie ahead.
static inline ivec3 voxc_r4_4_4_g8_faces_ahead(const voxc_r4_4_4_g8_Ray &ray, ivec3 cell,
    const voxc_r4_4_4_g8_EmptySpan &span) {
  int side = 1 << span.log2_side;
  // From the cube's low face to that of the empty span, where the coordinate falls.
  int back = side - (span.count << span.log2_side);
  return (cell & -side) + back + (ray.ahead & (side - back - back));
}

// About when each coordinate passes its face.
static inline vec3 voxc_r4_4_4_g8_times_of(const voxc_r4_4_4_g8_Ray &ray, vec3 face) {
  vec3 t = (face - ray.origin) * ray.inverse;
  return t - ray.late;
}

// The order of float32 numbers by their bits is one instruction where others would look for NaN. Negative ones are
// below all others, but of two of them the order is the other one: no t of a face ahead is negative but by rounding.

static inline float voxc_r4_4_4_g8_least_of(vec3 of) {
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(min(min(bits.x, bits.y), bits.z));
}

static inline float voxc_r4_4_4_g8_second_least_of(vec3 of) {
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(max(min(bits.x, bits.y), min(max(bits.x, bits.y), bits.z)));
}

static inline float voxc_r4_4_4_g8_greatest_of(vec3 of) {
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(max(max(bits.x, bits.y), bits.z));
}

// Float32 numbers as integers: significand * 2^(exponent - 150). No device flushes or rounds these.

const uint voxc_r4_4_4_g8_SIGN_BIT = 0x80000000u;
const uint voxc_r4_4_4_g8_INFINITY_BITS = 0x7f800000u;

// Below 2^24.
static inline uint voxc_r4_4_4_g8_significand_of(uint bits) {
  uint fraction = bits & 0x7fffffu;
  return (bits & voxc_r4_4_4_g8_INFINITY_BITS) == 0u ? fraction : fraction | 0x800000u;
}

static inline int voxc_r4_4_4_g8_exponent_of(uint bits) { return max(int(bits >> 23 & 0xffu), 1); }

static inline bool voxc_r4_4_4_g8_are_finite(uvec3 bits) {
  return all(lessThan(bits & voxc_r4_4_4_g8_INFINITY_BITS, uvec3(voxc_r4_4_4_g8_INFINITY_BITS)));
}

// True if each is 0 or has a significand of 24 bits, as devices do not always keep smaller ones.
static inline bool voxc_r4_4_4_g8_are_plain(uvec3 bits) {
  return all(greaterThanEqual((bits & ~voxc_r4_4_4_g8_SIGN_BIT) - 1u, uvec3(0x7fffffu)));
}

// 2^exponent, for exponents of normal numbers; the nearest such for others.
static inline float voxc_r4_4_4_g8_power_of_two(int exponent) {
  return uintBitsToFloat(uint(clamp(exponent, -126, 127) + 127) << 23);
}

// The bits of the longest component's magnitude.
static inline uint voxc_r4_4_4_g8_longest_of(uvec3 direction) {
  uvec3 size = direction & ~voxc_r4_4_4_g8_SIGN_BIT;
  return max(max(size.x, size.y), size.z);
}

// The largest whole numbers that are not above float32 numbers, within 2^22 of zero.
static inline ivec3 voxc_r4_4_4_g8_floor_of(uvec3 bits) {
  ivec3 whole = ivec3(clamp(floor(uintBitsToFloat(bits)), -4194304.0f, 4194304.0f));
  // Below 1, a denormal number may not survive arithmetic.
  ivec3 small = -ivec3(greaterThan(bits, uvec3(voxc_r4_4_4_g8_SIGN_BIT)));
  return mix(whole, small, lessThan(bits & ~voxc_r4_4_4_g8_SIGN_BIT, uvec3(0x3f800000u)));
}

// The exact sign of a sum of four products of float32 numbers.

// A sum in two's complement, times 2^(exponent - 300). Its sign is exact, its value within 2^-11 of itself.
struct voxc_r4_4_4_g8_Sum {
  int high;
  uint low;
  int exponent;
};

static inline int voxc_r4_4_4_g8_sign_of(const voxc_r4_4_4_g8_Sum &sum) {
  return sum.high < 0 ? -1 : (uint(sum.high) | sum.low) != 0u ? 1 : 0;
}

// The largest p for which 2^p is not above the magnitude; -1 for 0, and for -1 too.
static inline int voxc_r4_4_4_g8_log2_of(const voxc_r4_4_4_g8_Sum &sum) {
  uint flip = uint(sum.high >> 31);
  uint high = uint(sum.high) ^ flip;
  return findMSB(high != 0u ? high : sum.low ^ flip) + (high != 0u ? 32 : 0);
}

// Makes `shift` bits, at most 61, of room at the low end.
static inline void voxc_r4_4_4_g8_shift_left(voxc_r4_4_4_g8_Sum &sum, int shift) {
  uint high = uint(sum.high);
  if (shift >= 32) {
    high = sum.low << (shift - 32);
    sum.low = 0u;
  } else if (shift > 0) {
    high = high << shift | sum.low >> (32 - shift);
    sum.low <<= shift;
  }
  sum.high = int(high);
  sum.exponent -= shift;
}

static inline void voxc_r4_4_4_g8_add(voxc_r4_4_4_g8_Sum &sum, uint high, uint low, bool negative) {
  uint flip = negative ? ~0u : 0u;
  uint carry_of_low, carry_of_sign;
  uint partial = uaddCarry(sum.low, low ^ flip, carry_of_low);
  sum.low = uaddCarry(partial, flip & 1u, carry_of_sign);
  sum.high = int(uint(sum.high) + (high ^ flip) + carry_of_low + carry_of_sign);
}

// a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w, of bits of float32. A product is below 2^48 times its power of two.
// They are added from the largest power down; once the sum has 61 bits at the next power, all that is left is too small
// to change its sign.
[[gnu::noinline, gnu::cold, maybe_unused]] static voxc_r4_4_4_g8_Sum voxc_r4_4_4_g8_sum_of_products(uvec4 a, uvec4 b) {
  ivec4 exponent = ivec4(voxc_r4_4_4_g8_exponent_of(a.x) + voxc_r4_4_4_g8_exponent_of(b.x),
      voxc_r4_4_4_g8_exponent_of(a.y) + voxc_r4_4_4_g8_exponent_of(b.y),
      voxc_r4_4_4_g8_exponent_of(a.z) + voxc_r4_4_4_g8_exponent_of(b.z),
      voxc_r4_4_4_g8_exponent_of(a.w) + voxc_r4_4_4_g8_exponent_of(b.w));
  voxc_r4_4_4_g8_Sum sum = voxc_r4_4_4_g8_Sum(0, 0u, 0);
  int left = 4;
  while (left > 0) {
    int largest = max(max(exponent.x, exponent.y), max(exponent.z, exponent.w));
    int next = exponent.x == largest ? 0 : exponent.y == largest ? 1 : exponent.z == largest ? 2 : 3;
    uint high, low;
    umulExtended(voxc_r4_4_4_g8_significand_of(a[next]), voxc_r4_4_4_g8_significand_of(b[next]), high, low);
    if (voxc_r4_4_4_g8_sign_of(sum) == 0)
      sum.exponent = largest;
    int shift = sum.exponent - largest;
    exponent[next] = -1;
    left--;
    if (voxc_r4_4_4_g8_log2_of(sum) + shift >= 61) {
      left = 0;
    } else {
      voxc_r4_4_4_g8_shift_left(sum, shift);
      voxc_r4_4_4_g8_add(sum, high, low, (a[next] ^ b[next]) >= voxc_r4_4_4_g8_SIGN_BIT);
    }
  }
  return sum;
}

// sum / divisor in plain float32.
static inline float voxc_r4_4_4_g8_quotient(const voxc_r4_4_4_g8_Sum &sum, uint divisor) {
  bool negative = sum.high < 0;
  voxc_r4_4_4_g8_Sum magnitude = voxc_r4_4_4_g8_Sum(0, 0u, sum.exponent);
  voxc_r4_4_4_g8_add(magnitude, uint(sum.high), sum.low, negative);
  float value = float(magnitude.high) * 4294967296.0f + float(magnitude.low);
  float size = value / float(voxc_r4_4_4_g8_significand_of(divisor)) * voxc_r4_4_4_g8_power_of_two(sum.exponent
      - voxc_r4_4_4_g8_exponent_of(divisor) - 150);
  return negative != (divisor >= voxc_r4_4_4_g8_SIGN_BIT) ? -size : size;
}

// The moments at which a ray changes cell, in exact order. Cells are half-open, so where several coordinates pass a
// face at one t, rising ones change cell first, falling ones just after.

// A change of cell.
struct voxc_r4_4_4_g8_Crossing {
  float t;     // Approximate.
  int axis;    // One that changes,
  int face;    // and the face that it passes.
  ivec3 step;  // The change, a cell at most on each axis.
  bool rising; // Only rising coordinates change: those that fall may still stand on a boundary.
};

// The change of cell where a ray leaves a cube through the faces ahead: `crossed` tells the axes whose coordinates pass
// them first, about at t.
static inline voxc_r4_4_4_g8_Crossing voxc_r4_4_4_g8_crossing_of(const voxc_r4_4_4_g8_Ray &ray, ivec3 face, float t,
    bvec3 crossed) {
  ivec3 changes = mix(ivec3(0), ray.heading, crossed);
  ivec3 risen = max(changes, ivec3(0));
  voxc_r4_4_4_g8_Crossing crossing;
  crossing.rising = risen != ivec3(0);
  crossing.step = crossing.rising ? risen : changes;
  crossing.axis = crossing.step.x != 0 ? 0 : crossing.step.y != 0 ? 1 : 2;
  crossing.t = t;
  crossing.face = face[crossing.axis];
  return crossing;
}

// Cells from `least` to `most`.
struct voxc_r4_4_4_g8_Range {
  ivec3 least;
  ivec3 most;
};

// How far coordinate a is behind at_a when coordinate b passes at_b, with the sign of both speeds:
// (at_a - origin_a) * direction_b - (at_b - origin_b) * direction_a.
static inline voxc_r4_4_4_g8_Sum voxc_r4_4_4_g8_crossing_difference(const voxc_r4_4_4_g8_Ray &ray, int a, float at_a,
    int b, float at_b) {
  uint speed_a = ray.given_direction[a];
  uint speed_b = ray.given_direction[b];
  return voxc_r4_4_4_g8_sum_of_products(uvec4(floatBitsToUint(at_a), ray.given_origin[a] ^ voxc_r4_4_4_g8_SIGN_BIT,
      floatBitsToUint(at_b) ^ voxc_r4_4_4_g8_SIGN_BIT, ray.given_origin[b]), uvec4(speed_b, speed_b, speed_a, speed_a));
}

// -1 if coordinate a passes its face first, 0 if both pass theirs at the same t, else 1. Both move.
[[gnu::noinline, gnu::cold, maybe_unused]] static int voxc_r4_4_4_g8_compare_exactly(const voxc_r4_4_4_g8_Ray &ray,
    int a, int face_a, int b, int face_b) {
  voxc_r4_4_4_g8_Sum difference = voxc_r4_4_4_g8_crossing_difference(ray, a, float(face_a), b, float(face_b));
  int order = voxc_r4_4_4_g8_sign_of(difference);
  return ray.falls[a] == ray.falls[b] ? order : -order;
}

// The same, by doubles where they can decide.
static inline int voxc_r4_4_4_g8_compare_crossings(const voxc_r4_4_4_g8_Ray &ray, int a, int face_a, int b,
    int face_b) {
  return voxc_r4_4_4_g8_compare_exactly(ray, a, face_a, b, face_b);
}

static inline int voxc_r4_4_4_g8_undecided_axis(const voxc_r4_4_4_g8_Range &range) {
  return range.least.x != range.most.x ? 0 : range.least.y != range.most.y ? 1 : 2;
}

static inline int voxc_r4_4_4_g8_middle_of(const voxc_r4_4_4_g8_Range &range, int axis) {
  return range.least[axis] + (range.most[axis] - range.least[axis] + 1) / 2;
}

// Takes away from a range what lies to one side of a face, where `order` compares it with the crossing.
static inline void voxc_r4_4_4_g8_narrow(const voxc_r4_4_4_g8_Ray &ray, const voxc_r4_4_4_g8_Crossing &crossing,
    int axis, int face, int order, voxc_r4_4_4_g8_Range &range) {
  bool falls = ray.falls[axis];
  bool passed = order < 0 || (order == 0 && !(falls && crossing.rising));
  if (passed != falls)
    range.least[axis] = face;
  else
    range.most[axis] = face - 1;
}

// Narrows a range down, on each axis, to the cell that the ray is in once a crossing has happened.
[[gnu::noinline, gnu::cold, maybe_unused]] static ivec3 voxc_r4_4_4_g8_resolve_cell(const voxc_r4_4_4_g8_Ray &ray,
    const voxc_r4_4_4_g8_Crossing &crossing, const voxc_r4_4_4_g8_Range &candidates) {
  voxc_r4_4_4_g8_Range range = candidates;
  while (range.least != range.most) {
    int axis = voxc_r4_4_4_g8_undecided_axis(range);
    int face = voxc_r4_4_4_g8_middle_of(range, axis);
    voxc_r4_4_4_g8_narrow(ray, crossing, axis, face, voxc_r4_4_4_g8_compare_crossings(ray, axis, face, crossing.axis,
        crossing.face), range);
  }
  return range.least;
}

// What can be told, without integers, of the cell, within a range, that the ray is in once a crossing has happened.
static inline voxc_r4_4_4_g8_Range voxc_r4_4_4_g8_approximate_cell(const voxc_r4_4_4_g8_Ray &ray,
    const voxc_r4_4_4_g8_Crossing &crossing, const voxc_r4_4_4_g8_Range &range) {
  vec3 point = ray.origin_low + crossing.t * ray.direction;
  vec3 bound = mix(vec3(0.0f), vec3(ray.coordinate_error), ray.moves);
  vec3 least = vec3(range.least);
  vec3 most = vec3(range.most);
  return voxc_r4_4_4_g8_Range(ivec3(clamp(floor(point), least, most)), ivec3(clamp(floor(point + bound), least, most)));
}

// Steps that are exact for every ray: by float32 or doubles where these can decide, by integers elsewhere.

// How the ray leaves cells through the first of the faces ahead. Not sure if its t cannot decide which that is.
static inline voxc_r4_4_4_g8_Exit voxc_r4_4_4_g8_leave(const voxc_r4_4_4_g8_Ray &ray, vec3 face) {
  vec3 t = voxc_r4_4_4_g8_times_of(ray, face);
  float first = voxc_r4_4_4_g8_least_of(t);
  float second = voxc_r4_4_4_g8_second_least_of(t); // Of negative ones, none that is sure.
  return voxc_r4_4_4_g8_Exit(first, equal(t, vec3(first)),
      second > first + (first * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error));
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Not sure if
// its point cannot decide on which side of another face that is.
static inline ivec3 voxc_r4_4_4_g8_cell_beyond(const voxc_r4_4_4_g8_Ray &ray, vec3 face, voxc_r4_4_4_g8_Exit &leaving) {
  vec3 point = mix(ray.origin_low + leaving.t * ray.direction, face + ray.beyond, leaving.passed);
  vec3 whole = floor(point);
  bool is_certain = voxc_r4_4_4_g8_greatest_of(point - whole) < ray.cell_margin;
  leaving.sure = leaving.sure && is_certain;
  return ivec3(whole);
}

// Resolves the step over the empty span around the traversal's cell: which faces the ray passes first, of those that
// float32 cannot decide apart, and then by bisection to which cell it comes. All questions are asked at one place,
// since devices of wide vectors run through it as often as any ray needs it. Where the device cuts it short, the
// traversal stays where it is.
[[gnu::noinline, gnu::cold,
    maybe_unused]] static voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_exact_step(const voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal traversal, const voxc_r4_4_4_g8_EmptySpan &span) {
  int side = span.count << span.log2_side;
  ivec3 corner = voxc_r4_4_4_g8_corner_of(ray, traversal.cell, span);
  ivec3 face = corner + (ray.ahead & side);
  vec3 t = voxc_r4_4_4_g8_times_of(ray, vec3(face));
  float earliest = min(min(t.x, t.y), t.z);
  bvec3 may_be_first = lessThanEqual(t, vec3(earliest + (earliest * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error)));
  ivec3 bits = ivec3(may_be_first) * ivec3(ray.moves);
  int axes = bits.x | bits.y << 1 | bits.z << 2;
  int first = findLSB(uint(axes));
  axes &= axes - 1;
  bvec3 crossed = bvec3(first == 0, first == 1, first == 2);
  voxc_r4_4_4_g8_Crossing crossing;
  voxc_r4_4_4_g8_Range range = voxc_r4_4_4_g8_Range(ivec3(0), ivec3(1));
  bool orders = true;
  int order = 0;
  while (range.least != range.most) {
    if (orders && axes == 0) {
      orders = false;
      crossing = voxc_r4_4_4_g8_crossing_of(ray, face, earliest, crossed);
      ivec3 target = corner + crossing.step * side;
      range = voxc_r4_4_4_g8_approximate_cell(ray, crossing, voxc_r4_4_4_g8_Range(target, target + (side - 1)));
    }
    if (orders || range.least != range.most) {
      int axis = orders ? findLSB(uint(axes)) : voxc_r4_4_4_g8_undecided_axis(range);
      int at = orders ? face[axis] : voxc_r4_4_4_g8_middle_of(range, axis);
      order = voxc_r4_4_4_g8_compare_crossings(ray, axis, at, first, face[first]);
      if (!orders) {
        voxc_r4_4_4_g8_narrow(ray, crossing, axis, at, order, range);
      } else {
        if (order <= 0) {
          bvec3 others = order < 0 ? bvec3(false) : crossed;
          crossed = bvec3(others.x || axis == 0, others.y || axis == 1, others.z || axis == 2);
          first = axis;
        }
        axes &= axes - 1;
      }
    }
  }
  if (range.least == range.most) {
    traversal.cell = range.least;
    traversal.axis = crossing.axis;
  }
  return traversal;
}

// Resolves the step of a traversal that is pending.
static inline void voxc_r4_4_4_g8_resolve_step(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal) {
  voxc_r4_4_4_g8_EmptySpan span = voxc_r4_4_4_g8_EmptySpan(traversal.pending_step & 31, traversal.pending_step >> 5);
  traversal.pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
  traversal.cell = ~traversal.cell;
  traversal = voxc_r4_4_4_g8_exact_step(ray, traversal, span);
}

// Steps from one cell of the ray to the next.

// Ends a step over the empty span around the traversal's cell, or over that and more, which leads to another cell if
// that is sure.
static inline void voxc_r4_4_4_g8_end_step(voxc_r4_4_4_g8_Traversal &traversal, const voxc_r4_4_4_g8_Exit &leaving,
    ivec3 cell, const voxc_r4_4_4_g8_EmptySpan &span) {
  traversal.axis = leaving.passed.z ? 2 : leaving.passed.y ? 1 : 0;
  bool sure = leaving.sure;
  // A step that is not sure is left pending, and all loops end: what resolves it stands outside of them, where lanes
  // that are sure need not wait for it.
  // The next turn may read what is there before it is known if the step is sure.
  traversal.cell = sure ? cell : ~traversal.cell;
  traversal.pending_step = sure ? voxc_r4_4_4_g8_NO_PENDING_STEP : span.count << 5 | span.log2_side;
  voxc_r4_4_4_g8_count_step(traversal);
}

// Steps over the empty span around the traversal's cell, of which these faces lie ahead.
static inline void voxc_r4_4_4_g8_step_over(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal,
    const voxc_r4_4_4_g8_EmptySpan &span, vec3 face) {
  voxc_r4_4_4_g8_Exit leaving = voxc_r4_4_4_g8_leave(ray, face);
  ivec3 cell = voxc_r4_4_4_g8_cell_beyond(ray, face, leaving);
  voxc_r4_4_4_g8_end_step(traversal, leaving, cell, span);
}

// Steps over the empty span around the traversal's cell.
static inline void voxc_r4_4_4_g8_step_over(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal,
    const voxc_r4_4_4_g8_EmptySpan &span) {
  voxc_r4_4_4_g8_step_over(ray, traversal, span, vec3(voxc_r4_4_4_g8_faces_ahead(ray, traversal.cell, span)));
}

// Steps over the empty cube of 2^log2_side voxels a side around the traversal's cell.
static inline void voxc_r4_4_4_g8_step_over(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal,
    int log2_side) {
  voxc_r4_4_4_g8_step_over(ray, traversal, voxc_r4_4_4_g8_EmptySpan(log2_side, 1));
}

// Steps from the traversal's voxel, which is empty, to the next.
static inline void voxc_r4_4_4_g8_step_over_voxel(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal) {
  voxc_r4_4_4_g8_Exit leaving = voxc_r4_4_4_g8_leave(ray, vec3(traversal.cell - ray.ahead));
  voxc_r4_4_4_g8_end_step(traversal, leaving, traversal.cell + mix(ivec3(0), ray.heading, leaving.passed),
      voxc_r4_4_4_g8_EmptySpan(0, 1));
}

// Rays that begin far away, whose numbers would be too wrong to tell anything of a volume: they are moved along
// themselves until they begin near it.
// A ray is moved by a moment of which 12 bits are set, so that the moment times the upper 12 bits of a component of the
// direction is a float32, and times the lower 12 bits too: no product is rounded. What is summed up is kept as two
// float32, `high` and `low`, of which the lower one is wrong by a few of its own roundings. A ray that comes to the
// volume after a moment M, D < 2 M voxels long, begins at most the volume's size and D away from it, so that a move
// loses less than 2^-43 (2 D + far_away()), whichever way sums are rounded. It ends before the volume, at 2^-11 of the
// distance.
// A move keeps where the ray goes, so that nothing that is exact is touched: only what float32 says of it.

// The distance in voxels beyond which a ray is far.
static inline float voxc_r4_4_4_g8_far_away() {
  int side = max(max(voxc_r4_4_4_g8_VOLUME_SIZE.x, voxc_r4_4_4_g8_VOLUME_SIZE.y), voxc_r4_4_4_g8_VOLUME_SIZE.z);
  // In doubles, of a component that was raised to LEAST_COMPONENT, a t that is not larger makes less than one rounding.
  return float(2 * side);
}

// What is known of a ray that may have been moved.
struct voxc_r4_4_4_g8_Start {
  bool is_far;   // It still begins far away, and float32 tells nothing of it.
  float wrong;   // What may be wrong of its coordinates, beside a few roundings,
  float t_error; // and of a t.
};

static inline bool voxc_r4_4_4_g8_is_far(vec3 coordinate, bvec3 moves) {
  return any(greaterThan(abs(coordinate), mix(vec3(voxc_r4_4_4_g8_NEVER), vec3(voxc_r4_4_4_g8_far_away()), moves)));
}

// Moves coordinates. Those in float32 are sums of two: what the first sum loses is added to the second. Doubles lose
// one rounding of 2^-53.
static inline void voxc_r4_4_4_g8_move_by(vec3 way, vec3 &high, vec3 &low) {
  vec3 sum = high + way;
  vec3 of_way = sum - high;
  vec3 of_high = sum - of_way;
  vec3 lost = (high - of_high) + (way - of_way);
  high = sum;
  low += lost;
}

// Moves a ray that begins far away, to before the last of the faces by which it enters the volume. Once is enough up to
// a thousand times that distance.
static inline voxc_r4_4_4_g8_Start voxc_r4_4_4_g8_come_near(voxc_r4_4_4_g8_Ray &ray, vec3 face) {
  const uint UPPER = 0xfffff000u; // The bits of a float32 but the lowest 12 of its significand.
  const int MOST_MOVES = 3;
  // No ordinary ray is, if none comes near.
  voxc_r4_4_4_g8_Start start = voxc_r4_4_4_g8_Start(voxc_r4_4_4_g8_is_far(ray.origin, ray.moves), 0.0f, 0.0f);
  if (!start.is_far)
    return start;
  vec3 direction = mix(vec3(0.0f), ray.direction, ray.moves);
  const float LAST = 18446744073709551616.0f; // 2^64, at least as many voxels away.
  vec3 upper = uintBitsToFloat(floatBitsToUint(direction) & UPPER);
  vec3 high = ray.origin, low = vec3(0.0f);
  float latest = 0.0f;
  for (int moves = 0; moves < MOST_MOVES && start.is_far; moves++) {
    vec3 t = mix(vec3(-voxc_r4_4_4_g8_NEVER), (face - high) * ray.inverse, ray.moves);
    latest = max(max(t.x, t.y), t.z);
    bool is_ahead = latest > 0.0f && latest < LAST;
    float moment = is_ahead ? uintBitsToFloat(floatBitsToUint(latest * (1.0f - 1.0f / 1048576.0f)) & UPPER) : 0.0f;
    start.wrong += (4.0f * moment + voxc_r4_4_4_g8_far_away()) / 8796093022208.0f; // 2^43.
    voxc_r4_4_4_g8_move_by(moment * upper, high, low);
    voxc_r4_4_4_g8_move_by(moment * (direction - upper), high, low);
    latest -= moment;
    start.is_far = voxc_r4_4_4_g8_is_far(high, ray.moves);
  }
  vec3 whole = high + low;
  vec3 behind = low - (whole - high);
  ray.origin = start.is_far ? ray.origin : whole;
  ray.late = start.is_far ? ray.late : mix(vec3(0.0f), behind * ray.inverse, ray.moves);
  vec3 steep = abs(ray.inverse);
  // A t is rounded once more by what comes late, and none in the volume is above that of its last entry and the longest
  // side, which is half of what is far.
  steep = mix(vec3(0.0f), steep, ray.moves);
  start.t_error = 2.0f * start.wrong * max(max(steep.x, steep.y),
      steep.z) + (latest + 0.5f * voxc_r4_4_4_g8_far_away()) * voxc_r4_4_4_g8_ROUNDINGS / 4.0f;
  start.wrong += voxc_r4_4_4_g8_far_away() / 4194304.0f; // What is behind, and that rounding.
  return start;
}

// Where a traversal begins: in the cell of the ray's origin, or in the first cell of the volume that the ray comes to.

const float voxc_r4_4_4_g8_CLOSE = 1.0f / 2048.0f; // In voxels.

// Bounds what float32 gets wrong in a traversal through the volume, where the origin itself is wrong by `of_origin`,
// and a t by `t_error`. A coordinate that never changes stays in its cell.
static inline void voxc_r4_4_4_g8_bound_errors(voxc_r4_4_4_g8_Ray &ray, vec3 cell, float of_origin, float t_error) {
  vec3 half_size = 0.5f * vec3(voxc_r4_4_4_g8_VOLUME_SIZE);
  vec3 reach = abs(ray.origin - half_size) + half_size; // To the farther of the volume's two faces.
  float error = voxc_r4_4_4_g8_greatest_of(reach) * voxc_r4_4_4_g8_ROUNDINGS + of_origin;
  error = min(error + 2.0f * t_error, voxc_r4_4_4_g8_NEVER);
  ray.t_error = t_error;
  ray.origin_low = mix(cell + 0.25f, ray.origin - error, ray.moves);
  ray.coordinate_error = 2.0f * error;
  ray.cell_margin = 1.0f - ray.coordinate_error;
}

// True where the ray moves from a coordinate so close to 0 that it may pass that face before float32 says so, as scaled
// directions have no component below 2^-60.
static inline bvec3 voxc_r4_4_4_g8_starts_tiny(const voxc_r4_4_4_g8_Ray &ray) {
  const uint TINY_BITS = 0x30800000u; // Of 2^-30.
  uvec3 size = ray.given_origin & ~voxc_r4_4_4_g8_SIGN_BIT;
  bvec3 tiny = lessThan(size - 1u, uvec3(TINY_BITS - 1u));
  return greaterThan(ivec3(tiny) * ivec3(ray.moves), ivec3(0));
}

// Of the axes that let the ray into their slab at a face, the last, where a falling one comes after a rising one.
static inline int voxc_r4_4_4_g8_last_entered(const voxc_r4_4_4_g8_Ray &ray, bvec3 enters, ivec3 face) {
  int last = -1;
  for (int axis = 0; axis < 3; axis++) {
    if (enters[axis]) {
      int order = last < 0 ? 1 : voxc_r4_4_4_g8_compare_crossings(ray, axis, face[axis], last, face[last]);
      if (order > 0 || (order == 0 && ray.falls[axis]))
        last = axis;
    }
  }
  return last;
}

// The coordinate, kept within a voxel of the volume, that a ray has where it passes a face. Each turn leaves less than
// 2^-10 of the error of the guess before, and what float32 rounds.
static inline float voxc_r4_4_4_g8_coordinate_at(const voxc_r4_4_4_g8_Ray &ray, int axis, int face, int other) {
  float size = float(voxc_r4_4_4_g8_VOLUME_SIZE[other]);
  float at = 0.5f * size;
  for (float error = size; error > voxc_r4_4_4_g8_CLOSE; error *= 1.0f / 1024.0f) {
    float move = voxc_r4_4_4_g8_quotient(voxc_r4_4_4_g8_crossing_difference(ray, axis, float(face), other, at),
        ray.given_direction[axis]);
    at = clamp(at + move, -1.0f, size + 1.0f);
  }
  return at;
}

// Lets a ray from far away start where it passes a face, so that its errors do not grow with its distance.
static inline void voxc_r4_4_4_g8_start_at(voxc_r4_4_4_g8_Ray &ray, ivec3 cell, int axis, int face) {
  float error = 0.0f;
  for (int other = 0; other < 3; other++) {
    if (other == axis) {
      ray.origin[other] = float(face);
    } else if (ray.moves[other]) {
      ray.origin[other] = voxc_r4_4_4_g8_coordinate_at(ray, axis, face, other);
      // More than a few roundings.
      error = max(error, voxc_r4_4_4_g8_CLOSE + voxc_r4_4_4_g8_CLOSE * abs(ray.origin[other]) / 256.0f);
    }
  }
  vec3 steep = mix(vec3(0.0f), abs(ray.inverse), ray.moves);
  ray.late = vec3(0.0f);
  voxc_r4_4_4_g8_bound_errors(ray, vec3(cell), error, 2.0f * error * max(max(steep.x, steep.y), steep.z));
}

// Puts a traversal into the cell that the ray comes to where it passes a face, in exact arithmetic. `cell` tells the
// coordinates that never change.
static inline voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_behind_face(const voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal traversal, ivec3 cell, int axis, int face) {
  voxc_r4_4_4_g8_Crossing crossing;
  crossing.t = (float(face) - ray.origin[axis]) * ray.inverse[axis] - ray.late[axis];
  crossing.axis = axis;
  crossing.face = face;
  crossing.rising = !ray.falls[axis];
  voxc_r4_4_4_g8_Range range = voxc_r4_4_4_g8_Range(mix(cell, ivec3(-1), ray.moves), mix(cell,
      voxc_r4_4_4_g8_VOLUME_SIZE, ray.moves));
  range.most[axis] = face - (ray.falls[axis] ? 1 : 0);
  range.least[axis] = range.most[axis];
  range = voxc_r4_4_4_g8_approximate_cell(ray, crossing, range);
  ivec3 behind = range.least;
  behind = voxc_r4_4_4_g8_resolve_cell(ray, crossing, range);
  traversal.cell = behind;
  traversal.axis = axis;
  return traversal;
}

// Finds the cell in which the ray enters the volume, in exact arithmetic: that of its origin, or through the last of
// the faces that it must pass. A cell outside if there is none.
[[gnu::noinline, gnu::cold,
    maybe_unused]] static voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_entered_exactly(voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal traversal, bool starts_far) {
  ivec3 cell = voxc_r4_4_4_g8_floor_of(ray.given_origin);
  ivec3 below = ivec3(lessThan(cell, ivec3(0)));
  ivec3 above = ivec3(greaterThanEqual(cell, voxc_r4_4_4_g8_VOLUME_SIZE));
  ivec3 enters = below * (ivec3(ray.moves) - ivec3(ray.falls)) + above * ivec3(ray.falls);
  traversal.cell = cell;
  if (enters == ivec3(0) || enters != below + above)
    return traversal;
  ivec3 face = mix(ivec3(0), voxc_r4_4_4_g8_VOLUME_SIZE, ray.falls);
  int axis = voxc_r4_4_4_g8_last_entered(ray, greaterThan(enters, ivec3(0)), face);
  if (starts_far)
    voxc_r4_4_4_g8_start_at(ray, cell, axis, face[axis]);
  return voxc_r4_4_4_g8_behind_face(ray, traversal, cell, axis, face[axis]);
}

// The same by float32 or doubles, of an ordinary ray: it passes the last of these faces, or is past all of them. Not
// sure if that cannot decide which face is the last, or which cell is behind it.
static inline voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_entered(const voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal traversal, vec3 face, bool &sure) {
  // 2^48: a ray of a voxel a moment is past the volume by then, whatever enters last.
  const float LATEST = 281474976710656.0f;
  // A coordinate that never changes stays outside.
  vec3 t = mix(vec3(-1.0f), voxc_r4_4_4_g8_times_of(ray, face), ray.moves);
  bool is_as_given = ray.t_error == 0.0f; // Else it has come near, and does not begin here.
  // From a last face, which is not in the volume, a ray enters at 0; its t is a 0 with a sign.
  vec3 last_face = mix(vec3(voxc_r4_4_4_g8_NEVER), face, ray.falls);
  bvec3 on_face = equal(ray.origin, is_as_given ? last_face : vec3(voxc_r4_4_4_g8_NEVER));
  t = mix(t, vec3(0.0f), on_face);
  float latest = min(voxc_r4_4_4_g8_greatest_of(t), LATEST);
  float before = voxc_r4_4_4_g8_second_least_of(t);
  bvec3 passed = equal(t, vec3(latest));
  bool begins_here = !(latest > 0.0f) && is_as_given && !any(on_face);
  vec3 point = mix(ray.origin_low + latest * ray.direction, face + ray.beyond, passed);
  point = begins_here ? ray.origin : point;
  vec3 whole = floor(point);
  bool is_last = before < latest - (latest * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error);
  bool is_certain = voxc_r4_4_4_g8_greatest_of(point - whole) < ray.cell_margin;
  bool is_sure = begins_here || (is_last && is_certain);
  sure = sure && is_sure;
  traversal.cell = ivec3(clamp(whole, -1.0f, 4194304.0f));
  traversal.axis = begins_here ? -1 : passed.x ? 0 : passed.y ? 1 : 2;
  return traversal;
}

// True if a coordinate is past the volume, and goes on.
static inline bool voxc_r4_4_4_g8_leaves_volume(const voxc_r4_4_4_g8_Ray &ray) {
  ivec3 below = ivec3(lessThan(ray.origin, vec3(0.0f)));
  ivec3 above = ivec3(greaterThanEqual(ray.origin, vec3(voxc_r4_4_4_g8_VOLUME_SIZE)));
  return mix(above, below, ray.falls) != ivec3(0);
}

// Puts the traversal into the first cell of the volume on the ray; false if there is none, or if the ray is left.
static inline bool voxc_r4_4_4_g8_enter_volume(voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal,
    bool ordinary) {
  if (ordinary && voxc_r4_4_4_g8_leaves_volume(ray))
    return false;
  vec3 face = mix(vec3(0.0f), vec3(voxc_r4_4_4_g8_VOLUME_SIZE), ray.falls);
  vec3 cell = floor(ray.origin);
  voxc_r4_4_4_g8_Start near = voxc_r4_4_4_g8_come_near(ray, face);
  if (!ordinary && any(voxc_r4_4_4_g8_starts_tiny(ray)))
    near.t_error = voxc_r4_4_4_g8_NEVER;
  voxc_r4_4_4_g8_bound_errors(ray, cell, near.wrong, near.t_error);
  bool has_begun = voxc_r4_4_4_g8_is_in_volume(traversal.cell) || traversal.pending_step >= 0;
  if (has_begun && !near.is_far)
    return true; // Where it has entered need not be found again.
  bool sure = ordinary && !near.is_far;
  voxc_r4_4_4_g8_Traversal start = voxc_r4_4_4_g8_entered(ray, traversal, face, sure);
  if (!sure) {
    // What a function may change by reference stands in memory; the ray itself need not.
    voxc_r4_4_4_g8_Ray moved = ray;
    start = voxc_r4_4_4_g8_entered_exactly(moved, traversal, near.is_far);
    ray = moved;
  }
  traversal = start;
  return voxc_r4_4_4_g8_is_in_volume(traversal.cell);
}

// A ray as given, made ready for the traversal.

const float voxc_r4_4_4_g8_LEAST_COMPONENT = 1.0f / 1099511627776.0f / 1099511627776.0f; // 2^-80.

// Most rays are ordinary: float32 traverses with them as they are, and nothing overflows or is lost on the way. Their
// direction is scaled without a rounding, all numbers of theirs are then 0 or at least 2^-80, and they begin within
// 2^45 voxels, or near the volume if rays from far away are not moved. `longest` has the bits of the direction's
// longest component, and `component` is the direction once it is scaled.
static inline bool voxc_r4_4_4_g8_is_ordinary(uvec3 origin, uint longest, vec3 component) {
  const uint SHORTEST = 0x00800000u; // The bits of 2^-126, below which devices may keep no number.
  const uint RANGE = 0x7e800000u; // From there to 2^127, where no number is left to scale by.
  const uint FAR_BITS = 0x56000000u; // Of 2^45.
  uvec3 place = origin & ~voxc_r4_4_4_g8_SIGN_BIT;
  uvec3 least = min(place - 1u, floatBitsToUint(abs(component)));
  uint farthest = max(max(place.x, place.y), place.z);
  bool is_scaled = longest - SHORTEST < RANGE;
  bool is_large = min(min(least.x, least.y), least.z) >= floatBitsToUint(voxc_r4_4_4_g8_LEAST_COMPONENT);
  bool is_near = farthest < FAR_BITS;
  return is_scaled && is_large && is_near;
}

// The magnitudes of a direction, divided by a power of two that leaves the largest in [1, 2), for numbers of any size.
[[gnu::noinline, gnu::cold, maybe_unused]] static vec3 voxc_r4_4_4_g8_scaled_exactly(uvec3 size) {
  ivec3 exponent;
  int largest = -1000;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = voxc_r4_4_4_g8_significand_of(size[axis]);
    exponent[axis] = voxc_r4_4_4_g8_exponent_of(size[axis]) + findMSB(significand);
    largest = significand != 0u ? max(largest, exponent[axis]) : largest;
  }
  vec3 result;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = voxc_r4_4_4_g8_significand_of(size[axis]);
    result[axis] = float(significand) * voxc_r4_4_4_g8_power_of_two(-findMSB(significand))
        * voxc_r4_4_4_g8_power_of_two(max(exponent[axis] - largest, -60));
  }
  return result;
}

// Makes a ray ready, whose direction is scaled by a power of two so that its longest component is in [1, 2).
static inline voxc_r4_4_4_g8_Ray voxc_r4_4_4_g8_prepare_ray(uvec3 origin, uvec3 direction, bool &ordinary) {
  voxc_r4_4_4_g8_Ray ray;
  ray.given_origin = origin;
  ray.given_direction = direction;
  uvec3 size = direction & ~voxc_r4_4_4_g8_SIGN_BIT;
  uint longest = voxc_r4_4_4_g8_longest_of(direction);
  ray.moves = notEqual(size, uvec3(0u));
  vec3 component = uintBitsToFloat(direction) * uintBitsToFloat(0x7f000000u - (longest & voxc_r4_4_4_g8_INFINITY_BITS));
  component = mix(vec3(voxc_r4_4_4_g8_LEAST_COMPONENT), component, ray.moves);
  ordinary = voxc_r4_4_4_g8_is_ordinary(origin, longest, component);
  ray.plain = ordinary;
  if (!ordinary) {
    ray.plain = voxc_r4_4_4_g8_are_plain(origin) && voxc_r4_4_4_g8_are_plain(direction);
    component = mix(vec3(1.0f), vec3(-1.0f), greaterThan(direction,
        uvec3(voxc_r4_4_4_g8_SIGN_BIT))) * voxc_r4_4_4_g8_scaled_exactly(size);
    component = mix(vec3(voxc_r4_4_4_g8_LEAST_COMPONENT), component, ray.moves);
  }
  ivec3 sign = floatBitsToInt(component) >> 31;
  ray.origin = uintBitsToFloat(origin);
  ray.direction = component;
  ray.inverse = 1.0f / ray.direction;
  ray.late = vec3(0.0f);
  ray.falls = lessThan(sign, ivec3(0));
  ray.heading = sign | 1;
  ray.beyond = vec3(sign);
  ray.ahead = ~sign;
  return ray;
}

// From a ray to its traversal, and the end of the traversal.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
static inline bool voxc_r4_4_4_g8_goes_nowhere(uvec3 direction) {
  return ((direction.x | direction.y | direction.z) & ~voxc_r4_4_4_g8_SIGN_BIT) == 0u;
}

// Makes a ray ready, and its traversal too, if that has not begun. False if there is nothing to go through, or if the
// ray is left.
static inline bool voxc_r4_4_4_g8_begin_traversal(uvec3 origin, uvec3 direction, uint root, voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal &traversal) {
  bool stays = voxc_r4_4_4_g8_goes_nowhere(direction);
  bool ordinary;
  ray = voxc_r4_4_4_g8_prepare_ray(origin, stays ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction, ordinary);
  if (root == 0u)
    return false;
  if (!(voxc_r4_4_4_g8_are_finite(origin) && voxc_r4_4_4_g8_are_finite(direction)))
    return false;
  voxc_r4_4_4_g8_Traversal start = traversal;
  bool enters = voxc_r4_4_4_g8_enter_volume(ray, start, ordinary);
  bool may_have_begun = true; // A dispatch without the exact fallback begins all its rays.
  bool has_begun = may_have_begun && (voxc_r4_4_4_g8_is_in_volume(traversal.cell)
      || traversal.pending_step != voxc_r4_4_4_g8_NO_PENDING_STEP);
  if (!enters || !has_begun)
    traversal = start;
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its traversal has begun.
static inline bool voxc_r4_4_4_g8_end_traversal(uvec3 origin, uvec3 direction, voxc_r4_4_4_g8_Traversal &traversal,
    bool hit) {
  bool may_stay = true; // Packets go on with rays that exact arithmetic has prepared.
  if (!may_stay || !voxc_r4_4_4_g8_goes_nowhere(direction) || traversal.pending_step == voxc_r4_4_4_g8_RETRY
      || traversal.cell == voxc_r4_4_4_g8_floor_of(origin))
    return hit;
  traversal.cell = ivec3(-1);
  traversal.pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
  return false;
}

// The t of a face, correctly rounded, in integers.

// An unsigned number of 64 bits.
struct voxc_r4_4_4_g8_Wide {
  uint high;
  uint low;
};

static inline bool voxc_r4_4_4_g8_is_below(const voxc_r4_4_4_g8_Wide &a, const voxc_r4_4_4_g8_Wide &b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

static inline voxc_r4_4_4_g8_Wide voxc_r4_4_4_g8_sum_of(const voxc_r4_4_4_g8_Wide &a, const voxc_r4_4_4_g8_Wide &b) {
  uint carry;
  uint low = uaddCarry(a.low, b.low, carry);
  return voxc_r4_4_4_g8_Wide(a.high + b.high + carry, low);
}

static inline voxc_r4_4_4_g8_Wide voxc_r4_4_4_g8_difference_of(const voxc_r4_4_4_g8_Wide &a,
    const voxc_r4_4_4_g8_Wide &b) {
  uint borrow;
  uint low = usubBorrow(a.low, b.low, borrow);
  return voxc_r4_4_4_g8_Wide(a.high - b.high - borrow, low);
}

static inline int voxc_r4_4_4_g8_log2_of(const voxc_r4_4_4_g8_Wide &number) {
  return number.high != 0u ? 32 + findMSB(number.high) : findMSB(number.low);
}

// number * 2^shift, shift in [-63, 63]. Bits that fall off the low end are told of; none falls off the high end.
static inline voxc_r4_4_4_g8_Wide voxc_r4_4_4_g8_shifted(const voxc_r4_4_4_g8_Wide &number, int shift, bool &inexact) {
  int right = max(-shift, 0);
  int left = max(shift, 0);
  uint high = number.high;
  uint low = number.low;
  if (right >= 32) {
    inexact = inexact || low != 0u;
    low = high;
    high = 0u;
    right -= 32;
  } else if (left >= 32) {
    high = low;
    low = 0u;
    left -= 32;
  }
  if (right > 0) {
    inexact = inexact || (low & ((1u << right) - 1u)) != 0u;
    low = low >> right | high << (32 - right);
    high >>= right;
  } else if (left > 0) {
    high = high << left | low >> (32 - left);
    low <<= left;
  }
  return voxc_r4_4_4_g8_Wide(high, low);
}

// A number of 50 bits, times 2^exponent.
struct voxc_r4_4_4_g8_Distance {
  voxc_r4_4_4_g8_Wide number;
  int exponent;
  bool inexact; // The exact distance is a little more.
};

// |face - origin|, its leading 50 bits.
static inline voxc_r4_4_4_g8_Distance voxc_r4_4_4_g8_distance_to(uint face, uint origin) {
  uint significand = voxc_r4_4_4_g8_significand_of(origin);
  int exponent = voxc_r4_4_4_g8_exponent_of(origin) - 150;
  // The larger of the two has its first bit at place 61, and so none below place 0.
  int top = max(face == 0u ? -1000 : findMSB(face), significand == 0u ? -1000 : exponent + findMSB(significand));
  voxc_r4_4_4_g8_Distance distance = voxc_r4_4_4_g8_Distance(voxc_r4_4_4_g8_Wide(0u, 0u), 0, false);
  voxc_r4_4_4_g8_Wide a = voxc_r4_4_4_g8_shifted(voxc_r4_4_4_g8_Wide(0u, face), clamp(61 - top, -63, 63),
      distance.inexact);
  voxc_r4_4_4_g8_Wide b = voxc_r4_4_4_g8_shifted(voxc_r4_4_4_g8_Wide(0u, significand), clamp(61 - top + exponent, -63,
      63), distance.inexact);
  if (origin >= voxc_r4_4_4_g8_SIGN_BIT) {
    a = voxc_r4_4_4_g8_sum_of(a, b);
  } else {
    if (voxc_r4_4_4_g8_is_below(a, b))
      a = voxc_r4_4_4_g8_difference_of(b, a);
    else
      a = voxc_r4_4_4_g8_difference_of(a, b);
    // What fell off was to be taken away.
    if (distance.inexact)
      a = voxc_r4_4_4_g8_difference_of(a, voxc_r4_4_4_g8_Wide(0u, 1u));
  }
  int place = voxc_r4_4_4_g8_log2_of(a) - 49;
  distance.number = voxc_r4_4_4_g8_shifted(a, -place, distance.inexact);
  distance.exponent = top - 61 + place;
  return distance;
}

// value * 2^exponent of a value below 2^27, rounded to the nearest float32, ties to even; `inexact` if it is a little
// more.
static inline uint voxc_r4_4_4_g8_rounded(uint value, int exponent, bool inexact) {
  int log2_value = findMSB(value) + exponent;
  if (log2_value > 127)
    return voxc_r4_4_4_g8_INFINITY_BITS;
  int drop = min(findMSB(value) - 23 + max(-126 - log2_value, 0), 31);
  uint kept = value >> drop;
  uint rest = value & ((1u << drop) - 1u);
  uint middle = 1u << (drop - 1);
  if (rest > middle || (rest == middle && (inexact || (kept & 1u) != 0u)))
    kept++;
  return min((uint(max(log2_value + 126, 0)) << 23) + kept, voxc_r4_4_4_g8_INFINITY_BITS);
}

// When the ray passes a face ahead of its origin: |face - origin| / |direction|, as bits of float32.
[[gnu::noinline, gnu::cold, maybe_unused]] static uint voxc_r4_4_4_g8_time_exactly(const voxc_r4_4_4_g8_Ray &ray,
    int axis, int face) {
  voxc_r4_4_4_g8_Distance distance = voxc_r4_4_4_g8_distance_to(uint(face), ray.given_origin[axis]);
  if (distance.number.high == 0u)
    return 0u;
  uint divisor = voxc_r4_4_4_g8_significand_of(ray.given_direction[axis]);
  int shift = 23 - findMSB(divisor);
  divisor <<= shift;
  // The quotient, below 2^27, by an estimate that an exact remainder corrects: what float32 rounds leaves it wrong by
  // less than 100, so the remainder fits 32 bits; the quotient of that is wrong by 1 at most.
  float size = float(divisor);
  float estimate = (float(distance.number.high) * 4294967296.0f + float(distance.number.low)) / size;
  uint value = uint(estimate);
  uint high, low;
  umulExtended(value, divisor, high, low);
  int rest = int(distance.number.low - low);
  int more = int(floor(float(rest) / size));
  rest -= more * int(divisor);
  int last = rest < 0 ? -1 : rest >= int(divisor) ? 1 : 0;
  value += uint(more + last);
  rest -= last * int(divisor);
  int exponent = distance.exponent - (voxc_r4_4_4_g8_exponent_of(ray.given_direction[axis]) - 150 - shift);
  return voxc_r4_4_4_g8_rounded(value, exponent, distance.inexact || rest != 0);
}

// The same, as fast as it can be told. Where a device promises little of its arithmetic, integers tell it of every hit:
// a dispatch that does not resolve would defer each of them to one with it.
static inline uint voxc_r4_4_4_g8_crossing_time(const voxc_r4_4_4_g8_Ray &ray, int axis, int face, bool &sure) {
  sure = false;
  uint bits = 0u;
  if (!sure) {
    bits = voxc_r4_4_4_g8_time_exactly(ray, axis, face);
    sure = true;
  }
  return bits;
}

// The face through which the ray entered its cell.
static inline int voxc_r4_4_4_g8_entered_face(const voxc_r4_4_4_g8_Ray &ray,
    const voxc_r4_4_4_g8_Traversal &traversal) {
  return traversal.cell[traversal.axis] + (ray.falls[traversal.axis] ? 1 : 0);
}

// How a ray comes to the voxel that it hits.
struct voxc_r4_4_4_g8_Arrival {
  uint t;    // The bits of a float32.
  uint face; // Twice the axis on which the ray enters, and 1 more where its coordinate falls.
};

const uint voxc_r4_4_4_g8_BEGINS_INSIDE = 6u; // No face.

// True if the ray comes into its cell on two axes at one moment.
static inline bool voxc_r4_4_4_g8_enters_together(const voxc_r4_4_4_g8_Ray &ray, ivec3 face, int a, int b) {
  return ray.moves[a] && ray.falls[a] == ray.falls[b] && voxc_r4_4_4_g8_compare_crossings(ray, a, face[a], b,
      face[b]) == 0;
}

// The first axis on which the ray comes into the traversal's cell as it enters that. Not sure if steps cannot decide.
// Without exactness, of several, at an edge, the one that the traversal has met.
static inline int voxc_r4_4_4_g8_first_axis(const voxc_r4_4_4_g8_Ray &ray, const voxc_r4_4_4_g8_Traversal &traversal,
    bool &sure) {
  sure = true;
  int first = traversal.axis;
  ivec3 face = traversal.cell + ivec3(ray.falls);
  vec3 t = voxc_r4_4_4_g8_times_of(ray, vec3(face));
  for (int axis = 0; axis < 2; axis++) {
    float apart = abs(t[axis] - t[traversal.axis]);
    float bound = min(abs(t[axis]), abs(t[traversal.axis])) * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error;
    if (axis < first && ray.moves[axis] && ray.falls[axis] == ray.falls[traversal.axis] && !(apart > bound))
      sure = false;
  }
  if (!sure) {
    sure = true;
    for (int axis = 1; axis >= 0; axis--)
      first = axis < traversal.axis && voxc_r4_4_4_g8_enters_together(ray, face, axis, traversal.axis) ? axis : first;
  }
  return first;
}

// How the ray came to the traversal's cell. Not sure where float32 or doubles cannot decide.
static inline voxc_r4_4_4_g8_Arrival voxc_r4_4_4_g8_arrival_at(const voxc_r4_4_4_g8_Ray &ray,
    const voxc_r4_4_4_g8_Traversal &traversal, bool hit, bool &sure) {
  voxc_r4_4_4_g8_Arrival arrival;
  arrival.t = 0u;
  arrival.face = voxc_r4_4_4_g8_BEGINS_INSIDE;
  sure = true;
  if (!hit || traversal.axis < 0)
    return arrival;
  arrival.t = voxc_r4_4_4_g8_crossing_time(ray, traversal.axis, voxc_r4_4_4_g8_entered_face(ray, traversal), sure);
  bool sure_of_axis;
  int axis = voxc_r4_4_4_g8_first_axis(ray, traversal, sure_of_axis);
  arrival.face = 2u * uint(axis) + uint(ray.falls[axis]);
  sure = sure && sure_of_axis;
  return arrival;
}

// A single voxel: the traversal has arrived.
static inline bool voxc_r4_4_4_g8_intersect_voxel(voxc_r4_4_4_g8_Traversal &traversal, uint voxel) {
  traversal.voxel = voxel;
  return true;
}

// ---- The format: R(4, 4, 4) G(8) ----

// Which child of a node a place lies in, counted in children.
static inline int voxc_r4_4_4_g8_child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: svdag, 256 x 256 x 256 cells of 1 voxel a side.
const int voxc_r4_4_4_g8_LEVEL_2_DEPTH = 8;
const int voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL = 0;
const int voxc_r4_4_4_g8_LEVEL_2_LOG2_SIDE = 8;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
static inline uint voxc_r4_4_4_g8_child_level_2(const unsigned int *volume, uint node, ivec3 cell, int height,
    bool &leaf) {
  int child = voxc_r4_4_4_g8_child_index(cell >> height);
  uint masks = voxc_r4_4_4_g8_load_word(volume, node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return voxc_r4_4_4_g8_load_word(volume, node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
static inline bool voxc_r4_4_4_g8_intersect_level_2(const unsigned int *volume, const voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal &traversal, uint root) {
  uint path[voxc_r4_4_4_g8_LEVEL_2_DEPTH + 1];
  path[voxc_r4_4_4_g8_LEVEL_2_DEPTH] = root;
  int top = voxc_r4_4_4_g8_LEVEL_2_DEPTH;
  for (;;) {
    ivec3 cell = traversal.cell >> voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_r4_4_4_g8_child_level_2(volume, node, cell, layer, leaf);
    }
    ivec3 before = traversal.cell;
    if (node == 0u)
      voxc_r4_4_4_g8_step_over(ray, traversal, voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL + layer);
    else if (leaf && voxc_r4_4_4_g8_intersect_voxel(traversal, node))
      return true;
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    if (highest >= voxc_r4_4_4_g8_LEVEL_2_LOG2_SIDE)
      return false;
    top = max(layer, highest - voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL) + 1;
  }
}

// Level 1: raw, 16 x 16 x 16 cells of 256 voxels a side.
const ivec3 voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE = ivec3(4, 4, 4);
const int voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL = 8;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
static inline uint voxc_r4_4_4_g8_slot_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  return grid + uint(at.x + ((at.y
      + (at.z << voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE.y)) << voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty.
static inline uint voxc_r4_4_4_g8_cell_level_1(const unsigned int *volume, uint grid, ivec3 cell) {
  uint slot = voxc_r4_4_4_g8_slot_level_1(grid, cell);
  return voxc_r4_4_4_g8_load_word(volume, slot);
}

static inline bool voxc_r4_4_4_g8_intersect_level_1(const unsigned int *volume, const voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal &traversal, uint grid) {
  while (voxc_r4_4_4_g8_goes_on(traversal)) {
    voxc_r4_4_4_g8_EmptySpan span = voxc_r4_4_4_g8_EmptySpan(voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL, 1);
    uint value = voxc_r4_4_4_g8_cell_level_1(volume, grid, traversal.cell >> voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      voxc_r4_4_4_g8_step_over(ray, traversal, span);
    } else if (voxc_r4_4_4_g8_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
static inline uint voxc_r4_4_4_g8_colour_of(const unsigned int *volume, const voxc_r4_4_4_g8_Traversal &traversal) {
  return voxc_r4_4_4_g8_load_word(volume, traversal.voxel);
}

// ---- What follows is the same in every kernel ----

// Goes on with a traversal to its end, or until it is left.
static inline bool voxc_r4_4_4_g8_continue_traversal(const unsigned int *volume, const voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal &traversal, uint root) {
  bool hit = false;
  bool is_under_way = true;
  while (is_under_way) {
    while (traversal.pending_step >= 0)
      voxc_r4_4_4_g8_resolve_step(ray, traversal);
    // What was resolved may have been the last step inside.
    hit = voxc_r4_4_4_g8_is_in_volume(traversal.cell) && voxc_r4_4_4_g8_intersect_level_1(volume, ray, traversal, root);
    is_under_way = traversal.pending_step >= 0;
  }
  return hit;
}

// What lies between two moments of a ray, tmin and tmax.

// Moments as bits of float32 that are not below 0. Nothing lies between them if tmin > tmax.
struct voxc_r4_4_4_g8_Bounds {
  uint tmin;
  uint tmax;
};

// The bits of a moment, for which one before 0 is as good as 0.
static inline uint voxc_r4_4_4_g8_moment_of(uint bits) {
  return bits > voxc_r4_4_4_g8_SIGN_BIT && bits <= (voxc_r4_4_4_g8_SIGN_BIT | voxc_r4_4_4_g8_INFINITY_BITS) ? 0u
      : bits & ~voxc_r4_4_4_g8_SIGN_BIT;
}

// The bounds that two float32 tell. A NaN is in no interval, and no voxel is entered at +inf.
static inline voxc_r4_4_4_g8_Bounds voxc_r4_4_4_g8_bounds_between(uint tmin, uint tmax) {
  voxc_r4_4_4_g8_Bounds bounds = voxc_r4_4_4_g8_Bounds(voxc_r4_4_4_g8_moment_of(tmin), voxc_r4_4_4_g8_moment_of(tmax));
  bool are_bounds = bounds.tmin < voxc_r4_4_4_g8_INFINITY_BITS && tmax <= voxc_r4_4_4_g8_SIGN_BIT
      && bounds.tmax <= voxc_r4_4_4_g8_INFINITY_BITS;
  if (!are_bounds)
    bounds = voxc_r4_4_4_g8_Bounds(1u, 0u);
  return bounds;
}

const int voxc_r4_4_4_g8_UNDECIDED = 2; // No order: it cannot be told here.

// The order of the moment at which a coordinate passes a face and another moment, where
// (face - origin) * 1 - moment * direction has this sign.
static inline int voxc_r4_4_4_g8_order_by_sign(const voxc_r4_4_4_g8_Ray &ray, int axis, int sign_of_difference) {
  return ray.falls[axis] ? -sign_of_difference : sign_of_difference;
}

[[gnu::noinline, gnu::cold,
    maybe_unused]] static int voxc_r4_4_4_g8_compare_moment_exactly(const voxc_r4_4_4_g8_Ray &ray, int axis, int face,
    uint moment) {
  uint one = floatBitsToUint(1.0f);
  voxc_r4_4_4_g8_Sum difference = voxc_r4_4_4_g8_sum_of_products(uvec4(floatBitsToUint(float(face)),
      ray.given_origin[axis] ^ voxc_r4_4_4_g8_SIGN_BIT, moment ^ voxc_r4_4_4_g8_SIGN_BIT, 0u), uvec4(one, one,
      ray.given_direction[axis], 0u));
  return voxc_r4_4_4_g8_order_by_sign(ray, axis, voxc_r4_4_4_g8_sign_of(difference));
}

// What is known of the order of two moments: that one is later or sooner, or, of neither, that they are the same.
static inline int voxc_r4_4_4_g8_order_decided(const voxc_r4_4_4_g8_Ray &ray, int axis, uint moment, bool later,
    bool sooner, bool is_exact) {
  // Devices may not keep a denormal moment.
  bool decided = (later || sooner || is_exact) && ray.plain && moment - 1u >= 0x7fffffu;
  return decided ? voxc_r4_4_4_g8_order_by_sign(ray, axis, later ? 1 : sooner ? -1 : 0) : voxc_r4_4_4_g8_UNDECIDED;
}

// The same by float32, whose distance and way are rounded once each.
static inline int voxc_r4_4_4_g8_compare_moment_by_floats(const voxc_r4_4_4_g8_Ray &ray, int axis, int face,
    uint moment) {
  float distance = float(face) - uintBitsToFloat(ray.given_origin[axis]);
  float way = uintBitsToFloat(moment) * uintBitsToFloat(ray.given_direction[axis]);
  float bound = (abs(distance) + abs(way)) * voxc_r4_4_4_g8_ROUNDINGS;
  return voxc_r4_4_4_g8_order_decided(ray, axis, moment, distance - way > bound, distance - way < -bound, false);
}

static inline int voxc_r4_4_4_g8_compare_moment(const voxc_r4_4_4_g8_Ray &ray, int axis, int face, uint moment) {
  return voxc_r4_4_4_g8_compare_moment_by_floats(ray, axis, face, moment);
}

// Whether the ray enters the traversal's cell before a moment, -1, at it, 0, or after it, 1. UNDECIDED if only exact
// arithmetic can tell, and that is not at hand, or the device has cut it short.
static inline int voxc_r4_4_4_g8_compare_entry(const voxc_r4_4_4_g8_Ray &ray, const voxc_r4_4_4_g8_Traversal &traversal,
    uint moment) {
  if (traversal.axis < 0)
    return moment == 0u ? 0 : -1;
  int face = voxc_r4_4_4_g8_entered_face(ray, traversal);
  int order = voxc_r4_4_4_g8_compare_moment(ray, traversal.axis, face, moment);
  if (order == voxc_r4_4_4_g8_UNDECIDED)
    order = voxc_r4_4_4_g8_compare_moment_exactly(ray, traversal.axis, face, moment);
  return order;
}

// Where the entry of the traversal's cell lies: before the bounds, -1, within them, 0, or after them, 1. UNDECIDED as
// above.
static inline int voxc_r4_4_4_g8_place_of_entry(const voxc_r4_4_4_g8_Ray &ray,
    const voxc_r4_4_4_g8_Traversal &traversal, const voxc_r4_4_4_g8_Bounds &bounds) {
  int order = bounds.tmin == 0u ? 0 : voxc_r4_4_4_g8_compare_entry(ray, traversal, bounds.tmin);
  if (order < 0 || order == voxc_r4_4_4_g8_UNDECIDED)
    return order;
  return bounds.tmax == voxc_r4_4_4_g8_INFINITY_BITS ? 0 : max(voxc_r4_4_4_g8_compare_entry(ray, traversal,
      bounds.tmax), 0);
}

// Where a ray is at a moment, wrong by less than `wrong` and a rounding of it.
struct voxc_r4_4_4_g8_Place {
  vec3 at;
  vec3 wrong;
  bool is_known; // It is not out of float32's reach.
};

// From any distance, as rays come near (near.glsl): with halves of 12 bits no product is rounded, and their sum with
// the origin is kept as two float32, of which the lower one loses less than 2^-43 of the way and the distance. Where
// rays do not come near, as nearly all begin there, or as a language has no `precise`, it is one float32.
static inline voxc_r4_4_4_g8_Place voxc_r4_4_4_g8_place_at(const voxc_r4_4_4_g8_Ray &ray, uint moment) {
  const uint UPPER = 0xfffff000u; // The bits of a float32 but the lowest 12 of its significand.
  vec3 origin = uintBitsToFloat(ray.given_origin);
  vec3 direction = uintBitsToFloat(ray.given_direction);
  float t = uintBitsToFloat(moment);
  vec3 way = t * direction;
  vec3 reach = abs(origin) + abs(way);
  bool is_known = all(lessThan(reach, vec3(voxc_r4_4_4_g8_NEVER)));
  vec3 upper = uintBitsToFloat(ray.given_direction & UPPER);
  float early = uintBitsToFloat(moment & UPPER);
  vec3 high = origin, low = vec3(0.0f);
  voxc_r4_4_4_g8_move_by(early * upper, high, low);
  voxc_r4_4_4_g8_move_by(early * (direction - upper), high, low);
  voxc_r4_4_4_g8_move_by((t - early) * upper, high, low);
  voxc_r4_4_4_g8_move_by((t - early) * (direction - upper), high, low);
  return voxc_r4_4_4_g8_Place(high + low, reach / 1099511627776.0f, is_known); // 2^40.
}

// Moves a traversal that begins long before a moment to a cell that the ray comes to shortly before.
static inline void voxc_r4_4_4_g8_skip_to(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal,
    uint moment) {
  const int WORTH_SKIPPING = 4; // In voxels.
  if (moment == 0u || !voxc_r4_4_4_g8_is_in_volume(traversal.cell))
    return;
  uvec3 size = ray.given_direction & ~voxc_r4_4_4_g8_SIGN_BIT;
  int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  voxc_r4_4_4_g8_Place place = voxc_r4_4_4_g8_place_at(ray, moment);
  if (!place.is_known)
    return;
  // By more than a few roundings.
  float before = place.at[axis] - float(ray.heading[axis]) * (2.0f + place.wrong[axis]);
  int face = int(floor(clamp(before, -1.0f, float(voxc_r4_4_4_g8_VOLUME_SIZE[axis] + 1))));
  int behind = face - int(ray.falls[axis]);
  if ((behind - traversal.cell[axis]) * ray.heading[axis] > WORTH_SKIPPING)
    traversal = voxc_r4_4_4_g8_behind_face(ray, traversal, traversal.cell, axis, face);
}

// Lets a traversal end shortly after a moment, where float32 can decide when that is.
static inline void voxc_r4_4_4_g8_end_after(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal,
    uint moment) {
  if (!ray.plain || moment >= voxc_r4_4_4_g8_INFINITY_BITS || (moment != 0u && moment < 0x800000u))
    return;
  voxc_r4_4_4_g8_Place place = voxc_r4_4_4_g8_place_at(ray, moment);
  if (!place.is_known)
    return;
  vec3 after = place.at + vec3(ray.heading) * (2.0f + place.wrong);
  ivec3 last = ivec3(clamp(floor(after), vec3(0.0f), vec3(voxc_r4_4_4_g8_VOLUME_SIZE - 1)));
  traversal.begin = mix(ivec3(0), last, ray.falls);
  traversal.size = mix(voxc_r4_4_4_g8_VOLUME_SIZE, last + 1, greaterThan(ray.heading, ivec3(0))) - traversal.begin;
}

// Lets a traversal that is ready end shortly after its bounds. False, and a miss, if nothing lies between them.
static inline bool voxc_r4_4_4_g8_bound_traversal(const voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal,
    const voxc_r4_4_4_g8_Bounds &bounds) {
  if (bounds.tmin > bounds.tmax) {
    traversal.cell = ivec3(-1);
    traversal.pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
    return false;
  }
  voxc_r4_4_4_g8_end_after(ray, traversal, bounds.tmax);
  return true;
}

// Goes on with a traversal to the first voxel that the ray enters within the bounds. A traversal of which that cannot
// be told stays where it is, in that voxel; one that has come beyond the bounds ends.
static inline bool voxc_r4_4_4_g8_traverse_within(const unsigned int *volume, const voxc_r4_4_4_g8_Ray &ray,
    voxc_r4_4_4_g8_Traversal &traversal, uint root, const voxc_r4_4_4_g8_Bounds &bounds) {
  bool found = false;
  int place = -1;
  while (place < 0) {
    found = (voxc_r4_4_4_g8_is_in_volume(traversal.cell) || traversal.pending_step >= 0)
        && voxc_r4_4_4_g8_continue_traversal(volume, ray, traversal, root);
    place = found ? voxc_r4_4_4_g8_place_of_entry(ray, traversal, bounds) : 0;
    if (place < 0)
      voxc_r4_4_4_g8_step_over_voxel(ray, traversal);
  }
  if (found && place == 1)
    traversal.cell = ivec3(-1);
  return found && place == 0;
}

// What rays find, as it is told outside.

// A voxel on a ray. A miss is -1, -1, -1, 0, 0, -1, 0.
struct voxc_r4_4_4_g8_Hit {
  ivec3 voxel;
  float t;     // When the ray enters it, rounded to nearest; 0 where the ray begins in it.
  uint colour; // Its word: R in the lowest byte, then G, B and A; or a label.
  // Of the face by which the ray enters, 0, 1, 2 for x, y, z; the first of several. -1 where the ray begins inside.
  int axis;
  int side;    // -1 where that is the voxel's low face, 1 where it is the high one; 0 where there is none.
};

static inline voxc_r4_4_4_g8_Hit voxc_r4_4_4_g8_miss() { return voxc_r4_4_4_g8_Hit(ivec3(-1), 0.0f, 0u, -1, 0); }

static inline voxc_r4_4_4_g8_Hit voxc_r4_4_4_g8_hit_of(const unsigned int *volume, const voxc_r4_4_4_g8_Ray &ray,
    const voxc_r4_4_4_g8_Traversal &traversal) {
  bool sure;
  voxc_r4_4_4_g8_Arrival arrival = voxc_r4_4_4_g8_arrival_at(ray, traversal, true, sure);
  bool inside = arrival.face == voxc_r4_4_4_g8_BEGINS_INSIDE;
  int axis = inside ? -1 : int(arrival.face >> 1);
  int side = inside ? 0 : (arrival.face & 1u) != 0u ? 1 : -1;
  return voxc_r4_4_4_g8_Hit(traversal.cell, uintBitsToFloat(arrival.t), voxc_r4_4_4_g8_colour_of(volume, traversal),
      axis, side);
}

// The normal of the face by which the ray enters, out of the voxel; 0 where there is none.
static inline vec3 voxc_r4_4_4_g8_normal(const voxc_r4_4_4_g8_Hit &hit) {
  return vec3(ivec3(equal(ivec3(hit.axis), ivec3(0, 1, 2))) * hit.side);
}

// Where the ray of a hit enters the voxel, just outside of it, and within its face: rays that go on from there begin in
// the cell before that face, and need no tmin to leave the voxel. In a voxel in which the ray begins, that is where it
// begins.
static inline vec3 voxc_r4_4_4_g8_outside(vec3 origin, vec3 direction, const voxc_r4_4_4_g8_Hit &hit) {
  if (hit.axis < 0)
    return origin;
  vec3 low = vec3(hit.voxel);
  vec3 high = low + 1.0f;
  vec3 within = clamp(origin + hit.t * direction, low, high - high / 8388608.0f);
  vec3 beyond = hit.side > 0 ? high : low - max(low, 1.0f) / 8388608.0f;
  return mix(within, beyond, equal(ivec3(hit.axis), ivec3(0, 1, 2)));
}

// What is called from outside.

// Goes from the ray's begin, or from behind the traversal's voxel where it has one, to the next voxel within [tmin,
// tmax].
static inline bool voxc_r4_4_4_g8_seek(const unsigned int *volume, uvec3 origin, uvec3 direction, float tmin,
    float tmax, voxc_r4_4_4_g8_Ray &ray, voxc_r4_4_4_g8_Traversal &traversal) {
  bool goes_past = voxc_r4_4_4_g8_is_in_volume(traversal.cell);
  voxc_r4_4_4_g8_Bounds bounds = voxc_r4_4_4_g8_bounds_between(floatBitsToUint(tmin), floatBitsToUint(tmax));
  uint root = voxc_r4_4_4_g8_load_word(volume, 0u); // Leads to level 1, unless the volume is empty.
  bool found = voxc_r4_4_4_g8_begin_traversal(origin, direction, root, ray,
      traversal) && voxc_r4_4_4_g8_bound_traversal(ray, traversal, bounds);
  if (found) {
    if (goes_past)
      voxc_r4_4_4_g8_step_over_voxel(ray, traversal);
    else
      voxc_r4_4_4_g8_skip_to(ray, traversal, bounds.tmin);
    found = voxc_r4_4_4_g8_traverse_within(volume, ray, traversal, root, bounds);
  }
  return voxc_r4_4_4_g8_end_traversal(origin, direction, traversal, found);
}

// The first voxel that the ray enters at a t in [tmin, tmax], in exact arithmetic; a NaN is in no interval. The voxel
// in which the ray begins is entered at t = 0. So with a tmin above 0 a ray that starts in a solid does not see the
// voxels that it has entered by then, but the next, which it enters through a face that is hidden.
static inline bool voxc_r4_4_4_g8_closest(const unsigned int *volume, vec3 origin, vec3 direction, float tmin,
    float tmax, voxc_r4_4_4_g8_Hit &hit) {
  voxc_r4_4_4_g8_Ray ray;
  voxc_r4_4_4_g8_Traversal traversal = voxc_r4_4_4_g8_traversal_at(ivec3(-1));
  bool found = voxc_r4_4_4_g8_seek(volume, floatBitsToUint(origin), floatBitsToUint(direction), tmin, tmax, ray,
      traversal);
  hit = voxc_r4_4_4_g8_miss();
  if (found)
    hit = voxc_r4_4_4_g8_hit_of(volume, ray, traversal);
  return found;
}

// From a hit of this very ray to the next voxel on it, if that is entered at tmax or before. None is left out or comes
// twice, also where several are entered at one moment.
static inline bool voxc_r4_4_4_g8_next(const unsigned int *volume, vec3 origin, vec3 direction, float tmax,
    voxc_r4_4_4_g8_Hit &hit) {
  voxc_r4_4_4_g8_Ray ray;
  voxc_r4_4_4_g8_Traversal traversal = voxc_r4_4_4_g8_traversal_at(hit.voxel);
  bool found = voxc_r4_4_4_g8_is_in_volume(hit.voxel) && voxc_r4_4_4_g8_seek(volume, floatBitsToUint(origin),
      floatBitsToUint(direction), 0.0f, tmax, ray, traversal);
  hit = voxc_r4_4_4_g8_miss();
  if (found)
    hit = voxc_r4_4_4_g8_hit_of(volume, ray, traversal);
  return found;
}

// Whether there is a voxel that the ray enters at a t in [tmin, tmax].
static inline bool voxc_r4_4_4_g8_any(const unsigned int *volume, vec3 origin, vec3 direction, float tmin, float tmax) {
  voxc_r4_4_4_g8_Ray ray;
  voxc_r4_4_4_g8_Traversal traversal = voxc_r4_4_4_g8_traversal_at(ivec3(-1));
  return voxc_r4_4_4_g8_seek(volume, floatBitsToUint(origin), floatBitsToUint(direction), tmin, tmax, ray, traversal);
}

#undef VOXC_INDEX
#undef VOXC_LOAD
#undef VOXC_INLINE
#undef VOXC_CONSTANT
#undef VOXC_DEVICE
#undef VOXC_BUILTIN
#undef VOXC_OPERATOR
#undef OUT_OF_LINE
#undef VOXC_BEGIN_INLINE
#undef VOXC_END_INLINE

} // namespace voxc_r4_4_4_g8_text

using voxc_r4_4_4_g8_text::voxc_r4_4_4_g8_Hit;
using voxc_r4_4_4_g8_text::voxc_r4_4_4_g8_VOLUME_SIZE;
using voxc_r4_4_4_g8_text::voxc_r4_4_4_g8_any;
using voxc_r4_4_4_g8_text::voxc_r4_4_4_g8_closest;
using voxc_r4_4_4_g8_text::voxc_r4_4_4_g8_next;
using voxc_r4_4_4_g8_text::voxc_r4_4_4_g8_normal;
using voxc_r4_4_4_g8_text::voxc_r4_4_4_g8_outside;
