#include "ui/bars/frame_line.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "session/walk.h"
#include "ui/actions/compare.h"
#include "ui/widgets/language.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The least distance between two marks, design pixels.
constexpr float mark_distance = 11.0f;

void find_differences(const TimeLines& s) {
    DifferenceMarks& found = s.ui.transport.differences;
    const Results& results = s.ui.results;
    if (!results.b) {
        found = {};
        return;
    }
    const std::vector<DivergenceGroup>& groups = results.comparison.whole().divergences.groups;
    const bool is_known = found.frame_a == results.a.frame_number &&
                          found.frame_b == results.b->frame_number && found.width == s.width &&
                          found.groups_placed <= groups.size();
    if (!is_known) {
        found = {};
        found.frame_a = results.a.frame_number;
        found.frame_b = results.b->frame_number;
        found.width = s.width;
    }
    const float distance = mark_distance * s.unit();
    const bool is_fine = static_cast<float>(s.triangles()) * distance < s.width;
    for (; found.groups_placed < groups.size(); ++found.groups_placed) {
        const Cursor& first = groups[found.groups_placed].first;
        const float free = found.marks.empty() ? -distance : found.marks.back().x;
        if (s.on_frame(first.triangle + 1.0) - s.at.x < free + distance) continue;
        const double place = is_fine ? place_in_triangles(s.timeline, s.timeline.at_or_after(first))
                                     : first.triangle;
        const float x = s.on_frame(place) - s.at.x;
        if (x >= free + distance) found.marks.push_back({x, found.groups_placed});
    }
}

std::string words_of(const DivergenceGroup& group) {
    return tr("The two runs differ from here: triangles[{}], {}, {}, {}. Click to go there.",
              group.triangle, tr(phase_info(group.phase).word),
              group.count == 1 ? tr("1 moment") : tr("{} moments", group.count),
              tr(kind_text(group.kind)));
}

void draw_differences(const TimeLines& s) {
    find_differences(s);
    const std::vector<DifferenceMarks::Mark>& marks = s.ui.transport.differences.marks;
    const float u = s.unit();
    const float radius = 0.5f * time_marks_height * u;
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
        register_widget(s.ui, name, words_of(group));
        const float r = (is_hovered ? 5.5f : 4.5f) * u;
        draw_difference_mark(list, c, r, is_hovered ? packed(s.colours().text) : colour);
        if (is_clicked) stand_at(s.ui, group.first);
    }
}

void draw_line(const TimeLines& s) {
    const Palette& p = s.colours();
    const float u = s.unit();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float right = s.at.x + s.width, x = s.on_frame(s.cursor);
    list->AddRectFilled({s.at.x, s.top}, {right, s.bottom}, packed(p.button), 2.0f * u);
    list->AddRectFilled({s.at.x, s.top}, {x, s.bottom}, packed(p.accent), 2.0f * u);
    const int triangles = time_units(s.timeline.frame());
    if (static_cast<float>(triangles) * time_tick_distance * u > s.width) return;
    for (int t = 1; t < triangles; ++t) {
        const float tick = std::round(s.on_frame(t));
        list->AddLine({tick, s.top}, {tick, s.bottom}, packed(p.bar), u);
    }
}

void use_frame_line(const TimeLines& s, bool has_window) {
    const float u = s.unit();
    const bool has_marks = !s.ui.transport.differences.marks.empty();
    const float above = has_marks ? 0.0f : time_marks_height * u;
    const float below = has_window ? 2.0f * u : s.at.y + lone_time_line_height * u - s.bottom;
    ImGui::SetCursorScreenPos({s.at.x, s.top - above});
    ImGui::InvisibleButton("scrub", {s.width, s.bottom - s.top + above + below});
    if (ImGui::IsItemActive())
        scrub_to(s.ui.session, in_pass(s.timeline.at_place(s.pointer()), s.timeline.frame().pass));
    if (ImGui::IsItemHovered() && has_window) {
        const TimeWindow& window = s.window();
        const bool is_inside =
            s.in_scale >= window.begin && s.in_scale <= window.begin + window.width;
        zoom_by_wheel(s, is_inside ? s.in_scale : window.begin + 0.5 * window.width);
    }
    const bool has_squares = s.timeline.frame().squares != nullptr;
    const char* const extent =
        has_squares ? "The whole frame from its first square to its last."
        : s.timeline.frame().has_samples()
            ? "The whole frame from its first vertex to its last pixel, with one tick per triangle "
              "and one for the pixels."
            : "The whole frame from its first vertex to its last fragment, with one tick per "
              "triangle.";
    std::string help = tr(extent) + std::string(" ") + tr("Drag to go to any moment.");
    if (has_window && !has_squares)
        help.append(" ").append(tr("The bracket marks what the line below enlarges; scroll to make "
                                   "it narrower."));
    register_widget(s.ui, "walk.scrub", help);
    step_by_arrows(s, "walk.scrub");
}

} // namespace

void draw_frame_line(const TimeLines& s, bool has_window) {
    draw_line(s);
    draw_differences(s);
    use_frame_line(s, has_window);
}

} // namespace rasterwalk
