#include "ui/bars/time_strips.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "pipeline/timeline.h"
#include "session/walk.h"
#include "ui/actions/compare.h"
#include "ui/bars/time_window.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels, from top to bottom: room for the marks, the line of the frame, the grip of the
/// bracket, the enlarged part.
constexpr float marks_height = 10.0f;
constexpr float frame_line_height = 12.0f;
constexpr float grip_room = 11.0f;
constexpr float window_line_height = 25.0f;
/// Without the enlarged part the line is higher, and as high as a button with what is around it.
constexpr float lone_line_height = 14.0f;
constexpr float lone_height = 34.0f;

/// The least distance of two marks, and of two ticks; design pixels.
constexpr float mark_distance = 11.0f;
constexpr float tick_distance = 5.0f;
/// A triangle narrower than this is not divided into its pieces, design pixels.
constexpr float divided_triangle = 40.0f;

/// How much wider the window gets with one turn of the wheel.
constexpr double wheel_factor = 1.3;
/// So few moments fill the window at the narrowest.
constexpr double fewest_moments = 8.0;

/// Both time lines, screen pixels.
struct Strips {
    Ui& ui;
    const Timeline& timeline;
    ImVec2 at;
    float width;
    float top, bottom;               ///< of the line of the frame
    float window_top, window_bottom; ///< of the enlarged part
    double cursor;                   ///< its place on the line of the frame, in triangles
    double in_scale;                 ///< the same as the enlarged part spreads moments

    const Palette& colours() const { return palette(ui.options.theme); }
    float unit() const { return ui.options.text_scale; }
    double triangles() const { return std::max(timeline.frame().triangle_count(), 1); }
    TimeWindow& window() const { return ui.transport.window; }

    float on_frame(double place) const {
        return at.x + width * static_cast<float>(place / triangles());
    }
    float in_window(double place) const {
        const double share = (place - window().begin) / window().width;
        return at.x + width * static_cast<float>(std::clamp(share, -1.0, 2.0));
    }
    /// Where the pointer is along the lines, 0 to 1.
    double pointer() const {
        const float along = (ImGui::GetIO().MousePos.x - at.x) / width;
        return along > 0.0f ? std::min(along, 1.0f) : 0.0;
    }
};

double place_in_triangles(const Timeline& timeline, const Cursor& cursor) {
    if (cursor == cursor_end) return std::max(timeline.frame().triangle_count(), 1);
    const int count = std::max(timeline.moments(cursor.triangle).count, 1);
    return cursor.triangle + static_cast<double>(timeline.ordinal(cursor)) / count;
}

/// The same as the enlarged part spreads the moments of a triangle.
double place_in_scale(const Timeline& timeline, const Cursor& cursor) {
    if (cursor == cursor_end) return place_in_triangles(timeline, cursor);
    const TriangleScale scale = triangle_scale(timeline.moments(cursor.triangle));
    return cursor.triangle + scale.share_of(timeline.ordinal(cursor));
}

/// The moment at a place of the enlarged part.
Cursor moment_in_scale(const Timeline& timeline, double place) {
    const Frame& frame = timeline.frame();
    if (place >= frame.triangle_count()) return cursor_end;
    const int triangle = static_cast<int>(std::max(place, 0.0));
    if (frame.is_drawn(triangle)) {
        const TriangleMoments& moments = timeline.moments(triangle);
        const int ordinal = triangle_scale(moments).ordinal_at(place - triangle);
        if (ordinal < moments.count) return timeline.at_ordinal(triangle, ordinal);
    }
    const int next = frame.is_drawn(triangle) ? triangle + 1 : triangle;
    return timeline.at_or_after({next, Phase::vertices, 0, 0});
}

/// The wheel over one of the lines.
/// @param about what stays where it is, in triangles
void zoom_by_wheel(const Strips& s, double about) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheelH != 0.0f) {
        const double turns = std::clamp(io.MouseWheelH, -5.0f, 5.0f);
        pan_window(s.window(), -0.1 * turns * s.window().width);
    }
    if (io.MouseWheel == 0.0f) return;
    const double turns = std::clamp(io.MouseWheel, -10.0f, 10.0f);
    const int triangle = static_cast<int>(std::clamp(about, 0.0, s.triangles() - 1.0));
    const Frame& frame = s.timeline.frame();
    const bool is_drawn = triangle < frame.triangle_count() && frame.is_drawn(triangle);
    const int moments = is_drawn ? s.timeline.moments(triangle).count : 1;
    const double least = std::min(1.0, fewest_moments / std::max(moments, 1));
    zoom_window(s.window(), std::pow(wheel_factor, -turns), about, least);
}

