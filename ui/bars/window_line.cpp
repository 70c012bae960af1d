#include "ui/bars/window_line.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "session/walk.h"
#include "ui/bars/time_window.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/language.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A triangle narrower than this is not divided into its pieces, design pixels.
constexpr float divided_triangle = 40.0f;

/// The moment at a position of the enlarged part.
Cursor moment_in_scale(const Timeline& timeline, double place) {
    const Frame& frame = timeline.frame();
    if (frame.squares != nullptr)
        return timeline.at_or_after(moment_of_square(static_cast<int>(std::max(place, 0.0))));
    if (place >= time_units(frame)) return cursor_end;
    const int unit = static_cast<int>(std::max(place, 0.0));
    const int triangle = triangle_of_unit(frame, unit);
    const bool has_moments = has_moments_in_unit(frame, unit);
    if (has_moments) {
        const TriangleMoments& moments = timeline.moments(triangle);
        const int ordinal = triangle_scale(moments).ordinal_at(place - unit);
        if (ordinal < moments.count) return timeline.at_ordinal(triangle, ordinal);
    }
    return timeline.at_or_after(beginning_of(has_moments ? triangle + 1 : triangle));
}

void draw_bracket(const TimeLines& s) {
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
    register_widget(
        s.ui, "walk.bracket",
        tr("What the line below enlarges. Drag it along the frame; scroll to make it narrower "
           "or wider."));
    const Arrows arrows = take_arrows(s.ui, "walk.bracket");
    if (arrows.right != 0) pan_window(s.window(), 0.1 * arrows.right * window.width);
    const float y = top + 3.5f * u;
    list->AddRectFilled({middle - 0.5f * grip, y - 1.5f * u}, {middle + 0.5f * grip, y + 1.5f * u},
                        packed(is_lit ? p.text : p.dim), 1.5f * u);
}

/// A stretch of the enlarged part with one name and one colour.
struct Piece {
    double begin, end; ///< in triangles
    ImVec4 colour;
    std::string name;         ///< "edge 1"; may be empty
    std::string brief;        ///< if the name is too long; may be empty
    std::string count;        ///< given after the name; may be empty
    std::vector<int> between; ///< moments before each of its parts except the first
    int moments = 1;          ///< its number of moments, equally long
};

/// Where the ticks of a phase are: between its rows; moments are too narrow to be seen one by one.
std::vector<int> begins_of_rows(const PhaseMoments& phase) {
    return {phase.before.begin() + 1, phase.before.end() - 1};
}

/// @param unit of a triangle, or the one in which pixels are resolved
void add_pieces(const TimeLines& s, int unit, std::vector<Piece>& pieces) {
    const TriangleMoments& moments = s.timeline.moments(triangle_of_unit(s.timeline.frame(), unit));
    const TriangleScale scale = triangle_scale(moments);
    const auto add = [&](int first, int last) -> Piece& {
        Piece& piece = pieces.emplace_back();
        piece.begin = unit + scale.share_of(first);
        piece.end = last < moments.count ? unit + scale.share_of(last) : unit + 1.0;
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
                piece.name = element_name(info.piece, static_cast<int>(e), current_language());
                piece.count = std::to_string(phase.pieces[e].count);
            }
            continue;
        }
        Piece& piece = add(first, before);
        piece.name = tr(info.word);
        const auto count = std::count_if(phase.pieces.begin(), phase.pieces.end(),
                                         [](const auto& part) { return part.count > 0; });
        const bool is_rows = info.phase == Phase::rows || info.phase == Phase::resolve,
                   is_tests = info.phase == Phase::tests;
        piece.colour = is_rows ? s.colours().accent : s.colours().dim;
        if (is_rows || is_tests) piece.between = begins_of_rows(phase);
        // Of the box: each test is a pixel of one of its rows.
        if (count > 0)
            piece.count = is_tests && count > 1 ? tr("{} rows", count) : std::to_string(count);
    }
}

/// A square of the picture: what is drawn, what is divided, and background differ in colour.
Piece piece_of(const TimeLines& s, int number) {
    const Palette& p = s.colours();
    const WarnockSquare& square = (*s.timeline.frame().squares)[number];
    Piece piece;
    piece.begin = number;
    piece.end = number + 1.0;
    piece.colour = square.surface >= 0                     ? p.accent
                   : square.reason == SquareReason::divide ? p.dim
                                                           : p.line;
    piece.brief = to_text(moment_of_square(number));
    piece.name = fmt::format("{} · {}", piece.brief, tr(words(square.reason).in_short));
    return piece;
}

