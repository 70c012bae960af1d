#pragma once

// Varyings: what the vertices hand to the pixels of a polygon, interpolated between them.
//
// With perspective-correct interpolation every member holds q/z instead of q on its way through
// edges and rows, and the pixel shader divides.
//
// To add one: a member of the struct, its pointer in varying_members, its entry in varying_list. A
// step left out does not compile. The operators, the walks along edges and rows, the graph, the
// reports, the panels and the comparison of two runs follow from these three.

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterwalk {

struct Varyings {
    glm::vec3 position_world{0.0f}; ///< for light per pixel (the lab's pos3d)
    glm::vec3 normal{0.0f};         ///< of the vertex, world space
    glm::vec3 colour{0.0f};         ///< reflectance of the vertex, red green blue
    glm::vec2 texcoord{0.0f};       ///< position in a texture, 0..1 in it
    glm::vec3 illumination{0.0f};   ///< for light per vertex: the reflected light, red green blue
};

/// Every member of Varyings, in order. A varying's index is its place here.
inline constexpr std::tuple varying_members{&Varyings::position_world, &Varyings::normal,
                                            &Varyings::colour, &Varyings::texcoord,
                                            &Varyings::illumination};
inline constexpr int varying_count = std::tuple_size_v<decltype(varying_members)>;

template <class... Values>
constexpr std::size_t size_of_members(const std::tuple<Values Varyings::*...>&) {
    return (sizeof(Values) + ...);
}
static_assert(size_of_members(varying_members) == sizeof(Varyings),
              "a member of Varyings is missing from varying_members");

/// Calls `visit` with the pointer to each member, in order.
template <class Visit>
constexpr void for_each_varying(Visit visit) {
    std::apply([&](auto... member) { (visit(member), ...); }, varying_members);
}

/// op(a.m, b.m) for every member m.
template <class Op>
constexpr Varyings each(const Varyings& a, const Varyings& b, Op op) {
    Varyings result;
    for_each_varying([&](auto member) { result.*member = op(a.*member, b.*member); });
    return result;
}

constexpr Varyings operator+(const Varyings& a, const Varyings& b) {
    return each(a, b, [](const auto& p, const auto& q) { return p + q; });
}
constexpr Varyings operator-(const Varyings& a, const Varyings& b) {
    return each(a, b, [](const auto& p, const auto& q) { return p - q; });
}
constexpr Varyings operator*(const Varyings& a, float s) {
    return each(a, a, [s](const auto& p, const auto&) { return p * s; });
}
constexpr Varyings operator/(const Varyings& a, float s) {
    return each(a, a, [s](const auto& p, const auto&) { return p / s; });
}
constexpr bool operator==(const Varyings& a, const Varyings& b) {
    bool same = true;
    each(a, b, [&same](const auto& p, const auto& q) {
        same = same && p == q;
        return p;
    });
    return same;
}

/// The index of a member in varying_members and varying_list.
template <class Value>
constexpr int varying_index(Value Varyings::*wanted) {
    int index = -1, place = 0;
    for_each_varying([&](auto member) {
        if constexpr (std::is_same_v<decltype(member), Value Varyings::*>) {
            if (member == wanted) index = place;
        }
        ++place;
    });
    return index;
}

/// Some of the varyings. A walk carries only those asked for; the others stay as they were at its
/// start, and cost nothing.
struct VaryingSet {
    std::uint32_t bits = 0;

    static constexpr VaryingSet all() { return {(1u << varying_count) - 1u}; }
    template <class... Members>
    static consteval VaryingSet of(Members... members) {
        return {((1u << varying_index(members)) | ... | 0u)};
    }
    constexpr bool has(int index) const { return (bits >> index & 1u) != 0; }
    constexpr VaryingSet operator|(VaryingSet other) const { return {bits | other.bits}; }
    constexpr VaryingSet operator&(VaryingSet other) const { return {bits & other.bits}; }
    friend constexpr bool operator==(VaryingSet, VaryingSet) = default;
};

/// op(into.m, a.m, b.m) for every member m in the set; `op` assigns to its first argument.
template <class Op>
constexpr void each_in(VaryingSet set, Varyings& into, const Varyings& a, const Varyings& b,
                       Op op) {
    int index = 0;
    for_each_varying([&](auto member) {
        if (set.has(index++)) op(into.*member, a.*member, b.*member);
    });
}

/// The words for one component of a varying.
struct VaryingComponent {
    std::string_view id;           ///< "z_world"
    std::string_view name;         ///< "z world"
    std::string_view carried_name; ///< divided by z, as perspective-correct rows carry it: "zw/z"
    std::string_view help;         ///< one sentence
};

/// Where a varying is carried and shown.
enum class VaryingUse : std::uint8_t {
    by_shader, ///< carried and shown only if the pixel shader reads it
    listed,    ///< carried if the pixel shader reads it, shown in every stage
    always,    ///< carried and shown in every stage
};

/// What is known about a varying apart from its type.
struct VaryingInfo {
    std::string_view name;  ///< of the member
    std::string_view word;  ///< in a sentence: "its light is ..."
    std::string_view space; ///< in which its components are measured
    bool is_light = false;  ///< compared as it is seen: relative to full light, not to itself
    VaryingUse use = VaryingUse::by_shader;
    std::array<VaryingComponent, 3> components; ///< `count` of them
    int count = 0;
    float (*component)(const Varyings&, int) = nullptr; ///< 0 <= component < count
};

template <class Value>
constexpr VaryingInfo varying_info(std::string_view name, std::string_view word,
                                   std::string_view space, bool is_light, VaryingUse use,
                                   std::array<VaryingComponent, 3> components,
                                   float (*component)(const Varyings&, int), Value Varyings::*) {
    return {name, word, space, is_light, use, components, sizeof(Value) / sizeof(float), component};
}

/// Component i of a member.
template <auto member>
constexpr float varying_component(const Varyings& varyings, int i) {
    return (varyings.*member)[i];
}

/// All varyings, in the order of varying_members.
inline constexpr std::array varying_list{
    varying_info("position_world", "position in the room", "world", false, VaryingUse::listed,
                 {{{"x", "x", "x/z", "x of the position in the world."},
                   {"y", "y", "y/z", "y of the position in the world; it points down."},
                   {"z_world", "z world", "zw/z",
                    "z of the position in the world, which is not the depth: depth counts from the "
                    "camera."}}},
                 varying_component<&Varyings::position_world>, &Varyings::position_world),
    varying_info("normal", "normal", "world", false, VaryingUse::by_shader,
                 {{{"normal_x", "normal x", "nx/z", "x of the normal, interpolated."},
                   {"normal_y", "normal y", "ny/z", "y of the normal, interpolated."},
                   {"normal_z", "normal z", "nz/z", "z of the normal, interpolated."}}},
                 varying_component<&Varyings::normal>, &Varyings::normal),
    varying_info(
        "colour", "colour", "reflectance", true, VaryingUse::by_shader,
        {{{"colour_red", "colour red", "cr/z", "Red of the reflectance, interpolated."},
          {"colour_green", "colour green", "cg/z", "Green of the reflectance, interpolated."},
          {"colour_blue", "colour blue", "cb/z", "Blue of the reflectance, interpolated."}}},
        varying_component<&Varyings::colour>, &Varyings::colour),
    varying_info("texcoord", "position in the texture", "texture", false, VaryingUse::by_shader,
                 {{{"u", "u", "u/z", "u of the position in the texture, interpolated."},
                   {"v", "v", "v/z", "v of the position in the texture, interpolated."}}},
                 varying_component<&Varyings::texcoord>, &Varyings::texcoord),
    varying_info("illumination", "light", "light", true, VaryingUse::listed,
                 {{{"red", "red", "red/z", "Red of the light per vertex, interpolated."},
                   {"green", "green", "green/z", "Green of the light per vertex, interpolated."},
                   {"blue", "blue", "blue/z", "Blue of the light per vertex, interpolated."}}},
                 varying_component<&Varyings::illumination>, &Varyings::illumination),
};
static_assert(varying_list.size() == varying_count, "a varying is missing from varying_list");

/// The varyings with this use.
constexpr VaryingSet varyings_with(VaryingUse use) {
    VaryingSet set;
    for (int i = 0; i < varying_count; ++i) {
        if (varying_list[i].use == use) set.bits |= 1u << i;
    }
    return set;
}

} // namespace rasterwalk
