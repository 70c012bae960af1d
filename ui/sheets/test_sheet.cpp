#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/error.h"
#include "base/files.h"
#include "lessons/lesson_list.h"
#include "ui/actions/open_lesson.h"
#include "ui/sheets/reading_sheet.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const SheetLook test_look{.sheet = Sheet::test,
                          .window = "test",
                          .widgets = "test",
                          .title = "Test",
                          .close_help = "Closes the test; your answers are kept. Key: Esc",
                          .size = {620.0f, 560.0f}};

constexpr const char* report_file = "rasterwalk-test.html";

TestAnswers& answers_of(Ui& ui, bool is_after) {
    Progress& progress = ui.lesson.progress;
    return is_after ? progress.test_after : progress.test_before;
}

/// The first item without an answer; the number of items if all have one.
int first_open(const CourseTest& test, const TestAnswers& answers) {
    const auto found =
        std::find_if(test.items.begin(), test.items.end(), [&](const TestItem& item) {
            const auto said = answers.find(item.id);
            return said == answers.end() || std::find(item.choices.begin(), item.choices.end(),
                                                      said->second) == item.choices.end();
        });
    return static_cast<int>(found - test.items.begin());
}

/// "lessons 1 to 12": those that the test is about.
std::string lessons_in_words(const CourseTest& test) {
    std::vector<int> numbers;
    for (const TestItem& item : test.items)
        numbers.push_back(lesson_number(item.lesson));
    if (numbers.empty()) return "the lessons";
    const auto [first, last] = std::minmax_element(numbers.begin(), numbers.end());
    return fmt::format("lessons {} to {}", *first, *last);
}

void draw_sittings(Ui& ui, const CourseTest& test) {
    TestSheet& sheet = ui.sheets.test;
    const float gap = 6.0f * ui.options.text_scale;
    if (button(ui, "test.before", "before the lessons", sheet.is_after ? Look::plain : Look::chosen,
               "What you know before you begin.")) {
        sheet.is_after = sheet.is_going_back = false;
    }
    same_line_if_room("after the lessons", gap);
    if (button(ui, "test.after", "after the lessons", sheet.is_after ? Look::chosen : Look::plain,
               "The same items, once you have done " + lessons_in_words(test) + ".")) {
        sheet.is_after = true;
        sheet.is_going_back = false;
    }
    ImGui::Spacing();
}

/// An answer that can be chosen. Returns true when it is.
bool draw_choice(Ui& ui, const std::string& text, int number, bool is_said) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 padding{10.0f * u, 6.0f * u};
    const float width = ImGui::GetContentRegionAvail().x;
    const float wrap = std::max(width - 2.0f * padding.x, 1.0f);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 whole{width, size.y + 2.0f * padding.y};
    ImGui::PushID(number);
    const bool is_pressed = ImGui::InvisibleButton("choice", whole);
    ImGui::PopID();
    const bool is_hovered = ImGui::IsItemHovered();
    register_widget(ui, "test.choice." + std::to_string(number), "Choose this answer.", text);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec4 ground = is_said ? p.chosen : is_hovered ? p.button_hovered : p.button;
    list->AddRectFilled(low, {low.x + whole.x, low.y + whole.y}, packed(ground), 4.0f * u);
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + padding.x, low.y + padding.y},
                  packed(p.text), text.c_str(), nullptr, wrap + 1.0f);
    return is_pressed;
}

void draw_item(Ui& ui, const CourseTest& test, int number) {
    TestSheet& sheet = ui.sheets.test;
    const TestItem& item = test.items[static_cast<std::size_t>(number)];
    TestAnswers& answers = answers_of(ui, sheet.is_after);
    text_in(palette(ui.options.theme).dim,
            fmt::format("Item {} of {}", number + 1, test.items.size()), ui.fonts.small);
    wrapped_text(item.question);
    register_widget(ui, "test.question", {}, item.question);
    ImGui::Spacing();
    const auto said = answers.find(item.id);
    for (const int choice : item.order) {
        const std::string& text = item.choices[static_cast<std::size_t>(choice)];
        const bool is_said = said != answers.end() && said->second == text;
        if (!draw_choice(ui, text, choice, is_said)) continue;
        answers[item.id] = text;
        ui.lesson.progress.touch();
        sheet.is_going_back = false;
        return;
    }
    ImGui::Spacing();
    if (number > 0 && button(ui, "test.previous", "previous item", Look::link,
                             "Shows the previous item again, to change your answer.")) {
        sheet.item = number - 1;
        sheet.is_going_back = true;
    }
}

