// voxc_vector.h: the vectors of GLSL in C++, each kept in one SIMD register. Freestanding; for Clang 17 and GCC 12, or
// later ones.
#pragma once

#define VOXC_INLINE [[gnu::always_inline]] inline
// Where constants are made.
#define VOXC_CONSTANT [[gnu::always_inline]] constexpr

namespace voxc::glsl {

using uint = unsigned int;

/// A component of a vector of bool. Its lane is a mask, all ones for true, as comparisons make it.
struct Truth {
  int mask;

  VOXC_INLINE operator bool() const { return mask != 0; }
  VOXC_INLINE Truth &operator=(bool value) {
    mask = -int(value);
    return *this;
  }
};

/// How a component type is kept: what a lane holds, and what the name of a component means.
template <typename T> struct Kept {
  using Lane = T;
  using Component = T;
};
template <> struct Kept<bool> {
  using Lane = int;
  using Component = Truth;
};

template <typename T> VOXC_CONSTANT T lane(T value) { return value; }
VOXC_CONSTANT int lane(bool value) { return -int(value); }

/// A vector of three has a fourth lane, whose value means nothing.
template <typename T, int N> struct LanesOf {
  typedef typename Kept<T>::Lane Type __attribute__((vector_size((N == 2 ? 2 : 4) * 4)));
};
template <typename T, int N> using Lanes = typename LanesOf<T, N>::Type;

template <typename T, int N> struct Vector;

/// Lanes of U as lanes of T, as GLSL's constructors convert.
template <typename T, typename U, int N> VOXC_CONSTANT Lanes<T, N> convert(Lanes<U, N> lanes) {
  if constexpr (__is_same(T, U))
    return lanes;
  else if constexpr (__is_same(T, bool))
    return lanes != 0;
  else if constexpr (__is_same(U, bool))
    return __builtin_convertvector(lanes & 1, Lanes<T, N>);
  else
    return __builtin_convertvector(lanes, Lanes<T, N>);
}

template <typename T> struct Vector<T, 2> {
  union {
    Lanes<T, 2> lanes;
    struct {
      typename Kept<T>::Component x, y;
    };
  };

  Vector() = default;
  VOXC_CONSTANT explicit Vector(T all) : Vector(all, all) {}
  VOXC_CONSTANT Vector(T x, T y) : lanes{lane(x), lane(y)} {}
  template <typename U> VOXC_CONSTANT explicit Vector(Vector<U, 2> v) : lanes(convert<T, U, 2>(v.lanes)) {}
  VOXC_INLINE auto &operator[](int i) { return (&x)[i]; }
  VOXC_INLINE const auto &operator[](int i) const { return (&x)[i]; }
};

template <typename T> struct Vector<T, 3> {
  union {
    Lanes<T, 3> lanes;
    struct {
      typename Kept<T>::Component x, y, z;
    };
  };

  Vector() = default;
  VOXC_CONSTANT explicit Vector(T all) : lanes{lane(all), lane(all), lane(all), lane(all)} {}
  VOXC_CONSTANT Vector(T x, T y, T z) : lanes{lane(x), lane(y), lane(z)} {}
  template <typename U> VOXC_CONSTANT explicit Vector(Vector<U, 3> v) : lanes(convert<T, U, 3>(v.lanes)) {}
  VOXC_INLINE auto &operator[](int i) { return (&x)[i]; }
  VOXC_INLINE const auto &operator[](int i) const { return (&x)[i]; }
};

template <typename T> struct Vector<T, 4> {
  union {
    Lanes<T, 4> lanes;
    struct {
      typename Kept<T>::Component x, y, z, w;
    };
  };

  Vector() = default;
  VOXC_CONSTANT explicit Vector(T all) : Vector(all, all, all, all) {}
  VOXC_CONSTANT Vector(T x, T y, T z, T w) : lanes{lane(x), lane(y), lane(z), lane(w)} {}
  VOXC_CONSTANT Vector(Vector<T, 3> v, T w) : Vector(v.x, v.y, v.z, w) {}
  template <typename U> VOXC_CONSTANT explicit Vector(Vector<U, 4> v) : lanes(convert<T, U, 4>(v.lanes)) {}
  VOXC_INLINE auto &operator[](int i) { return (&x)[i]; }
  VOXC_INLINE const auto &operator[](int i) const { return (&x)[i]; }
};

using vec2 = Vector<float, 2>;
using vec3 = Vector<float, 3>;
using vec4 = Vector<float, 4>;
using ivec2 = Vector<int, 2>;
using ivec3 = Vector<int, 3>;
using ivec4 = Vector<int, 4>;
using uvec2 = Vector<uint, 2>;
using uvec3 = Vector<uint, 3>;
using uvec4 = Vector<uint, 4>;
using bvec2 = Vector<bool, 2>;
using bvec3 = Vector<bool, 3>;
using bvec4 = Vector<bool, 4>;

template <typename T, int N> VOXC_INLINE Vector<T, N> vectorOf(Lanes<T, N> lanes) {
  Vector<T, N> v;
  v.lanes = lanes;
  return v;
}

/// A type as a parameter that takes no part in deduction, so that any number converts to it.
template <typename T> struct Plain {
  using Type = T;
};
template <typename T> using Scalar = typename Plain<T>::Type;

/// Calls `function` for each component; for what SIMD lanes cannot do, or do wrongly in an unused lane.
template <typename T, int N, typename Function>
VOXC_INLINE Vector<T, N> componentwise(Function function, Vector<T, N> a, Vector<T, N> b) {
  Vector<T, N> result;
  for (int i = 0; i < N; ++i)
    result[i] = function(a[i], b[i]);
  return result;
}

#define VOXC_OPERATOR(op, expression)                                                                        \
  template <typename T, int N> VOXC_INLINE Vector<T, N> operator op(Vector<T, N> a, Vector<T, N> b) {        \
    return expression;                                                                                       \
  }                                                                                                          \
  template <typename T, int N> VOXC_INLINE Vector<T, N> operator op(Vector<T, N> a, Scalar<T> b) {           \
    return a op Vector<T, N>(b);                                                                             \
  }                                                                                                          \
  template <typename T, int N> VOXC_INLINE Vector<T, N> operator op(Scalar<T> a, Vector<T, N> b) {           \
    return Vector<T, N>(a) op b;                                                                             \
  }                                                                                                          \
  template <typename T, int N, typename U>                                                                   \
  VOXC_INLINE Vector<T, N> &operator op##=(Vector<T, N> &a, const U & b) {                                   \
    return a = a op b;                                                                                       \
  }
