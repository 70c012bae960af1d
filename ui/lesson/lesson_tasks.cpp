#include "ui/lesson/lesson_tasks.h"

#include <set>
#include <string>

#include <imgui.h>

#include "ui/lesson/lesson_box.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Scrolls what has just appeared into sight, once the text has its new length.
void scroll_to_fresh(Ui& ui, const std::string& name) {
    LessonView& view = ui.lesson;
    if (view.fresh != name || --view.frames_to_fresh > 0) return;
    view.fresh.clear();
    scroll_here(1.0f);
}

/// Why a task is solved, or what the last try missed.
void draw_task_words(Ui& ui, const LessonTask& task, const std::string& name, bool done,
                     float width) {
    const auto words = ui.lesson.task_words.find(task.id);
    if (words == ui.lesson.task_words.end() || words->second.text.empty()) return;
    if (words->second.is_reason != done) return; // another window has just solved it
    const std::string& said = words->second.text;
    draw_marked(ui, name + ".words", ui.lesson.pages[name + ".words"],
                done ? said : tr("**Not yet:** {}", said), width);
    register_widget(ui, name + ".words", {}, said);
    scroll_to_fresh(ui, name + ".words");
}

/// A hint, as far as it was requested.
void draw_hint(Ui& ui, const LessonTask& task, const std::string& name, float width) {
    std::set<std::string>& hints = ui.lesson.open_hints;
    if (hints.count(task.id) > 0) {
        draw_marked(ui, name + ".hint", ui.lesson.pages[name + ".hint"], "*" + task.hint + "*",
                    width);
        scroll_to_fresh(ui, name + ".hint");
    } else if (button(ui, name + ".hint", tr("hint"), Look::link,
                      tr("A nudge, if you are stuck."))) {
        hints.insert(task.id);
        ui.lesson.fresh = name + ".hint";
        ui.lesson.frames_to_fresh = 2;
    }
}

} // namespace

void draw_task(Ui& ui, const Lesson& lesson, const LessonTask& task, float width) {
    const Palette& p = palette(ui.options.theme);
    const bool done = ui.lesson.progress.is_task_done(lesson.id, task.id);
    const ImVec4 colour = done ? colour_of(Meaning::pass, ui.options.theme) : p.changed;
    const std::string name = "lesson.task." + task.id;
    ImGui::PushID(name.c_str());
    {
        LessonBox box(ui, width, colour);
        box.heading(tr(done ? "✓ DONE" : "TASK"), colour);
        register_widget(ui, name,
                        tr(done ? "You have solved this."
                                : "Ticked off when you have done it and nothing is moving."));
        box.markdown(name, ui.lesson.pages[name], without_label(task.text));
        draw_task_words(ui, task, name, done, box.inner_width());
        if (!task.hint.empty() && !done) draw_hint(ui, task, name, box.inner_width());
    }
    ImGui::PopID();
}

void draw_task_lines(Ui& ui, const Lesson& lesson, const LessonTask& task, float width) {
    const bool done = ui.lesson.progress.is_task_done(lesson.id, task.id);
    const std::string name = "lesson.task." + task.id;
    ImGui::PushID(name.c_str());
    draw_marked(ui, name, ui.lesson.pages[name], without_label(task.text), width);
    register_widget(ui, name);
    draw_task_words(ui, task, name, done, width);
    if (!task.hint.empty() && !done) draw_hint(ui, task, name, width);
    ImGui::PopID();
}

} // namespace rasterwalk
