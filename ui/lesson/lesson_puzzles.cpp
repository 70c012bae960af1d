#include "ui/lesson/lesson_puzzles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "ui/lesson/lesson_box.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/language.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels: the numbers of the lines, one brace, around the text of a line, between lines.
constexpr float number_width = 24.0f, brace_width = 15.0f, piece_padding = 5.0f, piece_gap = 2.0f;

/// So near to the edge of the window, in design pixels, a dragged line scrolls it.
constexpr float scroll_zone = 24.0f;

/// Where the pieces of a puzzle were drawn, screen pixels.
struct PieceArea {
    int piece = 0;
    int place = 0; ///< in the function; -1: it is not used
    float top = 0.0f, bottom = 0.0f;
};

class PuzzleDrawing {
  public:
    PuzzleDrawing(Ui& ui, const LessonPuzzle& puzzle, std::string name, float width, bool is_done)
        : ui_(ui), puzzle_(puzzle), name_(std::move(name)), width_(width), is_done_(is_done),
          view_(ui.lesson.puzzles[puzzle.id]) {}

    void draw() {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, piece_gap * ui_.options.text_scale});
        int number = 0;
        for (int i = 0; i < puzzle_.given; ++i)
            draw_given(++number, puzzle_.lines[static_cast<std::size_t>(i)]);
        for (const PlacedPiece& one : view_.desk.used)
            draw_piece(++number, one.piece, one.depth);
        if (view_.desk.used.empty()) draw_empty();
        for (std::size_t i = puzzle_.lines.size() - static_cast<std::size_t>(puzzle_.given_after);
             i < puzzle_.lines.size(); ++i) {
            draw_given(++number, puzzle_.lines[i]);
        }
        const float left_top = ImGui::GetCursorScreenPos().y;
        if (!is_done_ && !view_.desk.left.empty()) {
            ImGui::Dummy({1.0f, 4.0f * ui_.options.text_scale});
            text_in(palette(ui_.options.theme).dim, tr("LINES NOT USED"), ui_.fonts.small);
            for (const int piece : view_.desk.left)
                draw_piece(0, piece, 1);
        }
        ImGui::PopStyleVar();
        if (view_.dragged >= 0) drag(left_top);
        if (desk_ != std::nullopt) change();
    }

  private:
    float unit() const { return ui_.options.text_scale; }

    /// The room for the text of a line at this depth.
    float text_room(int depth) const {
        const float before = (number_width + brace_width * static_cast<float>(depth)) * unit();
        return std::max(width_ - before - 2.0f * piece_padding * unit(), 1.0f);
    }

    float height_of(const std::string& text, int depth) const {
        ImGui::PushFont(ui_.fonts.mono);
        const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, text_room(depth));
        ImGui::PopFont();
        return size.y + 2.0f * piece_gap * unit();
    }

    /// The number of the line, its background if it has one, and its text.
    void write(ImVec2 at, float height, int number, const std::string& text, int depth,
               std::optional<ImVec4> ground) const {
        const Palette& p = palette(ui_.options.theme);
        const bool is_wrong = number > 0 && view_.verdict && view_.verdict->line == number;
        const ImVec4 mark = colour_of(Meaning::fail, ui_.options.theme);
        ImDrawList* const list = ImGui::GetWindowDrawList();
        if (number > 0) {
            const std::string digits = std::to_string(number);
            const float wide = text_width(ui_.fonts.small, digits);
            const float right = at.x + (number_width - 6.0f) * unit();
            list->AddText(ui_.fonts.small, ui_.fonts.small->FontSize,
                          {right - wide, at.y + piece_gap * unit()},
                          packed(is_wrong ? mark : p.dim), digits.c_str());
        }
        const float left = at.x + (number_width + brace_width * static_cast<float>(depth)) * unit();
        const ImVec2 end{at.x + width_, at.y + height};
        const float round = 3.0f * unit();
        if (ground) list->AddRectFilled({left, at.y}, end, packed(*ground), round);
        if (is_wrong) list->AddRect({left, at.y}, end, packed(mark), round, 0, 1.5f * unit());
        list->AddText(ui_.fonts.mono, ui_.fonts.mono->FontSize,
                      {left + piece_padding * unit(), at.y + piece_gap * unit()},
                      packed(ground ? p.text : p.dim), text.c_str(), nullptr,
                      text_room(depth) + 1.0f);
    }

    void draw_given(int number, const PuzzleLine& line) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = height_of(line.text, line.depth);
        ImGui::Dummy({width_, height});
        clip_to_lines();
        write(at, height, number, line.text, line.depth, std::nullopt);
    }

    void draw_empty() {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const std::string text = is_gap(puzzle_) ? tr("Drag a line here.") : tr("Drag lines here.");
        const float height = height_of(text, 1);
        ImGui::Dummy({width_, height});
        clip_to_lines();
        write(at, height, 0, text, 1, std::nullopt);
    }

    void draw_piece(int number, int piece, int depth) {
        const Palette& p = palette(ui_.options.theme);
        const std::string& text = piece_text(puzzle_, piece);
        if (is_done_) {
            draw_given(number, {text, depth});
            return;
        }
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = height_of(text, depth);
        const std::string name = name_ + ".piece." + std::to_string(piece);
        ImGui::PushID(piece);
        const bool is_pressed = ImGui::InvisibleButton("piece", {width_, height});
        ImGui::PopID();
        const bool is_active = ImGui::IsItemActive(), is_hovered = ImGui::IsItemHovered();
        register_widget(ui_, name,
                        view_.dragged >= 0 ? ""
                        : number > 0
                            ? tr("Drag it, also to the side. With the keyboard, the arrows "
                                 "move it.")
                            : tr("Drag it to its place, or click to put it at the end. With "
                                 "the keyboard, ↑ puts it there."),
                        text);
        areas_.push_back({piece, place_of_piece(view_.desk, piece), at.y, at.y + height});
        const bool is_lit = is_active || is_hovered;
        write(at, height, number, text, depth, is_lit ? p.button_hovered : p.button);
        if (is_active && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
            if (view_.dragged != piece) begin_drag(piece, number > 0, depth);
        } else if (view_.dragged == piece) {
            view_.dragged = -1;
        } else if (is_pressed && number == 0) {
            changed_desk();
            put_piece(puzzle_, *desk_, piece, piece_count(puzzle_), deepest_puzzle);
        }
        use_arrows(name, piece);
    }

    void use_arrows(const std::string& name, int piece) {
        const Arrows arrows = take_arrows(ui_, name);
        if (arrows.up == 0 && arrows.right == 0) return;
        changed_desk();
        if (arrows.up != 0) move_piece(puzzle_, *desk_, piece, arrows.up > 0 ? 1 : -1);
        if (arrows.right != 0) indent_piece(puzzle_, *desk_, piece, arrows.right > 0 ? 1 : -1);
        ui_.focus.wants_sight = true;
    }

    void begin_drag(int piece, bool is_used, int depth) {
        view_.dragged = piece;
        view_.drag_depth = is_used ? depth : deepest_puzzle;
        view_.drag_from_left = !is_used;
    }

    /// The dragged line follows the pointer: it is put where its place would be.
    void drag(float left_top) {
        const ImVec2 mouse = ImGui::GetMousePos();
        scroll_at_edges(mouse.y);
        const int piece = view_.dragged;
        int place = 0;
        for (const PieceArea& area : areas_) {
            if (area.piece == piece || area.place < 0) continue;
            if (mouse.y > 0.5f * (area.top + area.bottom)) ++place;
        }
        changed_desk();
        if (!view_.desk.left.empty() && mouse.y > left_top + ui_.fonts.small->FontSize) {
            take_piece_out(puzzle_, *desk_, piece);
            return;
        }
        const float right = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left).x;
        const int more = static_cast<int>(std::round(right / (brace_width * unit())));
        const int deepest = deepest_at(puzzle_, view_.desk, place, piece);
        const int from = view_.drag_from_left ? deepest : view_.drag_depth;
        put_piece(puzzle_, *desk_, piece, place, from + more);
    }

    void scroll_at_edges(float y) const {
        const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
        const float zone = scroll_zone * unit(), speed = 6.0f * unit();
        if (y < top + zone) ImGui::SetScrollY(std::max(ImGui::GetScrollY() - speed, 0.0f));
        if (y > bottom - zone)
            ImGui::SetScrollY(std::min(ImGui::GetScrollY() + speed, ImGui::GetScrollMaxY()));
    }

    /// The desk as it will be when all is drawn.
    void changed_desk() {
        if (!desk_) desk_ = view_.desk;
    }

    void change() {
        if (*desk_ == view_.desk) return;
        view_.desk = *desk_;
        view_.verdict.reset();
    }

    Ui& ui_;
    const LessonPuzzle& puzzle_;
    std::string name_;
    float width_; ///< screen pixels
    bool is_done_;
    PuzzleView& view_;
    std::vector<PieceArea> areas_;
    std::optional<PuzzleDesk> desk_;
};

