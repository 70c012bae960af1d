#include "view/view_table.h"

#include <algorithm>

#include "base/error.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "pipeline/frame.h"
#include "pipeline/timeline.h"
#include "scene/tessellation.h"
#include "session/moments.h"
#include "session/second_run.h"
#include "session/shown_pass.h"
#include "settings/setting_table.h"
#include "view/canvas_fields.h"
#include "view/look_fields.h"
#include "view/view_form.h"
#include "view/view_links.h"

namespace rasterwalk {

namespace {

// The rows about the second run.

/// Is there a run B that settings describe? A student's program is never part of a view.
bool has_described_b(const Session& session) {
    return session.b && session.b->program == nullptr;
}

ViewField compare_field() {
    ViewForm<std::vector<std::string>> form{&ViewState::compare};
    form.read = read_assignments;
    form.toml = toml_list;
    form.read_session = [](const Session& session) -> std::optional<std::vector<std::string>> {
        if (!has_described_b(session)) return std::nullopt;
        return assignments_between(session.a.settings, session.b->settings);
    };
    form.show = [](const auto& compare, Session& session) {
        stop_comparing(session);
        if (compare) compare_with(session, settings_with(session.a.settings, *compare));
    };
    const ViewOption option{
        "b", "NAME=VALUE",
        "A second run that differs from the first in this setting; repeatable; none for no "
        "second run",
        true};
    ViewField field = make_field("compare", ViewPart::runs, option, form);
    field.parse = [](const GivenOption& given, ViewState& state) {
        state.compare = given.words;
        if (given.words.back() == no_value) state.compare = std::nullopt;
    };
    field.link = compare_link();
    field.words = [](const ViewChange& change) -> std::vector<std::string> {
        const Session& to = change.to_session;
        const Session& from = change.from_session;
        if (!has_described_b(to)) {
            return has_described_b(from) ? std::vector{std::string(no_value)}
                                         : std::vector<std::string>();
        }
        if (to.b == from.b && to.a == from.a) return {};
        if (to.a == *to.b) {
            // The option needs a word, so it gets the stage; then come values that setting the
            // stage would change.
            const std::string stage = "stage=" + value_text(*find_setting("stage"), to.a.settings);
            Settings said = to.a.settings;
            set_from_text(said, stage);
            std::vector<std::string> words = assignments_between(said, to.a.settings);
            words.insert(words.begin(), stage);
            return words;
        }
        return assignments_between(to.a.settings, to.b->settings);
    };
    return field;
}

ViewField wipe_field() {
    ViewForm<float> form{&ViewState::wipe};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        return block.input().number(node, 0.0f, 1.0f, "the position of the divider");
    };
    form.toml = [](float wipe) { return number_text(wipe); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<float> wipe = parse_number(word, 0.0f, 1.0f);
        if (!wipe) refuse_option(given, "a number from 0 to 1", word);
        return wipe;
    };
    form.word = [](const auto& wipe) { return number_text(wipe.value_or(Session().wipe)); };
    form.read_session = [](const Session& session) {
        return session.wipe != Session().wipe ? std::optional(std::clamp(session.wipe, 0.0f, 1.0f))
                                              : std::nullopt;
    };
    form.show = [](const auto& wipe, Session& session) {
        session.wipe = wipe.value_or(session.wipe);
    };
    const ViewOption option{"wipe", "NUMBER", "Position of the divider between them, 0 to 1"};
    return make_field("wipe", ViewPart::runs, option, form);
}

ViewField compare_view_field() {
    return enum_field(
        "compare_view", ViewPart::runs,
        {"compare-view", "NAME", "How two runs are shown: " + one_of(enum_words<CompareView>)},
        "way to compare", &ViewState::compare_view, &Session::compare_view, true);
}

// --- what is drawn

ViewField scene_field() {
    ViewForm<std::string> form{&ViewState::scene};
    form.read = [](const TomlBlock& block, const toml::node& node) { return block.text(node); };
    return make_field("scene", ViewPart::drawn, {}, form);
}

ViewField set_field() {
    ViewField field;
    field.key = "set";
    field.read = [](const TomlBlock& block, const toml::node& node, ViewState& state) {
        state.set = read_assignments(block, node);
    };
    field.write = [](const ViewState& state) {
        return state.set.empty() ? std::string() : toml_list(state.set);
    };
    field.read_session = [](const Session& session, const Scene& original, ViewState& state) {
        state.set = assignments_between(default_settings(original), session.a.settings);
    };
    field.take = [](const ViewState& over, ViewState& state) {
        state.set.insert(state.set.end(), over.set.begin(), over.set.end());
    };
    field.clear = [](ViewState& state) { state.set.clear(); };
    field.link = settings_link();
    return field;
}

std::vector<std::string> texts_of(const std::vector<PlacedTriangle>& triangles) {
    std::vector<std::string> texts;
    for (const PlacedTriangle& placed : triangles)
        texts.push_back(to_text(placed));
    return texts;
}

ViewField vertices_field() {
    ViewForm<std::vector<PlacedTriangle>> form{&ViewState::vertices};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        std::vector<PlacedTriangle> list;
        block.for_each_text(node, most_placed_triangles, [&](const std::string& text) {
            list.push_back(parse_placed_triangle(text));
        });
        return list;
    };
    form.toml = [](const auto& list) { return toml_list(texts_of(list)); };
    form.show = [](const auto& list, Session& session) {
        if (!list) return;
        for (const PlacedTriangle& placed : *list)
            place_triangle(session, placed);
    };
    const ViewOption option{
        "vertices", "[N:]X,Y/X,Y/X,Y",
        "Positions of the vertices of a scene in pixels, like 10,5/5,10/15,15, or "
        "3:10,5/5,10/15,15 for triangle 3; repeatable",
        true};
    ViewField field = make_field("vertices", ViewPart::drawn, option, form);
    field.is_of_scene = true;
    field.parse = [](const GivenOption& given, ViewState& state) {
        if (!state.vertices) state.vertices.emplace(); // others may have been moved too
        for (const std::string& word : given.words)
            state.vertices->push_back(parse_placed_triangle(word));
    };
    field.words = [](const ViewChange& change) {
        return texts_of(moved_triangles(*change.to_session.scene, *change.from_session.scene));
    };
    field.read_session = [](const Session& session, const Scene& original, ViewState& state) {
        std::vector<PlacedTriangle> moved = moved_triangles(*session.scene, original);
        if (!moved.empty()) state.vertices = std::move(moved);
    };
    return field;
}

