#include "ui/lesson/lesson_predictions.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/numbers.h"
#include "ui/actions/open_lesson.h"
#include "ui/lesson/lesson_box.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/language.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_number_field(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                       const std::string& name) {
    const float u = ui.options.text_scale;
    PredictionView& view = ui.lesson.predictions[prediction.id];
    ImGui::SetNextItemWidth(110.0f * u);
    if (std::exchange(view.takes_keys, false)) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputTextWithHint("##number", tr("your number"), &view.typed,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    register_widget(ui, name + ".number", tr("Type a number; 1/3 and 500*2 work too."));
    if (!prediction.unit.empty()) {
        ImGui::SameLine(0.0f, 6.0f * u);
        ImGui::AlignTextToFramePadding();
        text_in(palette(ui.options.theme).dim, prediction.unit);
    }
    ImGui::SameLine(0.0f, 10.0f * u);
    if (ImGui::GetContentRegionAvail().x < button_width(tr("answer"))) ImGui::NewLine();
    const bool pressed =
        button(ui, name + ".answer", tr("answer"), Look::main, tr("Checks your answer."));
    if (view.is_no_number) {
        text_in(colour_of(Meaning::fail, ui.options.theme),
                tr(view.typed.empty() ? "Type a number first." : "That is not a number."));
        register_widget(ui, name + ".fault", tr("1/3 and 500*2 are numbers too."));
    }
    if (!entered && !pressed) return;
    const std::optional<double> number = read_answer(view.typed);
    view.is_no_number = !number;
    view.takes_keys = true; // for another number, if one may be given
    if (!number) return;
    answer_prediction(ui, lesson, prediction, {*number},
                      answer_words(prediction, {*number}, view.typed));
}

/// Where the choices of a prediction are, from the first one's upper left corner.
struct ChoicePlace {
    ImVec2 at, size; ///< screen pixels
    float wrap;      ///< width of the words, screen pixels
};

/// @param side_by_side as many on a line as fit, instead of one
std::vector<ChoicePlace> places_of_choices(const LessonPrediction& prediction, float width,
                                           ImVec2 padding, bool side_by_side) {
    std::vector<ChoicePlace> places;
    const ImVec2 gap = ImGui::GetStyle().ItemSpacing;
    const float wrap = std::max(width - 2.0f * padding.x, 1.0f);
    float x = 0.0f, y = 0.0f, line = 0.0f;
    for (const int number : prediction.order) {
        const std::string& choice = prediction.choices[static_cast<std::size_t>(number)];
        const ImVec2 text = ImGui::CalcTextSize(choice.c_str(), nullptr, false, wrap);
        const ImVec2 size{side_by_side ? text.x + 2.0f * padding.x : width,
                          text.y + 2.0f * padding.y};
        if (x > 0.0f && (!side_by_side || x + size.x > width)) {
            y += line + gap.y;
            x = line = 0.0f;
        }
        places.push_back({{x, y}, size, wrap});
        x += size.x + gap.x;
        line = std::max(line, size.y);
    }
    return places;
}

/// Was it answered wrongly, with a second try to come?
bool is_second_try(Ui& ui, const LessonPrediction& prediction) {
    return ui.lesson.progress.has_second_try(ui.session.lesson, prediction.id) &&
           ui.lesson.predictions[prediction.id].judged.has_value();
}

/// The first choice, which must not be chosen again.
void draw_spent_choice(Ui& ui, const std::string& choice, const Area& area, ImVec2 padding,
                       float wrap) {
    ImGui::Dummy(area.size);
    clip_to_lines();
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                                        {area.position.x + padding.x, area.position.y + padding.y},
                                        packed(palette(ui.options.theme).dim), choice.c_str(),
                                        nullptr, wrap + 1.0f);
}

void draw_choices(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                  const std::string& name, float width, bool side_by_side) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    // In a strip every line counts.
    const ImVec2 padding{10.0f * u, (side_by_side ? 3.0f : 6.0f) * u};
    const std::vector<ChoicePlace> places =
        places_of_choices(prediction, width, padding, side_by_side);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    for (std::size_t i = 0; i < prediction.choices.size(); ++i) {
        const int number = prediction.order[i];
        const std::string& choice = prediction.choices[static_cast<std::size_t>(number)];
        const ImVec2 low{start.x + places[i].at.x, start.y + places[i].at.y};
        const ImVec2 size = places[i].size;
        ImGui::SetCursorScreenPos(low);
        if (choice == ui.lesson.predictions[prediction.id].said && is_second_try(ui, prediction)) {
            draw_spent_choice(ui, choice, {low, size}, padding, places[i].wrap);
            continue;
        }
        ImGui::PushID(number);
        const bool pressed = ImGui::InvisibleButton("choice", size);
        ImGui::PopID();
        const bool hovered = ImGui::IsItemHovered();
        register_widget(ui, name + ".choice." + std::to_string(number), tr("Choose this answer."));
        ImDrawList* const list = ImGui::GetWindowDrawList();
        list->AddRectFilled(low, {low.x + size.x, low.y + size.y},
                            packed(hovered ? p.button_hovered : p.button), 4.0f * u);
        list->AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                      {low.x + padding.x, low.y + padding.y}, packed(p.text), choice.c_str(),
                      nullptr, places[i].wrap + 1.0f);
        if (pressed) {
            const GivenAnswer given{number};
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
        text_in(palette(ui.options.theme).dim, tr("Click a pixel in the picture."));
        return;
    }
    if (button(ui, name + ".answer", tr("answer {}", pixel_words(*pixel)), Look::main,
               tr("Answers with the pixel that is picked in the picture."))) {
        answer_prediction(ui, lesson, prediction, {*pixel}, answer_words(prediction, {*pixel}));
    }
}

