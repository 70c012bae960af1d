#pragma once

// How a function of the student's is called whose name is known, but not its parameters.
//
// A function that is not overloaded has its parameters read from its type, and a giver has an
// argument for each, or has not. For one that is overloaded or a template, usual lists of
// parameters are tried. A giver is a struct with
//     Usual                        lists of parameters to try
//     gives<Type, before>()        can it fill a parameter of this type, after these others?
//     give<Type, before>()         the argument
//     takes<Result, Types...>()    would the answer be found after a call with all of these?
//     take<Types...>(arguments, result)

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "asking_names.h"
#include "asking_values.h"

namespace rasterwalk_kit {

template <class... Types>
struct Parameters {};

template <class Result, class... Types>
constexpr Parameters<Types...> parameters_of(Result (*)(Types...)) {
    return {};
}

template <class Seen>
constexpr auto own_parameters() {
    if constexpr (requires { parameters_of(&Seen::value()); }) {
        return parameters_of(&Seen::value());
    } else {
        return Nothing{};
    }
}

/// The parameters of a function that is not overloaded; Nothing otherwise.
template <class Name>
using OwnParameters = decltype(own_parameters<Look<Name>>());

/// Does the program have a function of this name, or a variable that can be called?
template <class Name>
constexpr bool is_written() {
    using Own = OwnParameters<Name>;
    if constexpr (std::is_same_v<Own, Parameters<Later>>) {
        return false;
    } else if constexpr (!std::is_same_v<Own, Nothing>) {
        return true;
    } else if constexpr (Look<Name>::is_value) {
        return std::is_class_v<std::remove_cvref_t<decltype(Look<Name>::value())>>;
    } else {
        return std::is_same_v<Look<Name>, NotSingle> && !Name::is_missing(Later{});
    }
}

/// Does the program have any of these functions?
template <class... Names>
constexpr bool is_any_written(List<Names...>) {
    return (is_written<Names>() || ...);
}

template <class Type>
struct IsVector : std::false_type {};
template <class Element, class Allocator>
struct IsVector<std::vector<Element, Allocator>> : std::true_type {};

template <class Type>
concept VectorOf = IsVector<std::remove_cvref_t<Type>>::value;

/// How a program may be handed its window: a pointer to a struct.
template <class Type>
concept WindowLike = std::is_pointer_v<std::remove_cvref_t<Type>> &&
    std::is_class_v<std::remove_pointer_t<std::remove_cvref_t<Type>>>;

/// Can it be changed by the function so that the caller sees it?
template <class Type>
concept Changeable =
    std::is_lvalue_reference_v<Type> && !std::is_const_v<std::remove_reference_t<Type>>;

/// What comes before a parameter.
struct Before {
    std::size_t vectors = 0; ///< std::vector
    std::size_t colours = 0; ///< three numbers
    std::size_t normals = 0; ///< four numbers
    std::size_t others = 0;  ///< neither vectors nor windows
};

template <class Type>
constexpr void pass(Before& before) {
    using Plain = std::remove_cvref_t<Type>;
    before.vectors += VectorOf<Plain> ? 1 : 0;
    before.colours += Spatial<Plain> && !Homogeneous<Plain> ? 1 : 0;
    before.normals += Homogeneous<Plain> ? 1 : 0;
    before.others += VectorOf<Plain> || WindowLike<Plain> ? 0 : 1;
}

template <std::size_t Index, class... Types>
constexpr Before before_parameter() {
    Before before;
    std::size_t index = 0;
    ((index++ < Index ? pass<Types>(before) : void()), ...);
    return before;
}

/// How many parameters there are of each kind.
template <class... Types>
constexpr Before all_parameters() {
    return before_parameter<sizeof...(Types), Types...>();
}

/// Which parameter is the vector that has so many vectors before it.
template <class... Types>
constexpr std::size_t vector_parameter(std::size_t wanted) {
    std::size_t found = 0;
    std::size_t position = 0;
    std::size_t vectors = 0;
    ((VectorOf<Types>&& vectors++ == wanted ? found = position++ : position++), ...);
    return found;
}

/// Which parameter is neither a vector nor a window, and has so many of these before it.
template <class... Types>
constexpr std::size_t other_parameter(std::size_t wanted) {
    std::size_t found = 0;
    std::size_t position = 0;
    std::size_t others = 0;
    ((!VectorOf<Types> && !WindowLike<Types>&& others++ == wanted ? found = position++
                                                                  : position++),
     ...);
    return found;
}

template <class Giver, class... Types, std::size_t... Index>
constexpr bool gives_all(std::index_sequence<Index...>) {
    return (Giver::template gives<Types, before_parameter<Index, Types...>()>() && ...);
}

/// Can this giver call this name with these parameters, and find the answer?
template <class Name, class Giver, class... Types>
constexpr bool is_callable(Parameters<Types...>) {
    if constexpr (requires { Name::call(std::declval<Types>()...); }) {
        using Result = decltype(Name::call(std::declval<Types>()...));
        return gives_all<Giver, Types...>(std::index_sequence_for<Types...>{}) &&
               Giver::template takes<Result, Types...>();
    } else {
        return false;
    }
}

template <class Name, class Giver>
constexpr bool is_callable(Nothing) {
    return false;
}

/// The first of these lists of parameters that the giver can call this name with.
template <class Name, class Giver, class First, class... Rest>
constexpr auto first_callable(List<First, Rest...>) {
    if constexpr (is_callable<Name, Giver>(First{})) {
        return First{};
    } else if constexpr (sizeof...(Rest) > 0) {
        return first_callable<Name, Giver>(List<Rest...>{});
    } else {
        return Nothing{};
    }
}

/// The parameters to call a name with: its own, or the first usual ones that fit; Nothing if none.
template <class Name, class Giver>
constexpr auto choose_parameters() {
    if constexpr (!is_written<Name>()) {
        return Nothing{};
    } else if constexpr (is_callable<Name, Giver>(OwnParameters<Name>{})) {
        return OwnParameters<Name>{};
    } else {
        return first_callable<Name, Giver>(typename Giver::Usual{});
    }
}

/// An argument, which is kept until the answer has been read.
template <std::size_t Index, class Type>
struct Slot {
    Type value;
};

template <class Indices, class... Types>
struct ArgumentsAt;
template <std::size_t... Index, class... Types>
struct ArgumentsAt<std::index_sequence<Index...>, Types...> : Slot<Index, Types>... {};

/// The arguments of a call. Takes less time to compile than std::tuple.
template <class... Types>
using Arguments = ArgumentsAt<std::index_sequence_for<Types...>, Types...>;

template <std::size_t Index, class Type>
Type& slot_value(Slot<Index, Type>& slot) {
    return slot.value;
}

template <class Name, class Giver, class... Types, std::size_t... Index>
void call_in_order(Giver& giver, std::index_sequence<Index...>) {
    Arguments<std::remove_cvref_t<Types>...> arguments{
        {giver.template give<Types, before_parameter<Index, Types...>()>()}...};
    if constexpr (std::is_void_v<decltype(Name::call(std::declval<Types>()...))>) {
        Name::call(static_cast<Types&&>(slot_value<Index>(arguments))...);
        giver.template take<Types...>(arguments, Nothing{});
    } else {
        giver.template take<Types...>(
            arguments, Name::call(static_cast<Types&&>(slot_value<Index>(arguments))...));
    }
}

/// Calls a name with arguments from this giver, and gives it what came of it.
template <class Name, class Giver, class... Types>
void call_with(Giver& giver, Parameters<Types...>) {
    call_in_order<Name, Giver, Types...>(giver, std::index_sequence_for<Types...>{});
}

/// The first of these names that the giver can call; Nothing if there is none.
template <class Giver, class First, class... Rest>
constexpr auto first_name(List<First, Rest...>) {
    if constexpr (!std::is_same_v<decltype(choose_parameters<First, Giver>()), Nothing>) {
        return First{};
    } else if constexpr (sizeof...(Rest) > 0) {
        return first_name<Giver>(List<Rest...>{});
    } else {
        return Nothing{};
    }
}

} // namespace rasterwalk_kit
