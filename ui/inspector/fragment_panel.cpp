#include <algorithm>
#include <string>
#include <vector>

#include "base/element_names.h"
#include "explain/depth_formulas.h"
#include "session/walk.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/fragment_parts.h"
#include "ui/inspector/inspector_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void put_swatch(const Ui& ui, float width, const glm::vec3& colour) {
    draw_swatch(ui, ImGui::GetCursorScreenPos(), width, colour);
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
}

/// A link at the right edge of the line, or on the next line if there is no room for it.
bool link_at_right(Ui& ui, const char* name, const char* label, const char* help) {
    const float width = ImGui::CalcTextSize(label).x + 4.0f * ui.options.text_scale;
    ImGui::SameLine();
    const float room = ImGui::GetContentRegionAvail().x;
    if (room < width) {
        ImGui::NewLine();
    } else {
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));
    const bool clicked = button(ui, name, label, Look::link, help);
    ImGui::PopStyleVar();
    return clicked;
}

/// The links to the fragment drawn last and to this one's moment.
struct FragmentLinks {
    bool can_follow, can_go;
};

FragmentLinks links_of(const Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const bool is_done = ui.results.a.done == report.cursor;
    return {ui.session.selection.pixel && !is_done && ui.results.a.done &&
                ui.results.a.done->phase == Phase::rows,
            !is_done};
}

void draw_follow_link(Ui& ui) {
    if (link_at_right(ui, "fragment.follow", "the last fragment",
                      "Releases the picked pixel and always shows the last fragment.")) {
        ui.session.selection.pixel = std::nullopt;
    }
}

void draw_go_link(Ui& ui) {
    const Cursor cursor = report_of(ui).cursor;
    if (link_at_right(ui, "fragment.go", "go to it",
                      "Goes to the moment just after this fragment is drawn.")) {
        go_to_source(ui, from_moment(cursor));
    }
}

/// Triangle, entry and fragment, in the longest form that has room.
std::string place_of(const FragmentReport& report, float room) {
    const int triangle = report.cursor.triangle;
    const std::string counted =
        " · " + element_name_of(entry_form, report.row.index, report.row.row_count) + " · " +
        element_name_of(fragment_form, report.step, report.row.count);
    const std::string bare = " · " + element_name(entry_form, report.row.index) + " · " +
                             element_name(fragment_form, report.step);
    const std::string shortest = short_triangle_name(triangle) + bare;
    return first_fitting(
        {triangle_name(triangle) + counted, short_triangle_name(triangle) + counted, shortest},
        room);
}

/// Where lines are few the links are below the numbers.
void draw_title(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const Palette& p = palette(ui.options.theme);
    const Scene& scene = *ui.results.a.frame.scene;
    const int triangle = report.cursor.triangle;
    const std::string& part = part_name(scene, triangle);
    const std::vector<std::string> parts{part_words(scene, triangle), part,
                                         part.substr(part.rfind(' ') + 1)};
    const std::string pixel =
        "(" + std::to_string(report.pixel.x) + ", " + std::to_string(report.pixel.y) + ")";
    const bool is_picked = ui.session.selection.pixel.has_value();
    const std::string title = (is_picked ? "Pixel " : "Last fragment: pixel ") + pixel;
    const std::string short_title = (is_picked ? "Pixel " : "Last: pixel ") + pixel;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float beside = style.ItemSpacing.x + ImGui::GetTextLineHeight() +
                         style.ItemInnerSpacing.x + text_width(parts.back());
    ImGui::PushFont(ui.fonts.bold);
    const bool has_room = text_width(title) + beside <= ImGui::GetContentRegionAvail().x;
    put_text(has_room ? title : short_title);
    ImGui::PopFont();
    register_widget(ui, "fragment.pixel",
                    is_picked ? "Column and row of the pixel that the fragment fell on."
                              : "Column and row of the pixel that the last fragment fell on.");
    ImGui::SameLine();
    ImGui::BeginGroup();
    const glm::vec3 reflectance = scene.corner(triangle, 0).reflectance;
    put_swatch(ui, ImGui::GetTextLineHeight(),
               report.texture ? reflectance * report.texture->colour : reflectance);
    ImGui::SameLine(0.0f, style.ItemInnerSpacing.x);
    const std::string shown = first_fitting(parts, ImGui::GetContentRegionAvail().x);
    text_in(p.dim, shown);
    ImGui::EndGroup();
    register_widget(ui, "fragment.part",
                    "The part of the scene that the triangle belongs to: " + part + ".", shown);
    const FragmentLinks links = links_of(ui);
    if (links.can_follow && !ui.inspector.is_low) draw_follow_link(ui);
    text_in(p.dim, place_of(report, ImGui::GetContentRegionAvail().x));
    register_widget(
        ui, "fragment.place",
        "Where the fragment belongs: its triangle, the entry of the triangle's row table, and how "
        "far along that row; all count from 0.");
    if (links.can_go && !ui.inspector.is_low) draw_go_link(ui);
}

