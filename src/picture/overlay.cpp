#include "picture/overlay.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "picture/colour_map.h"

namespace rasterwalk {

namespace {

constexpr glm::vec<3, std::uint8_t> orange{230, 159, 0};
constexpr glm::vec<3, std::uint8_t> sky_blue{86, 180, 233};
constexpr glm::vec<3, std::uint8_t> yellow{240, 228, 66};
constexpr glm::vec<3, std::uint8_t> vermillion{213, 94, 0};
constexpr glm::vec<3, std::uint8_t> reddish_purple{204, 121, 167};

/// From the lowest layer to the highest: tints of everything first, then what marks few pixels.
constexpr Overlay layers[] = {Overlay::owner,     Overlay::overdraw,   Overlay::cost,
                              Overlay::mip_level, Overlay::edge_field, Overlay::affine_error,
                              Overlay::depth,     Overlay::over_one,   Overlay::drawn_twice,
                              Overlay::uncovered};

/// What overlay_tint() takes for E = 0.
constexpr float middle_amount = 0.5f;

float brightest_channel(const glm::vec3& colour) {
    return std::max({colour.r, colour.g, colour.b});
}

/// A straight-alpha colour that further tints are laid over.
struct TintStack {
    float red = 0.0f, green = 0.0f, blue = 0.0f, opacity = 0.0f;

    void add(const Tint& tint) {
        const float below = opacity * (1.0f - tint.opacity);
        const float sum = tint.opacity + below;
        if (!(sum > 0.0f)) return;
        const auto mix = [&](float channel, std::uint8_t over) {
            return (static_cast<float>(over) * tint.opacity + channel * below) / sum;
        };
        red = mix(red, tint.colour.r);
        green = mix(green, tint.colour.g);
        blue = mix(blue, tint.colour.b);
        opacity = sum;
    }
};

/// How much of an overlay a pixel has; below 0: nothing at all.
struct Amounts {
    const Framebuffer& framebuffer;
    const PixelFacts& facts;
    const OverlayTotals& totals;
    const std::vector<PixelCost>& costs;
    const std::optional<EdgeField>& field;

    float of(Overlay overlay, std::size_t pixel) const {
        switch (overlay) {
        case Overlay::owner:
            return framebuffer.owner[pixel] >= 0 ? 1.0f : -1.0f;
        case Overlay::overdraw:
            return framebuffer.overdraw[pixel] == 0
                       ? -1.0f
                       : static_cast<float>(framebuffer.overdraw[pixel]) /
                             static_cast<float>(totals.most_overdraw);
        case Overlay::drawn_twice:
            return facts.drawn_twice[pixel] ? 1.0f : -1.0f;
        case Overlay::depth:
            if (facts.depth.empty() || facts.depth[pixel] == DepthVerdicts{}) return -1.0f;
            return facts.depth[pixel].failed > 0 ? 1.0f : 0.0f;
        case Overlay::uncovered:
            return framebuffer.overdraw[pixel] == 0 ? 1.0f : -1.0f;
        case Overlay::over_one:
            return brightest_channel(framebuffer.colour[pixel]) > 1.0f ? 1.0f : -1.0f;
        case Overlay::affine_error:
            return totals.largest_error > 0.0f ? facts.affine_error[pixel] / totals.largest_error
                                               : -1.0f;
        case Overlay::cost: {
            const std::uint32_t total = costs[pixel].total();
            return total == 0 ? -1.0f
                              : static_cast<float>(total) / static_cast<float>(totals.most_cost);
        }
        case Overlay::edge_field:
            return field ? amount_of_field(pixel) : -1.0f;
        case Overlay::mip_level:
            return facts.mip_level[pixel] == no_mip_level
                       ? -1.0f
                       : std::min(facts.mip_level[pixel] / top_mip_colour, 1.0f);
        case Overlay::wireframe:
        case Overlay::alone:
        case Overlay::vectors:
        case Overlay::weights:
            break;
        }
        return -1.0f;
    }

