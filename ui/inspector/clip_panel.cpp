#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/enumerated.h"
#include "base/numbers.h"
#include "session/quiz_state.h"
#include "session/tabs.h"
#include "stages/project.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/clip_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// "the near plane and the left plane", "the near plane, the left plane and the top plane".
std::string list_of_planes(Outcode code) {
    std::vector<std::string> names;
    for (std::size_t p = 0; p < clip_plane_count; ++p) {
        if ((code >> p & 1u) != 0) names.push_back("the " + plane_name(static_cast<ClipPlane>(p)));
    }
    return enumerated(names);
}

/// What happens to the triangle, in a sentence.
std::string verdict_of(const ClipHistory& history, const Settings& settings) {
    const TriangleCodes& codes = history.codes;
    if (history.rejected != Rejection::none) {
        return "Rejected before clipping because all corners lie beyond " +
               list_of_planes(history.outer_codes.common()) + ".";
    }
    if (!history.cuts) {
        if (history.clipped.is_cut)
            return "It is changed by a function that reports no plane; what is left is shown "
                   "below.";
        if (history.clipped.rejection != Rejection::none)
            return "Nothing is cut; the whole triangle is left out.";
        if (settings.reject == Reject::cheap)
            return "Nothing is cut; cheap clipping skips the rows and columns outside the picture.";
        if (settings.clip != Clip::leave_out)
            return "Nothing is cut; anything outside the view is divided as it is.";
        return "Nothing is cut, as in the lab. A triangle with a vertex behind the camera is left "
               "out completely, and anything outside the picture is left out pixel by pixel.";
    }
    if (history.clipped.rejection != Rejection::none) {
        if (codes.common() != 0) {
            return "Nothing is left because all corners lie beyond " +
                   list_of_planes(codes.common()) + ".";
        }
        return "Nothing is left, although no plane has all corners beyond it. The triangle passes "
               "by a corner of the view, which outcodes alone cannot detect.";
    }
    if (history.planes.empty()) {
        return "Accepted because no corner lies beyond a plane. There is nothing to cut.";
    }
    Outcode cut = 0;
    for (const PlaneHistory& plane : history.planes)
        cut = static_cast<Outcode>(cut | 1u << static_cast<unsigned>(plane.plane));
    return fmt::format("Cut by {}: 3 corners become {}, drawn as {}.", list_of_planes(cut),
                       history.polygon.size(),
                       counted(static_cast<int>(history.fan.size()), "triangle", "triangles"));
}

/// The vertex behind the camera that is explained; -1: there is none.
int vertex_behind_camera(const ClipHistory& history) {
    for (int v = 0; v < triangle_corners; ++v) {
        const float w = history.corners[static_cast<std::size_t>(v)].position_clip.w;
        if (w <= 0.0f) return v;
    }
    return -1;
}

/// The same on one line: with blanks that allow no line break.
std::string unbroken(const std::string& text) {
    std::string result;
    for (const char letter : text)
        result += letter == ' ' ? "\xC2\xA0" : std::string(1, letter);
    return result;
}

/// What the division would do to a vertex behind the camera.
std::string behind_camera_text(const ClipHistory& history, const Frame& frame, int vertex) {
    const glm::vec4& clip = history.corners[static_cast<std::size_t>(vertex)].position_clip;
    const std::string w = shown({clip.w});
    std::string text;
    if (clip.w < 0.0f) {
        const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
        const glm::vec2 place = glm::vec2(frame.stages.viewport_middle(rules)) +
                                frame.stages.perspective_divide(clip, 1.0f / clip.w);
        const auto part = [](float value) { return fixed(static_cast<double>(value), 0); };
        text = fmt::format("{} is behind the camera: {}. Dividing by this negative w mirrors it to "
                           "{}, on the other side of the picture, and turns the triangle inside "
                           "out.",
                           vertex_name(vertex), unbroken("w = " + w),
                           unbroken(fmt::format("({}, {})", part(place.x), part(place.y))));
    } else {
        text = vertex_name(vertex) + " lies in the camera's own plane: w = 0, and nothing can be "
                                     "divided by 0.";
    }
    if (history.cuts) return text + " So it is cut off before the division.";
    if (!frame.is_drawn(history.triangle)) return text + " So the whole triangle is left out.";
    return text + " That is what is drawn now.";
}

/// If nothing is cut: a button to see it cut.
void draw_offer(Ui& ui) {
    if (hides_settings(ui.session)) return;
    if (button(ui, "clip.cut_all", "Cut by all six planes", Look::plain,
               "Sets \"Clipped\" to \"by all planes\", so anything outside the view is cut off "
               "before the division.")) {
        ui.session.a.settings.clip = Clip::all;
    }
}

void draw_clip_verdict(const ClipPage& page) {
    Ui& ui = page.ui;
    const bool is_culled = page.frame.settings.cull != Cull::none && page.history.cull.is_back;
    wrapped_text(verdict_of(page.history, page.frame.settings) +
                 (is_culled ? " It is left out because it faces away." : ""));
    register_widget(
        ui, "clip.verdict",
        "What happens to the triangle between the vertex shader and the division by w.");
    if (!page.history.cuts && page.history.rejected == Rejection::none) draw_offer(ui);
    const int behind = vertex_behind_camera(page.history);
    if (behind < 0) return;
    wrapped_text_in(colour_of(Meaning::fail, ui.options.theme),
                    behind_camera_text(page.history, page.frame, behind));
    register_widget(ui, "clip.behind",
                    "Behind the camera, w is negative. The division by w turns a point behind the "
                    "camera into one in front of it, mirrored through the eye.");
}

