#pragma once

// Part of claims.h: older versions of glm let a vector be multiplied by a number of another type,
// as in `0.5 * v` or `v / 2`. The number becomes one of the vector's type.

#include <type_traits>

#include <glm/glm.hpp>

namespace glm {

/// A vector, if `Number` is a number of another type than its elements.
template <length_t Length, typename Element, qualifier Q, typename Number>
using vec_with_other_number = typename std::enable_if<std::is_arithmetic<Number>::value &&
                                                          std::is_arithmetic<Element>::value &&
                                                          !std::is_same<Number, Element>::value,
                                                      vec<Length, Element, Q>>::type;

template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator+(const vec<L, T, Q>& vector, N number) {
    return vector + static_cast<T>(number);
}
template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator+(N number, const vec<L, T, Q>& vector) {
    return static_cast<T>(number) + vector;
}
template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator-(const vec<L, T, Q>& vector, N number) {
    return vector - static_cast<T>(number);
}
template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator-(N number, const vec<L, T, Q>& vector) {
    return static_cast<T>(number) - vector;
}
template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator*(const vec<L, T, Q>& vector, N number) {
    return vector * static_cast<T>(number);
}
template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator*(N number, const vec<L, T, Q>& vector) {
    return static_cast<T>(number) * vector;
}
template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator/(const vec<L, T, Q>& vector, N number) {
    return vector / static_cast<T>(number);
}
template <length_t L, typename T, qualifier Q, typename N>
vec_with_other_number<L, T, Q, N> operator/(N number, const vec<L, T, Q>& vector) {
    return static_cast<T>(number) / vector;
}

} // namespace glm
