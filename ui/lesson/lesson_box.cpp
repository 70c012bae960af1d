#include "ui/lesson/lesson_box.h"

#include <optional>
#include <string_view>

#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/lesson/lesson_page.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Does the step itself show the vectors, so that the letters of its formulas are theirs?
bool is_about_vectors(Ui& ui) {
    const Lesson* const lesson = open_lesson_of(ui);
    if (lesson == nullptr) return false;
    const std::optional<OverlaySet>& overlays = shown_step(ui, *lesson).state.overlays;
    return overlays && overlays->has(Overlay::vectors);
}

} // namespace

void draw_marked(Ui& ui, const std::string& name, std::shared_ptr<MarkdownPage>& page,
                 const MarkdownContent& content, float width) {
    const MarkdownEvents events = draw_markdown(ui, page, content, width, name + ".link.",
                                                ui.session.lesson_folder, is_about_vectors(ui));
    answer_links(ui, document_of(*page), events);
}

std::string without_label(const std::string& text) {
    for (const std::string_view label :
         {"**Task.**", "**Prediction.**", "**Look back.**", "**Put in order.**", "**Fill in.**"}) {
        if (!text.starts_with(label)) continue;
        const std::size_t start = text.find_first_not_of(" \n", label.size());
        return start == text.npos ? std::string() : text.substr(start);
    }
    return text;
}

LessonBox::LessonBox(Ui& ui, float width, const ImVec4& colour)
    : ui_(ui), colour_(colour), start_(ImGui::GetCursorScreenPos()), width_(width) {
    begin_card(ui, width);
}

LessonBox::~LessonBox() {
    end_card(ui_);
    const float u = ui_.options.text_scale;
    const float bottom = ImGui::GetItemRectMin().y - ImGui::GetStyle().ItemSpacing.y;
    ImGui::GetWindowDrawList()->AddRectFilled(start_, {start_.x + 3.0f * u, bottom},
                                              packed(colour_), 5.0f * u,
                                              ImDrawFlags_RoundCornersLeft);
}

float LessonBox::inner_width() const {
    return width_ - 24.0f * ui_.options.text_scale;
}

void LessonBox::heading(const char* text, const ImVec4& colour) {
    text_in(colour, text, ui_.fonts.small);
    // Together with the first line.
    const float bottom = ImGui::GetItemRectMax().y + ImGui::GetStyle().ItemSpacing.y +
                         1.4f * ui_.fonts.text->FontSize;
    keep_beginning(start_.y - 1.0f, bottom);
}

void LessonBox::markdown(const std::string& name, std::shared_ptr<MarkdownPage>& page,
                         const std::string& text) {
    draw_marked(ui_, name, page, text, inner_width());
}

} // namespace rasterwalk
