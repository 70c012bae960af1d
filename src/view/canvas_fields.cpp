#include "view/canvas_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "session/canvas_view.h"
#include "stages/clip.h"
#include "view/view_form.h"
#include "view/view_links.h"

namespace rasterwalk {

namespace {

/// If a lesson names no centre, it depends on the pixel or the size of the picture.
bool is_same_place(const ViewChange& change) {
    const ViewState& to = change.to;
    const ViewState& from = change.from;
    return to.zoom == from.zoom && to.centre == from.centre && to.pixel == from.pixel &&
           change.to_session.a.settings.viewport == change.from_session.a.settings.viewport;
}

} // namespace

ViewField zoom_field() {
    ViewForm<float> form{&ViewState::zoom};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        const float zoom = block.input().number(node, 0.0f, largest_zoom, "the zoom");
        if (zoom != 0.0f && zoom < smallest_zoom) {
            block.input().fail(node, "the zoom must be 0.25 to 64, or 0 to fit.");
        }
        return zoom;
    };
    form.toml = [](float zoom) { return number_text(zoom); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<float> zoom =
            word == "fit" ? 0.0f : parse_number(word, smallest_zoom, largest_zoom);
        if (!zoom) refuse_option(given, "a number from 0.25 to 64 or fit", word);
        return zoom;
    };
    form.read_session = [](const Session& session) {
        const float zoom = session.canvas.zoom;
        return zoom > 0.0f ? std::optional(std::clamp(zoom, smallest_zoom, largest_zoom))
                           : std::nullopt;
    };
    form.show = [](const auto& zoom, Session& session) {
        session.canvas.zoom = zoom.value_or(0.0f);
    };
    const ViewOption option{"zoom", "NUMBER",
                            "Screen pixels for each pixel of the picture, 0.25 to 64, or fit"};
    ViewField field = make_field("zoom", ViewPart::canvas, option, form);
    field.is_of_scene = true;
    field.words = [](const ViewChange& change) -> std::vector<std::string> {
        if (is_same_place(change)) return {};
        if (change.to.zoom) return {number_text(*change.to.zoom)};
        if (change.from.zoom) return {"fit"};
        return {};
    };
    return field;
}

namespace {

bool is_near(const glm::vec2& place) {
    return std::max(std::abs(place.x), std::abs(place.y)) <= farthest_centre;
}

} // namespace

ViewField centre_field() {
    ViewForm<glm::vec2> form{&ViewState::centre};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        const std::optional<glm::vec2> centre = parse_place(block.text(node));
        if (!centre) {
            block.input().fail(node, "a position in the picture is needed here, like \"250,131\".");
        }
        if (!is_near(*centre)) {
            block.input().fail(node, "this position is too far outside the picture.");
        }
        return *centre;
    };
    form.toml = [](const glm::vec2& centre) { return toml_text(to_text(centre)); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<glm::vec2> centre = parse_place(word);
        if (!centre || !is_near(*centre)) {
            refuse_option(given, "a position in the picture, like 250,131.5", word);
        }
        return centre;
    };
    form.read_session = [](const Session& session) -> std::optional<glm::vec2> {
        if (session.canvas.zoom <= 0.0f) return std::nullopt;
        const glm::vec2& centre = session.canvas.centre;
        return glm::vec2{std::clamp(centre.x, -farthest_centre, farthest_centre),
                         std::clamp(centre.y, -farthest_centre, farthest_centre)};
    };
    const ViewOption option{"centre", "X,Y", "Position at the middle of the zoomed picture"};
    ViewField field = make_field("centre", ViewPart::canvas, option, form);
    field.is_of_scene = true;
    field.words = [](const ViewChange& change) -> std::vector<std::string> {
        if (is_same_place(change) || !change.to.zoom) return {};
        return {to_text(*change.to.centre)};
    };
    field.show = [](const ViewState& state, Session& session) {
        const Viewport& size = session.a.settings.viewport;
        const glm::vec2 middle(0.5f * static_cast<float>(size.width),
                               0.5f * static_cast<float>(size.height));
        const glm::vec2 near = state.pixel ? glm::vec2(*state.pixel) : middle;
        session.canvas.centre = state.centre.value_or(near);
    };
    return field;
}

namespace {

/// Something about the canvas that is on or off, and stays as it was if it is not given.
/// @param what its name in messages
ViewField switch_field(std::string_view key, const ViewOption& option, std::string_view what,
                       std::optional<bool> ViewState::*member, bool CanvasView::*shown) {
    ViewForm<bool> form{member};
    form.read = [what](const TomlBlock& block, const toml::node& node) {
        const std::optional<bool> on = node.value_exact<bool>();
        if (!on) block.input().fail(node, std::string(what) + " must be true or false.");
        return *on;
    };
    form.toml = [](bool on) { return std::string(on ? "true" : "false"); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        constexpr std::array<std::string_view, 2> words{"off", "on"};
        return option_index(given, words, word) == 1;
    };
    form.word = [shown](const auto& on) {
        return std::string(on.value_or(CanvasView().*shown) ? "on" : "off");
    };
    form.read_session = [shown](const Session& session) {
        const bool on = session.canvas.*shown;
        return on != CanvasView().*shown ? std::optional(on) : std::nullopt;
    };
    form.show = [shown](const auto& on, Session& session) {
        session.canvas.*shown = on.value_or(session.canvas.*shown);
    };
    return make_field(key, ViewPart::canvas, option, form);
}

} // namespace

