#include "ui/lesson/lesson_controls.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include <imgui.h>

#include "base/error.h"
#include "facts/facts.h"
#include "lessons/lesson_run.h"
#include "session/quiz_state.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/setting_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Widths of a field on the line of its name, design pixels.
constexpr float least_field = 130.0f, widest_field = 360.0f;

/// Space between name, field and read-out, design pixels.
constexpr float word_space = 10.0f;

/// "Focal length", "Camera position z".
std::string title_of(const LessonControl& control) {
    std::string title(control.setting->title);
    const bool is_part = control.range.part >= 0;
    return is_part ? title.append(" ").append(control.name, control.name.rfind('.') + 1) : title;
}

/// The read-out for the current state.
std::string read_out_of(Ui& ui, const LessonControl& control) {
    if (control.read_out.empty()) return {};
    const Facts facts(ui.session, ui.results, &ui.lesson.facts);
    try {
        return fill_in(control.read_out, "", std::nullopt, std::cref(facts));
    } catch (const Error&) {
        return {}; // it was already checked on reading
    }
}

void draw_title(const Ui& ui, const std::string& title) {
    ImGui::AlignTextToFramePadding();
    text_in(palette(ui.options.theme).dim, title);
}

} // namespace

void draw_lesson_control(Ui& ui, const LessonControl& control, float width) {
    const float u = ui.options.text_scale, gap = word_space * u;
    const float top = ImGui::GetCursorScreenPos().y;
    const std::string name = "lesson.control." + control.name;
    if (hides_settings(ui.session)) {
        wrapped_text_in(palette(ui.options.theme).dim,
                        "The settings are hidden until the quiz is over.");
        clip_to_lines();
        register_widget(ui, name + ".hidden", "They would give the mistake away.");
        return;
    }
    const std::string title = title_of(control), read_out = read_out_of(ui, control);
    const float said = text_width(ui.fonts.bold, read_out);
    ImGui::PushID(name.c_str());
    const float before = text_width(title) + gap;
    const bool has_title_at_side = width - before >= least_field * u;
    draw_title(ui, shortened(title, width));
    if (has_title_at_side) ImGui::SameLine(0.0f, gap);
    const float room = has_title_at_side ? width - before : width;
    const bool has_words_at_side = !read_out.empty() && room - said - gap >= least_field * u;
    ImGui::SetNextItemWidth(
        std::min(has_words_at_side ? room - said - gap : room, widest_field * u));
    edit_setting(ui, ui.session.a.settings, *control.setting, name, control.range);
    clip_range_to_lines(top, ImGui::GetItemRectMax().y);
    if (!read_out.empty()) {
        if (has_words_at_side) {
            ImGui::SameLine(0.0f, gap);
            ImGui::AlignTextToFramePadding();
        }
        ImGui::PushFont(ui.fonts.bold);
        if (has_words_at_side) {
            put_text(read_out);
        } else {
            wrapped_text(read_out);
        }
        ImGui::PopFont();
        register_widget(ui, name + ".read_out", "The result of this setting.", read_out);
    }
    ImGui::PopID();
}

std::vector<const LessonControl*> controls_of_part(const Lesson& lesson, const LessonStep& step,
                                                   int part) {
    const auto is_control = [&](int i) {
        return i >= 0 && i < static_cast<int>(step.parts.size()) &&
               step.parts[static_cast<std::size_t>(i)].kind == LessonPart::Kind::control;
    };
    int first = part, last = part;
    while (is_control(first - 1))
        --first;
    while (is_control(last + 1))
        ++last;
    std::vector<const LessonControl*> controls;
    for (int i = first; i <= last; ++i) {
        if (!is_control(i)) continue;
        const int index = step.parts[static_cast<std::size_t>(i)].index;
        controls.push_back(&lesson.controls[static_cast<std::size_t>(index)]);
    }
    return controls;
}

} // namespace rasterwalk