void draw_verdict_of_run(Ui& ui, PuzzleView& view, const std::string& name) {
    if (!view.verdict || view.verdict->is_right) return;
    std::string words = view.verdict->sentence;
    if (view.verdict->line > 0) words = tr("Line {}: {}", view.verdict->line, words);
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(Meaning::fail, ui.options.theme));
    wrapped_text("✗  " + words);
    ImGui::PopStyleColor();
    register_widget(ui, name + ".verdict", {}, words);
    clip_to_lines();
    if (std::exchange(view.is_fresh, false)) scroll_here(1.0f);
}

void draw_buttons(Ui& ui, const Lesson& lesson, const LessonPuzzle& puzzle, PuzzleView& view,
                  const std::string& name) {
    if (button(ui, name + ".run", tr("run it"), Look::main,
               tr("Runs the function with several inputs, and compares what it gives."))) {
        view.verdict = judge_order(puzzle, view.desk.used);
        view.is_fresh = true;
        ui.lesson.strip.is_recut = true;
        if (view.verdict->is_right) ui.lesson.progress.record_task(lesson.id, puzzle.id);
    }
    if (view.desk.used.empty()) return;
    ImGui::SameLine(0.0f, 12.0f * ui.options.text_scale);
    if (button(ui, name + ".start_over", tr("start over"), Look::link,
               tr("Takes all lines out again."))) {
        view.desk = new_desk(puzzle);
        view.verdict.reset();
    }
}