// The line of the whole frame.

void find_differences(const Strips& s) {
    DifferenceMarks& found = s.ui.transport.differences;
    const Results& results = s.ui.results;
    if (!results.b) {
        found = {};
        return;
    }
    const std::vector<DivergenceGroup>& groups = results.comparison.whole().divergences.groups;
    const bool is_known = found.frame_a == results.a.frame_number &&
                          found.frame_b == results.b->frame_number && found.width == s.width &&
                          found.looked_at <= groups.size();
    if (!is_known) {
        found = {};
        found.frame_a = results.a.frame_number;
        found.frame_b = results.b->frame_number;
        found.width = s.width;
    }
    const float distance = mark_distance * s.unit();
    const bool is_fine = static_cast<float>(s.triangles()) * distance < s.width;
    for (; found.looked_at < groups.size(); ++found.looked_at) {
        const Cursor& first = groups[found.looked_at].first;
        const float free = found.marks.empty() ? -distance : found.marks.back().x;
        if (s.on_frame(first.triangle + 1.0) - s.at.x < free + distance) continue;
        const double place = is_fine ? place_in_triangles(s.timeline, s.timeline.at_or_after(first))
                                     : first.triangle;
        const float x = s.on_frame(place) - s.at.x;
        if (x >= free + distance) found.marks.push_back({x, found.looked_at});
    }
}

std::string words_of(const DivergenceGroup& group) {
    return fmt::format("The runs part here: triangles[{}], {}, {}, {}. Click to go there.",
                       group.triangle, phase_info(group.phase).word,
                       counted(group.count, "moment", "moments"), kind_text(group.kind));
}

void draw_differences(const Strips& s) {
    find_differences(s);
    const std::vector<DifferenceMarks::Mark>& marks = s.ui.transport.differences.marks;
    const float u = s.unit();
    const float radius = 0.5f * marks_height * u;
    const ImU32 colour = packed(colour_of(Meaning::fail, s.ui.options.theme));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const ImVec2 c{s.at.x + marks[i].x, s.top - 6.0f * u};
        const std::string name = "walk.difference." + std::to_string(i);
        ImGui::SetCursorScreenPos({c.x - radius, c.y - radius});
        const bool is_clicked =
            ImGui::InvisibleButton(name.c_str(), {2.0f * radius, 2.0f * radius});
        const bool is_hovered = ImGui::IsItemHovered();
        const DivergenceGroup& group =
            s.ui.results.comparison.whole().divergences.groups[marks[i].group];
        name_widget(s.ui, name, words_of(group));
        const float r = (is_hovered ? 5.5f : 4.5f) * u;
        list->AddQuadFilled({c.x - r, c.y}, {c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r},
                            is_hovered ? packed(s.colours().text) : colour);
        if (is_clicked) stand_at(s.ui, group.first);
    }
}

void draw_frame_line(const Strips& s) {
    const Palette& p = s.colours();
    const float u = s.unit();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float right = s.at.x + s.width, x = s.on_frame(s.cursor);
    list->AddRectFilled({s.at.x, s.top}, {right, s.bottom}, packed(p.button), 2.0f * u);
    list->AddRectFilled({s.at.x, s.top}, {x, s.bottom}, packed(p.accent), 2.0f * u);
    const int triangles = s.timeline.frame().triangle_count();
    if (static_cast<float>(triangles) * tick_distance * u > s.width) return;
    for (int t = 1; t < triangles; ++t) {
        const float tick = std::round(s.on_frame(t));
        list->AddLine({tick, s.top}, {tick, s.bottom}, packed(p.bar), u);
    }
}

