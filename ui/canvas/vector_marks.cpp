#include "ui/canvas/vector_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "outside/eye_line.h"
#include "outside/label_places.h"
#include "ui/canvas/marks.h"
#include "ui/ui.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The normal before it is bent is quieter than the one that counts, 0..1.
constexpr float quiet = 0.6f;

/// A shorter arrow is a dot as well, design pixels.
constexpr float shortest_arrow = 8.0f;

/// Lines are cut this far outside the canvas, screen pixels, so that their ends are not seen.
constexpr double outside_margin = 40.0;

/// A line of the overlay on the screen.
struct SeenVectorLine {
    OutsideArrow line;
    ImVec2 from, to;
    bool has_tip = false; ///< where it ends is seen
};

EyeLine between(ImVec2 from, ImVec2 to) {
    EyeLine line;
    line.from = {from.x, from.y};
    line.to = {to.x, to.y};
    line.is_seen = true;
    return line;
}

std::optional<SeenVectorLine> on_screen(const Marks& m, const OutsideArrow& line) {
    const std::optional<PictureLine> seen = line_in_picture(m.run.frame, line.from, line.to);
    if (!seen) return std::nullopt;
    const auto at = [&](const glm::dvec2& place) {
        return m.at(static_cast<float>(place.x), static_cast<float>(place.y));
    };
    const ImVec2 tip = at(seen->to);
    const glm::dvec2 low(m.low.x, m.low.y), high(m.high.x, m.high.y);
    const EyeLine part =
        clipped_to(between(at(seen->from), tip), low - outside_margin, high + outside_margin);
    if (!part.is_seen) return std::nullopt;
    const bool is_inside =
        tip.x >= m.low.x && tip.y >= m.low.y && tip.x <= m.high.x && tip.y <= m.high.y;
    const auto screen = [](const glm::dvec2& place) {
        return ImVec2(static_cast<float>(place.x), static_cast<float>(place.y));
    };
    return SeenVectorLine{line, screen(part.from), screen(part.to), is_inside && !seen->is_to_cut};
}

/// Where the name of an arrow belongs: at its tip, or where it leaves the canvas.
std::optional<glm::vec2> place_of_name(const Marks& m, const SeenVectorLine& line, ImVec2 corner) {
    const float border = 2.0f * m.u;
    const EyeLine part =
        clipped_to(between(line.from, line.to), {corner.x + border, corner.y + border},
                   {m.high.x - border, m.high.y - border});
    return part.is_seen ? std::optional(glm::vec2(part.to)) : std::nullopt;
}

void draw_letters(const Marks& m, const std::vector<SeenVectorLine>& lines,
                  std::vector<CanvasLabel>& taken_names) {
    const ImVec2 corner = corner_of_labels(m);
    const glm::vec2 low(corner.x, corner.y), room = glm::vec2(m.high.x, m.high.y) - low;
    ImFont* const font = m.ui.fonts.bold;
    std::vector<OutsideLabel> labels;
    std::vector<VectorName> names;
    std::vector<OutsideLine> obstacles;
    for (const SeenVectorLine& line : lines) {
        const glm::vec2 from = glm::vec2(line.from.x, line.from.y) - low,
                        to = glm::vec2(line.to.x, line.to.y) - low;
        obstacles.push_back({OutsideLineKind::vector, 0, from, to});
        if (line.line.kind != OutsideLineKind::vector) continue;
        const std::optional<glm::vec2> at = place_of_name(m, line, corner);
        if (!at) continue;
        const auto name = static_cast<VectorName>(line.line.number);
        const std::string symbol(vector_words(name).symbol);
        const glm::vec2 size{text_width(font, symbol), font->FontSize};
        const float halo = halo_width * m.u + 1.0f;
        labels.push_back({*at - low, size + 2.0f * halo, 5.0f * m.u, LabelSide::right, 2.0f * m.u});
        names.push_back(name);
    }
    std::vector<OutsideBox> taken;
    for (const CanvasLabel& label : taken_names)
        taken.push_back({glm::vec2(label.low.x, label.low.y) - low,
                         glm::vec2(label.high.x, label.high.y) - low});
    const auto places = label_places(labels, taken, obstacles, room);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        // A letter without a free place is at the tip all the same: an arrow must have one.
        const glm::vec2 place = low + places[i].value_or(labels[i].point);
        const ImVec2 text{std::round(place.x + halo_width * m.u + 1.0f),
                          std::round(place.y + halo_width * m.u + 1.0f)};
        const std::string symbol(vector_words(names[i]).symbol);
        draw_haloed(m.list, font, m.u, text, symbol,
                    {packed(vector_colour(names[i], Theme::dark)), dark_casing});
        taken_names.push_back({symbol,
                               {place.x, place.y},
                               {place.x + labels[i].size.x, place.y + labels[i].size.y},
                               text});
    }
}

