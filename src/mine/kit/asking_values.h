#pragma once

// How a question's numbers get into a student's own types, and back. Which members a type has is
// found out from a list of usual names; nothing is assumed about the type itself.
//
// Include this before the student's code: a macro of theirs could change what is written here.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "asking_names.h"
#include "recording.h"

namespace rasterwalk_kit {

/// A pointer to something that was found.
template <class Pointer>
concept Found = !std::is_same_v<std::remove_cv_t<std::remove_pointer_t<Pointer>>, Nothing>;

template <class Type>
concept Number = std::is_arithmetic_v<Type>;

/// Has numbers x and y: glm's vectors, and structs of the student's.
template <class Type>
concept Flat = requires(Type& value) {
    requires Number<std::remove_cvref_t<decltype(value.x)>>;
    requires Number<std::remove_cvref_t<decltype(value.y)>>;
};

/// Has numbers x, y and z.
template <class Type>
concept Spatial = Flat<Type> && requires(Type& value) {
    requires Number<std::remove_cvref_t<decltype(value.z)>>;
};

/// Has numbers x, y, z and w.
template <class Type>
concept Homogeneous = Spatial<Type> && requires(Type& value) {
    requires Number<std::remove_cvref_t<decltype(value.w)>>;
};

/// Only x and y, and nothing that could be depth.
template <class Type>
concept Planar = Flat<Type> && !Spatial<Type>;

/// A colour, or one brightness.
template <class Type>
concept Bright = Spatial<Type> || Number<Type>;

/// A vector as glm has them: nothing but its components.
template <class Type>
concept Vector = Flat<Type> && requires(Type& value) {
    typename Type::value_type;
    value[0];
};

/// A matrix as glm has them, at least 3 x 3.
template <class Type>
concept Matrix = requires(Type& value) {
    typename Type::col_type;
    requires Number<std::remove_cvref_t<decltype(value[0][0])>>;
    requires Spatial<typename Type::col_type>;
};

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the name of a member cannot be a parameter.
#define RASTERWALK_MEMBER(member, Kind)                                                            \
    if constexpr (requires { requires Kind<std::remove_cvref_t<decltype(holder.member)>>; }) {     \
        return &holder.member;                                                                     \
    } else

/// Where a pixel's x and y are: in the holder itself or in one of its members.
/// @returns a pointer to what has x and y, or to Nothing
template <class Holder>
constexpr auto flat_in(Holder& holder) {
    if constexpr (Flat<std::remove_cv_t<Holder>>) {
        return &holder;
    } else
        RASTERWALK_MEMBER(position, Planar)
    RASTERWALK_MEMBER(pos, Planar)
    RASTERWALK_MEMBER(p, Planar)
    RASTERWALK_MEMBER(pixel, Planar)
    RASTERWALK_MEMBER(screen, Planar)
    RASTERWALK_MEMBER(screenPos, Planar)
    RASTERWALK_MEMBER(coord, Planar)
    RASTERWALK_MEMBER(coords, Planar)
    RASTERWALK_MEMBER(xy, Planar)
    RASTERWALK_MEMBER(pos2d, Planar)
    RASTERWALK_MEMBER(pos2D, Planar)
    return static_cast<Nothing*>(nullptr);
}

/// Where 1/z is. `depth` and `z` come last, because they may be meant for z itself.
template <class Holder>
constexpr auto reciprocal_in(Holder& holder) {
    RASTERWALK_MEMBER(zinv, Number)
    RASTERWALK_MEMBER(zInv, Number)
    RASTERWALK_MEMBER(z_inv, Number)
    RASTERWALK_MEMBER(zINV, Number)
    RASTERWALK_MEMBER(Zinv, Number)
    RASTERWALK_MEMBER(ZInv, Number)
    RASTERWALK_MEMBER(invZ, Number)
    RASTERWALK_MEMBER(invz, Number)
    RASTERWALK_MEMBER(inv_z, Number)
    RASTERWALK_MEMBER(inverseZ, Number)
    RASTERWALK_MEMBER(zInverse, Number)
    RASTERWALK_MEMBER(zinverse, Number)
    RASTERWALK_MEMBER(oneOverZ, Number)
    RASTERWALK_MEMBER(one_over_z, Number)
    RASTERWALK_MEMBER(invDepth, Number)
    RASTERWALK_MEMBER(depth, Number)
    RASTERWALK_MEMBER(z, Number)
    return static_cast<Nothing*>(nullptr);
}

/// Where the position in the scene is that a pixel carries.
template <class Holder>
constexpr auto place_in(Holder& holder) {
    RASTERWALK_MEMBER(pos3d, Spatial)
    RASTERWALK_MEMBER(pos3D, Spatial)
    RASTERWALK_MEMBER(Pos3d, Spatial)
    RASTERWALK_MEMBER(Pos3D, Spatial)
    RASTERWALK_MEMBER(pos_3d, Spatial)
    RASTERWALK_MEMBER(pos3, Spatial)
    RASTERWALK_MEMBER(p3d, Spatial)
    RASTERWALK_MEMBER(point3d, Spatial)
    RASTERWALK_MEMBER(position3d, Spatial)
    RASTERWALK_MEMBER(position3D, Spatial)
    RASTERWALK_MEMBER(position_3d, Spatial)
    RASTERWALK_MEMBER(worldPos, Spatial)
    RASTERWALK_MEMBER(world_pos, Spatial)
    RASTERWALK_MEMBER(worldPosition, Spatial)
    RASTERWALK_MEMBER(world, Spatial)
    RASTERWALK_MEMBER(position, Spatial)
    RASTERWALK_MEMBER(pos, Spatial)
    return static_cast<Nothing*>(nullptr);
}

/// Where the light is that a pixel carries.
template <class Holder>
constexpr auto light_in(Holder& holder) {
    RASTERWALK_MEMBER(illumination, Bright)
    RASTERWALK_MEMBER(Illumination, Bright)
    RASTERWALK_MEMBER(illum, Bright)
    RASTERWALK_MEMBER(light, Bright)
    RASTERWALK_MEMBER(brightness, Bright)
    RASTERWALK_MEMBER(intensity, Bright)
    RASTERWALK_MEMBER(color, Bright)
    RASTERWALK_MEMBER(colour, Bright)
    return static_cast<Nothing*>(nullptr);
}

/// Where the place of a vertex, of a camera or of a lamp is.
template <class Holder>
constexpr auto position_in(Holder& holder) {
    RASTERWALK_MEMBER(position, Spatial)
    RASTERWALK_MEMBER(pos, Spatial)
    RASTERWALK_MEMBER(Position, Spatial)
    RASTERWALK_MEMBER(location, Spatial)
    RASTERWALK_MEMBER(origin, Spatial)
    RASTERWALK_MEMBER(eye, Spatial)
    RASTERWALK_MEMBER(p, Spatial)
    RASTERWALK_MEMBER(v, Spatial)
    RASTERWALK_MEMBER(cameraPos, Spatial)
    RASTERWALK_MEMBER(lightPos, Spatial)
    return static_cast<Nothing*>(nullptr);
}

/// Where the normal of a vertex or triangle is.
template <class Holder>
constexpr auto normal_in(Holder& holder) {
    RASTERWALK_MEMBER(normal, Spatial)
    RASTERWALK_MEMBER(Normal, Spatial)
    RASTERWALK_MEMBER(norm, Spatial)
    RASTERWALK_MEMBER(n, Spatial)
    return static_cast<Nothing*>(nullptr);
}

/// Where the colour of a vertex or triangle is.
template <class Holder>
constexpr auto colour_in(Holder& holder) {
    RASTERWALK_MEMBER(reflectance, Bright)
    RASTERWALK_MEMBER(reflectivity, Bright)
    RASTERWALK_MEMBER(color, Bright)
    RASTERWALK_MEMBER(colour, Bright)
    RASTERWALK_MEMBER(albedo, Bright)
    return static_cast<Nothing*>(nullptr);
}

/// A pixel of the student's: a type with x and y somewhere.
template <class Type>
concept PixelLike = std::is_class_v<Type> && Found<decltype(flat_in(std::declval<Type&>()))>;

/// A vertex of the student's: a position, or a struct with one.
template <class Type>
concept VertexLike = Spatial<Type> ||
    (std::is_class_v<Type>&& Found<decltype(position_in(std::declval<Type&>()))>);

/// Three numbers of the student's, as doubles; one number is repeated.
template <class Type>
std::array<double, 3> three_of(const Type& value) {
    if constexpr (Spatial<Type>) {
        return {static_cast<double>(value.x), static_cast<double>(value.y),
                static_cast<double>(value.z)};
    } else {
        const auto number = static_cast<double>(value);
        return {number, number, number};
    }
}

/// Sets x, y and z, and w to 1 where there is one; of one number, to the first.
template <class Type>
void set_three(Type& value, const double* numbers) {
    if constexpr (Spatial<Type>) {
        value.x = static_cast<std::remove_reference_t<decltype(value.x)>>(numbers[0]);
        value.y = static_cast<std::remove_reference_t<decltype(value.y)>>(numbers[1]);
        value.z = static_cast<std::remove_reference_t<decltype(value.z)>>(numbers[2]);
        if constexpr (requires { value.w = 1; }) {
            value.w = 1;
        }
    } else {
        value = static_cast<Type>(numbers[0]);
    }
}

/// Gives a pixel of the student's the values of a question, as far as it has members for them.
template <class Pixel>
void set_pixel(Pixel& pixel, const PixelValues& values) {
    auto* const flat = flat_in(pixel);
    flat->x = static_cast<std::remove_reference_t<decltype(flat->x)>>(values.x);
    flat->y = static_cast<std::remove_reference_t<decltype(flat->y)>>(values.y);
    auto* const reciprocal = reciprocal_in(pixel);
    if constexpr (Found<std::remove_const_t<decltype(reciprocal)>>) {
        *reciprocal = static_cast<std::remove_reference_t<decltype(*reciprocal)>>(values.zinv);
    }
    auto* const place = place_in(pixel);
    if constexpr (Found<std::remove_const_t<decltype(place)>>) {
        set_three(*place, values.place);
    }
    auto* const light = light_in(pixel);
    if constexpr (Found<std::remove_const_t<decltype(light)>>) {
        set_three(*light, values.light);
    }
}

/// What a pixel of the student's holds.
template <class Pixel>
PixelValues values_of(const Pixel& pixel) {
    PixelValues values{};
    std::uint32_t fields = field_xy;
    const auto* const flat = flat_in(pixel);
    values.x = static_cast<double>(flat->x);
    values.y = static_cast<double>(flat->y);
    const auto* const reciprocal = reciprocal_in(pixel);
    if constexpr (Found<std::remove_const_t<decltype(reciprocal)>>) {
        fields |= field_zinv;
        values.zinv = static_cast<double>(*reciprocal);
    }
    const auto* const place = place_in(pixel);
    if constexpr (Found<std::remove_const_t<decltype(place)>>) {
        fields |= field_place;
        const std::array<double, 3> three = three_of(*place);
        std::copy(three.begin(), three.end(), values.place);
    }
    const auto* const light = light_in(pixel);
    if constexpr (Found<std::remove_const_t<decltype(light)>>) {
        fields |= field_light;
        const std::array<double, 3> three = three_of(*light);
        std::copy(three.begin(), three.end(), values.light);
    }
    values.fields = fields;
    return values;
}

/// Gives a vertex of the student's a position, a normal and a colour: three numbers each.
template <class Vertex>
void set_vertex(Vertex& vertex, const double* position, const double* normal,
                const double* colour) {
    if constexpr (Spatial<Vertex>) {
        set_three(vertex, position);
    } else {
        set_three(*position_in(vertex), position);
        auto* const own_normal = normal_in(vertex);
        if constexpr (Found<std::remove_const_t<decltype(own_normal)>>) {
            set_three(*own_normal, normal);
        }
        auto* const own_colour = colour_in(vertex);
        if constexpr (Found<std::remove_const_t<decltype(own_colour)>>) {
            set_three(*own_colour, colour);
        }
    }
}

/// A value behind a raw or smart pointer, or the value itself.
/// @returns a pointer, null if theirs is
template <class Type>
auto* behind(Type& value) {
    if constexpr (std::is_pointer_v<std::remove_cv_t<Type>>) {
        return value;
    } else if constexpr (requires {
                             value.get();
                             *value;
                         }) {
        return value.get();
    } else {
        return &value;
    }
}

} // namespace rasterwalk_kit
