#pragma once

#include <memory>
#include <string>

#include <imgui.h>

#include "ui/lesson/lesson_state.h"
#include "ui/page/markdown.h"

namespace rasterwalk {

struct Ui;

/// Markdown of a lesson, whose links are answered.
/// @param name of its widgets: `NAME.link.0`
void draw_marked(Ui& ui, const std::string& name, std::shared_ptr<MarkdownPage>& page,
                 const MarkdownContent& content, float width);

/// The text without the bold words that say what it is in a repository browser; here the box says
/// it.
std::string without_label(const std::string& text);

/// A box with a bar in its colour at the left, open as long as the object lives.
class LessonBox {
  public:
    /// @param width screen pixels
    LessonBox(Ui& ui, float width, const ImVec4& colour);
    ~LessonBox();
    LessonBox(const LessonBox&) = delete;
    LessonBox& operator=(const LessonBox&) = delete;

    /// Width of the content, screen pixels.
    float inner_width() const;

    /// In small letters.
    void heading(const char* text, const ImVec4& colour);

    void markdown(const std::string& name, std::shared_ptr<MarkdownPage>& page,
                  const std::string& text);

  private:
    Ui& ui_;
    ImVec4 colour_;
    ImVec2 start_;
    float width_;
};

} // namespace rasterwalk