/// A chosen sentence in quotation marks; a number or a pixel unchanged, with a full stop.
std::string quoted_answer(const LessonPrediction& prediction, const std::string& answer) {
    if (prediction.kind != LessonPrediction::Kind::choice) return answer + ".";
    return "“" + answer + "”" + (answer.ends_with('.') ? "" : ".");
}

/// "You said: 12. The program says: 11 pixels." For a first try with a second to come: "You said:
/// 12."
/// @param is_second the answer is the second one
std::string verdict(const LessonPrediction& prediction, const PredictionView& view,
                    bool is_second_try, bool is_second) {
    const Judgement& judged = *view.judged;
    if (!judged.fault.empty()) return judged.fault;
    // In a lecture, there need be no answer.
    if (view.said.empty()) {
        const bool is_one_of_many = prediction.kind == LessonPrediction::Kind::pixel;
        const std::string answer = quoted_answer(prediction, judged.answer);
        return is_one_of_many ? tr("One of them is {}", answer)
                              : tr("The program says: {}", answer);
    }
    const std::string said = quoted_answer(prediction, view.said);
    const std::string text = !judged.is_right ? tr("You said: {}", said)
                             : is_second      ? tr("Right on the second try: {}", said)
                                              : tr("Right: {}", said);
    if (is_second_try) return text;
    using Kind = LessonPrediction::Kind;
    if (prediction.kind == Kind::pixel)
        return judged.is_right ? text : text + " " + tr("That pixel is not right.");
    const bool is_nearly = prediction.kind == Kind::number && judged.answer != view.said;
    if (judged.is_right && !is_nearly) return text;
    return text + " " + tr("The program says: {}", quoted_answer(prediction, judged.answer));
}

/// What the program says about an answer.
void draw_verdict(Ui& ui, const LessonPrediction& prediction, const std::string& name) {
    const PredictionView& view = ui.lesson.predictions[prediction.id];
    const bool is_right = view.judged->is_right;
    const auto& answers = ui.lesson.progress.of(ui.session.lesson).answers;
    const auto kept = answers.find(prediction.id);
    const bool is_second = kept != answers.end() && kept->second.second == view.said;
    const std::string said = verdict(prediction, view, is_second_try(ui, prediction), is_second);
    const ImVec4 colour = colour_of(is_right ? Meaning::pass : Meaning::fail, ui.options.theme);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushFont(ui.fonts.bold);
    const char* const mark = view.said.empty() ? "" : is_right ? "✓  " : "✗  ";
    wrapped_text(mark + said);
    ImGui::PopFont();
    ImGui::PopStyleColor();
    register_widget(ui, name + ".verdict", {}, said);
    clip_to_lines();
}

/// Brings what was just said into sight, and gives the keyboard to the widget after it.
void show_fresh(Ui& ui, const std::string& widget) {
    scroll_here(1.0f);
    if (!ui.focus.is_shown) return;
    ui.focus.name = widget;
    ui.focus.wants_sight = true;
}

void draw_again(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                const std::string& name) {
    const bool is_pressed = button(ui, name + ".again", tr("answer again"), Look::link,
                                   tr("The program remembers your first answer."));
    if (std::exchange(ui.lesson.predictions[prediction.id].is_fresh, false))
        show_fresh(ui, name + ".again");
    if (is_pressed) ask_again(ui, lesson, prediction);
    if (is_pressed || !prediction.then || ui.lesson.predictions[prediction.id].is_in_picture)
        return;
    ImGui::SameLine(0.0f, 12.0f * ui.options.text_scale);
    if (button(ui, name + ".show", tr("show it"), Look::link,
               tr("Sets up the picture, moment and tab of the answer."))) {
        reveal_answer(ui, lesson, prediction);
    }
}

void draw_reveal(Ui& ui, LessonBox& box, const Lesson& lesson, const LessonPrediction& prediction,
                 const std::string& name) {
    PredictionView& view = ui.lesson.predictions[prediction.id];
    const std::string reason = shown_reason(view);
    draw_verdict(ui, prediction, name);
    if (!reason.empty()) box.markdown(name, view.because, reason);
    draw_again(ui, lesson, prediction, name);
}