ViewField cursor_field() {
    ViewForm<Cursor> form{&ViewState::cursor};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        const std::optional<Cursor> cursor = parse_cursor(block.text(node));
        if (!cursor) {
            block.input().fail(
                node, in_quotes(block.text(node)) +
                          " is not a moment; moments are written t12, t12/v1, t12/p2/s1, "
                          "t12/k, t12/e2/s14, t12/b4/c7, t12/r37/c5, s37/c5, w12, p1:t12 or end.");
        }
        return *cursor;
    };
    form.toml = [](const Cursor& cursor) { return toml_text(to_text(cursor)); };
    form.word = [](const auto& cursor) { return to_text(cursor.value_or(cursor_end)); };
    form.read_session = [](const Session& session) -> std::optional<Cursor> {
        if (session.cursor == cursor_end) return std::nullopt;
        const Cursor cursor = existing_moment(*session.scene, session.a.settings, session.cursor);
        return cursor != cursor_end ? std::optional(cursor) : std::nullopt;
    };
    form.show = [](const auto& cursor, Session& session) {
        session.cursor = cursor_end;
        if (!cursor) return;
        session.cursor = moment_of(*session.scene, session.a.settings, *cursor);
    };
    const ViewOption option{"to", "CURSOR",
                            "Draw up to this moment: t12, t12/v1, t12/p2/s1, t12/k, t12/e2/s14, "
                            "t12/b4/c7, t12/r37/c5, s37/c5, w12, p1:t12 or end"};
    ViewField field = make_field("cursor", ViewPart::selection, option, form);
    field.is_of_scene = true;
    field.link = cursor_link();
    return field;
}

// --- what is picked

ViewField pixel_field() {
    ViewForm<glm::ivec2> form{&ViewState::pixel};
    const auto text = [](const glm::ivec2& pixel) {
        return std::to_string(pixel.x).append(",").append(std::to_string(pixel.y));
    };
    const auto is_inside = [](const glm::ivec2& pixel, const Viewport& size) {
        return pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.width && pixel.y < size.height;
    };
    form.read = [](const TomlBlock& block, const toml::node& node) { return block.pixel(node); };
    form.toml = [text](const glm::ivec2& pixel) { return toml_text(text(pixel)); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<glm::ivec2> pixel = parse_pixel(word);
        if (!pixel && word != no_value) {
            refuse_option(given, "a column and a row, like 250,131, or none", word);
        }
        return pixel;
    };
    form.word = [text](const auto& pixel) { return pixel ? text(*pixel) : std::string(no_value); };
    form.read_session = [is_inside](const Session& session) {
        const std::optional<glm::ivec2>& pixel = session.selection.pixel;
        return pixel && is_inside(*pixel, shown_size(session)) ? pixel : std::nullopt;
    };
    form.show = [text, is_inside](const auto& pixel, Session& session) {
        const Viewport size = shown_size(session);
        session.selection.pixel = std::nullopt;
        if (pixel && !is_inside(*pixel, size)) {
            throw UsageError("the pixel " + text(*pixel) + " is outside the picture of " +
                             std::to_string(size.width) + " x " + std::to_string(size.height) +
                             " pixels.");
        }
        session.selection.pixel = pixel;
    };
    ViewField field = make_field("pixel", ViewPart::selection,
                                 {"pixel", "X,Y", "Pixel that is picked, or none"}, form);
    field.is_of_scene = true;
    field.link = pixel_link();
    return field;
}

