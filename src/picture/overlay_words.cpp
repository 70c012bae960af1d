// What the overlays say: their totals, the ends of their scales, and what they have at a pixel.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "picture/overlay.h"

namespace rasterwalk {

namespace {

/// What a pixel took, all that is in its total, without what it took none of: "3 fragments, 3 depth
/// tests, 2 lights".
std::string cost_words(const PixelCost& cost) {
    std::string words = counted(cost.fragments, "fragment", "fragments");
    const auto add = [&](std::uint32_t count, const char* one, const char* many) {
        if (count > 0) words += ", " + counted(count, one, many);
    };
    add(cost.depth_tests, "depth test", "depth tests");
    add(cost.lights, "light", "lights");
    add(cost.shadow_tests, "shadow test", "shadow tests");
    add(cost.texels, "texel", "texels");
    return words;
}

double distance_to_wire(const WireEdge& wire, glm::ivec2 pixel) {
    const double dx = wire.to.x - wire.from.x, dy = wire.to.y - wire.from.y;
    const double px = pixel.x - wire.from.x, py = pixel.y - wire.from.y;
    const double length2 = dx * dx + dy * dy;
    const double t = length2 > 0.0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(px - t * dx, py - t * dy);
}

const WireEdge* nearest_wire(const OverlayPicture& picture, glm::ivec2 pixel, double reach) {
    const WireEdge* nearest = nullptr;
    for (const WireEdge& wire : picture.wires) {
        const double distance = distance_to_wire(wire, pixel);
        if (distance > reach) continue;
        nearest = &wire;
        reach = distance;
    }
    return nearest;
}

/// In square pixels, to four digits after the point.
std::string number_of_e(std::int64_t e) {
    std::string text = decimals_without_zeros(in_square_pixels(e), 4);
    // Rounded to 0 it would seem to lie on the edge.
    if (e != 0 && (text == "0" || text == "-0")) text = scientific(in_square_pixels(e), 2);
    return with_minus_signs(text);
}

/// "E = −12.5 square pixels"
std::string words_of_e(std::int64_t e) {
    const std::string number = number_of_e(e);
    return fmt::format("E = {} {}", number, unit_for(number, "square pixels"));
}

std::string short_level(float level) {
    return decimals_without_zeros(static_cast<double>(level), 2);
}

/// "level 2", "level 1.37"
std::string level_words(float level) {
    return level == no_mip_level ? "no texture" : "level " + short_level(level);
}

/// "0.250 of [0], 0.500 of [1], 0.250 of [2]", by vertex.
std::string weight_words(const WeightParts& weights) {
    std::array<const WeightPart*, edge_function_count> by_vertex;
    for (std::size_t i = 0; i < by_vertex.size(); ++i)
        by_vertex[i] = &weights.parts[i];
    std::sort(by_vertex.begin(), by_vertex.end(),
              [](const WeightPart* a, const WeightPart* b) { return a->vertex < b->vertex; });
    std::string words;
    for (const WeightPart* const part : by_vertex) {
        words += fmt::format("{}{} of [{}]", words.empty() ? "" : ", ",
                             with_minus_signs(decimals(static_cast<double>(part->weight), 3)),
                             part->vertex);
    }
    return words;
}

} // namespace

std::string overlay_total(Overlay overlay, const Frame& frame, const OverlayPicture& picture) {
    const OverlayTotals& totals = picture.totals;
    switch (overlay) {
    case Overlay::wireframe:
        if (totals.wires > most_wires) {
            return fmt::format("the first {} of {}", most_wires,
                               counted(totals.wires, "edge", "edges"));
        }
        return counted(totals.wires, "edge", "edges");
    case Overlay::owner:
        return fmt::format("{} of {} seen", totals.visible_triangles,
                           counted(frame.triangle_count(), "triangle", "triangles"));
    case Overlay::overdraw:
        return fmt::format("{}, at most {} on a pixel",
                           counted(totals.fragments, "fragment", "fragments"),
                           totals.most_overdraw);
    case Overlay::drawn_twice:
        return counted(totals.drawn_twice, "pixel", "pixels");
    case Overlay::depth:
        if (picture.facts.depth.empty()) return "there is no depth test";
        return fmt::format("{} failed on {}", totals.failed_fragments,
                           counted(totals.failed_pixels, "pixel", "pixels"));
    case Overlay::uncovered:
        return counted(totals.uncovered, "pixel", "pixels");
    case Overlay::over_one:
        return fmt::format("{}, the brightest {:.2f}", counted(totals.over_one, "pixel", "pixels"),
                           totals.brightest);
    case Overlay::affine_error:
        return fmt::format("at most {:.3f}, mean {:.3f} world units", totals.largest_error,
                           totals.mean_error);
    case Overlay::cost:
        if (!picture.cost.is_counted()) return "counting …";
        return fmt::format("{}, at most {} on a pixel",
                           counted(totals.cost, "piece of work", "pieces of work"),
                           totals.most_cost);
    case Overlay::edge_field:
        if (!picture.field) return "no triangle with an area is shown";
        return fmt::format("{} of {}", edge_name(picture.field->edge.number),
                           triangle_name(picture.field->triangle));
    case Overlay::weights:
        if (!picture.weights) return "pick a pixel, and a triangle that has an area";
        return fmt::format("({},{}) in {}", picture.weights->pixel.x, picture.weights->pixel.y,
                           triangle_name(picture.weights->triangle));
    case Overlay::mip_level:
        if (totals.most_level == no_mip_level) return "no pixel has a texture";
        if (totals.least_level == totals.most_level) return level_words(totals.most_level);
        return fmt::format("levels {} to {}", short_level(totals.least_level),
                           short_level(totals.most_level));
    case Overlay::alone:
        if (!picture.lone.triangle()) return "no triangle is selected";
        if (!frame.is_drawn(*picture.lone.triangle()))
            return triangle_name(*picture.lone.triangle()) + " is left out";
        return fmt::format("{}, {} drawn", triangle_name(*picture.lone.triangle()),
                           counted(picture.lone.pixels(), "pixel", "pixels"));
    case Overlay::vectors:
        break;
    }
    return {};
}

std::array<std::string, 2> overlay_scale(Overlay overlay, const OverlayPicture& picture) {
    if (overlay == Overlay::overdraw) return {"1", std::to_string(picture.totals.most_overdraw)};
    if (overlay == Overlay::cost && picture.cost.is_counted())
        return {"0", std::to_string(picture.totals.most_cost)};
    if (overlay == Overlay::affine_error)
        return {"0", decimals(static_cast<double>(picture.totals.largest_error), 3)};
    if (overlay == Overlay::edge_field && picture.field) {
        const std::string largest = decimals(in_square_pixels(picture.field->largest), 0);
        return {"−" + largest, largest};
    }
    if (overlay == Overlay::mip_level)
        return {"level 0", fmt::format("{} and more", top_mip_colour)};
    return {};
}

std::string overlay_value(Overlay overlay, const Frame& frame, const Framebuffer& framebuffer,
                          const OverlayPicture& picture, glm::ivec2 pixel, float reach) {
    if (!framebuffer.contains(pixel.x, pixel.y)) return {};
    const std::size_t at = framebuffer.at(pixel.x, pixel.y);
    const int owner = framebuffer.owner[at];
    switch (overlay) {
    case Overlay::wireframe: {
        const WireEdge* const wire = nearest_wire(picture, pixel, static_cast<double>(reach));
        if (wire == nullptr) return "no edge";
        return fmt::format("{} of {}", edge_name(wire->edge), triangle_name(wire->triangle));
    }
    case Overlay::owner:
        if (owner < 0) return "none";
        return fmt::format("{}, {}", triangle_name(owner), part_words(*frame.scene, owner));
    case Overlay::overdraw:
        return counted(framebuffer.overdraw[at], "fragment", "fragments");
    case Overlay::drawn_twice: {
        const DrawnTwice& twice = picture.facts.drawn_twice[at];
        if (!twice) return "no";
        return fmt::format("{} and {}", triangle_name(twice.first), triangle_name(twice.second));
    }
    case Overlay::depth:
        if (picture.facts.depth.empty()) return {};
        return fmt::format("{} passed, {} failed", picture.facts.depth[at].passed,
                           picture.facts.depth[at].failed);
    case Overlay::uncovered:
        return framebuffer.overdraw[at] == 0 ? "uncovered" : "covered";
    case Overlay::over_one: {
        if (owner < 0) return "none";
        const glm::vec3& colour = framebuffer.colour[at];
        return decimals(static_cast<double>(std::max({colour.r, colour.g, colour.b})), 3);
    }
    case Overlay::affine_error:
        return owner < 0 ? "none"
                         : decimals(static_cast<double>(picture.facts.affine_error[at]), 4);
    case Overlay::cost:
        return picture.cost.is_counted() ? cost_words(picture.cost.pixels()[at]) : std::string();
    case Overlay::edge_field:
        if (!picture.field) return {};
        return words_of_e(picture.field->at(pixel.x, pixel.y));
    case Overlay::weights:
        return picture.weights && picture.weights->pixel == pixel ? weight_words(*picture.weights)
                                                                  : std::string();
    case Overlay::mip_level:
        return level_words(picture.facts.mip_level[at]);
    case Overlay::alone:
        return picture.lone.triangle() && picture.lone.picture().owner[at] >= 0 ? "drawn"
                                                                                : "not drawn";
    case Overlay::vectors:
        break;
    }
    return {};
}

} // namespace rasterwalk
