#pragma once

// Functions of this program that a program of the lab can call.

#include <cstring>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "code/code_program.h"

namespace rasterwalk {

/// The type in a program of a type of ours; their bytes are the same, apart from bool.
template <class T>
inline constexpr CodeTypeId code_type_of = -1;
template <>
inline constexpr CodeTypeId code_type_of<void> = code_type::nothing;
template <>
inline constexpr CodeTypeId code_type_of<bool> = code_type::boolean;
template <>
inline constexpr CodeTypeId code_type_of<int> = code_type::integer;
template <>
inline constexpr CodeTypeId code_type_of<float> = code_type::real;
template <>
inline constexpr CodeTypeId code_type_of<double> = code_type::double_real;
template <>
inline constexpr CodeTypeId code_type_of<glm::ivec2> = code_type::ivec2;
template <>
inline constexpr CodeTypeId code_type_of<glm::ivec3> = code_type::ivec3;
template <>
inline constexpr CodeTypeId code_type_of<glm::vec2> = code_type::vec2;
template <>
inline constexpr CodeTypeId code_type_of<glm::vec3> = code_type::vec3;
template <>
inline constexpr CodeTypeId code_type_of<glm::vec4> = code_type::vec4;
template <>
inline constexpr CodeTypeId code_type_of<glm::mat3> = code_type::mat3;
template <>
inline constexpr CodeTypeId code_type_of<glm::mat4> = code_type::mat4;

template <class T>
T read_code_value(const std::uint32_t* words) {
    if constexpr (std::is_same_v<T, bool>) {
        return *words != 0;
    } else {
        T value;
        std::memcpy(static_cast<void*>(&value), words, sizeof value);
        return value;
    }
}

template <class T>
void write_code_value(std::uint32_t* words, const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        *words = value ? 1 : 0;
    } else {
        std::memcpy(words, &value, sizeof value);
    }
}

template <class T>
inline constexpr int code_words = std::is_same_v<T, bool> ? 1 : static_cast<int>(sizeof(T) / 4);

template <class Result, class... Arguments, class Call, std::size_t... index>
CodeHostFunction host_function_of(std::string name, Call call, std::index_sequence<index...>) {
    return {std::move(name),
            code_type_of<Result>,
            {code_type_of<Arguments>...},
            [call]([[maybe_unused]] std::uint32_t* result,
                   [[maybe_unused]] const std::uint32_t* arguments) {
                // Where each argument begins: after all those before it.
                constexpr int sizes[]{code_words<Arguments>..., 0};
                [[maybe_unused]] const auto begin = [&](std::size_t argument) {
                    int words = 0;
                    for (std::size_t i = 0; i < argument; ++i)
                        words += sizes[i];
                    return arguments + words;
                };
                if constexpr (std::is_void_v<Result>) {
                    call(read_code_value<Arguments>(begin(index))...);
                } else {
                    write_code_value(result, static_cast<Result>(call(
                                                 read_code_value<Arguments>(begin(index))...)));
                }
            }};
}

/// A function that the program calls by this name: host_function<float(vec3, vec3)>("dot", ...).
template <class Signature>
struct HostFunctionMaker;
template <class Result, class... Arguments>
struct HostFunctionMaker<Result(Arguments...)> {
    template <class Call>
    static CodeHostFunction make(std::string name, Call call) {
        return host_function_of<Result, Arguments...>(std::move(name), std::move(call),
                                                      std::index_sequence_for<Arguments...>{});
    }
};
template <class Signature, class Call>
CodeHostFunction host_function(std::string name, Call call) {
    return HostFunctionMaker<Signature>::make(std::move(name), std::move(call));
}

/// The functions of C++ and GLM, and GLM's products with matrices, by the name "*".
const std::vector<CodeHostFunction>& usual_functions();

} // namespace rasterwalk
