#include "ui/lesson/lesson_questions.h"

#include <algorithm>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/numbers.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A box with a bar in its colour at the left, and a heading in capitals.
class Box {
  public:
    Box(Ui& ui, float width, const ImVec4& colour)
        : ui_(ui), colour_(colour), start_(ImGui::GetCursorScreenPos()), width_(width) {
        begin_card(ui, width);
    }
    ~Box() {
        end_card(ui_);
        const float u = ui_.options.text_scale;
        const float bottom = ImGui::GetItemRectMin().y - ImGui::GetStyle().ItemSpacing.y;
        ImGui::GetWindowDrawList()->AddRectFilled(start_, {start_.x + 3.0f * u, bottom},
                                                  packed(colour_), 5.0f * u,
                                                  ImDrawFlags_RoundCornersLeft);
    }
    Box(const Box&) = delete;
    Box& operator=(const Box&) = delete;

    float inner_width() const { return width_ - 24.0f * ui_.options.text_scale; }

    void heading(const char* text, const ImVec4& colour) {
        ImGui::PushFont(ui_.fonts.small);
        text_in(colour, text);
        ImGui::PopFont();
    }

    void markdown(const std::string& name, std::shared_ptr<MarkdownPage>& page,
                  const std::string& text) {
        const MarkdownEvents events = draw_markdown(ui_, page, text, inner_width(), name + ".link.",
                                                    ui_.session.lesson_folder);
        answer_links(ui_, document_of(*page), events);
    }

  private:
    Ui& ui_;
    ImVec4 colour_;
    ImVec2 start_;
    float width_;
};

/// The text without the words in bold that say in a repository browser what it is; here the box
/// says it.
std::string without_label(const std::string& text) {
    for (const std::string_view label : {"**Task.**", "**Prediction.**"}) {
        if (!text.starts_with(label)) continue;
        const std::size_t start = text.find_first_not_of(" \n", label.size());
        return start == text.npos ? std::string() : text.substr(start);
    }
    return text;
}

void draw_number_field(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                       const std::string& name) {
    const float u = ui.options.text_scale;
    PredictionView& view = ui.lesson.predictions[prediction.id];
    ImGui::SetNextItemWidth(110.0f * u);
    const bool entered = ImGui::InputTextWithHint("##number", "your number", &view.typed,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    name_widget(ui, name + ".number", "Your number; 1/3 and 500*2 are numbers too.");
    if (!prediction.unit.empty()) {
        ImGui::SameLine(0.0f, 6.0f * u);
        ImGui::AlignTextToFramePadding();
        text_in(palette(ui.options.theme).dim, prediction.unit);
    }
    ImGui::SameLine(0.0f, 10.0f * u);
    if (ImGui::GetContentRegionAvail().x < button_width("answer")) ImGui::NewLine();
    const bool pressed =
        button(ui, name + ".answer", "answer", Look::main, "Then the program tells its own.");
    if (view.is_no_number) {
        text_in(colour_of(Meaning::fail, ui.options.theme),
                view.typed.empty() ? "Type a number first." : "That is not a number.");
        name_widget(ui, name + ".fault", "1/3 and 500*2 are numbers too.");
    }
    if (!entered && !pressed) return;
    const std::optional<double> number = read_answer(view.typed);
    view.is_no_number = !number;
    if (!number) return;
    answer_prediction(ui, lesson, prediction, {*number},
                      answer_words(prediction, {*number}, view.typed));
}

void draw_choices(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                  const std::string& name) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const float width = ImGui::CalcItemWidth();
    for (std::size_t i = 0; i < prediction.choices.size(); ++i) {
        const std::string& choice = prediction.choices[i];
        const ImVec2 padding{10.0f * u, 6.0f * u};
        const float wrap = width - 2.0f * padding.x;
        const ImVec2 text = ImGui::CalcTextSize(choice.c_str(), nullptr, false, wrap);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const ImVec2 size{width, text.y + 2.0f * padding.y};
        ImGui::PushID(static_cast<int>(i));
        const bool pressed = ImGui::InvisibleButton("choice", size);
        ImGui::PopID();
        const bool hovered = ImGui::IsItemHovered();
        name_widget(ui, name + ".choice." + std::to_string(i), "Choose this answer.");
        ImDrawList* const list = ImGui::GetWindowDrawList();
        list->AddRectFilled(low, {low.x + size.x, low.y + size.y},
                            packed(hovered ? p.button_hovered : p.button), 4.0f * u);
        list->AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                      {low.x + padding.x, low.y + padding.y}, packed(p.text), choice.c_str(),
                      nullptr, wrap);
        if (pressed) {
            const GivenAnswer given{static_cast<int>(i)};
            answer_prediction(ui, lesson, prediction, given, answer_words(prediction, given));
        }
    }
}