/// The number of triangles drawn of the scene.
int triangles_of(const Session& session) {
    // How many pieces planes cut is known only once they have.
    const bool is_cut = hidden_rule(shown_run(session, session.a).settings) == Hidden::bsp;
    if (is_cut) return prepare_frame(*session.scene, session.a.settings).triangle_count();
    const int parts = tessellation_of(*session.scene, session.a.settings.tessellation);
    return session.scene->triangle_count() * parts * parts;
}

int rows_of(const Session& session) {
    return shown_size(session).height;
}

int vertices_of(const Session&) {
    return triangle_corners;
}

/// Something picked by its number, from 0.
/// @param most the largest number that may be written, whatever the scene
ViewField number_field(std::string_view name, std::string_view plural, std::string_view help,
                       int most, int (*count)(const Session&),
                       std::optional<int> ViewState::*member,
                       std::optional<int> Selection::*selected) {
    ViewForm<int> form{member};
    form.read = [most](const TomlBlock& block, const toml::node& node) {
        return block.whole(node, 0, most);
    };
    form.toml = [](int number) { return std::to_string(number); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<int> number = parse_int(word);
        if (!number && word != no_value) refuse_option(given, "a whole number or none", word);
        return number;
    };
    form.word = [](const auto& number) {
        return number ? std::to_string(*number) : std::string(no_value);
    };
    form.read_session = [count, selected](const Session& session) {
        const std::optional<int>& number = session.selection.*selected;
        return number && *number >= 0 && *number < count(session) ? number : std::nullopt;
    };
    form.show = [=](const auto& number, Session& session) {
        session.selection.*selected = std::nullopt;
        if (number && (*number < 0 || *number >= count(session))) {
            throw UsageError(std::string("there is no ")
                                 .append(name)
                                 .append(" ")
                                 .append(std::to_string(*number))
                                 .append(": the ")
                                 .append(plural)
                                 .append(" are 0 to ")
                                 .append(std::to_string(count(session) - 1))
                                 .append("."));
        }
        session.selection.*selected = number;
    };
    ViewField field = make_field(name, ViewPart::selection, {name, "N", std::string(help)}, form);
    field.is_of_scene = true;
    field.link = number_link(name, count, selected);
    return field;
}

std::vector<ViewField> make_table() {
    return {
        scene_field(),
        set_field(),
        cursor_field(),
        pixel_field(),
        number_field("triangle", "triangles", "Triangle that is selected, from 0, or none",
                     max_triangles, triangles_of, &ViewState::triangle, &Selection::triangle),
        number_field("row", "rows", "Row of the picture that is selected, from 0, or none",
                     largest_viewport, rows_of, &ViewState::row, &Selection::row),
        number_field("vertex", "vertices", "Vertex that is selected, 0 to 2, or none",
                     triangle_corners - 1, vertices_of, &ViewState::vertex, &Selection::vertex),
        panels_field(), // before the tab, which may depend on them
        tab_field(),
        page_field(),
        plane_field(),
        overlays_field(),
        zoom_field(),
        centre_field(),
        grid_field(),
        row_table_field(),
        fates_field(),
        cell_numbers_field(),
        field_edge_field(),
        canvas_field(),
        outside_field(),
        compare_field(),
        compare_view_field(),
        wipe_field(),
        depth_range_field(),
        vertices_field(),
        point_at_field(),
    };
}

} // namespace

std::span<const ViewField> view_table() {
    static const std::vector<ViewField> table = make_table();
    return table;
}

std::span<const ViewField* const> view_table_drawn_first() {
    static const std::vector<const ViewField*> fields = [] {
        std::vector<const ViewField*> list;
        for (const ViewField& field : view_table())
            list.push_back(&field);
        std::stable_partition(list.begin(), list.end(), [](const ViewField* field) {
            return field->part == ViewPart::drawn;
        });
        return list;
    }();
    return fields;
}

const ViewField& view_field(std::string_view key) {
    const std::span<const ViewField> table = view_table();
    return *std::find_if(table.begin(), table.end(),
                         [&](const ViewField& field) { return field.key == key; });
}

TomlKeys view_keys(const TomlBlock& block, ViewState& state) {
    TomlKeys keys;
    for (const ViewField& field : view_table()) {
        keys[field.key] = [&block, &state, &field](const toml::node& node) {
            state.lines[std::string(field.key)] = line_of(node);
            field.read(block, node, state);
        };
    }
    return keys;
}

ViewState read_view_state(const toml::table& table, int line, FaultList& faults, const char* what) {
    TomlBlock block(table, line, what, faults);
    ViewState state;
    state.line = line;
    block.read(view_keys(block, state));
    return state;
}

} // namespace rasterwalk
