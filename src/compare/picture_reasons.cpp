#include "compare/picture_reasons.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "base/numbers.h"
#include "picture/view_image.h"

namespace rasterwalk {

namespace {

/// Where a pixel is in the planes.
std::size_t place_of(const DrawnPicture& of, glm::ivec2 place) {
    return of.planes.at(of.planes.origin.x + place.x, of.planes.origin.y + place.y);
}

/// The triangle of the given scene that a pixel shows; -1: none.
int shown_triangle(const DrawnPicture& of, glm::ivec2 place) {
    const int owner = of.planes.owner[place_of(of, place)];
    if (owner < 0) return -1;
    return scene_triangle(*of.frame.scene, owner) / of.frame.triangles_of_each();
}

/// Calls this with a pixel and those around it.
template <class Visit>
void for_each_around(glm::ivec2 place, Viewport size, const Visit& visit) {
    for (int row = std::max(place.y - 1, 0); row <= std::min(place.y + 1, size.height - 1); ++row) {
        for (int column = std::max(place.x - 1, 0); column <= std::min(place.x + 1, size.width - 1);
             ++column)
            visit(glm::ivec2(column, row));
    }
}

bool is_on_outline(const DrawnPicture& of, glm::ivec2 place) {
    const int here = shown_triangle(of, place);
    bool differs = false;
    for_each_around(place, of.planes.size, [&](glm::ivec2 near) {
        differs = differs || shown_triangle(of, near) != here;
    });
    return differs;
}

/// Is nothing drawn there although something is on both sides, in some direction?
bool is_hole(const DrawnPicture& of, glm::ivec2 place) {
    if (shown_triangle(of, place) >= 0) return false;
    const Viewport size = of.planes.size;
    const auto is_covered = [&](glm::ivec2 at) {
        const bool is_inside = at.x >= 0 && at.y >= 0 && at.x < size.width && at.y < size.height;
        return is_inside && shown_triangle(of, at) >= 0;
    };
    constexpr std::array directions{glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1),
                                    glm::ivec2(1, -1)};
    return std::any_of(directions.begin(), directions.end(), [&](glm::ivec2 step) {
        return is_covered(place + step) && is_covered(place - step);
    });
}

/// Do all channels differ by one 255th at most, as they are shown?
bool is_alike(const DrawnPicture& a, const DrawnPicture& b, glm::ivec2 place) {
    const glm::vec3 in_a = shown_colour(a.planes.colour[place_of(a, place)], a.planes.rules.screen);
    const glm::vec3 in_b = shown_colour(b.planes.colour[place_of(b, place)], b.planes.rules.screen);
    constexpr float one_byte = 1.0f / 255.0f + 1e-6f;
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(in_a[i] - in_b[i]) <= one_byte)) return false;
    }
    return true;
}

PixelReason reason_of(const DrawnPicture& a, const DrawnPicture& b, glm::ivec2 place) {
    if (shown_triangle(a, place) == shown_triangle(b, place))
        return is_alike(a, b, place) ? PixelReason::rounding : PixelReason::colour;
    if (is_hole(a, place) || is_hole(b, place)) return PixelReason::crack;
    if (is_on_outline(a, place) || is_on_outline(b, place)) return PixelReason::coverage;
    const bool is_empty_in_one = shown_triangle(a, place) < 0 || shown_triangle(b, place) < 0;
    return is_empty_in_one ? PixelReason::left_out : PixelReason::depth;
}

std::string shown_words(const DrawnPicture& of, glm::ivec2 place) {
    const int triangle = shown_triangle(of, place);
    if (triangle < 0) return "nothing";
    return fmt::format("{} (triangles[{}])", part_name(*of.frame.given, triangle), triangle);
}

/// What the run keeps of a colour.
std::string_view precision_words(Engine engine) {
    return engine == Engine::fast || engine == Engine::opengl ? "8 bits per channel" : "floats";
}

std::string why(PixelReason reason, const DrawnPicture& a, const DrawnPicture& b) {
    switch (reason) {
    case PixelReason::rounding:
        if (precision_words(a.engine) != precision_words(b.engine)) {
            return fmt::format("their colours are at most 1/255 apart: A keeps {}, B {}",
                               precision_words(a.engine), precision_words(b.engine));
        }
        return "their colours are at most 1/255 apart";
    case PixelReason::colour:
        return "it is the same triangle, in different colours";
    case PixelReason::coverage: {
        const std::string in_a = coverage_words(a), in_b = coverage_words(b);
        if (in_a == in_b) return "an outline is there, and they do not agree about it";
        return fmt::format("A finds the pixels of a triangle {}, B {}", in_a, in_b);
    }
    case PixelReason::crack:
        return "triangles meet there, and one of the runs covers the pixel with neither of them";
    case PixelReason::left_out:
        return "only one of them draws anything there: the other leaves out, or cuts, what it "
               "draws";
    case PixelReason::depth:
        return "one triangle is in front of the other, and they disagree about which";
    }
    return {};
}

} // namespace

const std::array<PixelReasonWords, pixel_reason_count>& pixel_reason_list() {
    static constexpr std::array<PixelReasonWords, pixel_reason_count> list{{
        {PixelReason::rounding, "by 1/255 or less",
         "Both show the same triangle, in colours at most 1/255 apart."},
        {PixelReason::colour, "in colour",
         "Both show the same triangle, in colours more than 1/255 apart."},
        {PixelReason::coverage, "on outlines",
         "They show different triangles where two triangles meet, or where one ends."},
        {PixelReason::crack, "in cracks",
         "One picture has a hole there, with something drawn on both sides of it."},
        {PixelReason::left_out, "left out",
         "Only one of them draws anything there: the other leaves out, or cuts, what it draws."},
        {PixelReason::depth, "in depth",
         "They show different triangles, away from any outline: they disagree about which "
         "is in front."},
    }};
    static_assert(is_indexed_by(list, &PixelReasonWords::reason));
    return list;
}

std::string coverage_words(const DrawnPicture& picture) {
    if (picture.engine == Engine::rays) return "by a ray through each pixel's centre";
    const Settings& settings = picture.frame.settings;
    const bool is_steps = picture.engine == Engine::steps;
    if (is_steps && coverage_rule(settings) == Coverage::rows)
        return "by rows between the samples of its edges";
    // The other engines snap corners as finely as that.
    const Snap snap = is_steps ? settings.snap : Snap::subpixel;
    const std::string_view corners = snap == Snap::pixel       ? "at whole pixels"
                                     : snap == Snap::sixteenth ? "at 16ths of a pixel"
                                                               : "at fine fractions of a pixel";
    return fmt::format("by testing each pixel's centre, with corners {}", corners);
}

void PictureReasons::add(const DrawnPicture& a, const DrawnPicture& b, glm::ivec2 place) {
    const PixelReason reason = reason_of(a, b, place);
    ++counts_[static_cast<std::size_t>(reason)];
    std::optional<DifferentPixel>& first =
        reason == PixelReason::rounding ? first_ : beyond_rounding_;
    if (first) return;
    first = DifferentPixel{place, reason,
                           fmt::format("A shows {} and B {}; {}.", shown_words(a, place),
                                       shown_words(b, place), why(reason, a, b))};
}

} // namespace rasterwalk