    float amount_of_field(std::size_t pixel) const {
        const auto width = static_cast<std::size_t>(framebuffer.size.width);
        const std::int64_t e =
            field->at(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
        if (e == 0) return middle_amount;
        const float share =
            static_cast<float>(static_cast<double>(e) / static_cast<double>(field->largest));
        const float amount = middle_amount + (1.0f - middle_amount) * share;
        // However near it is to 0, its sign is seen.
        if (amount == middle_amount) return std::nextafter(amount, e > 0 ? 1.0f : 0.0f);
        return amount;
    }
};

void count_owners(const Framebuffer& framebuffer, int triangles, OverlayTotals& totals) {
    std::vector<bool> seen(static_cast<std::size_t>(triangles), false);
    for (const std::int32_t owner : framebuffer.owner) {
        if (owner >= 0) seen[static_cast<std::size_t>(owner)] = true;
    }
    totals.visible_triangles = static_cast<int>(std::count(seen.begin(), seen.end(), true));
}

OverlayTotals count_totals(const Frame& frame, const Framebuffer& framebuffer, OverlaySet shown,
                           const PixelFacts& facts) {
    OverlayTotals totals;
    if (shown.empty()) return totals; // a moment of a large picture must not cost all its pixels
    if (shown.has(Overlay::owner)) count_owners(framebuffer, frame.triangle_count(), totals);
    for (const std::uint32_t overdraw : framebuffer.overdraw) {
        totals.fragments += overdraw;
        totals.most_overdraw = std::max(totals.most_overdraw, overdraw);
        totals.uncovered += overdraw == 0 ? 1 : 0;
    }
    if (shown.has(Overlay::over_one)) {
        for (const glm::vec3& colour : framebuffer.colour) {
            const float channel = brightest_channel(colour);
            totals.over_one += channel > 1.0f ? 1 : 0;
            totals.brightest = std::max(totals.brightest, channel);
        }
    }
    if (shown.has(Overlay::drawn_twice)) {
        totals.drawn_twice = std::count_if(facts.drawn_twice.begin(), facts.drawn_twice.end(),
                                           [](const DrawnTwice& twice) { return bool(twice); });
    }
    if (shown.has(Overlay::depth)) {
        for (const DepthVerdicts& verdicts : facts.depth) {
            totals.failed_pixels += verdicts.failed > 0 ? 1 : 0;
            totals.failed_fragments += verdicts.failed;
        }
    }
    if (shown.has(Overlay::affine_error)) {
        double sum = 0.0;
        std::int64_t covered = 0;
        for (std::size_t i = 0; i < facts.affine_error.size(); ++i) {
            if (framebuffer.owner[i] < 0) continue;
            ++covered;
            sum += static_cast<double>(facts.affine_error[i]);
            totals.largest_error = std::max(totals.largest_error, facts.affine_error[i]);
        }
        totals.mean_error = covered > 0 ? sum / static_cast<double>(covered) : 0.0;
    }
    if (shown.has(Overlay::mip_level)) {
        for (const float level : facts.mip_level) {
            if (level == no_mip_level) continue;
            const bool is_first = totals.least_level == no_mip_level;
            totals.least_level = is_first ? level : std::min(totals.least_level, level);
            totals.most_level = std::max(totals.most_level, level);
        }
    }
    return totals;
}

void add_costs(const std::vector<PixelCost>& costs, OverlayTotals& totals) {
    for (const PixelCost& pixel : costs) {
        totals.cost += pixel.total();
        totals.most_cost = std::max(totals.most_cost, pixel.total());
    }
}

/// The different edges of the frame, in drawing order, each once.
std::vector<WireEdge> find_wires(const Frame& frame) {
    std::vector<WireEdge> wires;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        const PolygonCorners v = frame.triangle_vertices(t);
        for (std::size_t e = 0; e < v.size(); ++e) {
            const ScreenVertex& a = v[e];
            const ScreenVertex& b = v[(e + 1) % v.size()];
            wires.push_back({{a.column, a.row}, {b.column, b.row}, t, static_cast<int>(e)});
        }
    }
    const auto key = [](const WireEdge& wire) {
        const std::array from{wire.from.x, wire.from.y}, to{wire.to.x, wire.to.y};
        return from < to ? std::pair(from, to) : std::pair(to, from);
    };
    std::stable_sort(wires.begin(), wires.end(),
                     [&](const WireEdge& a, const WireEdge& b) { return key(a) < key(b); });
    wires.erase(std::unique(wires.begin(), wires.end(),
                            [&](const WireEdge& a, const WireEdge& b) { return key(a) == key(b); }),
                wires.end());
    std::sort(wires.begin(), wires.end(), [](const WireEdge& a, const WireEdge& b) {
        return std::pair(a.triangle, a.edge) < std::pair(b.triangle, b.edge);
    });
    return wires;
}

Image compose_image(const Framebuffer& framebuffer, OverlaySet shown, const Amounts& amounts) {
    Image image{framebuffer.size.width, framebuffer.size.height, {}};
    image.rgba.resize(4 * framebuffer.owner.size());
    std::size_t pixel = 0;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column, ++pixel) {
            TintStack stack;
            for (const Overlay overlay : layers) {
                if (!shown.has(overlay)) continue;
                const float amount = amounts.of(overlay, pixel);
                if (amount < 0.0f) continue;
                stack.add(overlay_tint(overlay, amount, {column, row}, framebuffer.owner[pixel]));
            }
            const auto byte = [](float value) {
                return static_cast<std::uint8_t>(std::lround(value));
            };
            image.rgba[4 * pixel + 0] = byte(stack.red);
            image.rgba[4 * pixel + 1] = byte(stack.green);
            image.rgba[4 * pixel + 2] = byte(stack.blue);
            image.rgba[4 * pixel + 3] = byte(255.0f * stack.opacity);
        }
    }
    return image;
}