/// After the lessons: each item, with what was said and what is right.
void draw_outcome(Ui& ui, const CourseTest& test, const TestAnswers& answers) {
    const Palette& p = palette(ui.options.theme);
    for (const TestItem& item : test.items) {
        const std::string& said = answers.at(item.id);
        const bool is_right = said == item.choices.front();
        ImGui::PushStyleColor(
            ImGuiCol_Text, colour_of(is_right ? Meaning::pass : Meaning::fail, ui.options.theme));
        wrapped_text(std::string(is_right ? "✓  " : "✗  ") + said);
        ImGui::PopStyleColor();
        wrapped_text_in(p.dim, item.question, ui.fonts.small);
        if (!is_right) {
            wrapped_text("Right: " + item.choices.front());
            const std::string label = "lesson " + std::to_string(lesson_number(item.lesson));
            if (button(ui, "test.lesson." + item.id, label, Look::link,
                       "Opens the lesson that this is about.")) {
                ui.sheets.show(Sheet::test, false);
                open_lesson(ui, item.lesson, 0);
            }
        }
        ImGui::Spacing();
    }
}

void save_report(Ui& ui, const CourseTest& test) {
    const Progress& progress = ui.lesson.progress;
    try {
        write_file(report_file,
                   test_page(test, progress.test_before, progress.test_after, ui.sheets.test.name));
        show_info(ui.session, std::string("Saved ") + report_file + " in the current folder.");
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
}

void draw_report(Ui& ui, const CourseTest& test) {
    TestSheet& sheet = ui.sheets.test;
    const float u = ui.options.text_scale;
    const Progress& progress = ui.lesson.progress;
    ImGui::SetNextItemWidth(std::min(220.0f * u, ImGui::GetContentRegionAvail().x));
    ImGui::InputTextWithHint("##name", "your name", &sheet.name);
    register_widget(ui, "test.name", "It appears at the top of the report.");
    if (!ui.host.is_browser) {
        same_line_if_room("save the report", 8.0f * u);
        if (button(ui, "test.save", "save the report", Look::main,
                   "Saves both sittings as a page in the current folder, to hand in.")) {
            save_report(ui, test);
        }
    }
    same_line_if_room("copy it as text", 8.0f * u);
    if (button(ui, "test.copy", "copy it as text", Look::plain, "Copies both sittings as text.")) {
        ImGui::SetClipboardText(
            test_text(test, progress.test_before, progress.test_after, sheet.name).c_str());
        show_info(ui.session, "Copied the report.");
    }
}

void draw_result(Ui& ui, const CourseTest& test) {
    TestSheet& sheet = ui.sheets.test;
    TestAnswers& answers = answers_of(ui, sheet.is_after);
    const TestScore score = score_of_test(test, answers);
    ImGui::PushFont(ui.fonts.bold);
    const std::string words = fmt::format("{} of {} are right.", score.right, test.items.size());
    put_text(words);
    ImGui::PopFont();
    register_widget(ui, "test.score", {}, words);
    if (!sheet.is_after) {
        wrapped_text("You will see which ones after the second sitting, so that it is not "
                     "spoiled. Now do " +
                     lessons_in_words(test) + ".");
    } else {
        const TestScore before = score_of_test(test, ui.lesson.progress.test_before);
        if (before.answered > 0)
            put_text(fmt::format("Before the lessons it was {}.", before.right));
    }
    ImGui::Spacing();
    draw_report(ui, test);
    if (button(ui, "test.again", "take this sitting again", Look::link,
               "Removes the answers of this sitting.")) {
        answers.clear();
        ui.lesson.progress.touch();
        return;
    }
    ImGui::Separator();
    if (sheet.is_after) draw_outcome(ui, test, answers);
}

} // namespace

void draw_test_sheet(Ui& ui, ImVec2 window) {
    if (!ui.sheets.is_open(Sheet::test)) return;
    TestSheet& sheet = ui.sheets.test;
    if (!sheet.test && sheet.fault.empty()) {
        try {
            sheet.test = read_course_test();
        } catch (const Error& fault) {
            sheet.fault = fault.what();
        }
    }
    begin_sheet(ui, test_look, window);
    if (!sheet.test) {
        wrapped_text(sheet.fault);
    } else {
        draw_sittings(ui, *sheet.test);
        ImGui::BeginChild("test.content");
        begin_line_clip();
        const int open = first_open(*sheet.test, answers_of(ui, sheet.is_after));
        const int count = static_cast<int>(sheet.test->items.size());
        const int item = sheet.is_going_back ? sheet.item : open;
        if (item < count) {
            draw_item(ui, *sheet.test, item);
        } else {
            draw_result(ui, *sheet.test);
        }
        end_line_clip();
        ImGui::EndChild();
    }
    end_sheet();
}

} // namespace rasterwalk