void use_frame_line(const Strips& s, bool has_window) {
    const float u = s.unit();
    const bool has_marks = !s.ui.transport.differences.marks.empty();
    const float above = has_marks ? 0.0f : marks_height * u;
    const float below = has_window ? 2.0f * u : s.at.y + lone_height * u - s.bottom;
    ImGui::SetCursorScreenPos({s.at.x, s.top - above});
    ImGui::InvisibleButton("scrub", {s.width, s.bottom - s.top + above + below});
    if (ImGui::IsItemActive()) scrub_to(s.ui.session, s.timeline.at_place(s.pointer()));
    if (ImGui::IsItemHovered() && has_window) {
        const TimeWindow& window = s.window();
        const bool is_inside =
            s.in_scale >= window.begin && s.in_scale <= window.begin + window.width;
        zoom_by_wheel(s, is_inside ? s.in_scale : window.begin + 0.5 * window.width);
    }
    name_widget(s.ui, "walk.scrub",
                has_window
                    ? "The whole frame from its first vertex to its last fragment; a tick a "
                      "triangle. Drag to go to any moment. The bracket is what the line below "
                      "enlarges; the wheel makes it narrower."
                    : "The whole frame from its first vertex to its last fragment; a tick a "
                      "triangle. Drag to go to any moment.");
}

// The bracket, and what leads from it to the enlarged part.

void draw_bracket(const Strips& s) {
    const Palette& p = s.colours();
    const float u = s.unit();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const TimeWindow& window = s.window();
    float left = s.on_frame(window.begin), right = s.on_frame(window.begin + window.width);
    list->AddQuadFilled({left, s.bottom + 2.0f * u}, {right, s.bottom + 2.0f * u},
                        {s.at.x + s.width, s.window_top}, {s.at.x, s.window_top},
                        packed(p.button, 0.45f));
    const float widen = std::max(0.0f, 3.0f * u - 0.5f * (right - left));
    left -= widen;
    right += widen;
    list->AddRect({left - u, s.top - 2.0f * u}, {right + u, s.bottom + 2.0f * u}, packed(p.text),
                  2.0f * u, 0, 1.5f * u);
    if (window.width >= s.triangles()) return;

    const float grip = std::min(std::max(right - left, 26.0f * u), s.width);
    const float middle =
        std::clamp(0.5f * (left + right), s.at.x + 0.5f * grip, s.at.x + s.width - 0.5f * grip);
    const float top = s.bottom + 2.0f * u;
    ImGui::SetCursorScreenPos({middle - 0.5f * grip, top});
    ImGui::InvisibleButton("bracket", {grip, s.window_top - top - u});
    const bool is_held = ImGui::IsItemActive();
    const bool is_lit = is_held || ImGui::IsItemHovered();
    if (is_held) {
        pan_window(s.window(), ImGui::GetIO().MouseDelta.x / s.width * s.triangles());
    }
    if (is_lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (is_lit) zoom_by_wheel(s, window.begin + 0.5 * window.width);
    name_widget(s.ui, "walk.bracket",
                "What the line below enlarges. Drag it along the frame; the wheel makes it "
                "narrower or wider.");
    const float y = top + 3.5f * u;
    list->AddRectFilled({middle - 0.5f * grip, y - 1.5f * u}, {middle + 0.5f * grip, y + 1.5f * u},
                        packed(is_lit ? p.text : p.dim), 1.5f * u);
}

// The enlarged part.

/// A stretch of the enlarged part under one name and in one colour.
struct Piece {
    double begin, end; ///< in triangles
    ImVec4 colour;
    std::string name;         ///< "edge 1"; may be empty
    std::string brief;        ///< where the name is too long; may be empty
    int count = 0;            ///< said behind the name; 0: not
    std::vector<int> between; ///< moments of it before each of its parts but the first
    int moments = 1;          ///< that it has; evenly long
};

/// Where ticks stand in a phase: between its rows; they are too narrow to be seen one by one.
std::vector<int> begins_of_rows(const PhaseMoments& phase) {
    return {phase.before.begin() + 1, phase.before.end() - 1};
}

void add_pieces(const Strips& s, int triangle, std::vector<Piece>& pieces) {
    const TriangleMoments& moments = s.timeline.moments(triangle);
    const TriangleScale scale = triangle_scale(moments);
    const auto add = [&](int first, int last) -> Piece& {
        Piece& piece = pieces.emplace_back();
        piece.begin = triangle + scale.share_of(first);
        piece.end = last < moments.count ? triangle + scale.share_of(last) : triangle + 1.0;
        piece.moments = last - first;
        return piece;
    };
    int before = 0;
    for (const PhaseInfo& info : phase_list) {
        const PhaseMoments& phase = moments.of(info.phase);
        const int first = before;
        before += phase.count();
        if (phase.count() == 0) continue;
        if (info.phase == Phase::edges) {
            for (std::size_t e = 0; e < phase.pieces.size(); ++e) {
                if (phase.pieces[e].count == 0) continue;
                Piece& piece = add(first + phase.before[e], first + phase.before[e + 1]);
                piece.colour = colour_of(edge_meaning(static_cast<int>(e)), s.ui.options.theme);
                piece.brief = std::to_string(e);
                piece.name = element_name(info.piece, static_cast<int>(e));
                piece.count = phase.pieces[e].count;
            }
            continue;
        }
        Piece& piece = add(first, before);
        piece.name = info.word;
        piece.count =
            static_cast<int>(std::count_if(phase.pieces.begin(), phase.pieces.end(),
                                           [](const auto& part) { return part.count > 0; }));
        const bool is_rows = info.phase == Phase::rows;
        piece.colour = is_rows ? s.colours().accent : s.colours().dim;
        if (is_rows) piece.between = begins_of_rows(phase);
    }
}

/// What the enlarged part is made of. Of very many triangles it is one piece.
std::vector<Piece> pieces_in_window(const Strips& s) {
    const TimeWindow& window = s.window();
    const Frame& frame = s.timeline.frame();
    const Palette& p = s.colours();
    const double end = window.begin + window.width;
    const float each = s.width / static_cast<float>(window.width);
    std::vector<Piece> pieces;
    if (each < 3.0f * s.unit()) return {{window.begin, end, p.accent, "", "", 0, {}, 1}};
    const int last = std::min(static_cast<int>(std::ceil(end)), frame.triangle_count());
    for (int t = static_cast<int>(window.begin); t < last; ++t) {
        const double first = t;
        const std::string index = fmt::format("[{}]", t);
        if (!frame.is_drawn(t)) {
            pieces.push_back({first, first + 1.0, p.line, "left out", index, 0, {}, 1});
        } else if (each < divided_triangle * s.unit()) {
            pieces.push_back({first, first + 1.0, p.accent, "triangles" + index, index, 0, {}, 1});
        } else {
            add_pieces(s, t, pieces);
        }
    }
    return pieces;
}

/// The longest of what can be said of a piece that fits.
std::string fitting_label(const Piece& piece, float room) {
    const auto fits = [&](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str()).x <= room;
    };
    const std::string whole =
        piece.count > 0 ? fmt::format("{} · {}", piece.name, piece.count) : piece.name;
    for (const std::string& text : {whole, piece.name, piece.brief}) {
        if (fits(text)) return text;
    }
    return {};
}