std::string pixel_words(glm::ivec2 pixel) {
    return "(" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
}

void draw_pixel_answer(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                       const std::string& name) {
    const std::optional<glm::ivec2>& pixel = ui.session.selection.pixel;
    if (!pixel) {
        text_in(palette(ui.options.theme).dim, "Click a pixel in the picture.");
        return;
    }
    if (button(ui, name + ".answer", "answer " + pixel_words(*pixel), Look::main,
               "Answers with the pixel that is picked in the picture.")) {
        answer_prediction(ui, lesson, prediction, {*pixel}, answer_words(prediction, {*pixel}));
    }
}

/// A chosen sentence in quotation marks; a number or a pixel as it is, with a full stop.
std::string as_said(const LessonPrediction& prediction, const std::string& answer) {
    if (prediction.kind != LessonPrediction::Kind::choice) return answer + ".";
    return "“" + answer + "”" + (answer.ends_with('.') ? "" : ".");
}

/// "You said: 12. The program says: 11 pixels."
std::string verdict(const LessonPrediction& prediction, const PredictionView& view) {
    const Judgement& judged = *view.judged;
    if (!judged.fault.empty()) return judged.fault;
    std::string text = judged.is_right ? "Right: " : "You said: ";
    text.append(as_said(prediction, view.said));
    using Kind = LessonPrediction::Kind;
    if (prediction.kind == Kind::pixel) return judged.is_right ? text : text + " That is not one.";
    const bool is_nearly = prediction.kind == Kind::number && judged.answer != view.said;
    if (!judged.is_right || is_nearly) {
        text.append(" The program says: ").append(as_said(prediction, judged.answer));
    }
    return text;
}

void draw_reveal(Ui& ui, Box& box, const LessonPrediction& prediction, const std::string& name) {
    PredictionView& view = ui.lesson.predictions[prediction.id];
    const Judgement judged = *view.judged;
    const Theme theme = ui.options.theme;
    const ImVec4 colour = colour_of(judged.is_right ? Meaning::pass : Meaning::fail, theme);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushFont(ui.fonts.bold);
    wrapped_text((judged.is_right ? "✓  " : "✗  ") + verdict(prediction, view));
    ImGui::PopFont();
    ImGui::PopStyleColor();
    name_widget(ui, name + ".verdict");
    if (!judged.because.empty()) box.markdown(name, view.because, judged.because);
    if (button(ui, name + ".again", "answer again", Look::link,
               "The first answer is the one that is remembered.")) {
        view.judged.reset();
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
        Box box(ui, width, colour);
        box.heading(done ? "✓ DONE" : "TASK", colour);
        name_widget(ui, name, done ? "You have solved this." : "Ticked off as soon as it is so.");
        box.markdown(name, ui.lesson.pages[name], without_label(task.text));
        if (!task.hint.empty() && !done) {
            std::set<std::string>& hints = ui.lesson.open_hints;
            if (hints.count(task.id) > 0) {
                box.markdown(name + ".hint", ui.lesson.pages[name + ".hint"],
                             "*" + task.hint + "*");
            } else if (button(ui, name + ".hint", "hint", Look::link,
                              "A nudge, if you are stuck.")) {
                hints.insert(task.id);
            }
        }
    }
    ImGui::PopID();
}

void draw_prediction(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                     float width) {
    const ImVec4 colour = palette(ui.options.theme).link;
    const std::string name = "lesson.prediction." + prediction.id;
    ImGui::PushID(name.c_str());
    {
        Box box(ui, width, colour);
        box.heading("PREDICTION", colour);
        name_widget(ui, name, "Answer first; then the program shows.");
        box.markdown(name + ".text", ui.lesson.pages[name], without_label(prediction.text));
        ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
        if (!take_up_answer(ui, lesson, prediction)) {
            text_in(palette(ui.options.theme).dim, "Your answer comes back …");
        } else if (ui.lesson.predictions[prediction.id].judged) {
            draw_reveal(ui, box, prediction, name);
        } else if (prediction.kind == LessonPrediction::Kind::number) {
            draw_number_field(ui, lesson, prediction, name);
        } else if (prediction.kind == LessonPrediction::Kind::choice) {
            draw_choices(ui, lesson, prediction, name);
        } else {
            draw_pixel_answer(ui, lesson, prediction, name);
        }
    }
    ImGui::PopID();
}

} // namespace rasterwalk
