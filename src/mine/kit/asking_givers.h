#pragma once

// What each of the lab's functions is given, and where its answer is found.

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <glm/glm.hpp>

#include "asking_calls.h"
#include "asking_extras.h"
#include "asking_questions.h"
#include "asking_values.h"

namespace rasterwalk_kit {

template <class Type>
constexpr auto pixel_in_parameter() {
    using Plain = std::remove_cvref_t<Type>;
    if constexpr (VectorOf<Plain>) {
        return pixel_in_parameter<typename Plain::value_type>();
    } else if constexpr (PixelLike<Plain> && !Vector<Plain>) {
        return List<Plain>{};
    } else {
        return List<>{};
    }
}

template <class... Types>
constexpr Joined<decltype(pixel_in_parameter<Types>())...> pixels_in(Parameters<Types...>) {
    return {};
}
constexpr List<> pixels_in(Nothing) {
    return {};
}

template <class... Names>
constexpr Joined<decltype(pixels_in(OwnParameters<Names>{}))...>
pixels_in_functions(List<Names...>) {
    return {};
}

template <class... Candidates>
constexpr Joined<std::conditional_t<PixelLike<Candidates>, List<Candidates>, List<>>...>
pixels_among(List<Candidates...>) {
    return {};
}

template <class... Candidates>
constexpr Joined<std::conditional_t<VertexLike<Candidates>, List<Candidates>, List<>>...>
vertices_among(List<Candidates...>) {
    return {};
}

/// The types that may be a program's pixels: those that are called so, those that its functions
/// take, and glm's.
template <class Program>
using PixelTypes = Joined<decltype(pixels_among(Types<typename Program::PixelTypeNames>{})),
                          decltype(pixels_in_functions(typename Program::PolygonRows{})),
                          decltype(pixels_in_functions(typename Program::Interpolate{})),
                          decltype(pixels_in_functions(typename Program::DrawRows{})),
                          List<glm::ivec2, glm::vec2>>;

/// The types that may be its vertices.
template <class Program>
using VertexTypes = Joined<decltype(vertices_among(Types<typename Program::VertexTypeNames>{})),
                           List<glm::vec3, glm::vec4>>;

template <class Vertex, class... Pixels>
constexpr auto usual_vertex_parameters(List<Pixels...>) {
    return List<Parameters<Vertex&, Pixels&>..., Parameters<Vertex&>>{};
}
template <class Program, class... Vertices>
constexpr auto all_vertex_parameters(List<Vertices...>) {
    return Joined<decltype(usual_vertex_parameters<Vertices>(PixelTypes<Program>{}))...>{};
}

/// VertexShader(vertex, pixel), or pixel = VertexShader(vertex).
template <class Program>
struct VertexGiver : ExtraGiver<Program, VertexQuestion> {
    using Usual = decltype(all_vertex_parameters<Program>(VertexTypes<Program>{}));

    template <class Type, Before before>
    static constexpr bool gives() {
        using Plain = std::remove_cvref_t<Type>;
        if constexpr (WindowLike<Plain>) {
            return has_window<Program, Plain>();
        } else if constexpr (before.others == 0) {
            return VertexLike<Plain> && std::default_initializable<Plain>;
        } else {
            return before.others == 1 && PixelLike<Plain> && Changeable<Type> &&
                   std::default_initializable<Plain>;
        }
    }

    template <class Result, class... Types>
    static constexpr bool takes() {
        constexpr std::size_t others = all_parameters<Types...>().others;
        return others == 2 || (others == 1 && PixelLike<std::remove_cvref_t<Result>>);
    }

    template <class Type, Before before>
    auto give() const {
        using Plain = std::remove_cvref_t<Type>;
        if constexpr (WindowLike<Plain>) {
            return window<Program, Plain>();
        } else {
            Plain given{};
            if constexpr (before.others == 0) {
                set_vertex(given, this->question.position, this->question.normal,
                           this->question.colour);
            }
            return given;
        }
    }

    template <class... Types, class All, class Result>
    void take(All& arguments, const Result& result) {
        if constexpr (PixelLike<Result>) {
            this->question.answer = values_of(result);
        } else {
            this->question.answer = values_of(slot_value<other_parameter<Types...>(1)>(arguments));
        }
    }
};

template <class... Samples>
constexpr auto usual_interpolate_parameters(List<Samples...>) {
    return Joined<List<Parameters<Samples&, Samples&, std::vector<Samples>&>,
                       Parameters<Samples&, Samples&, int>>...>{};
}

/// Interpolate(a, b, result), result = Interpolate(a, b, count), or the same for one number.
template <class Program>
struct InterpolateGiver : ExtraGiver<Program, InterpolateQuestion> {
    using Usual = decltype(usual_interpolate_parameters(
        Joined<PixelTypes<Program>, List<glm::vec3, float, int>>{}));

