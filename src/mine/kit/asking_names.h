#pragma once

// What a name is in the student's program: a variable, a function, an enumerator, a macro's value,
// a type, or nothing. The driver makes a struct of each name, with `look` and for functions `call`
// and `is_missing`.

#include <type_traits>

namespace rasterwalk_kit {

/// Stands for what a program does not have.
struct Nothing {};

/// Is passed where an argument only serves to put off a decision until a template is used.
struct Later {};

/// A variable or function of the student's.
template <auto& Value>
struct Variable {
    static constexpr bool is_value = !std::is_function_v<std::remove_reference_t<decltype(Value)>>;
    static constexpr auto& value() { return Value; }
};

/// An enumerator of the student's.
template <auto Value>
struct Enumerator {
    static constexpr bool is_value = true;
    static auto& value() {
        static auto number = static_cast<double>(Value);
        return number;
    }
};

/// The value of a macro of the student's, which this function returns.
template <auto Value>
struct Macro {
    static constexpr bool is_value = true;
    static auto& value() {
        static auto known = Value();
        return known;
    }
};

template <class Function>
struct IsMacroValue : std::false_type {};
template <class Result>
struct IsMacroValue<Result()> : std::negation<std::is_void<Result>> {};

/// The type of a function that returns the value of a macro.
template <class Function>
concept MacroValue = IsMacroValue<Function>::value;

/// A type of the student's.
template <class Type>
struct TypeFound {
    static constexpr bool is_value = false;
    using type = Type;
};

/// None of these, or several functions of one name.
struct NotSingle {
    static constexpr bool is_value = false;
};

template <auto& Value>
constexpr Variable<Value> single(Later) {
    return {};
}
template <auto Value>
requires std::is_enum_v<decltype(Value)>
constexpr Enumerator<Value> single(Later) {
    return {};
}
template <class Type>
constexpr TypeFound<Type> single(Later) {
    return {};
}

/// Names, or types, in the order in which they are preferred.
template <class... Entries>
struct List {};

template <class... Left, class... Right>
constexpr List<Left..., Right...> operator+(List<Left...>, List<Right...>) {
    return {};
}

/// All entries of these lists.
template <class... Lists>
using Joined = decltype((List<>{} + ... + Lists{}));

/// What a name is.
template <class Name>
using Look = decltype(Name::look(Later{}));

template <class... Names>
constexpr Joined<std::conditional_t<Look<Names>::is_value, List<Look<Names>>, List<>>...>
values_among(List<Names...>) {
    return {};
}

/// Those of these names that have a value, as what they are.
template <class Names>
using Values = decltype(values_among(Names{}));

template <class Name>
constexpr auto type_called() {
    if constexpr (requires { typename Look<Name>::type; }) {
        return List<typename Look<Name>::type>{};
    } else {
        return List<>{};
    }
}

template <class... Names>
constexpr Joined<decltype(type_called<Names>())...> types_among(List<Names...>) {
    return {};
}

/// Those of these names that are types, as these types.
template <class Names>
using Types = decltype(types_among(Names{}));

} // namespace rasterwalk_kit