/// Ticks between moments if they are far enough apart, or else between rows.
void draw_ticks(const Strips& s, const Piece& piece) {
    const float u = s.unit();
    const double length = piece.end - piece.begin;
    const double pixels = static_cast<double>(s.width) * length / s.window().width;
    const auto least = static_cast<double>(tick_distance * u);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float line = s.window_bottom - 3.0f * u;
    const auto tick = [&](int moment) {
        const float x = std::round(s.in_window(piece.begin + length * moment / piece.moments) - u);
        list->AddLine({x, line - 4.0f * u}, {x, line}, packed(s.colours().dim, 0.55f), u);
    };
    // Of the piece, only what is in the window.
    const auto moment_at = [&](double place) {
        const double share = std::clamp((place - piece.begin) / length, 0.0, 1.0);
        return static_cast<int>(share * piece.moments);
    };
    const int first = moment_at(s.window().begin) + 1;
    const int last = std::min(moment_at(s.window().begin + s.window().width), piece.moments - 1);
    if (pixels / piece.moments >= least) {
        for (int i = first; i <= last; ++i)
            tick(i);
    } else if (pixels / static_cast<double>(piece.between.size() + 1) >= least) {
        const auto from = std::lower_bound(piece.between.begin(), piece.between.end(), first);
        for (auto i = from; i != piece.between.end() && *i <= last; ++i)
            tick(*i);
    }
}

