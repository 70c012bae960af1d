#pragma once

// What a function may be given besides its subject: the window, a colour, a triangle. `Program` is
// the driver's list of the names that a program may have.

#include <concepts>
#include <type_traits>
#include <utility>

#include "asking_calls.h"
#include "asking_names.h"
#include "asking_questions.h"
#include "asking_values.h"

namespace rasterwalk_kit {

template <class Pointer, class... Seen>
constexpr bool is_any_window(List<Seen...>) {
    return (std::is_same_v<std::remove_cvref_t<decltype(Seen::value())>, Pointer> || ...);
}

/// Can a program's function be handed a window of this type?
template <class Program, class Pointer>
constexpr bool has_window() {
    return is_any_window<Pointer>(Values<typename Program::Windows>{}) ||
           Program::template makes_window<Pointer>();
}

template <class Pointer, class Seen>
Pointer window_in() {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(Seen::value())>, Pointer>) {
        return Seen::value();
    } else {
        return nullptr;
    }
}

template <class Pointer, class... Seen>
Pointer window_among(List<Seen...>) {
    Pointer found = nullptr;
    ((found == nullptr ? void(found = window_in<Pointer, Seen>()) : void()), ...);
    return found;
}

/// The program's own window of this type, or one that is made for it.
template <class Program, class Pointer>
Pointer window() {
    static Pointer made = nullptr;
    Pointer found = window_among<Pointer>(Values<typename Program::Windows>{});
    if constexpr (Program::template makes_window<Pointer>()) {
        if (found == nullptr && made == nullptr) made = Program::template make_window<Pointer>();
    }
    return found != nullptr ? found : made;
}

/// The type of the first variable that is a window; Nothing if there is none.
template <class... Seen>
constexpr auto window_type(List<Seen...>) {
    return Nothing{};
}
template <class First, class... Rest>
constexpr auto window_type(List<First, Rest...>) {
    using Type = std::remove_cvref_t<decltype(First::value())>;
    if constexpr (WindowLike<Type>) {
        return Type{};
    } else {
        return window_type(List<Rest...>{});
    }
}

template <class Program, class Window>
void open_window(Window& variable) {
    if constexpr (WindowLike<Window> && !std::is_const_v<Window>) {
        if constexpr (Program::template makes_window<Window>()) {
            if (variable == nullptr) variable = Program::template make_window<Window>();
        }
    }
}

/// Opens the windows that the program's variables do not point to yet.
template <class Program, class... Seen>
void open_windows(List<Seen...>) {
    (open_window<Program>(Seen::value()), ...);
}

/// A triangle of the scene.
template <class Type>
concept TriangleLike = std::is_class_v<Type> && std::copy_constructible<Type> &&
    requires(Type& value) {
    requires Spatial<std::remove_cvref_t<decltype(value.v0)>>;
    requires Spatial<std::remove_cvref_t<decltype(value.v1)>>;
    requires Spatial<std::remove_cvref_t<decltype(value.v2)>>;
    requires Found<decltype(colour_in(value))>;
};

template <class Triangle>
concept TriangleOfParts = std::default_initializable<Triangle> ||
    std::constructible_from<Triangle, decltype(Triangle::v0), decltype(Triangle::v0),
                            decltype(Triangle::v0), decltype(Triangle::v0)> ||
    std::constructible_from<Triangle, decltype(Triangle::v0), decltype(Triangle::v0),
                            decltype(Triangle::v0), glm::vec3>;

/// A triangle of the student's, with this normal and colour.
template <class Triangle>
Triangle triangle_of(const Surface& surface) {
    Triangle given = [] {
        using Corner = decltype(Triangle::v0);
        if constexpr (std::default_initializable<Triangle>) {
            return Triangle{};
        } else if constexpr (std::constructible_from<Triangle, Corner, Corner, Corner, glm::vec3>) {
            return Triangle(Corner{}, Corner{}, Corner{}, glm::vec3{});
        } else {
            return Triangle(Corner{}, Corner{}, Corner{}, Corner{});
        }
    }();
    set_three(*colour_in(given), surface.colour);
    if constexpr (Found<decltype(normal_in(given))>) {
        set_three(*normal_in(given), surface.normal);
    }
    return given;
}

/// The part of a giver that all have. In the lab with vec4, colours still have three numbers, so
/// four are the normal. Two of the same kind are not given: it is not known which is which.
template <class Program, class Question>
struct ExtraGiver {
    Question& question;

    template <class Type, Before before>
    static constexpr bool gives_extra() {
        using Plain = std::remove_cvref_t<Type>;
        if constexpr (WindowLike<Plain>) {
            return has_window<Program, Plain>();
        } else if constexpr (Homogeneous<Plain>) {
            return before.normals == 0;
        } else if constexpr (Spatial<Plain>) {
            return before.colours == 0;
        } else if constexpr (TriangleLike<Plain>) {
            return TriangleOfParts<Plain>;
        } else {
            return false;
        }
    }

    template <class Type>
    auto give_extra() const {
        using Plain = std::remove_cvref_t<Type>;
        if constexpr (WindowLike<Plain>) {
            return window<Program, Plain>();
        } else if constexpr (Spatial<Plain>) {
            Plain given{};
            set_three(given, Homogeneous<Plain> ? question.normal : question.colour);
            return given;
        } else {
            return triangle_of<Plain>(question);
        }
    }
};

} // namespace rasterwalk_kit