std::string verdict(const Ui& ui, const FragmentReport& report) {
    if (report.fate == Fate::back_facing)
        return "✗ culled before the depth test: its normal points away from the camera";
    if (report.fate == Fate::cut_out) {
        return "✗ cut out before the depth test: the alpha of its texture here is " +
               fixed(static_cast<double>(report.alpha), 3) + ", below 1/2";
    }
    if (report.depth_test == DepthTest::off) return "no depth test: the last one drawn stays";
    if (report.depth_test == DepthTest::reversed) {
        return report.fate == Fate::written ? "✓ passed: it is farther than what was there"
                                            : "✗ failed: it is not farther than what was there";
    }
    if (depth_epsilon_rule(ui.results.a.frame.settings) > 0.0f) {
        return report.fate == Fate::written ? "✓ passed: it is nearer by more than epsilon"
                                            : "✗ failed: it is not nearer by more than epsilon";
    }
    if (report.depth_test == DepthTest::raced && report.fate == Fate::written &&
        !is_nearer(report.depth, report.stored, depth_words(ui.results.a.frame).kind))
        return "✓ passed: what is there now was written by the other thread after this test";
    return report.fate == Fate::written ? "✓ passed: nothing nearer was there"
                                        : "✗ failed: something nearer was there";
}

void draw_colours(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const Palette& p = palette(ui.options.theme);
    const auto numbers = [](const glm::vec3& colour) {
        return fixed(static_cast<double>(colour.r), 3) + " " +
               fixed(static_cast<double>(colour.g), 3) + " " +
               fixed(static_cast<double>(colour.b), 3);
    };
    const auto draw = [&](const char* word, const char* name, const glm::vec3& colour,
                          const char* help) {
        const float start = ImGui::GetCursorPosX();
        ImGui::BeginGroup();
        text_in(p.dim, word);
        ImGui::SameLine(start + ImGui::CalcTextSize("would be ").x);
        put_swatch(ui, 2.0f * ImGui::GetTextLineHeight(), colour);
        ImGui::SameLine();
        put_text(numbers(colour), ui.fonts.mono);
        ImGui::EndGroup();
        register_widget(ui, name, help);
    };
    draw("before", "fragment.before", report.before, "The pixel's colour before: red green blue.");
    draw("after", "fragment.after", report.after, "The pixel's colour after: red green blue.");
    if (report.fate != Fate::written) {
        draw("would be", "fragment.would_be", report.colour,
             "The colour that the fragment would have had.");
    }
}