void draw_piece(const Strips& s, const Piece& piece) {
    const Palette& p = s.colours();
    const float u = s.unit();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float left = s.in_window(piece.begin), right = s.in_window(piece.end) - u;
    if (right <= s.at.x || left >= s.at.x + s.width) return;
    const float done = std::clamp(s.in_window(s.in_scale), left, std::max(left, right));
    const bool has_begun = s.in_scale > piece.begin;
    const float line = s.window_bottom - 3.0f * u;
    list->AddRectFilled({left, s.window_top}, {right, s.window_bottom}, packed(p.button));
    if (has_begun) {
        list->AddRectFilled({left, s.window_top}, {done, line}, packed(piece.colour, 0.38f));
    }
    list->AddRectFilled({left, line}, {right, s.window_bottom},
                        packed(piece.colour, has_begun ? 1.0f : 0.5f));
    if (piece.moments > 1) draw_ticks(s, piece);
    const float text_left = std::max(left, s.at.x) + 6.0f * u;
    const std::string label =
        fitting_label(piece, std::min(right, s.at.x + s.width) - text_left - 4.0f * u);
    const float y = 0.5f * (s.window_top + line - ImGui::GetFontSize());
    list->AddText({text_left, y}, packed(has_begun ? p.text : p.dim), label.c_str());
}

void draw_window_line(const Strips& s) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    ImGui::PushFont(s.ui.fonts.small);
    list->PushClipRect({s.at.x, s.window_top - 4.0f * s.unit()},
                       {s.at.x + s.width, s.window_bottom + 4.0f * s.unit()}, true);
    for (const Piece& piece : pieces_in_window(s))
        draw_piece(s, piece);
    list->PopClipRect();
    ImGui::PopFont();
}

void use_window_line(const Strips& s) {
    TimeWindow& window = s.window();
    ImGui::SetCursorScreenPos({s.at.x, s.window_top});
    ImGui::InvisibleButton("window", {s.width, s.window_bottom - s.window_top});
    window.is_dragged = ImGui::IsItemActive();
    const double place = window.begin + s.pointer() * window.width;
    const bool is_hovered = ImGui::IsItemHovered();
    const bool is_moved = ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0.0f;
    if (window.is_dragged && is_moved) {
        scrub_to(s.ui.session, moment_in_scale(s.timeline, place));
    }
    if (is_hovered) zoom_by_wheel(s, place);
    if (is_hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        show_triangle(window, place);
    }
    name_widget(
        s.ui, "walk.window",
        "The part in the bracket, enlarged: what a triangle is made of, each piece about as "
        "long as it has moments. Drag to go to any of them; the wheel enlarges, and a double "
        "click shows the whole triangle again.");
}

/// Where time stands, on both lines.
void draw_cursor_lines(const Strips& s, bool has_window) {
    const float u = s.unit();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImU32 colour = packed(s.colours().text);
    const auto line = [&](float x, float top, float bottom) {
        list->AddRectFilled({x - 1.5f * u, top - 3.0f * u}, {x + 1.5f * u, bottom + 3.0f * u},
                            colour, u);
    };
    line(s.on_frame(s.cursor), s.top, s.bottom);
    if (!has_window) return;
    const TimeWindow& window = s.window();
    if (s.in_scale < window.begin || s.in_scale > window.begin + window.width) return;
    line(s.in_window(s.in_scale), s.window_top, s.window_bottom);
}

} // namespace

float time_strips_height(const Ui& ui, bool has_window) {
    const float height = has_window
                             ? marks_height + frame_line_height + grip_room + window_line_height
                             : lone_height;
    return height * ui.options.text_scale;
}

void draw_time_strips(Ui& ui, ImVec2 at, float width, bool has_window) {
    const float u = ui.options.text_scale;
    const Timeline timeline(ui.results.a.frame);
    const float top = at.y + marks_height * u;
    const float bottom = top + (has_window ? frame_line_height : lone_line_height) * u;
    const float window_top = bottom + grip_room * u;
    const Strips s{ui,
                   timeline,
                   at,
                   std::max(width, 1.0f),
                   top,
                   bottom,
                   window_top,
                   window_top + window_line_height * u,
                   place_in_triangles(timeline, ui.results.a.cursor),
                   place_in_scale(timeline, ui.results.a.cursor)};
    follow_moment(s.window(), timeline.frame().triangle_count(), s.in_scale, ui.results.a.cursor);
    draw_frame_line(s);
    draw_differences(s);
    use_frame_line(s, has_window);
    if (has_window) {
        draw_bracket(s);
        draw_window_line(s);
        use_window_line(s);
    }
    draw_cursor_lines(s, has_window);
}

} // namespace rasterwalk