/// The parallelogram, if all of it is in front of the camera.
void tint_span(const Marks& m, const SpannedSides& sides) {
    const auto corners = sides.corners();
    std::array<ImVec2, 4> places;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto line = line_in_picture(m.run.frame, corners[i], corners[(i + 1) % 4]);
        if (!line || line->is_from_cut || line->is_to_cut) return;
        places[i] = m.at(static_cast<float>(line->from.x), static_cast<float>(line->from.y));
    }
    m.list->AddQuadFilled(places[0], places[1], places[2], places[3],
                          IM_COL32(255, 255, 255, static_cast<int>(255.0f * span_tint)));
}

void draw_lines(const Marks& m, const std::vector<SeenVectorLine>& lines) {
    const VectorPen pen{m.list, m.u, Theme::dark, dark_casing};
    for (const SeenVectorLine& line : lines) {
        const OutsideLineKind kind = line.line.kind;
        const auto name = static_cast<VectorName>(line.line.number);
        if (line.has_tip || kind != OutsideLineKind::vector) {
            draw_vector_line(pen, kind, name, line.from, line.to);
        } else {
            m.list->AddLine(line.from, line.to, dark_casing, 4.6f * m.u);
            m.list->AddLine(line.from, line.to, packed(vector_colour(name, Theme::dark)),
                            2.2f * m.u);
        }
    }
}

} // namespace

float direction_length(ImVec2 room, float u) {
    constexpr float usual = 80.0f, largest_share = 0.35f; // design pixels, of the smaller side
    return std::min(usual * u, largest_share * std::min(room.x, room.y));
}

ImVec4 vector_colour(VectorName name, Theme theme) {
    ImVec4 colour = colour_of(vector_meaning(name), theme);
    if (name == VectorName::unbent) colour.w = quiet;
    return colour;
}

void draw_vector_line(const VectorPen& pen, OutsideLineKind kind, VectorName name, ImVec2 from,
                      ImVec2 to) {
    const ImU32 current = packed(colour_of(Meaning::current, pen.theme));
    const float u = pen.u;
    switch (kind) {
    case OutsideLineKind::vector: {
        const ImU32 colour = packed(vector_colour(name, pen.theme));
        draw_arrow(pen.list, u, from, to, {colour, pen.casing}, 1.5f);
        if (std::hypot(to.x - from.x, to.y - from.y) < shortest_arrow * u) {
            pen.list->AddCircleFilled(to, 4.4f * u, pen.casing);
            pen.list->AddCircleFilled(to, 3.0f * u, colour);
        }
        break;
    }
    case OutsideLineKind::vector_shadow:
        pen.list->AddLine(from, to, pen.casing, 10.0f * u);
        pen.list->AddLine(from, to, packed(vector_colour(VectorName::v, pen.theme)), 8.0f * u);
        break;
    case OutsideLineKind::vector_dropped:
        pen.list->AddLine(from, to, pen.casing, 3.2f * u);
        draw_dashed(pen.list, u, from, to, current, 1.6f * u);
        break;
    case OutsideLineKind::vector_angle:
        pen.list->AddLine(from, to, pen.casing, 3.2f * u);
        pen.list->AddLine(from, to, current, 1.4f * u);
        break;
    case OutsideLineKind::vector_opposite:
        pen.list->AddLine(from, to, pen.casing, 2.4f * u);
        draw_dashed(pen.list, u, from, to, packed(colour_of(Meaning::current, pen.theme), 0.75f),
                    1.0f * u);
        break;
    default:
        break; // not of the overlay
    }
}

void draw_vector_marks(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high,
                       std::vector<CanvasLabel>& labels) {
    const RunResults& a = ui.results.a;
    const std::optional<VectorReport>& report = a.inspected.vectors;
    if (!report || report->vectors.empty() || a.preview.is_shown) return;
    const ShownRun run = run_a(ui);
    const Marks m{ui, run, list, low, high, ui.options.text_scale, run.place.scale};
    const double pixels = pixels_per_unit(a.frame, report->vectors.front().from) * double{m.scale};
    const double pixel = pixels > 0.0 ? 1.0 / pixels : 0.0; // in the world
    const ImVec2 room{high.x - low.x, high.y - low.y};
    if (report->sides) tint_span(m, *report->sides);
    std::vector<SeenVectorLine> lines;
    for (const OutsideArrow& line :
         vector_lines(*report, double{direction_length(room, m.u)} * pixel,
                      double{right_angle_side * m.u} * pixel)) {
        if (const std::optional<SeenVectorLine> seen = on_screen(m, line)) lines.push_back(*seen);
    }
    draw_lines(m, lines);
    draw_letters(m, lines, labels);
}

} // namespace rasterwalk
