#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "inspect/model_lines.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The most lines of a file that the list has: beyond them it could not scroll by whole pixels.
constexpr int most_listed_lines = 100'000;

/// How often the state of the file is read, seconds.
constexpr double seconds_between_questions = 1.0;

const ModelSource& source_of(const Ui& ui) {
    return *ui.results.a.frame.given->model_source.get();
}

const ObjReport& report_of_model(const Ui& ui) {
    return *ui.results.a.frame.given->model_report;
}

/// "64 MB", "1.5 MB"
std::string megabytes(std::size_t bytes) {
    return significant(static_cast<double>(bytes) / (1 << 20), 3) + " MB";
}

/// The vertex whose corner is lit.
int lit_vertex(const Ui& ui) {
    return std::clamp(ui.session.selection.vertex.value_or(0), 0, triangle_corners - 1);
}

/// The vertex of the model whose corner is lit. A camera that moves does not change it.
ModelVertex vertex_shown(const Ui& ui) {
    return {model_triangle(ui.results.a.frame, *ui.results.a.triangle), lit_vertex(ui)};
}

/// The line on which the face of the triangle shown begins.
int line_of_face(const Ui& ui) {
    return source_of(ui).triangles[static_cast<std::size_t>(vertex_shown(ui).triangle)].line;
}

/// Forgets what is known about another file, or about this one as it was read before.
void begin_with_source(Ui& ui) {
    const std::shared_ptr<const ModelSource>& source =
        ui.results.a.frame.given->model_source.shared();
    if (ui.inspector.file.source.lock() == source) return;
    ui.inspector.file = FileLook();
    ui.inspector.file.source = source;
}

/// Finds the corner again if another one is shown.
void find_corner(Ui& ui) {
    FileLook& look = ui.inspector.file;
    const Frame& frame = ui.results.a.frame;
    const int drawn = *ui.results.a.triangle;
    const ModelVertex now = vertex_shown(ui);
    const bool is_whole = is_from_file(frame, drawn);
    if (look.of == now && look.was_from_file == is_whole) return;
    look.of = now;
    look.was_from_file = is_whole;
    look.words.clear();
    look.named.clear();
    look.corner = file_corner(frame, drawn, now.vertex);
    if (!look.corner) return;
    const FileCorner& corner = *look.corner;
    look.words = corner_words(source_of(ui), corner);
    for (const int line :
         {corner.line, corner.position_line, corner.texcoord_line, corner.normal_line}) {
        if (line == 0) continue;
        for (FileLine& one : file_lines(source_of(ui), report_of_model(ui), line, 1))
            look.named.push_back(std::move(one));
    }
}

void draw_file_name(Ui& ui) {
    FileLook& look = ui.inspector.file;
    const ModelSource& source = source_of(ui);
    if (ImGui::GetTime() - look.asked_at >= seconds_between_questions) {
        look.asked_at = ImGui::GetTime();
        look.has_changed = file_state(source.path) != source.state;
    }
    const std::string path = visible_line(source.path);
    const std::string name = path.substr(path.find_last_of("/\\") + 1);
    const std::string place = fmt::format("line {} of {}", line_of_face(ui), source.lines);
    text_in(palette(ui.options.theme).dim,
            first_fitting({place + " of " + name, place}, ImGui::GetContentRegionAvail().x));
    register_widget(ui, "file.place", path, place);
    if (look.has_changed) {
        wrapped_text_in(palette(ui.options.theme).changed,
                        "The file has changed since it was read, or is gone. This is what was "
                        "read.");
        register_widget(ui, "file.changed");
    }
}

/// Of a line of the file, screen pixels.
float line_height(const Ui& ui) {
    return ui.fonts.mono->FontSize + 4.0f * ui.options.text_scale;
}

/// What a click on a line or on a corner selects.
void select_line(Ui& ui, const FileLine& line, int corner) {
    const Frame& frame = ui.results.a.frame;
    const std::optional<ModelVertex> found =
        vertex_of_line(source_of(ui), line, corner, vertex_shown(ui).triangle);
    if (!found) {
        show_info(ui.session, fmt::format("No triangle uses line {}.", line.number));
        return;
    }
    const std::optional<int> drawn = drawn_triangle(frame, found->triangle);
    if (!drawn) return;
    ui.session.selection.triangle = drawn;
    const bool is_face = line.face > 0 && corner < 0;
    if (!is_face) ui.session.selection.vertex = found->vertex;
}