void draw_depth(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const Palette& p = palette(ui.options.theme);
    begin_card(ui);
    text_in(p.dim, "depth and colour", ui.fonts.small);
    const bool tested = report.depth_test != DepthTest::off;
    draw_fragment_section(ui, "depth");
    const ImVec4 colour =
        !tested && report.fate == Fate::written
            ? p.text
            : colour_of(report.fate == Fate::written ? Meaning::pass : Meaning::fail,
                        ui.options.theme);
    wrapped_text_in(colour, verdict(ui, report));
    const Frame& frame = ui.results.a.frame;
    register_widget(
        ui, "fragment.fate",
        "The fragment is drawn if its value is " +
            std::string(depth_words(ui.results.a.frame).nearer) +
            (report.depth_test == DepthTest::or_equal ? " or equal: margin ≥ " : ": margin > ") +
            margin_limit(depth_rules(frame.settings, frame.scene->space)) + "." +
            (report.depth_test == DepthTest::raced
                 ? " So are some that are not nearer than what the other thread has drawn."
                 : ""));
    draw_fragment_section(ui, "blend");
    draw_colours(ui);
    if (report.resolve) wrapped_text_in(p.dim, "resolved, when everything is drawn");
    draw_fragment_section(ui, "resolve");
    end_card(ui);
}

/// What the numbers are not.
void draw_supersampling(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    if (!frame.has_samples() || sampling_rule(frame.settings) != Sampling::supersample) return;
    wrapped_text_in(palette(ui.options.theme).dim,
                    "With supersampling the shader runs at each sample; these numbers and those of "
                    "the light are those of the pixel's centre.");
    register_widget(ui, "fragment.supersampled");
}

/// How the chosen number was computed.
void draw_chosen_number(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const Formula* formula = find_formula(report.formulas, ui.inspector.chosen.fragment_number);
    if (formula == nullptr) formula = find_formula(report.formulas, "zinv");
    follow_source(ui, draw_formula_card(ui, *formula, "fragment.formula"));
}

/// For when the title has no room for them.
void draw_links_below(Ui& ui) {
    const FragmentLinks links = links_of(ui);
    if (links.can_go) draw_go_link(ui);
    if (links.can_follow) draw_follow_link(ui);
}

void draw_no_fragment(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    std::string words;
    if (!has_fragments(frame.settings.stage)) {
        words = "This stage has no fragments. They come with filled triangles.";
    } else if (ui.session.selection.pixel) {
        words = "No fragment ever falls on this pixel. The History tab says why.";
    } else {
        words = "Click a pixel of the picture, or step to a fragment.";
    }
    wrapped_text_in(palette(ui.options.theme).dim, words);
    register_widget(ui, "fragment.none");
    if (!has_fragments(frame.settings.stage) &&
        button(ui, "fragment.fill", "to Fill stage", Look::plain,
               "Draws the picture up to filled triangles.")) {
        set_step(ui.session.a.settings, {Stage::fill});
    }
}

} // namespace

const FragmentReport& report_of(const Ui& ui) {
    return *ui.results.a.inspected.fragment;
}

void follow_source(Ui& ui, const std::optional<Source>& source) {
    if (!source) return;
    if (source->kind == SourceKind::formula) ui.inspector.chosen.fragment_number = source->name;
    go_to_source(ui, *source);
}

void draw_fragment_section(Ui& ui, std::string_view section) {
    follow_source(ui, draw_section(ui, report_of(ui).formulas, section, "fragment."));
}

void draw_fragment_panel(Ui& ui) {
    if (!ui.results.a.inspected.fragment) {
        draw_no_fragment(ui);
        return;
    }
    const std::string chosen = ui.inspector.chosen.fragment_number;
    const auto values = [&] {
        draw_fragment_values(ui);
        draw_supersampling(ui);
        ImGui::Spacing();
    };
    const auto card = [&] {
        const bool is_new = ui.inspector.chosen.fragment_number != chosen;
        draw_chosen_number(ui);
        // In the page it is brought into view by a click on its number.
        if (!ui.inspector.has_card && is_new) scroll_here(1.0f);
        if (ui.inspector.is_low) draw_links_below(ui);
    };
    const auto head = [&] {
        draw_title(ui);
        draw_engine_note(ui);
    };
    const PanelBlock title{head}, light{[&] { draw_fragment_light(ui); }},
        depth{[&] { draw_depth(ui); }};
    draw_panel(ui, "fragment", {title, {values, true}, light, depth}, card);
}

} // namespace rasterwalk
