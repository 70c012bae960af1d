#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "picture/overlay.h"
#include "session/quiz_state.h"
#include "ui/actions/compare.h"
#include "ui/inspector/rows_parts.h"
#include "ui/ui.h"
#include "ui/widgets/small_pictures.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

using PixelColour = std::array<std::uint8_t, 4>;

PixelColour opaque(const ImVec4& colour) {
    const auto byte = [](float value) {
        return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
    };
    return {byte(colour.x), byte(colour.y), byte(colour.z), 255};
}

/// Between the colours of the canvas and of text: triangles are quiet, faults are not.
PixelColour quiet_colour(const Palette& p, float share) {
    const auto mix = [&](float a, float b) { return a + share * (b - a); };
    return opaque(
        {mix(p.canvas.x, p.text.x), mix(p.canvas.y, p.text.y), mix(p.canvas.z, p.text.z), 1.0f});
}

/// As the overlay marks it on the large picture.
PixelColour overlay_colour(Overlay overlay) {
    const Tint tint = overlay_tint(overlay, 1.0f, {0, 0});
    return {tint.colour.x, tint.colour.y, tint.colour.z, 255};
}

PixelColour colour_of_pixel(EdgePixel pixel, Theme theme) {
    const Palette& p = palette(theme);
    switch (pixel) {
    case EdgePixel::triangle:
        return quiet_colour(p, 0.55f);
    case EdgePixel::neighbour:
        return quiet_colour(p, 0.3f);
    case EdgePixel::twice:
        return overlay_colour(Overlay::drawn_twice);
    case EdgePixel::hole:
        return overlay_colour(Overlay::uncovered);
    case EdgePixel::neither:
        break;
    }
    return opaque(p.canvas);
}

PixelColour colour_of_pixel(PolygonPixel pixel, Theme theme) {
    const Palette& p = palette(theme);
    switch (pixel) {
    case PolygonPixel::inside:
        return quiet_colour(p, 0.45f);
    case PolygonPixel::filled:
        return opaque(colour_of(Meaning::fail, theme));
    case PolygonPixel::missed:
        return overlay_colour(Overlay::uncovered);
    case PolygonPixel::outside:
        break;
    }
    return opaque(p.canvas);
}

std::optional<SmallSign> sign_of(EdgePixel pixel) {
    if (pixel == EdgePixel::twice) return SmallSign::dot;
    if (pixel == EdgePixel::hole) return SmallSign::hollow;
    return std::nullopt;
}

std::optional<SmallSign> sign_of(PolygonPixel pixel) {
    if (pixel == PolygonPixel::filled) return SmallSign::stroke;
    if (pixel == PolygonPixel::missed) return SmallSign::hollow;
    return std::nullopt;
}

/// The pixels of a window as an image, and the signs on them.
template <class Pixel>
CoverageImage coverage_image(const std::vector<Pixel>& pixels, const Rectangle& window,
                             Theme theme) {
    CoverageImage result;
    result.image.width = window.right - window.left;
    result.image.height = window.bottom - window.top;
    result.image.rgba.reserve(4 * pixels.size());
    int at = 0;
    for (const Pixel pixel : pixels) {
        const PixelColour colour = colour_of_pixel(pixel, theme);
        result.image.rgba.insert(result.image.rgba.end(), colour.begin(), colour.end());
        if (const std::optional<SmallSign> sign = sign_of(pixel))
            result.marks.push_back({at % result.image.width, at / result.image.width, *sign});
        ++at;
    }
    return result;
}

ImVec2 place_in(const Rectangle& window, const GridPoint& point) {
    const auto pixels = [](std::int64_t at) {
        return static_cast<float>(at) / static_cast<float>(grid_parts);
    };
    return {pixels(point.x) - static_cast<float>(window.left),
            pixels(point.y) - static_cast<float>(window.top)};
}

/// Looks for neighbour and polygon when the triangle, the frame or the picked pixel has changed.
void look_at_triangle(Ui& ui, CoveragePictures& shown) {
    const RunResults& a = ui.results.a;
    const std::optional<glm::ivec2>& picked = ui.session.selection.pixel;
    const bool is_known = shown.frame_number == a.frame_number && shown.triangle == *a.triangle &&
                          shown.picked == picked && shown.theme == ui.options.theme;
    if (is_known) return;
    shown.frame_number = a.frame_number;
    shown.triangle = *a.triangle;
    shown.picked = picked;
    shown.theme = ui.options.theme;
    shown.shared = shared_edge_at(a.frame, *a.triangle, picked);
    shown.edge.reset();
    shown.polygon = polygon_picture(a.frame, *a.triangle);
    shown.images_of = CoverageSubject::none;
}