/// Lays the pieces out, also when the lesson's file was edited and has others now.
void lay_out_pieces(PuzzleView& view, const LessonPuzzle& puzzle, bool is_done) {
    if (has_same_pieces(view.of, puzzle)) return;
    view = {};
    view.of = puzzle;
    view.desk = is_done ? solved_desk(puzzle) : new_desk(puzzle);
}

/// Everything below the heading.
void draw_content(Ui& ui, const Lesson& lesson, const LessonPuzzle& puzzle, const std::string& name,
                  float width) {
    const bool is_done = ui.lesson.progress.is_task_done(lesson.id, puzzle.id);
    PuzzleView& view = ui.lesson.puzzles[puzzle.id];
    lay_out_pieces(view, puzzle, is_done);
    draw_marked(ui, name + ".text", ui.lesson.pages[name], without_label(puzzle.text), width);
    register_widget(ui, name);
    ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
    PuzzleDrawing(ui, puzzle, name, width, is_done).draw();
    ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
    if (is_done) {
        if (puzzle.because.empty()) return;
        draw_marked(ui, name + ".because", ui.lesson.pages[name + ".because"], puzzle.because,
                    width);
        register_widget(ui, name + ".because", {}, puzzle.because);
        if (std::exchange(view.is_fresh, false)) scroll_here(1.0f);
        return;
    }
    draw_buttons(ui, lesson, puzzle, view, name);
    draw_verdict_of_run(ui, view, name);
}

std::string widget_of(const LessonPuzzle& puzzle) {
    return "lesson.puzzle." + puzzle.id;
}

} // namespace

void draw_puzzle(Ui& ui, const Lesson& lesson, const LessonPuzzle& puzzle, float width) {
    const bool is_done = ui.lesson.progress.is_task_done(lesson.id, puzzle.id);
    const ImVec4 colour =
        is_done ? colour_of(Meaning::pass, ui.options.theme) : palette(ui.options.theme).changed;
    const std::string name = widget_of(puzzle);
    ImGui::PushID(name.c_str());
    {
        LessonBox box(ui, width, colour);
        box.heading(is_done          ? tr("✓ DONE")
                    : is_gap(puzzle) ? tr("FILL IN")
                                     : tr("PUT IN ORDER"),
                    colour);
        draw_content(ui, lesson, puzzle, name, box.inner_width());
    }
    ImGui::PopID();
}

void draw_puzzle_lines(Ui& ui, const Lesson& lesson, const LessonPuzzle& puzzle, float width) {
    const std::string name = widget_of(puzzle);
    ImGui::PushID(name.c_str());
    draw_content(ui, lesson, puzzle, name, width);
    ImGui::PopID();
}

} // namespace rasterwalk