/// What is said about a wrong first answer.
std::string words_to_miss(const PredictionView& view) {
    if (!view.judged->says.empty()) return view.judged->says;
    return tr("That is not it. Think again: you have a second try.");
}

/// In a strip: the verdict, as much of the reason as fits, and the button to answer again.
void draw_short_reveal(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                       const std::string& name, const MarkdownDocument& because, float width) {
    const float left = ImGui::GetCursorScreenPos().x;
    draw_verdict(ui, prediction, name);
    const ImVec2 gap = ImGui::GetStyle().ItemSpacing;
    const bool is_one_line = ImGui::GetItemRectSize().y < 2.0f * ImGui::GetFontSize();
    const float end = ImGui::GetItemRectMax().x + gap.x + button_width(tr("answer again"));
    if (is_one_line && end <= left + width) ImGui::SameLine();
    draw_again(ui, lesson, prediction, name);
    if (!because.blocks.empty())
        draw_marked(ui, name, ui.lesson.pages[name + ".because"], because, width);
}

void draw_answers(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                  const std::string& name, float width, bool side_by_side) {
    switch (prediction.kind) {
    case LessonPrediction::Kind::number:
        draw_number_field(ui, lesson, prediction, name);
        break;
    case LessonPrediction::Kind::choice:
        draw_choices(ui, lesson, prediction, name, width, side_by_side);
        break;
    case LessonPrediction::Kind::pixel:
        draw_pixel_answer(ui, lesson, prediction, name);
        break;
    }
}

/// The first widget that can answer.
std::string first_answer(Ui& ui, const LessonPrediction& prediction, const std::string& name) {
    switch (prediction.kind) {
    case LessonPrediction::Kind::number:
        return name + ".number";
    case LessonPrediction::Kind::choice: {
        const std::string& spent = ui.lesson.predictions[prediction.id].said;
        for (const int number : prediction.order) {
            if (prediction.choices[static_cast<std::size_t>(number)] != spent)
                return name + ".choice." + std::to_string(number);
        }
        break;
    }
    case LessonPrediction::Kind::pixel:
        break;
    }
    return name + ".answer";
}

/// The ways to answer; for the second try also what is said about the first answer, and a way out.
void draw_tries(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                const std::string& name, float width, bool side_by_side) {
    PredictionView& view = ui.lesson.predictions[prediction.id];
    // The verdict on an answer given below appears in the next frame.
    const bool is_fresh = std::exchange(view.is_fresh, false);
    const bool is_second = is_second_try(ui, prediction);
    if (is_second) {
        draw_verdict(ui, prediction, name);
        const std::string words = words_to_miss(view);
        draw_marked(ui, name, view.because, words, width);
        register_widget(ui, name + ".says", {}, words);
        ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
    }
    draw_answers(ui, lesson, prediction, name, side_by_side ? width : ImGui::CalcItemWidth(),
                 side_by_side);
    if (!is_second) return;
    const bool is_pressed = ui.lesson.lessons.course().answers == AnswerRule::on_request &&
                            button(ui, name + ".show", tr("show the answer"), Look::link,
                                   tr("Gives up the second try."));
    if (is_fresh) show_fresh(ui, first_answer(ui, prediction, name));
    if (is_pressed) reveal_answer(ui, lesson, prediction);
}

} // namespace

std::string shown_reason(const PredictionView& view) {
    const Judgement& judged = *view.judged;
    if (judged.says.empty()) return judged.because;
    return judged.because.empty() ? judged.says : judged.says + "\n\n" + judged.because;
}

void draw_prediction(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                     float width) {
    const ImVec4 colour = palette(ui.options.theme).link;
    const std::string name = "lesson.prediction." + prediction.id;
    ImGui::PushID(name.c_str());
    {
        LessonBox box(ui, width, colour);
        box.heading(tr(prediction.looks_back ? "LOOK BACK" : "PREDICTION"), colour);
        register_widget(ui, name, tr("Answer first; then the program shows its own answer."));
        box.markdown(name + ".text", ui.lesson.pages[name], without_label(prediction.text));
        ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
        if (!take_up_answer(ui, lesson, prediction)) {
            text_in(palette(ui.options.theme).dim, tr("Restoring your answer …"));
        } else if (is_revealed(ui, lesson, prediction)) {
            draw_reveal(ui, box, lesson, prediction, name);
        } else {
            draw_tries(ui, lesson, prediction, name, box.inner_width(), false);
        }
    }
    ImGui::PopID();
}

void draw_prediction_lines(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                           const MarkdownDocument& because, float width) {
    const std::string name = "lesson.prediction." + prediction.id;
    ImGui::PushID(name.c_str());
    take_up_answer(ui, lesson, prediction);
    if (is_revealed(ui, lesson, prediction)) {
        draw_short_reveal(ui, lesson, prediction, name, because, width);
    } else {
        draw_marked(ui, name + ".text", ui.lesson.pages[name], without_label(prediction.text),
                    width);
        register_widget(ui, name);
        draw_tries(ui, lesson, prediction, name, width, true);
    }
    ImGui::PopID();
}

} // namespace rasterwalk
