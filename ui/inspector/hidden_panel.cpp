#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "explain/order_formulas.h"
#include "session/moments.h"
#include "settings/value_words.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Of a deep tree, this many planes next to the root are listed, and as many next to the triangle.
constexpr std::size_t planes_at_each_end = 4;

/// What orders the triangles, and where the one shown is among them.
void draw_place(Ui& ui, const DrawnList& list, int triangle) {
    const Frame& frame = ui.results.a.frame;
    std::string text;
    if (list.divided == nullptr) {
        text = fmt::format("Sorted by depth, the {} first. {} of {} come before this one.",
                           frame.stages.is_drawn_before == is_drawn_before ? "farthest" : "nearest",
                           triangle, frame.triangle_count());
    } else {
        const BspTree& tree = list.divided->tree;
        const bool is_right = frame.stages.is_near_side == is_near_side;
        text = fmt::format("A tree of {}, walked from {}: at each plane, the side {} the camera "
                           "first.",
                           counted(static_cast<int>(tree.nodes.size()), "plane", "planes"),
                           is_right ? "back to front" : "front to back",
                           is_right ? "without" : "with");
    }
    wrapped_text(text);
    register_widget(ui, "hidden.place", "How the drawn list was ordered.", text);
}

/// The planes on the way to the triangle: where the camera is, and what is therefore drawn first.
void draw_walk(Ui& ui, int triangle) {
    const Frame& frame = ui.results.a.frame;
    const Palette& p = palette(ui.options.theme);
    std::vector<OrderNode> nodes = order_nodes(frame, triangle);
    if (nodes.empty()) return;
    std::size_t left_out = 0;
    if (nodes.size() > 2 * planes_at_each_end + 1) {
        left_out = nodes.size() - 2 * planes_at_each_end;
        const auto middle = nodes.begin() + planes_at_each_end;
        nodes.erase(middle, middle + static_cast<std::ptrdiff_t>(left_out));
    }
    put_text("The way from the root", ui.fonts.bold);
    // All lines in the longest form that fits for each of them.
    constexpr int form_count = 3;
    std::vector<std::array<std::string, form_count>> lines;
    float widest[form_count]{};
    for (const OrderNode& node : nodes) {
        const char* const side = node.is_front ? "in front of" : "behind";
        const char* const near = node.is_near ? "near" : "far";
        lines.push_back({fmt::format("{} the plane of [{}]: its {} side, drawn {}", side,
                                     node.triangle, near, node.is_last ? "last" : "first"),
                         fmt::format("{} [{}]: {} side", side, node.triangle, near),
                         fmt::format("{} [{}]", side, node.triangle)});
        for (std::size_t i = 0; i < form_count; ++i)
            widest[i] = std::max(widest[i], text_width(lines.back()[i]));
    }
    std::size_t form = 0;
    while (form + 1 < form_count && widest[form] > ImGui::GetContentRegionAvail().x)
        ++form;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (left_out > 0 && i == planes_at_each_end)
            text_in(p.dim, fmt::format("… {} more", left_out));
        text_in(p.text, lines[i][form]);
        register_widget(
            ui, fmt::format("hidden.plane.{}", i),
            fmt::format("The triangle lies {} the plane of the scene's triangles[{}]. "
                        "The camera is on {} side, and this side is drawn {} the other.",
                        nodes[i].is_front ? "in front of" : "behind", nodes[i].triangle,
                        nodes[i].is_near ? "the same" : "the other",
                        nodes[i].is_last ? "after" : "before"));
    }
}

/// The square that was looked at last, which the picture frames, and why it is drawn, left or
/// divided.
void draw_square(Ui& ui, const WarnockSquares& squares) {
    const std::optional<Cursor>& done = ui.results.a.done;
    if (!done) {
        wrapped_text("No square has been looked at yet.");
        register_widget(ui, "hidden.square", "The whole picture comes first.");
        return;
    }
    wrapped_text(describe_moment(ui.results.a.frame, *done));
    register_widget(ui, "hidden.square",
                    "The square that was looked at last; it is framed in the picture.");
    const SquareReasonWords& reason = words(squares[done->square].reason);
    std::string sentence(reason.sentence);
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    wrapped_text_in(palette(ui.options.theme).dim, sentence + ".");
    register_widget(ui, "hidden.reason", "What was done with the square, and why.",
                    reason.in_short);
}

/// What is counted of a way.
struct WayColumn {
    const char* title;
    const char* help;
    std::string (*words)(const HiddenWay&);
};