#define VOXC_LANE_OPERATOR(op) VOXC_OPERATOR(op, (vectorOf<T, N>(a.lanes op b.lanes)))

VOXC_LANE_OPERATOR(+)
VOXC_LANE_OPERATOR(-)
VOXC_LANE_OPERATOR(*)
VOXC_LANE_OPERATOR(&)
VOXC_LANE_OPERATOR(|)
VOXC_LANE_OPERATOR(^)
VOXC_LANE_OPERATOR(<<)
VOXC_LANE_OPERATOR(>>)
// An unused lane of integers may divide by 0, and a processor may trap.
VOXC_OPERATOR(%, componentwise([](T p, T q) { return p % q; }, a, b))
template <typename T, int N> VOXC_INLINE Vector<T, N> quotient(Vector<T, N> a, Vector<T, N> b) {
  if constexpr (__is_same(T, float))
    return vectorOf<T, N>(a.lanes / b.lanes);
  else
    return componentwise([](T p, T q) { return p / q; }, a, b);
}
VOXC_OPERATOR(/, quotient(a, b))

#undef VOXC_LANE_OPERATOR
#undef VOXC_OPERATOR

template <typename T, int N> VOXC_INLINE Vector<T, N> operator-(Vector<T, N> v) {
  return vectorOf<T, N>(-v.lanes);
}
template <typename T, int N> VOXC_INLINE Vector<T, N> operator~(Vector<T, N> v) {
  return vectorOf<T, N>(~v.lanes);
}
/// GLSL's function `not`, a word that C++ spells so as well.
template <int N> VOXC_INLINE Vector<bool, N> operator!(Vector<bool, N> v) {
  return vectorOf<bool, N>(~v.lanes);
}

} // namespace voxc::glsl
