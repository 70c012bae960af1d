// The colours of the edges, by what the eye can distinguish: distances in Oklab (Ottosson, "A
// perceptual color space for image processing", 2020), where 0.02 is about the smallest visible
// difference, and the contrast of WCAG 2.1.

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "explain/vectors.h"
#include "stages/clip.h"
#include "tests/support/catch.h"
#include "ui/widgets/style.h"

using namespace rasterwalk;

namespace {

double linear(float channel) {
    const auto c = static_cast<double>(channel);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

glm::dvec3 linear(const ImVec4& colour) {
    return {linear(colour.x), linear(colour.y), linear(colour.z)};
}

glm::dvec3 oklab(const ImVec4& colour) {
    const glm::dmat3 to_cones = glm::transpose(
        glm::dmat3{0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451,
                   0.1073969566, 0.0883024619, 0.2817188376, 0.6299787005});
    const glm::dmat3 to_lab = glm::transpose(glm::dmat3{0.2104542553, 0.7936177850, -0.0040720468,
                                                        1.9779984951, -2.4285922050, 0.4505937099,
                                                        0.0259040371, 0.7827717662, -0.8086757660});
    glm::dvec3 cones = to_cones * linear(colour);
    for (int i = 0; i < 3; ++i)
        cones[i] = std::cbrt(cones[i]);
    return to_lab * cones;
}

double contrast(const ImVec4& a, const ImVec4& b) {
    const auto light = [](const ImVec4& colour) {
        return glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), linear(colour)) + 0.05;
    };
    return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

} // namespace

TEST_CASE("Every edge that clipping can make has a colour of its own, in both themes") {
    const int most = 3 + static_cast<int>(clip_plane_count);
    REQUIRE(edge_colour_count >= most);
    for (const Theme theme : {Theme::dark, Theme::light}) {
        for (int a = 0; a < most; ++a) {
            const ImVec4 colour = colour_of(edge_meaning(a), theme);
            CAPTURE(theme == Theme::dark, a);
            CHECK(contrast(colour, palette(theme).ground) >= 4.5);
            for (int b = 0; b < a; ++b) {
                CAPTURE(b);
                const ImVec4 other = colour_of(edge_meaning(b), theme);
                CHECK(glm::distance(oklab(colour), oklab(other)) > 0.12);
            }
        }
    }
}

TEST_CASE("An edge beyond them begins the colours again") {
    CHECK(edge_meaning(edge_colour_count) == edge_meaning(0));
    CHECK(edge_meaning(edge_colour_count + 2) == edge_meaning(2));
}

TEST_CASE("The letters of vectors can be read and told apart, in both themes") {
    constexpr VectorName names[] = {VectorName::normal, VectorName::to_lamp, VectorName::to_eye,
                                    VectorName::half,   VectorName::tangent, VectorName::bitangent};
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const auto colour = [&](VectorName name) { return colour_of(vector_meaning(name), theme); };
        const auto are_different = [&](VectorName a, VectorName b) {
            CAPTURE(theme == Theme::dark, vector_words(a).title, vector_words(b).title);
            // Less than edges: each has its letter as well.
            CHECK(glm::distance(oklab(colour(a)), oklab(colour(b))) > 0.05);
        };
        for (std::size_t i = 0; i < std::size(names); ++i) {
            CAPTURE(theme == Theme::dark, vector_words(names[i]).title);
            CHECK(contrast(colour(names[i]), palette(theme).ground) >= 4.5);
            CHECK(contrast(colour(names[i]), palette(theme).card) >= 4.5);
            for (std::size_t k = 0; k < i; ++k)
                are_different(names[i], names[k]);
        }
        // These are together at a triangle.
        are_different(VectorName::u, VectorName::v);
        are_different(VectorName::u, VectorName::normal);
        CHECK(contrast(colour(VectorName::u), palette(theme).card) >= 4.5);
    }
}