/// In the order in which they are left out where there is no room.
const std::array way_columns{
    WayColumn{"parts",
              "What is drawn one after another: the triangles of the scene, the pieces they were "
              "cut into, or the squares of the picture, those that are divided in turn too.",
              [](const HiddenWay& way) {
                  const int squares = way.counts.squares;
                  return std::to_string(squares > 0 ? squares : way.triangles);
              }},
    WayColumn{"splits", "Triangles and pieces that were cut in two.",
              [](const HiddenWay& way) { return std::to_string(way.counts.splits); }},
    WayColumn{"bytes", "What has to be remembered besides scene and picture.",
              [](const HiddenWay& way) { return std::to_string(way.counts.memory); }},
    WayColumn{"compared",
              "Depth buffer: fragments with what their pixels hold. Painter: depths of two "
              "triangles. BSP tree: the camera with a plane. Warnock: a triangle with a square, "
              "and two triangles in one.",
              [](const HiddenWay& way) { return std::to_string(way.counts.comparisons); }},
    WayColumn{"wrong",
              "Pixels that show what the depth buffer shows neither there nor at any pixel next to "
              "it.",
              [](const HiddenWay& way) { return std::to_string(way.wrong); }},
};

std::string name_of(const HiddenWay& way) {
    return choice_words(*find_setting("hidden"), word_of(way.way));
}

std::string words_in(const WayColumn& column, const HiddenWay& way) {
    return way.is_possible ? column.words(way) : "–";
}

/// The width of each column, and of the names before them, screen pixels.
std::vector<float> way_widths(const Ui& ui, const std::vector<HiddenWay>& ways) {
    std::vector<float> widths{0.0f};
    for (const HiddenWay& way : ways)
        widths[0] = std::max(widths[0], button_width(name_of(way)));
    for (const WayColumn& column : way_columns) {
        widths.push_back(text_width(ui.fonts.small, column.title));
        for (const HiddenWay& way : ways)
            widths.back() = std::max(widths.back(), text_width(words_in(column, way)));
    }
    return widths;
}

void draw_way(Ui& ui, const HiddenWay& way, std::size_t first_column, bool is_chosen) {
    const Palette& p = palette(ui.options.theme);
    const std::string word(word_of(way.way));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    std::string help = is_chosen ? "In use now." : "Uses it: hidden=" + word + ".";
    for (const WayColumn& column : way_columns)
        help += fmt::format("\n{}: {}", column.title, words_in(column, way));
    const bool pressed =
        button(ui, "hidden.way." + word, name_of(way), is_chosen ? Look::quiet : Look::link, help);
    if (pressed && !refuses_settings(ui.session)) ui.session.a.settings.hidden = way.way;
    for (std::size_t i = first_column; i < way_columns.size(); ++i) {
        ImGui::TableNextColumn();
        const std::string text = words_in(way_columns[i], way);
        right_aligned(text, is_chosen ? p.text : p.dim);
        register_widget(ui, fmt::format("hidden.{}.{}", word, way_columns[i].title),
                        way.is_possible ? way_columns[i].help : "The scene is too large for this.",
                        text);
    }
}

/// As many columns as there is room for; the tooltip of each name has all of them.
void draw_ways(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    wrapped_text("All ways, with this scene and camera", ui.fonts.bold);
    const std::vector<HiddenWay>& ways = ui.results.hidden.ways;
    if (ways.empty()) {
        text_in(p.dim, "Counting …");
        return;
    }
    const std::vector<float> widths = way_widths(ui, ways);
    const float gap = 2.0f * ImGui::GetStyle().CellPadding.x + 1.0f;
    float needed = 0.0f;
    for (const float width : widths)
        needed += width + gap;
    std::size_t first = 0;
    while (first + 1 < way_columns.size() && needed > ImGui::GetContentRegionAvail().x)
        needed -= widths[++first] + gap;
    const auto columns = static_cast<int>(way_columns.size() - first) + 1;
    if (!begin_lined_table("hidden.ways", columns, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, widths[0] + gap);
    for (std::size_t i = first; i < way_columns.size(); ++i)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, widths[i + 1] + gap);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (std::size_t i = first; i < way_columns.size(); ++i) {
        ImGui::TableNextColumn();
        right_aligned(way_columns[i].title, p.dim, ui.fonts.small);
        register_widget(ui, std::string("hidden.title.") + way_columns[i].title,
                        way_columns[i].help);
    }
    const Hidden chosen = hidden_rule(ui.results.a.frame.settings);
    for (const HiddenWay& way : ways)
        draw_way(ui, way, first, way.way == chosen);
    ImGui::EndTable();
}

} // namespace

void draw_hidden_panel(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    if (frame.squares != nullptr) {
        draw_square(ui, *frame.squares);
        ImGui::Spacing();
        draw_ways(ui);
        return;
    }
    if (!begin_triangle_panel(ui, "place in the picture")) return;
    if (frame.list != nullptr) {
        const int triangle = *ui.results.a.triangle;
        draw_place(ui, *frame.list, triangle);
        if (frame.list->divided == nullptr) {
            const std::optional<Source> source =
                draw_formula(ui, order_formulas(frame, triangle).front(), "hidden.depth");
            if (source) go_to_source(ui, *source);
        } else {
            draw_walk(ui, triangle);
        }
        ImGui::Spacing();
    }
    draw_ways(ui);
}

} // namespace rasterwalk