ImVec4 ink_of(const Ui& ui, const FileLine& line) {
    switch (line.use) {
    case FileLineUse::unmarked:
        break;
    case FileLineUse::aside:
        return palette(ui.options.theme).dim;
    case FileLineUse::faulty:
        return colour_of(Meaning::fail, ui.options.theme);
    }
    return palette(ui.options.theme).text;
}

/// How a line is marked.
struct LineMark {
    bool is_face = false;  ///< the triangle's
    bool is_named = false; ///< by the lit corner
    int lit_corner = -1;   ///< of the face; -1: none
};

LineMark mark_of(const Ui& ui, const FileLine& line) {
    LineMark mark;
    const std::optional<FileCorner>& corner = ui.inspector.file.corner;
    mark.is_face = line.face > 0 && line.face == line_of_face(ui);
    if (!corner) return mark;
    mark.is_named = line.number == corner->position_line || line.number == corner->texcoord_line ||
                    line.number == corner->normal_line;
    if (mark.is_face) mark.lit_corner = corner->number;
    return mark;
}

std::string click_help(const FileLine& line) {
    const std::string sentence = line.sentence.empty() ? "" : line.sentence + "\n";
    if (line.face > 0) return sentence + "Click to select its triangle, or a corner its vertex.";
    return sentence + "Click a v, vt or vn to select a vertex that uses it.";
}

/// A line of the file with its number, as a row that can be clicked.
/// @param prefix of the names of its widgets
void draw_line(Ui& ui, const FileLine& line, const std::string& prefix) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale, height = line_height(ui);
    const LineMark mark = mark_of(ui, line);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float right = low.x + ImGui::GetContentRegionAvail().x;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (mark.is_face || mark.is_named)
        list->AddRectFilled(low, {right, low.y + height}, packed(p.row_lit));
    if (mark.is_face) draw_current_bar(ui, list, low, low.y + height);
    const std::string name = prefix + std::to_string(line.number);
    const float digits = text_width(std::to_string(source_of(ui).lines));
    float x = low.x + 8.0f * u + digits + text_width("  ");
    const float top = low.y + 0.5f * (height - ImGui::GetTextLineHeight());
    const std::string number = std::to_string(line.number);
    list->PushClipRect(low, {right, low.y + height}, true);
    list->AddText({low.x + 8.0f * u + digits - text_width(number), top}, packed(p.dim),
                  number.c_str());
    const Meaning of_vertex = edge_meaning(lit_vertex(ui));
    for (const FilePiece& piece : line.pieces) {
        const float width = text_width(piece.text);
        const bool is_lit = piece.corner >= 0 && piece.corner == mark.lit_corner;
        ImVec4 ink = ink_of(ui, line);
        if (is_lit) ink = colour_of(of_vertex, ui.options.theme);
        list->AddText({x, top}, packed(ink), piece.text.c_str());
        if (is_lit) {
            const float below = top + ImGui::GetTextLineHeight();
            list->AddLine({x, below}, {x + width, below}, packed(ink), 1.5f * u);
        }
        if (piece.corner >= 0 && x < right) {
            ImGui::SetCursorScreenPos({x, low.y});
            const std::string corner = fmt::format("{}.corner.{}", name, piece.corner);
            if (ImGui::InvisibleButton(corner.c_str(), {width, height}))
                select_line(ui, line, piece.corner);
            register_widget(ui, corner, "Click to select this corner's triangle and vertex.",
                            piece.text);
        }
        x += width;
    }
    if (!line.sentence.empty()) {
        const std::string words = "  " + line.sentence;
        list->AddText(ui.fonts.small, ui.fonts.small->FontSize, {x, top}, packed(ink_of(ui, line)),
                      words.c_str());
    }
    list->PopClipRect();
    ImGui::SetCursorScreenPos(low);
    if (ImGui::InvisibleButton(name.c_str(), {std::max(right - low.x, 1.0f), height}))
        select_line(ui, line, -1);
    std::string text;
    for (const FilePiece& piece : line.pieces)
        text += piece.text;
    register_widget(ui, name, click_help(line), text);
    ImGui::SetCursorScreenPos({low.x, low.y + height});
}

