// voxc_vector.h: the vectors of GLSL that kernels use, in C++: plain structures, since what runs several rays
// at once makes a wide register of each component. Freestanding; for Clang 17 and GCC 12, or later ones.
#pragma once

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
