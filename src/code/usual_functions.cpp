#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "code/code_host.h"

namespace rasterwalk {

namespace {

using Functions = std::vector<CodeHostFunction>;

template <class T>
void add_orders(Functions& all) {
    all.push_back(host_function<T(T, T)>("min", [](T a, T b) { return std::min(a, b); }));
    all.push_back(host_function<T(T, T)>("max", [](T a, T b) { return std::max(a, b); }));
    all.push_back(host_function<T(T)>("abs", [](T a) { return static_cast<T>(std::abs(a)); }));
    all.push_back(host_function<T(T, T, T)>(
        "clamp", [](T a, T low, T high) { return std::min(std::max(a, low), high); }));
}

template <class T>
void add_real(Functions& all) {
    const auto one = [&](const char* name, T (*call)(T)) {
        all.push_back(host_function<T(T)>(name, call));
    };
    one("fabs", [](T a) { return std::fabs(a); });
    one("floor", [](T a) { return std::floor(a); });
    one("ceil", [](T a) { return std::ceil(a); });
    one("round", [](T a) { return std::round(a); });
    one("trunc", [](T a) { return std::trunc(a); });
    one("sqrt", [](T a) { return std::sqrt(a); });
    one("sin", [](T a) { return std::sin(a); });
    one("cos", [](T a) { return std::cos(a); });
    one("tan", [](T a) { return std::tan(a); });
    one("asin", [](T a) { return std::asin(a); });
    one("acos", [](T a) { return std::acos(a); });
    one("atan", [](T a) { return std::atan(a); });
    one("exp", [](T a) { return std::exp(a); });
    one("exp2", [](T a) { return std::exp2(a); });
    one("log", [](T a) { return std::log(a); });
    one("log2", [](T a) { return std::log2(a); });
    all.push_back(host_function<T(T, T)>("pow", [](T a, T b) { return std::pow(a, b); }));
    all.push_back(host_function<T(T, T)>("fmod", [](T a, T b) { return std::fmod(a, b); }));
    all.push_back(host_function<T(T, T)>("atan2", [](T a, T b) { return std::atan2(a, b); }));
    all.push_back(host_function<T(T, T)>("fmax", [](T a, T b) { return std::fmax(a, b); }));
    all.push_back(host_function<T(T, T)>("fmin", [](T a, T b) { return std::fmin(a, b); }));
    all.push_back(host_function<bool(T)>("isinf", [](T a) { return std::isinf(a); }));
    all.push_back(host_function<bool(T)>("isnan", [](T a) { return std::isnan(a); }));
}

template <class V>
void add_vector(Functions& all) {
    all.push_back(host_function<float(V, V)>("dot", [](V a, V b) { return glm::dot(a, b); }));
    all.push_back(host_function<float(V)>("length", [](V a) { return glm::length(a); }));
    all.push_back(
        host_function<float(V, V)>("distance", [](V a, V b) { return glm::distance(a, b); }));
    all.push_back(host_function<V(V)>("normalize", [](V a) { return glm::normalize(a); }));
    all.push_back(host_function<V(V, V)>("reflect", [](V a, V b) { return glm::reflect(a, b); }));
    all.push_back(
        host_function<V(V, V, float)>("mix", [](V a, V b, float t) { return glm::mix(a, b, t); }));
}

template <class V>
void add_components(Functions& all) {
    all.push_back(host_function<V(V)>("abs", [](V a) { return glm::abs(a); }));
    all.push_back(host_function<V(V, V)>("min", [](V a, V b) { return glm::min(a, b); }));
    all.push_back(host_function<V(V, V)>("max", [](V a, V b) { return glm::max(a, b); }));
}

template <class M, class V>
void add_matrix(Functions& all) {
    all.push_back(host_function<V(M, V)>("*", [](const M& m, V v) { return m * v; }));
    all.push_back(host_function<V(V, M)>("*", [](V v, const M& m) { return v * m; }));
    all.push_back(host_function<M(M, M)>("*", [](const M& a, const M& b) { return a * b; }));
    all.push_back(host_function<M(M)>("transpose", [](const M& m) { return glm::transpose(m); }));
    all.push_back(host_function<M(M)>("inverse", [](const M& m) { return glm::inverse(m); }));
}

Functions make_usual_functions() {
    Functions all;
    add_orders<int>(all);
    add_orders<float>(all);
    add_orders<double>(all);
    add_real<float>(all);
    add_real<double>(all);
    add_vector<glm::vec2>(all);
    add_vector<glm::vec3>(all);
    add_vector<glm::vec4>(all);
    add_components<glm::ivec2>(all);
    add_components<glm::vec2>(all);
    add_components<glm::vec3>(all);
    add_matrix<glm::mat3, glm::vec3>(all);
    add_matrix<glm::mat4, glm::vec4>(all);
    all.push_back(host_function<glm::vec3(glm::vec3, glm::vec3)>(
        "cross", [](glm::vec3 a, glm::vec3 b) { return glm::cross(a, b); }));
    all.push_back(host_function<float(float, float, float)>(
        "mix", [](float a, float b, float t) { return glm::mix(a, b, t); }));
    all.push_back(host_function<float(float)>("radians", [](float a) { return glm::radians(a); }));
    return all;
}

} // namespace

const std::vector<CodeHostFunction>& usual_functions() {
    static const Functions all = make_usual_functions();
    return all;
}

} // namespace rasterwalk