/// The corner of the vertex, the line of its face, and the lines that it names.
void draw_corner(Ui& ui) {
    const FileLook& look = ui.inspector.file;
    const int vertex = lit_vertex(ui);
    ImGui::PushFont(ui.fonts.mono);
    if (look.corner) {
        text_in(colour_of(edge_meaning(vertex), ui.options.theme),
                shortened(short_vertex_name(vertex) + ": " + look.words,
                          ImGui::GetContentRegionAvail().x));
        register_widget(ui, "file.corner",
                        "The corner of this vertex in the face, and the statements that it names. "
                        "v, vt and vn are each counted from 1.",
                        look.words);
        for (const FileLine& line : look.named)
            draw_line(ui, line, "file.named.");
    }
    ImGui::PopFont();
    if (!look.corner) {
        wrapped_text_in(palette(ui.options.theme).dim,
                        ui.results.a.frame.triangles_of_each() > 1
                            ? "Tessellation made this vertex; the file has only the face."
                            : "A plane cut this piece; the file has only the face.");
        register_widget(ui, "file.no_corner");
    }
    ImGui::Separator();
}

/// The lines from `first`, those in view drawn.
void draw_lines_in_view(Ui& ui, int first, int count, int face_line) {
    FileLook& look = ui.inspector.file;
    const float height = line_height(ui);
    const ModelVertex vertex = vertex_shown(ui);
    if (look.scrolled_to != vertex || ui.session.jumps != look.jumps) {
        // The last lines cannot come to the middle.
        const bool is_there =
            scroll_to_line(face_line - first, height) ||
            (ImGui::GetScrollMaxY() > 0.0f && ImGui::GetScrollY() >= ImGui::GetScrollMaxY());
        if (is_there) {
            look.scrolled_to = vertex;
            look.jumps = ui.session.jumps;
        }
    }
    ImGuiListClipper clipper;
    clipper.Begin(count, height);
    while (clipper.Step()) {
        const int from = first + clipper.DisplayStart;
        const int many = clipper.DisplayEnd - clipper.DisplayStart;
        const bool is_known = look.first <= from && from + many <= look.first + look.count;
        if (!is_known) {
            look.first = from;
            look.count = many;
            look.lines = file_lines(source_of(ui), report_of_model(ui), from, many);
        }
        for (const FileLine& line : look.lines) {
            if (line.number >= from && line.number < from + many) draw_line(ui, line, "file.");
        }
    }
}

void draw_list(Ui& ui) {
    const ModelSource& source = source_of(ui);
    const int face_line = line_of_face(ui);
    const int first =
        source.lines > most_listed_lines ? std::max(face_line - most_listed_lines / 2, 1) : 1;
    const int count = std::min(source.lines - first + 1, most_listed_lines);
    if (count < source.lines) {
        text_in(palette(ui.options.theme).dim,
                shortened(fmt::format("Lines {} to {} are listed.", first, first + count - 1),
                          ImGui::GetContentRegionAvail().x));
        register_widget(ui, "file.listed");
    }
    const float least = 5.0f * line_height(ui);
    const float height = std::max(ImGui::GetContentRegionAvail().y, least);
    ImGui::BeginChild("file.lines", {0, height}, false, ImGuiWindowFlags_NoNav);
    begin_line_clip();
    ImGui::PushFont(ui.fonts.mono);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.0f});
    draw_lines_in_view(ui, first, count, face_line);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    end_line_clip();
    ImGui::EndChild();
}

} // namespace

void draw_file_panel(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    if (!ui.results.a.triangle || frame.given->model_source.get() == nullptr) {
        text_in(palette(ui.options.theme).dim, "This scene was not read from a model file.");
        register_widget(ui, "file.none");
        return;
    }
    begin_with_source(ui);
    draw_triangle_title(ui);
    draw_file_name(ui);
    const ModelSource& source = source_of(ui);
    if (source.line_marks.empty()) {
        wrapped_text(fmt::format("The file has {}. The text of files up to {} is kept after "
                                 "reading, so the text of this one cannot be shown.",
                                 megabytes(source.bytes), megabytes(most_kept_model_text)));
        register_widget(ui, "file.too_large");
        return;
    }
    find_corner(ui);
    draw_corner(ui);
    draw_list(ui);
}

} // namespace rasterwalk