/// The part of the edge at the picked pixel, or at the one being tested.
void look_at_shared_edge(const Ui& ui, CoveragePictures& shown) {
    std::optional<glm::ivec2> pixel = shown.picked;
    if (const std::optional<PixelTest> test = shown_test(ui); test && !pixel)
        pixel = glm::ivec2(test->column, test->row);
    const Frame& frame = ui.results.a.frame;
    const Rectangle window = edge_window(frame, *shown.shared, pixel);
    if (shown.edge && shown.edge->window == window) return;
    shown.edge = edge_picture(frame, *shown.shared, window);
    shown.images_of = CoverageSubject::none;
}

template <class Pictures>
void make_images(CoveragePictures& shown, CoverageSubject subject, const Rectangle& window,
                 Pictures pixels_of) {
    if (shown.images_of == subject) return;
    for (std::size_t i = 0; i < shown.images.size(); ++i)
        shown.images[i] = coverage_image(pixels_of(i), window, shown.theme);
    shown.images_of = subject;
    ++shown.number;
}

SmallPicture small_of(const CoveragePictures& shown, std::size_t i, std::string name) {
    SmallPicture small;
    small.name = std::move(name);
    small.image = &shown.images[i].image;
    small.marks = shown.images[i].marks;
    small.number = shown.number;
    return small;
}

/// The outline of the triangle shown in the colours of its edges, its neighbour's dimmed.
std::vector<SmallLine> lines_of_edge(const EdgePicture& edge, Theme theme) {
    std::vector<SmallLine> lines;
    // The triangle's own edges lie over those of its neighbour.
    for (const std::size_t which : {std::size_t{1}, std::size_t{0}}) {
        const auto& corners = edge.outlines[which];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const ImVec4 colour = which == 0 ? colour_of(edge_meaning(static_cast<int>(i)), theme)
                                             : palette(theme).dim;
            lines.push_back({place_in(edge.window, corners[i]),
                             place_in(edge.window, corners[(i + 1) % corners.size()]),
                             packed(colour)});
        }
    }
    return lines;
}

/// What a rule does with the pixels on the edge, in a sentence.
std::string rule_tooltip(const EdgeByRule& by_rule) {
    constexpr std::array sentences{
        "E ≥ 0: each triangle takes the pixels whose centres lie on its edges.",
        "E > 0: no triangle takes the pixels whose centres lie on its edges.",
        "Each triangle takes the pixels on its top and left edges, and no others."};
    const auto i = static_cast<std::size_t>(
        std::find(compared_fill_rules.begin(), compared_fill_rules.end(), by_rule.rule) -
        compared_fill_rules.begin());
    return std::string(sentences.at(i)) +
           "\nYellow with a dot: drawn by both. Hollow: drawn by neither. The lighter pixels "
           "belong to the triangle shown.\nCounted along the whole edge.\nClick to draw with this "
           "rule.";
}

void draw_rules_at_edge(Ui& ui, CoveragePictures& shown) {
    const EdgePicture& edge = *shown.edge;
    make_images(
        shown, CoverageSubject::rules,
        edge.window, [&](std::size_t i) -> const auto& { return edge.pixels[i]; });
    std::vector<SmallPicture> pictures;
    for (std::size_t i = 0; i < edge.rules.size(); ++i) {
        const EdgeByRule& by_rule = edge.rules[i];
        const std::string word(word_of(by_rule.rule));
        SmallPicture small = small_of(shown, i, "inside.rule." + word);
        small.title = word;
        std::replace(small.title.begin(), small.title.end(), '_', ' ');
        small.words = fmt::format("{} twice, {}", grouped(by_rule.twice),
                                  counted(by_rule.holes, "hole", "holes"));
        small.tooltip = rule_tooltip(by_rule);
        small.lines = lines_of_edge(edge, shown.theme);
        small.is_chosen = ui.session.a.settings.fill_rule == by_rule.rule;
        small.can_be_chosen = true;
        pictures.push_back(std::move(small));
    }
    if (const auto clicked = draw_small_pictures(ui, pictures, shown.textures))
        ui.session.a.settings.fill_rule = compared_fill_rules[*clicked];
}