    template <class Type>
    static constexpr bool is_sample = std::default_initializable<Type> &&
                                      (PixelLike<Type> || Number<Type>);

    template <class Type, Before before>
    static constexpr bool gives() {
        using Plain = std::remove_cvref_t<Type>;
        if constexpr (WindowLike<Plain>) {
            return has_window<Program, Plain>();
        } else if constexpr (VectorOf<Plain>) {
            return before.vectors == 0 && Changeable<Type> && is_sample<typename Plain::value_type>;
        } else {
            return before.others < 2 ? is_sample<Plain>
                                     : before.others == 2 && std::integral<Plain>;
        }
    }

    template <class Result, class... Types>
    static constexpr bool takes() {
        constexpr Before all = all_parameters<Types...>();
        if constexpr (VectorOf<Result>) {
            return all.others >= 2 && is_sample<typename std::remove_cvref_t<Result>::value_type>;
        } else {
            return all.others >= 2 && all.vectors == 1;
        }
    }

    template <class Type, Before before>
    auto give() const {
        using Plain = std::remove_cvref_t<Type>;
        const InterpolateQuestion& asked = this->question;
        if constexpr (WindowLike<Plain>) {
            return window<Program, Plain>();
        } else if constexpr (VectorOf<Plain>) {
            return Plain(asked.count);
        } else if constexpr (before.others == 2) {
            return static_cast<Plain>(asked.count);
        } else {
            const PixelValues& values = before.others == 0 ? asked.from : asked.to;
            Plain given{};
            if constexpr (Number<Plain>) {
                given = static_cast<Plain>(asked.is_asked_y ? values.y : values.x);
            } else {
                set_pixel(given, values);
            }
            return given;
        }
    }

    template <class... Types, class All, class Result>
    void take(All& arguments, const Result& result) {
        if constexpr (VectorOf<Result>) {
            take_samples(result);
        } else {
            take_samples(slot_value<vector_parameter<Types...>(0)>(arguments));
        }
    }

  private:
    template <class Samples>
    void take_samples(const Samples& samples) {
        InterpolateQuestion& asked = this->question;
        asked.answer.count = samples.size();
        for (std::size_t i = 0; i < samples.size() && i < most_listed; ++i) {
            PixelValues& values = asked.answer.values[i];
            if constexpr (Number<typename Samples::value_type>) {
                if (!asked.is_asked_y) values = PixelValues{};
                values.fields = field_xy;
                (asked.is_asked_y ? values.y : values.x) = static_cast<double>(samples[i]);
                asked.is_for_numbers = true;
            } else {
                values = values_of(samples[i]);
            }
        }
    }
};

/// A vector of pixels whose elements can be made.
template <class Type>
concept PixelVector =
    VectorOf<Type> && std::default_initializable<typename std::remove_cvref_t<Type>::value_type> &&
    PixelLike<typename std::remove_cvref_t<Type>::value_type>;

template <class Pixels>
Pixels pixels_of(const PixelValues* values, std::size_t count) {
    Pixels pixels(count);
    for (std::size_t i = 0; i < count; ++i)
        set_pixel(pixels[i], values[i]);
    return pixels;
}

/// Lists as many pixels as there is room for.
template <class Pixels>
void list_pixels(PixelList& list, const Pixels& pixels) {
    list.count = pixels.size();
    for (std::size_t i = 0; i < pixels.size() && i < most_listed; ++i) {
        list.values[i] = values_of(pixels[i]);
    }
}

template <class... Pixels>
constexpr auto usual_rows_parameters(List<Pixels...>) {
    return List<Parameters<std::vector<Pixels>&, std::vector<Pixels>&, std::vector<Pixels>&>...>{};
}

/// What holds both lists of rows.
template <class Type>
concept RowsLike = std::is_class_v<Type> && requires(const Type& rows) {
    requires PixelVector<decltype(rows.left)>;
    requires PixelVector<decltype(rows.right)>;
};

/// ComputePolygonRows(polygon, left, right), or rows = ComputePolygonRows(polygon).
template <class Program>
struct RowsGiver : ExtraGiver<Program, RowsQuestion> {
    using Usual = decltype(usual_rows_parameters(PixelTypes<Program>{}));

    template <class Type, Before before>
    static constexpr bool gives() {
        if constexpr (VectorOf<Type>) {
            return PixelVector<Type> && (before.vectors == 0 || Changeable<Type>);
        } else {
            return ExtraGiver<Program, RowsQuestion>::template gives_extra<Type, before>();
        }
    }

