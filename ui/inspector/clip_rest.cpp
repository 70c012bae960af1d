#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "explain/cull_formulas.h"
#include "inspect/stats.h"
#include "settings/value_words.h"
#include "ui/inspector/clip_parts.h"
#include "ui/inspector/clip_table.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const char* cull_answer_text(const CullAnswer& answer) {
    if (answer.is_open) return "no answer";
    return answer.is_in_parts ? "in parts" : answer.is_back ? "back" : "front";
}

std::string answer_help(const Frame& frame, Cull rule) {
    const std::string sight(sight_name(frame));
    switch (rule) {
    case Cull::face_normal:
        return sight + ": does the normal of the first corner point away from the camera? Then "
                       "this is a back face.";
    case Cull::screen_area:
        return "The signed area on the screen. It is less than 0 where the corners go round "
               "counterclockwise, as those of a back face do. With a corner behind the camera "
               "there is no such order.";
    case Cull::vertex_normals:
        return sight + " of the corner whose normal points away least. It is a back face only if "
                       "all of them point away, so a smooth object keeps the faces on its outline.";
    case Cull::fragment_normal:
        return sight + " at every fragment, with the normal interpolated to it. A fragment faces "
                       "away only if this is greater than 0. The number is that of the corner "
                       "whose normal points away least.";
    case Cull::none:
    case Cull::view_axis:
    case Cull::lamp:
        break;
    }
    return "";
}

void draw_answer(const ClipPage& page, const CullAnswer& answer, bool is_in_force) {
    const Setting& setting = *find_setting("cull");
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string word(word_of(answer.rule));
    text_in(is_in_force ? page.palette().text : page.palette().dim,
            (is_in_force ? "● " : "○ ") + choice_words(setting, word));
    register_widget(page.ui, "clip.cull.way." + word, answer_help(page.frame, answer.rule));
    ImGui::PushFont(page.ui.fonts.mono);
    ImGui::TableNextColumn();
    const std::string text = std::abs(answer.measure) >= 1000.0f
                                 ? fixed(static_cast<double>(answer.measure), 0)
                                 : fixed(static_cast<double>(answer.measure), 3);
    draw_selected_formula(page, "clip.cull." + word, answer.formula, text, page.palette().text,
                          std::string(answer_help(page.frame, answer.rule)));
    ImGui::TableNextColumn();
    const Meaning meaning = answer.is_back ? Meaning::fail : Meaning::pass;
    right_aligned(cull_answer_text(answer),
                  answer.is_open ? page.palette().dim : colour_of(meaning, page.ui.options.theme));
    ImGui::PopFont();
}

/// What happens to it, and why the ways differ.
std::string culling_text(const ClipPage& page, const std::vector<CullAnswer>& answers) {
    const Cull in_force = page.frame.settings.cull;
    std::string text;
    if (in_force == Cull::none) {
        text = "No back faces are left out, so the triangle is drawn whichever side it shows.";
    } else if (in_force == Cull::fragment_normal) {
        text = "The setting checks each fragment separately and leaves out those whose normal "
               "points away.";
    } else {
        text = page.history.cull.is_back ? "It is left out." : "It is drawn.";
    }
    const auto is_back = [](const CullAnswer& answer) { return answer.is_back; };
    const auto backs = std::count_if(answers.begin(), answers.end(), is_back);
    if (backs == 0 || backs == static_cast<std::ptrdiff_t>(answers.size())) return text;
    const bool is_open = std::any_of(answers.begin(), answers.end(),
                                     [](const CullAnswer& answer) { return answer.is_open; });
    text += " The tests differ here because ";
    if (is_open) {
        text += "a corner is behind the camera, so the corners have no order on the screen.";
    } else if (answers[0].is_back != answers[1].is_back) {
        text += "its normal and corner order disagree on which side is front.";
    } else {
        text += "some of its vertices have normals that point toward the camera.";
    }
    return text;
}

} // namespace