/// The pieces of the enlarged part. With very many triangles it is one piece.
std::vector<Piece> pieces_in_window(const TimeLines& s) {
    const TimeWindow& window = s.window();
    const Frame& frame = s.timeline.frame();
    const Palette& p = s.colours();
    const double end = window.begin + window.width;
    const float each = s.width / static_cast<float>(window.width);
    std::vector<Piece> pieces;
    if (each < 3.0f * s.unit()) return {{window.begin, end, p.accent, "", "", "", {}, 1}};
    const int last = std::min(static_cast<int>(std::ceil(end)), time_units(frame));
    for (int n = static_cast<int>(window.begin); frame.squares != nullptr && n < last; ++n)
        pieces.push_back(piece_of(s, n));
    if (frame.squares != nullptr) return pieces;
    for (int t = static_cast<int>(window.begin); t < last; ++t) {
        const double first = t;
        const std::string index = fmt::format("[{}]", t);
        const bool is_divided = each >= divided_triangle * s.unit();
        if (t == frame.triangle_count()) {
            if (is_divided)
                add_pieces(s, t, pieces);
            else
                pieces.push_back({first, first + 1.0, p.accent, tr("resolve"), "", "", {}, 1});
        } else if (!frame.has_moments(t) || (!is_divided && !frame.is_drawn(t))) {
            pieces.push_back({first, first + 1.0, p.line, tr("left out"), index, "", {}, 1});
        } else if (!is_divided) {
            pieces.push_back({first, first + 1.0, p.accent, "triangles" + index, index, "", {}, 1});
        } else {
            add_pieces(s, t, pieces);
        }
    }
    return pieces;
}

/// The longest label of a piece that fits.
std::string fitting_label(const Piece& piece, float room) {
    const auto fits = [&](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str()).x <= room;
    };
    const std::string whole =
        piece.count.empty() ? piece.name : fmt::format("{} · {}", piece.name, piece.count);
    for (const std::string& text : {whole, piece.name, piece.brief}) {
        if (fits(text)) return text;
    }
    return {};
}

/// Ticks between moments if they are far enough apart; otherwise between rows.
void draw_ticks(const TimeLines& s, const Piece& piece) {
    const float u = s.unit();
    const double length = piece.end - piece.begin;
    const double pixels = static_cast<double>(s.width) * length / s.window().width;
    const auto least = static_cast<double>(time_tick_distance * u);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float line = s.window_bottom - 3.0f * u;
    const auto tick = [&](int moment) {
        const float x = std::round(s.in_window(piece.begin + length * moment / piece.moments) - u);
        list->AddLine({x, line - 4.0f * u}, {x, line}, packed(s.colours().dim, 0.55f), u);
    };
    // Only the part of the piece that is in the window.
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

void draw_piece(const TimeLines& s, const Piece& piece) {
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

void draw_pieces(const TimeLines& s) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    ImGui::PushFont(s.ui.fonts.small);
    list->PushClipRect({s.at.x, s.window_top - 4.0f * s.unit()},
                       {s.at.x + s.width, s.window_bottom + 4.0f * s.unit()}, true);
    for (const Piece& piece : pieces_in_window(s))
        draw_piece(s, piece);
    list->PopClipRect();
    ImGui::PopFont();
}

void use_window_line(const TimeLines& s) {
    TimeWindow& window = s.window();
    ImGui::SetCursorScreenPos({s.at.x, s.window_top});
    ImGui::InvisibleButton("window", {s.width, s.window_bottom - s.window_top});
    window.is_dragged = ImGui::IsItemActive();
    const double place = window.begin + s.pointer() * window.width;
    const bool is_hovered = ImGui::IsItemHovered();
    const bool is_moved = ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0.0f;
    if (window.is_dragged && is_moved) {
        scrub_to(s.ui.session,
                 in_pass(moment_in_scale(s.timeline, place), s.timeline.frame().pass));
    }
    if (is_hovered) zoom_by_wheel(s, place);
    if (is_hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        show_triangle(window, place);
    }
    const bool has_squares = s.timeline.frame().squares != nullptr;
    register_widget(
        s.ui, "walk.window",
        has_squares
            ? tr("The part in the bracket, enlarged: one piece per square. Drag to go to any "
                 "moment "
                 "and scroll to enlarge.")
            : tr("The part in the bracket, enlarged. It shows what a triangle is made of; the more "
                 "moments a piece has, the longer it is. Drag to go to any moment and scroll to "
                 "enlarge; a double click shows the whole triangle again."));
    step_by_arrows(s, "walk.window");
}

} // namespace

void draw_window_line(const TimeLines& s) {
    draw_bracket(s);
    draw_pieces(s);
    use_window_line(s);
}

} // namespace rasterwalk