/// The remainder, 0..period - 1, for numbers of either sign.
int wrapped(int value, int period) {
    return ((value % period) + period) % period;
}

} // namespace

const std::array<OverlayInfo, overlay_count>& overlay_list() {
    static constexpr std::array<OverlayInfo, overlay_count> list{{
        {Overlay::wireframe, "wireframe",
         "The true edges of all triangles: straight lines between the projected vertices."},
        {Overlay::alone, "one triangle alone",
         "Fills the triangle shown as far as it is drawn, whatever is in front of it, and shows "
         "only the edges of all others. Not available while two runs are compared."},
        {Overlay::owner, "triangle owner",
         "Tints every triangle in its own colour and names the triangle under the pointer."},
        {Overlay::overdraw, "overdraw", "How many fragments fell on each pixel, drawn or not."},
        {Overlay::drawn_twice, "drawn twice",
         "Pixels on which two neighbours both drew a fragment. A row includes both ends, so "
         "both triangles draw the edge that they share."},
        {Overlay::depth, "depth test",
         "Hatched where at least one fragment failed the depth test, blue where all passed."},
        {Overlay::uncovered, "uncovered", "Pixels on which nothing fell."},
        {Overlay::over_one, "colour over 1",
         "Pixels with a channel above 1, which is clamped when the colour is shown."},
        {Overlay::affine_error, "affine error",
         "How far apart the affine and the perspective-correct position of the visible point lie "
         "in the world."},
        {Overlay::cost, "cost",
         "How much work each pixel takes as the steps draw it: its fragments, depth tests, lights, "
         "shadow tests and texels, each counted as one."},
        {Overlay::edge_field, "edge function",
         "E of one edge of the triangle shown, over the whole picture: blue where it is positive, "
         "on "
         "the inner side, and orange where it is negative; stronger the farther from the edge."},
        {Overlay::weights, "weights as areas",
         "Joins the centre of the picked pixel with the vertices of the triangle shown. Each "
         "vertex has the share of the triangle opposite as its weight."},
        {Overlay::mip_level, "mip level",
         "The level of the mip chain at which each pixel's texture was read. Level 0, the texture "
         "itself, has no tint; between two levels that are mixed, the colours are too."},
        {Overlay::vectors, "vectors",
         "At the picked pixel, the vectors that its light is worked out with. Where none is "
         "picked, "
         "the two sides of the triangle shown that begin at vertices[0], and what their products "
         "measure; or, if a vertex is selected, the normal and the way there from the eye."},
    }};
    static_assert(is_indexed_by(list, &OverlayInfo::overlay));
    return list;
}

int OverlaySet::count() const {
    return std::popcount(bits);
}