void draw_clip_rest(const ClipPage& page) {
    const std::vector<CutCorner> corners = corners_before(page.history);
    if (page.history.planes.empty() || page.history.polygon.empty()) return;
    const PolygonCorners pixels = page.frame.triangle_vertices(page.history.triangle);
    const bool has_pixels =
        page.frame.is_drawn(page.history.triangle) && pixels.size() == corners.size();
    draw_clip_title(page, "The polygon that remains", "divided by w: pixels");
    if (begin_clip_table(page, "rest", {1.2f, 1.1f, 1.1f, 0.8f, 0.9f, 0.9f})) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        for (const int i : {0, 1, 3}) {
            const auto at = static_cast<std::size_t>(i);
            draw_column_title(page, std::string("clip.rest.") + clip_coordinates[at],
                              clip_coordinates[at], clip_coordinate_help[at]);
        }
        draw_column_title(page, "clip.rest.column", "column", "The column of its pixel.");
        draw_column_title(page, "clip.rest.row", "row", "The row of its pixel.");
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const std::string corner = std::to_string(c);
            draw_corner_name(page, corners[c], page.progress.has_value());
            register_widget(page.ui, "clip.rest." + corner, corner_help(corners[c]));
            ImGui::PushFont(page.ui.fonts.mono);
            for (const int i : {0, 1, 3}) {
                const std::string id = corner_formula_id(corners[c], i);
                ImGui::TableNextColumn();
                draw_selected_formula(
                    page,
                    "clip.rest." + corner + "." + clip_coordinates[static_cast<std::size_t>(i)], id,
                    clip_number(corners[c].vertex.position_clip[i], i), page.palette().dim,
                    clip_coordinate_help[static_cast<std::size_t>(i)]);
            }
            for (const bool is_column : {true, false}) {
                const std::string id = "pixel." + corner + (is_column ? ".column" : ".row");
                ImGui::TableNextColumn();
                if (!has_pixels) continue;
                draw_selected_formula(page, "clip." + id, id,
                                      whole_text(is_column ? pixels[c].column : pixels[c].row),
                                      page.palette().text, "Its pixel in the picture.");
            }
            ImGui::PopFont();
        }
        end_clip_table();
    }
    std::string fan;
    for (const auto& triangle : page.history.fan) {
        fan += fan.empty() ? "" : ",  ";
        for (std::size_t k = 0; k < triangle.size(); ++k)
            fan += (k == 0 ? "" : " ") +
                   short_corner_name(corners[static_cast<std::size_t>(triangle[k])]);
    }
    wrapped_text(
        fmt::format("{} make {}:", counted(static_cast<int>(corners.size()), "corner", "corners"),
                    counted(static_cast<int>(page.history.fan.size()), "triangle", "triangles")));
    wrapped_text_in(page.palette().dim, fan, page.ui.fonts.mono);
    register_widget(page.ui, "clip.fan",
                    "The fan: every triangle begins at the first corner of the polygon.");
}

void draw_clip_culling(const ClipPage& page) {
    const std::vector<CullAnswer> answers = cull_answers(page.frame, page.history);
    if (answers.empty()) return;
    draw_clip_title(page, "Front or back?", "by each test");
    if (begin_clip_table(page, "culling", {1.6f, 1.2f, 1.0f})) {
        for (const CullAnswer& answer : answers)
            draw_answer(page, answer, answer.rule == page.frame.settings.cull);
        end_clip_table();
    }
    wrapped_text_in(page.palette().dim, culling_text(page, answers));
    register_widget(
        page.ui, "clip.culling",
        "Of a closed object you see only the sides that face the camera, so the others need "
        "not be drawn. The \"Culled\" setting selects the test that is used.");
}

void draw_clip_counts(const ClipPage& page) {
    const RunResults& a = page.ui.results.a;
    const bool is_whole = a.replay.tallied() == cursor_end;
    const LeftOut left_out = count_left_out(page.frame);
    const ClipCounts clipping = count_clipping(page.frame);
    draw_clip_title(page, "In the whole frame",
                    counted(page.frame.triangle_count(), "triangle", "triangles"));
    if (!begin_clip_table(page, "counts", {2.2f, 1.0f})) return;
    const auto line = [&](const std::string& title, const std::string& name, std::int64_t count,
                          const std::string& help) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        text_in(page.palette().text, title);
        register_widget(page.ui, "clip.count." + name, help);
        ImGui::PushFont(page.ui.fonts.mono);
        ImGui::TableNextColumn();
        right_aligned(whole_text(count), page.palette().text);
        ImGui::PopFont();
        register_text(page.ui, "clip.count." + name, whole_text(count));
    };
    line("rejected", "rejected", left_out.of(Rejection::outside),
         "Triangles whose corners all lie beyond the same plane, found by their outcodes.");
    line("cut", "clipped", clipping.clipped, "Triangles that a plane has cut.");
    line("after clipping", "clip_triangles", clipping.clip_triangles,
         "Triangles after clipping, including the fan of each polygon; those that were not cut "
         "count as well.");
    line("culled", "culled", left_out.of(Rejection::back_facing),
         "Back faces, which are left out.");
    line(is_whole ? "fragments outside" : "fragments outside, so far", "fragments_outside",
         a.replay.tally().fragments_outside,
         "Fragments that fall outside the picture and are computed for nothing. Clipping by all "
         "planes avoids them, and so does cheap clipping.");
    end_clip_table();
}

} // namespace rasterwalk