void draw_coverage_methods(Ui& ui, CoveragePictures& shown) {
    const PolygonPicture& polygon = *shown.polygon;
    make_images(
        shown, CoverageSubject::methods,
        polygon.window, [&](std::size_t i) -> const auto& { return polygon.methods[i].pixels; });
    constexpr std::array<const char*, coverage_method_count> titles{"row table", "fan",
                                                                    "active edges"};
    constexpr std::array<const char*, coverage_method_count> sentences{
        "One left and one right end per row, and all pixels between them.",
        "The triangles of the polygon's fan around its first corner, each filled.",
        "In each row, every edge that crosses it switches between outside and inside: the even-odd "
        "rule."};
    std::vector<SmallPicture> pictures;
    for (std::size_t i = 0; i < coverage_method_count; ++i) {
        const CoverageByMethod& method = polygon.methods[i];
        SmallPicture small = small_of(
            shown, i, "inside.way." + std::string(word_of(static_cast<CoverageMethod>(i))));
        small.title = titles[i];
        small.words = fmt::format("{}, {} wrong", counted(method.covered, "pixel", "pixels"),
                                  grouped(method.wrong));
        small.tooltip = std::string(sentences[i]) +
                        "\nStruck through: filled, but outside. Hollow: inside, but not filled.";
        for (std::size_t c = 0; c < polygon.outline.size(); ++c) {
            small.lines.push_back(
                {place_in(polygon.window, polygon.outline[c]),
                 place_in(polygon.window, polygon.outline[(c + 1) % polygon.outline.size()]),
                 packed(palette(shown.theme).text)});
        }
        pictures.push_back(std::move(small));
    }
    draw_small_pictures(ui, pictures, shown.textures);
}

std::vector<std::string> words_of_edge(const SharedEdge& shared) {
    const std::string edge = edge_name(shared.edge), other = triangle_name(shared.neighbour);
    return {edge + ", shared with " + other, edge + ", " + other, edge};
}

std::vector<std::string> words_of_polygon(const PolygonPicture& polygon) {
    const std::string corners = std::to_string(polygon.outline.size()) + " corners";
    return {"the whole polygon of " + corners, "polygon, " + corners, corners};
}

/// What the pictures show; a choice if there are two things to show.
void draw_subject(Ui& ui, CoveragePictures& shown, bool shows_rules) {
    ImGui::PushFont(ui.fonts.small);
    if (shown.shared && shown.polygon) {
        if (button(ui, "inside.show.polygon", "polygon", shows_rules ? Look::quiet : Look::chosen,
                   "The whole polygon, filled by row table, fan and active edges."))
            shown.wants_rules = false;
        ImGui::SameLine();
        if (button(ui, "inside.show.rules", "fill rules", shows_rules ? Look::chosen : Look::quiet,
                   "An edge that a neighbour shares, under each fill rule."))
            shown.wants_rules = true;
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
    }
    std::vector<std::string> words =
        shows_rules ? words_of_edge(*shown.shared) : words_of_polygon(*shown.polygon);
    words.emplace_back(); // or nothing
    text_in(palette(ui.options.theme).dim, first_fitting(words, ImGui::GetContentRegionAvail().x));
    ImGui::PopFont();
}

} // namespace

bool has_coverage_pictures(Ui& ui) {
    const RunResults& a = ui.results.a;
    const bool asks_centres = a.triangle && a.frame.is_drawn(*a.triangle) &&
                              !walks_edges(a.frame.stages) && !hides_settings(ui.session);
    if (!asks_centres) return false;
    look_at_triangle(ui, ui.inspector.coverage);
    return ui.inspector.coverage.shared || ui.inspector.coverage.polygon;
}

void draw_coverage_pictures(Ui& ui) {
    CoveragePictures& shown = ui.inspector.coverage;
    const bool shows_rules = shown.shared && (shown.wants_rules || !shown.polygon);
    draw_subject(ui, shown, shows_rules);
    if (shows_rules) {
        look_at_shared_edge(ui, shown);
        draw_rules_at_edge(ui, shown);
    } else {
        draw_coverage_methods(ui, shown);
    }
}

} // namespace rasterwalk