    template <class Result, class... Types>
    static constexpr bool takes() {
        constexpr std::size_t vectors = all_parameters<Types...>().vectors;
        return vectors == 3 || (vectors == 1 && RowsLike<std::remove_cvref_t<Result>>);
    }

    template <class Type, Before before>
    auto give() const {
        using Plain = std::remove_cvref_t<Type>;
        if constexpr (!VectorOf<Plain>) {
            return this->template give_extra<Type>();
        } else if constexpr (before.vectors == 0) {
            return pixels_of<Plain>(this->question.polygon, this->question.count);
        } else {
            return Plain{};
        }
    }

    template <class... Types, class All, class Result>
    void take(All& arguments, const Result& result) {
        if constexpr (RowsLike<Result>) {
            list_pixels(this->question.left, result.left);
            list_pixels(this->question.right, result.right);
        } else {
            list_pixels(this->question.left, slot_value<vector_parameter<Types...>(1)>(arguments));
            list_pixels(this->question.right, slot_value<vector_parameter<Types...>(2)>(arguments));
        }
    }
};

template <class Window, class Rows>
using UsualDrawParameters =
    List<Parameters<Rows&, Rows&>, Parameters<Rows&, Rows&, glm::vec3&>,
         Parameters<Window&, Rows&, Rows&>, Parameters<Window&, Rows&, Rows&, glm::vec3&>,
         Parameters<Rows&, Rows&, Window&>, Parameters<Rows&, Rows&, glm::vec3&, Window&>>;

template <class Window, class... Pixels>
constexpr auto usual_draw_parameters(List<Pixels...>) {
    return Joined<UsualDrawParameters<Window, std::vector<Pixels>>...>{};
}

/// DrawPolygonRows(left, right).
template <class Program>
struct DrawGiver : ExtraGiver<Program, DrawQuestion> {
    using Usual = decltype(usual_draw_parameters<typename Program::Window>(PixelTypes<Program>{}));

    template <class Type, Before before>
    static constexpr bool gives() {
        if constexpr (VectorOf<Type>) {
            return PixelVector<Type>;
        } else {
            return ExtraGiver<Program, DrawQuestion>::template gives_extra<Type, before>();
        }
    }

    template <class Result, class... Types>
    static constexpr bool takes() {
        return all_parameters<Types...>().vectors == 2;
    }

    template <class Type, Before before>
    auto give() const {
        using Plain = std::remove_cvref_t<Type>;
        if constexpr (VectorOf<Plain>) {
            const DrawQuestion& asked = this->question;
            return pixels_of<Plain>(before.vectors == 0 ? asked.left : asked.right, asked.count);
        } else {
            return this->template give_extra<Type>();
        }
    }

    template <class... Types, class All, class Result>
    void take(All&, const Result&) {}
};

template <class Window, class Pixel>
using UsualShaderParameters =
    List<Parameters<Pixel&>, Parameters<Pixel&, glm::vec3&>, Parameters<Window&, Pixel&>,
         Parameters<Window&, Pixel&, glm::vec3&>, Parameters<Pixel&, Window&>,
         Parameters<Pixel&, glm::vec3&, Window&>>;

template <class Window, class... Pixels>
constexpr auto usual_shader_parameters(List<Pixels...>) {
    return Joined<UsualShaderParameters<Window, Pixels>...>{};
}

/// PixelShader(pixel).
template <class Program>
struct ShaderGiver : ExtraGiver<Program, ShaderQuestion> {
    using Usual =
        decltype(usual_shader_parameters<typename Program::Window>(PixelTypes<Program>{}));

    template <class Type, Before before>
    static constexpr bool is_pixel =
        before.others == 0 && !WindowLike<Type> && PixelLike<std::remove_cvref_t<Type>>;

    template <class Type, Before before>
    static constexpr bool gives() {
        if constexpr (is_pixel<Type, before>) {
            return std::default_initializable<std::remove_cvref_t<Type>>;
        } else if constexpr (before.others == 0 && !WindowLike<Type>) {
            return false;
        } else {
            return ExtraGiver<Program, ShaderQuestion>::template gives_extra<Type, before>();
        }
    }

    template <class Result, class... Types>
    static constexpr bool takes() {
        return all_parameters<Types...>().others > 0;
    }

    template <class Type, Before before>
    auto give() const {
        if constexpr (is_pixel<Type, before>) {
            std::remove_cvref_t<Type> given{};
            set_pixel(given, this->question.pixel);
            return given;
        } else {
            return this->template give_extra<Type>();
        }
    }

    template <class... Types, class All, class Result>
    void take(All&, const Result&) {}
};

} // namespace rasterwalk_kit