FactsWanted facts_wanted(OverlaySet overlays) {
    return {overlays.has(Overlay::drawn_twice), overlays.has(Overlay::depth),
            overlays.has(Overlay::affine_error), overlays.has(Overlay::mip_level)};
}

void compose_overlays(const Frame& frame, const Cursor& cursor, const Framebuffer& framebuffer,
                      OverlaySet overlays, bool same_moment, OverlayPicture& picture) {
    picture.shown = overlays;
    const FactsWanted wanted = facts_wanted(overlays);
    if (!same_moment || !picture.facts.known.includes(wanted)) {
        picture.facts = pixel_facts(frame, cursor, wanted);
    }
    picture.totals = count_totals(frame, framebuffer, overlays, picture.facts);
    const bool has_costs = overlays.has(Overlay::cost) && picture.cost.is_counted();
    if (has_costs) add_costs(picture.cost.pixels(), picture.totals);
    picture.wires.clear();
    if (overlays.has(Overlay::wireframe) || overlays.has(Overlay::alone)) {
        picture.wires = find_wires(frame);
        picture.totals.wires = static_cast<int>(picture.wires.size());
        if (picture.wires.size() > most_wires) picture.wires.resize(most_wires);
    }
    OverlaySet tints;
    for (const Overlay layer : layers)
        tints.set(layer, overlays.has(layer));
    if (!picture.field) tints.set(Overlay::edge_field, false);
    if (!has_costs) tints.set(Overlay::cost, false);
    picture.image = tints.empty() ? Image{}
                                  : compose_image(framebuffer, tints,
                                                  {framebuffer, picture.facts, picture.totals,
                                                   picture.cost.pixels(), picture.field});
}

Image ground_of_overlays(const Image& picture) {
    // Out of 256: the channels' shares of brightness, and how much of it is kept.
    constexpr int red = 54, green = 183, blue = 19, kept = 160;
    Image ground = picture;
    for (std::size_t at = 0; at + 3 < ground.rgba.size(); at += 4) {
        const std::uint8_t* const p = &picture.rgba[at];
        const int light = (red * p[0] + green * p[1] + blue * p[2]) / 256;
        for (std::size_t channel = 0; channel < 3; ++channel)
            ground.rgba[at + channel] = static_cast<std::uint8_t>(light * kept / 256);
    }
    return ground;
}

Tint overlay_tint(Overlay overlay, float amount, glm::ivec2 pixel, int triangle) {
    switch (overlay) {
    case Overlay::owner:
        return {distinct_colour(triangle), 0.6f};
    case Overlay::overdraw:
    case Overlay::cost:
        return {viridis(amount), 0.65f};
    case Overlay::affine_error:
        return {reddish_purple, 0.9f * amount};
    case Overlay::depth:
        if (amount > 0.0f) return {vermillion, wrapped(pixel.x + pixel.y, 6) < 2 ? 0.9f : 0.35f};
        return {sky_blue, 0.22f};
    case Overlay::over_one:
        // Stripes, like those for overexposed parts in cameras, with the picture visible between.
        switch (wrapped(pixel.x - pixel.y, 6)) {
        case 0:
        case 1:
            return {{255, 255, 255}, 0.9f};
        case 2:
            return {{0, 0, 0}, 0.75f};
        default:
            return {{255, 255, 255}, 0.2f};
        }
    case Overlay::drawn_twice:
        return {yellow, 0.95f};
    case Overlay::uncovered:
        return {orange, wrapped(pixel.x + pixel.y, 4) < 2 ? 1.0f : 0.55f};
    case Overlay::edge_field: {
        if (amount == middle_amount) return {};
        const float distance = std::abs(amount - middle_amount) / (1.0f - middle_amount);
        return {amount > middle_amount ? sky_blue : vermillion, 0.12f + 0.68f * distance};
    }
    case Overlay::mip_level:
        // Most textures have few levels: the first ones lie farther apart on the scale.
        return {viridis(std::sqrt(amount)), 0.7f * std::min(amount * top_mip_colour, 1.0f)};
    case Overlay::wireframe:
    case Overlay::alone:
    case Overlay::vectors:
    case Overlay::weights:
        break;
    }
    return {};
}

} // namespace rasterwalk