/// What is explained until the student asks: what was just done, or the first cut, or else what
/// culling tests.
std::string usual_number(const ClipHistory& history, const std::optional<ClipProgress>& progress) {
    const auto id_of = [](const ClipStep& step) {
        const auto plane = static_cast<int>(step.plane);
        return step.is_cut ? fmt::format("t.{}.{}", plane, step.from)
                           : fmt::format("d.{}.{}", plane, step.from);
    };
    if (progress) {
        const PlaneHistory& plane = history.planes[static_cast<std::size_t>(progress->planes)];
        const int last = std::clamp(progress->steps, 1, static_cast<int>(plane.steps.size())) - 1;
        return id_of(plane.steps[static_cast<std::size_t>(last)]);
    }
    for (const PlaneHistory& plane : history.planes) {
        for (const ClipStep& step : plane.steps) {
            if (step.is_cut) return id_of(step);
        }
    }
    return "corner." + std::to_string(std::max(vertex_behind_camera(history), 0)) + ".w";
}

/// Has the cursor reached a step of clipping since the panel was last drawn?
bool follow_cursor(Ui& ui, const ClipHistory& history,
                   const std::optional<ClipProgress>& progress) {
    ClipLook& look = ui.inspector.clip;
    if (look.triangle != history.triangle) look = {};
    look.triangle = history.triangle;
    const bool has_moved = progress && look.picked_at != ui.results.a.cursor;
    look.picked_at = ui.results.a.cursor;
    return has_moved;
}

/// The number that was asked about, until the triangle changes or the cursor reaches a step.
std::string shown_number(Ui& ui, const ClipHistory& history,
                         const std::optional<ClipProgress>& progress, bool has_moved) {
    ClipLook& look = ui.inspector.clip;
    if (has_moved || !clip_formula(ui.results.a.frame, history, look.number)) look.number.clear();
    return look.number.empty() ? usual_number(history, progress) : look.number;
}

void draw_clip_card(const ClipPage& page) {
    Ui& ui = page.ui;
    std::optional<Formula> formula = clip_formula(page.frame, page.history, page.number);
    if (!formula) return;
    const float top = ImGui::GetCursorScreenPos().y;
    begin_card(ui);
    text_in(page.palette().dim, formula->help);
    keep_beginning(top, ImGui::GetItemRectMin().y + ImGui::GetTextLineHeight());
    register_widget(ui, "clip.formula", formula->help);
    ImGui::PushFont(ui.inspector.is_low ? ui.fonts.small : ui.fonts.text);
    const std::optional<Source> clicked = draw_formula(ui, *formula, "clip.formula");
    ImGui::PopFont();
    end_card(ui);
    if (!clicked) return;
    if (clicked->kind == SourceKind::formula) {
        ui.inspector.clip.number = clicked->name;
    }
    go_to_source(ui, *clicked);
}

/// All parts, and which of them has the number that is explained.
std::vector<PanelBlock> blocks_of(const ClipPage& page) {
    const auto has = [&](const std::string& prefix) { return page.number.starts_with(prefix); };
    std::vector<PanelBlock> blocks{{[&] { draw_clip_verdict(page); }},
                                   {[&] { draw_clip_corners(page); }, has("corner.")},
                                   {[&] { draw_clip_codes(page); }, has("code.")}};
    if (page.history.cuts && page.history.rejected == Rejection::none) {
        blocks.push_back({[&] { draw_clip_plane_buttons(page); }});
        for (std::size_t p = 0; p < page.history.codes.plane_count; ++p) {
            const std::string place = std::to_string(p) + ".";
            blocks.push_back({[&page, p] { draw_clip_plane(page, static_cast<ClipPlane>(p)); },
                              has("d." + place) || has("t." + place)});
        }
        blocks.back().has_chosen = blocks.back().has_chosen || has("new.");
    }
    blocks.push_back({[&] { draw_clip_rest(page); }, has("pixel.")});
    blocks.push_back({[&] { draw_clip_culling(page); }, true});
    blocks.push_back({[&] { draw_clip_counts(page); }});
    return blocks;
}

} // namespace

const Palette& ClipPage::palette() const {
    return rasterwalk::palette(ui.options.theme);
}

bool ClipPage::is_coming(ClipPlane plane, int step) const {
    if (!progress) return false;
    const int place = planes_before(history, plane);
    return place > progress->planes || (place == progress->planes && step >= progress->steps);
}

bool ClipPage::is_current(ClipPlane plane, int step) const {
    return progress && planes_before(history, plane) == progress->planes &&
           work_of(history, plane) != nullptr && step + 1 == progress->steps;
}

void draw_clip_panel(Ui& ui) {
    const RunResults& a = ui.results.a;
    if (!a.inspected.clip) {
        const char* const why = a.triangle ? "The scene is given in pixels, so it has no camera "
                                             "and nothing is clipped."
                                           : "The scene has no triangles.";
        wrapped_text_in(palette(ui.options.theme).dim, why);
        return;
    }
    const ClipHistory& history = *a.inspected.clip;
    const std::optional<ClipProgress> progress = clip_progress(history, a.done);
    const bool has_moved = follow_cursor(ui, history, progress);
    const ClipPage page{
        ui, a.frame, history, progress, shown_number(ui, history, progress, has_moved), has_moved};
    const std::string before = ui.inspector.clip.number;
    draw_triangle_title(ui);
    draw_panel(ui, "clip", blocks_of(page), [&] {
        draw_clip_card(page);
        // The click was in the previous frame, where the formula was elsewhere.
        const bool is_new = ui.inspector.formula_frame + 1 == ImGui::GetFrameCount();
        if (!ui.inspector.has_card && is_new) scroll_here(1.0f);
    });
    if (ui.inspector.clip.number != before) ui.inspector.formula_frame = ImGui::GetFrameCount();
}

} // namespace rasterwalk