ViewField grid_field() {
    const ViewOption option{"grid", "WORD", "Grid of pixels, at 8x and above: on or off"};
    return switch_field("grid", option, "the grid", &ViewState::grid, &CanvasView::grid);
}

ViewField row_table_field() {
    const ViewOption option{
        "row-table", "WORD",
        "Row table next to the rows of the picture, at 24x and above: on or off"};
    return switch_field("row_table", option, "the row table", &ViewState::row_table,
                        &CanvasView::row_table);
}

ViewField fates_field() {
    const ViewOption option{
        "fates", "WORD", "Pass and fail in the cells of the triangle, at 24x and above: on or off"};
    return switch_field("fates", option, "the switch for pass and fail", &ViewState::fates,
                        &CanvasView::fates);
}

namespace {

/// One of several ways in which the canvas shows something; the usual one if it is not given.
/// @param what its name in messages
template <class Enum>
ViewField choice_field(std::string_view key, const ViewOption& option, const char* what,
                       std::optional<Enum> ViewState::*member, Enum CanvasView::*shown) {
    return word_field(
        key, ViewPart::canvas, option, what,
        member, [shown](auto& session) -> auto& { return session.canvas.*shown; }, false);
}

} // namespace

ViewField cell_numbers_field() {
    const ViewOption option{"cell-numbers", "NAME",
                            "Numbers in the cells, if the zoom leaves room: " +
                                one_of(enum_words<CellNumbers>)};
    return choice_field("cell_numbers", option, "numbers in the cells", &ViewState::cell_numbers,
                        &CanvasView::numbers);
}

ViewField field_edge_field() {
    // Each plane that cuts a triangle can add one.
    constexpr int most_edges = triangle_corners + static_cast<int>(clip_plane_count);
    ViewForm<int> form{&ViewState::field_edge};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        return block.whole(node, 0, most_edges - 1);
    };
    form.toml = [](int edge) { return std::to_string(edge); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<int> edge = parse_int(word);
        const bool is_edge = edge && *edge >= 0 && *edge < most_edges;
        if (!is_edge && word != no_value)
            refuse_option(given, fmt::format("a number from 0 to {} or none", most_edges - 1),
                          word);
        return is_edge ? edge : std::nullopt;
    };
    form.word = [](const auto& edge) {
        return edge ? std::to_string(*edge) : std::string(no_value);
    };
    form.read_session = [](const Session& session) { return session.canvas.field_edge; };
    form.show = [](const auto& edge, Session& session) { session.canvas.field_edge = edge; };
    return make_field("field_edge", ViewPart::canvas,
                      {"field-edge", "N", "Edge of the overlay edge_field, from 0, or none"}, form);
}

ViewField canvas_field() {
    const ViewOption option{"canvas", "WORD",
                            "The picture, the scene from outside, or both: " +
                                one_of(enum_words<CanvasShows>)};
    ViewField field =
        choice_field("canvas", option, "canvas", &ViewState::canvas, &CanvasView::shows);
    field.link = word_link("canvas", "canvas",
                           {enum_words<CanvasShows>.begin(), enum_words<CanvasShows>.end()},
                           [](Session& session, const std::string& word) {
                               session.canvas.shows = *value_of_word<CanvasShows>(word);
                           });
    return field;
}

namespace {

constexpr const char* outside_form = "camera, or yaw and pitch like -0.75,-0.4, or yaw, pitch, "
                                     "distance and target like -0.75,-0.4,5,0,0,1";

} // namespace

ViewField outside_field() {
    ViewForm<OutsideView> form{&ViewState::outside};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        const std::optional<OutsideView> view = parse_outside_view(block.text(node));
        if (!view) {
            block.input().fail(node,
                               std::string("the view from outside must be ") + outside_form + ".");
        }
        return *view;
    };
    form.toml = [](const OutsideView& view) { return toml_text(to_text(view)); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<OutsideView> view = parse_outside_view(word);
        if (!view) refuse_option(given, outside_form, word);
        return view;
    };
    form.word = [](const auto& view) { return to_text(view.value_or(OutsideView())); };
    form.read_session = [](const Session& session) {
        const OutsideView view = within_ranges(session.canvas.outside);
        return to_text(view) != to_text(OutsideView()) ? std::optional(view) : std::nullopt;
    };
    form.show = [](const auto& view, Session& session) {
        session.canvas.outside = view.value_or(OutsideView());
    };
    const ViewOption option{"outside", "YAW,PITCH",
                            "View of the scene from outside: " + std::string(outside_form)};
    ViewField field = make_field("outside", ViewPart::canvas, option, form);
    field.is_of_scene = true;
    field.link = {"outside",
                  [](const std::string& argument) {
                      if (parse_outside_view(argument)) return;
                      throw UsageError("the link names no view from outside: " +
                                       in_quotes(argument) + " is not " + outside_form + ".");
                  },
                  [](Session& session, const Frame&, const std::string& argument) {
                      session.canvas.outside = *parse_outside_view(argument);
                  }};
    return field;
}

} // namespace rasterwalk
