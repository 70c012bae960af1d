#include "cli/commands.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/error.h"
#include "base/numbers.h"
#include "cli/formula_report.h"
#include "cli/json.h"
#include "explain/fragment_report.h"
#include "explain/shadow_formulas.h"
#include "explain/texture_report.h"
#include "inspect/pixel_history.h"
#include "inspect/pixel_tests.h"
#include "session/shown_pass.h"

namespace rasterwalk {

namespace {

std::optional<int> parse_coordinate(std::string_view text) {
    // A number may be quoted with blanks before it.
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    int value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole = fault == std::errc{} && end == text.data() + text.size();
    return is_whole ? std::optional(value) : std::nullopt;
}

glm::ivec2 pixel_of(const std::string& text, Viewport size) {
    const std::string range =
        fmt::format("columns 0 to {}, rows 0 to {}", size.width - 1, size.height - 1);
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::optional<int> column = parse_coordinate(std::string_view(text).substr(0, comma));
    const std::optional<int> row =
        parse_coordinate(std::string_view(text).substr(std::min(comma + 1, text.size())));
    if (!column || !row) {
        throw UsageError(fmt::format(
            "'{}' is not a pixel. Write it as COLUMN,ROW; the picture has {}.", text, range));
    }
    if (*column < 0 || *column >= size.width || *row < 0 || *row >= size.height) {
        throw UsageError(
            fmt::format("there is no pixel {},{}: the picture has {}.", *column, *row, range));
    }
    return {*column, *row};
}

Json to_json(const TextureReport& texture) {
    Json texels = Json::array();
    for (const SampledTexel& texel : texture.taken) {
        texels.push_back({{"colour", vector_to_json(texel.colour)},
                          {"column", texel.column},
                          {"level", texel.level},
                          {"row", texel.row},
                          {"weight", texel.weight}});
    }
    return {{"colour", vector_to_json(texture.colour)},
            {"down", texture.down},
            {"level", texture.level},
            {"name", texture.surface.texture->name},
            {"right", texture.right},
            {"texels", std::move(texels)},
            {"u", texture.place.texcoord.x},
            {"v", texture.place.texcoord.y}};
}

Json to_json(const ParallaxReport& parallax) {
    const ParallaxTerms& terms = parallax.terms;
    return {{"height", terms.height},
            {"shift_u", terms.shift.x},
            {"shift_v", terms.shift.y},
            {"step_b", terms.step.y},
            {"step_t", terms.step.x},
            {"stored", terms.stored},
            {"unshifted_u", parallax.carried.texcoord.x},
            {"unshifted_v", parallax.carried.texcoord.y},
            {"view", vector_to_json(terms.view)}};
}

/// The shadow test at a fragment; none if nothing casts shadows, or if this is not a fragment.
std::optional<ShadowTerms> shadow_of(const Frame& frame, const Cursor& cursor) {
    if (occluders_of(frame) == nullptr) return std::nullopt;
    const std::optional<FragmentReport> report = fragment_report(frame, cursor);
    if (!report) return std::nullopt;
    return report->shading == Shading::flat ? report->light_per_triangle.shadow
                                            : report->light.shadow;
}

Json to_json(const ShadowTerms& shadow, const Frame& frame) {
    Json object{{"asked", shadow.is_tested}, {"lit", shadow.lit}};
    if (!shadow.is_tested) return object;
    if (shadow.face < 0) {
        if (!shadow.hit.is_hit()) return object;
        object["name"] = part_name(*frame.in_order, shadow.hit.triangle);
        // With another order, its number in the list that is drawn stands in no report.
        object[frame.list == nullptr ? "triangle" : "scene_triangle"] = shadow.hit.triangle;
        object["way"] = shadow.hit.t;
        return object;
    }
    Json texels = Json::array();
    for (int i = 0; i < shadow.texel_count; ++i) {
        const ShadowTexel& texel = shadow.texels[static_cast<std::size_t>(i)];
        Json one{{"column", texel.column}, {"lit", texel.is_lit}, {"row", texel.row}};
        if (texel.inv_depth > 0.0f) one["z"] = 1.0f / texel.inv_depth;
        texels.push_back(std::move(one));
    }
    object["bias"] = shadow.bias;
    object["face"] = shadow_face_names[static_cast<std::size_t>(shadow.face)];
    object["texels"] = std::move(texels);
    object["z"] = shadow.from_face.z;
    return object;
}

/// The numbers of some of the samples of a pixel.
Json samples_of(SampleMask mask) {
    Json numbers = Json::array();
    for (int sample = 0; sample < sample_count; ++sample) {
        if (has_sample(mask, sample)) numbers.push_back(sample);
    }
    return numbers;
}

Json to_json(const ResolveEvent& event, const Cursor& to) {
    Json samples = Json::array();
    for (const glm::vec3& sample : event.samples)
        samples.push_back(vector_to_json(sample));
    return {{"colour", vector_to_json(event.colour)},
            {"cursor", to_text(event.cursor)},
            {"drawn", event.cursor < to},
            {"samples", std::move(samples)}};
}

Json to_json(const Frame& frame, const PixelEntry& entry, bool stays, const Cursor& to) {
    const Scene& scene = *frame.scene;
    const bool is_in_a_row = entry.row >= 0;
    Json object{{"colour_after", vector_to_json(entry.colour_after)},
                {"colour_before", vector_to_json(entry.colour_before)}};
    if (is_in_a_row) object["column"] = entry.column;
    object["cursor"] = moment_text(frame, entry.cursor);
    object["depth"] = entry.depth;
    object["drawn"] = entry.cursor < to;
    object["fate"] = word_of(entry.fate);
    object["margin"] = entry.margin;
    object["margin_to_winner"] = entry.margin_to_winner;
    object["name"] = part_name(scene, entry.cursor.triangle);
    if (frame.shifts) {
        const std::optional<FragmentReport> report = fragment_report(frame, entry.cursor);
        if (report && report->parallax) object["parallax"] = to_json(*report->parallax);
    }
    if (is_in_a_row) object["row"] = entry.row;
    if (entry.covered != 0)
        object["samples"] = {{"covered", samples_of(entry.covered)},
                             {"passed", samples_of(entry.passed)}};
    if (!scene.sources.empty())
        object["scene_triangle"] = scene_triangle(scene, entry.cursor.triangle);
    if (const auto shadow = shadow_of(frame, entry.cursor))
        object["shadow"] = to_json(*shadow, frame);
    object["stays"] = stays;
    object["stored"] = entry.stored;
    object["stored_zinv"] = entry.stored; // its name before other values could be stored
    if (const auto texture = texture_report(frame, entry.cursor))
        object["texture"] = to_json(*texture);
    object["triangle"] = entry.cursor.triangle;
    object["zinv"] = entry.zinv;
    return object;
}

Json to_json(const Frame& frame, const TestEvent& event, const Cursor& to) {
    Json values = Json::array(), edges = Json::array();
    for (const std::int64_t e : event.test.e)
        values.push_back(in_square_pixels(e));
    for (const int number : event.test.edges)
        edges.push_back(number < 0 ? Json() : Json(number)); // an inner edge has no number
    return {{"asked", event.cursor < to},
            {"edge_functions", std::move(values)},
            {"edges", std::move(edges)},
            {"fan_triangle", event.test.triangle},
            {"inside", event.test.is_inside},
            {"is_corner_given_away", event.test.is_given_corner},
            {"moment", moment_text(frame, event.cursor)},
            {"passes", event.test.passes},
            {"weights", event.test.weights}};
}

Json to_json(const Scene& scene, const NearTriangle& near, const glm::ivec2& pixel) {
    Json rules = Json::array();
    for (const OtherRule& rule : near.rules)
        rules.push_back({{"left", rule.left}, {"right", rule.right}, {"rule", rule.rule}});
    Json object{{"columns_away", near.columns_away}};
    if (!near.is_empty) object["left"] = near.left;
    object["name"] = part_name(scene, near.triangle);
    if (!near.is_empty) object["right"] = near.right;
    object["row"] = near.row;
    object["rows_away"] = near.rows_away;
    object["rules"] = std::move(rules);
    object["triangle"] = near.triangle;
    object["why"] = miss_text(near);
    object["would_need"] = rules_text(near, pixel);
    return object;
}

/// Room for the name of a part, and of the scene's triangle if another one is drawn; longer ones
/// push the rest of their line to the right.
std::size_t name_width(const Scene& scene) {
    return scene.sources.empty() ? 16 : 34;
}

/// Of the column of moments: those of squares are longer.
std::size_t moment_width(const Frame& frame) {
    return frame.squares == nullptr && frame.pass == 0 ? 15 : 20;
}

/// The pixel's colour when everything before `to` is drawn; of several samples, that of sample 0
/// until they are resolved.
glm::vec3 colour_at(const PixelHistory& history, const Cursor& to) {
    glm::vec3 colour(0.0f);
    if (history.resolve && history.resolve->cursor < to) return history.resolve->colour;
    for (const PixelEntry& entry : history.entries) {
        const bool is_shown = entry.covered == 0 || has_sample(entry.passed, 0);
        if (entry.cursor < to && is_shown) colour = entry.colour_after;
    }
    return colour;
}

Json to_json(const Frame& frame, const PixelHistory& history, const Cursor& to) {
    const Scene& scene = *frame.scene;
    Json entries = Json::array(), nearest = Json::array();
    for (std::size_t i = 0; i < history.entries.size(); ++i) {
        const bool stays = static_cast<int>(i) == history.winner;
        entries.push_back(to_json(frame, history.entries[i], stays, to));
    }
    for (const NearTriangle& near : history.nearest)
        nearest.push_back(to_json(scene, near, history.pixel));
    Json object{{"colour", vector_to_json(colour_at(history, to))},
                {"column", history.pixel.x},
                {"covered", !history.entries.empty()},
                {"depth_holds", depth_words(frame).name},
                {"depth_tested", history.depth_tested},
                {"history", std::move(entries)},
                {"row", history.pixel.y},
                {"uncovered", std::move(nearest)}};
    if (history.resolve) object["resolve"] = to_json(*history.resolve, to);
    if (!history.tests.empty()) {
        Json tests = Json::array();
        for (const TestEvent& event : history.tests)
            tests.push_back(to_json(frame, event, to));
        object["tests"] = std::move(tests);
    }
    return object;
}

/// Each test of the pixel, if edge functions are used.
void print_tests(const Frame& frame, const PixelHistory& history, const Cursor& to,
                 std::ostream& out) {
    for (const TestEvent& event : history.tests) {
        out << fmt::format("{:<15}  {}{}\n", moment_text(frame, event.cursor),
                           pixel_test_text(event.test),
                           event.cursor < to ? "" : "  not tested yet");
    }
}

/// The fragment that stays; null if none does.
const PixelEntry* winner_of(const PixelHistory& history) {
    return history.winner < 0 ? nullptr
                              : &history.entries[static_cast<std::size_t>(history.winner)];
}

/// What the fragment that stays took from its texture.
void print_texture(const Frame& frame, const PixelHistory& history, std::ostream& out) {
    const PixelEntry* const winner = winner_of(history);
    if (winner == nullptr) return;
    const std::optional<TextureReport> texture = texture_report(frame, winner->cursor);
    if (!texture) return;
    out << fmt::format("texture {}: u {:.6f}, v {:.6f}; reaches {:.3f} texels to the next column, "
                       "{:.3f} to the next row; level {:.4f}.\n",
                       texture->surface.texture->name, texture->place.texcoord.x,
                       texture->place.texcoord.y, texture->right, texture->down, texture->level);
    for (const SampledTexel& texel : texture->taken) {
        out << fmt::format("  level {}  column {:>4}  row {:>4}  weight {:.6f}  {:.4f} {:.4f} "
                           "{:.4f}\n",
                           texel.level, texel.column, texel.row, texel.weight, texel.colour.r,
                           texel.colour.g, texel.colour.b);
    }
}

/// Whether the lamp's light arrives at the fragment that stays.
void print_shadow(const Frame& frame, const PixelHistory& history, std::ostream& out) {
    const PixelEntry* const winner = winner_of(history);
    if (winner == nullptr) return;
    if (const std::optional<ShadowTerms> shadow = shadow_of(frame, winner->cursor))
        out << shadow_text(*shadow, frame) << ".\n";
}

const char* word_in_table(Fate fate) {
    switch (fate) {
    case Fate::written:
        break;
    case Fate::depth_failed:
        return "hidden";
    case Fate::back_facing:
        return "back";
    case Fate::cut_out:
        return "cut out";
    }
    return "written";
}

std::string entry_line(const Frame& frame, const PixelHistory& history, std::size_t i,
                       const Cursor& to) {
    const Scene& scene = *frame.scene;
    const PixelEntry& entry = history.entries[i];
    std::string name = part_words(scene, entry.cursor.triangle);
    name.resize(std::max(name.size(), name_width(scene)), ' '); // bytes
    const glm::vec3& colour = entry.colour_after;
    std::string line =
        fmt::format("{:>3}  {:<{}}  {}  {:>9.6f}  {:>9.6f}  {:>+9.6f}  {:>+9.6f}  {:<7}  {:.4f} "
                    "{:.4f} {:.4f}",
                    i, moment_text(frame, entry.cursor), moment_width(frame), name,
                    depth_kind(frame) == ClipDepth::inv_z ? entry.zinv : entry.depth, entry.stored,
                    entry.margin, entry.margin_to_winner, word_in_table(entry.fate), colour.r,
                    colour.g, colour.b);
    if (entry.covered != 0)
        line +=
            "  covers " + sample_signs(entry.covered) + ", passes " + sample_signs(entry.passed);
    if (static_cast<int>(i) == history.winner) line += "  stays";
    if (entry.cursor >= to) line += "  not drawn yet";
    return line + "\n";
}

void print_text(const Frame& frame, const PixelHistory& history, const Cursor& to,
                std::ostream& out) {
    const Scene& scene = *frame.scene;
    const Stage stage = frame.settings.stage;
    out << "pixel " << history.pixel.x << ',' << history.pixel.y << ", stage "
        << stage_info(frame.settings).name << ": ";
    if (history.entries.empty()) {
        out << "nothing falls on it.\n" << uncovered_text(frame, history.pixel) << '\n';
        for (const NearTriangle& near : history.nearest) {
            const std::string rules = rules_text(near, history.pixel);
            out << short_triangle_name(near.triangle) << " " << part_words(scene, near.triangle)
                << ": " << miss_text(near) << (rules.empty() ? "" : "; ") << rules << ".\n";
        }
        return;
    }
    const char* const what = has_fragments(stage) ? "fragment" : "mark";
    out << counted(static_cast<std::int64_t>(history.entries.size()), what, std::string(what) + "s")
        << ".\n"
        << fmt::format("  #  {:<{}}  {:<{}}  {:>8}     stored     margin  to winner  fate     "
                       "colour after\n",
                       "moment", moment_width(frame), "part", name_width(scene),
                       depth_words(frame).short_name);
    for (std::size_t i = 0; i < history.entries.size(); ++i)
        out << entry_line(frame, history, i, to);
    if (!history.resolve) return;
    const glm::vec3& colour = history.resolve->colour;
    const bool is_late = frame.settings.sample_rule == SampleRule::late_clamp;
    out << fmt::format(
        "     {:<{}}  the mean of four samples, {} clamped: {:.4f} {:.4f} {:.4f}{}\n",
        to_text(history.resolve->cursor), moment_width(frame), is_late ? "then" : "each", colour.r,
        colour.g, colour.b, history.resolve->cursor < to ? "" : "  not resolved yet");
}

/// The numbers of the fragment that stays, section by section.
void print_fragment(const Frame& frame, const std::optional<FragmentReport>& report,
                    std::ostream& out) {
    if (!report) {
        out << "\nNo fragment stays.\n";
        return;
    }
    std::vector<std::string_view> not_in_use{"flat", "triangle_light", "vertex_light",
                                             "pixel_light"};
    std::erase(not_in_use, light_in_use(report->shading));
    out << '\n';
    if (frame.has_samples() && sampling_rule(frame.settings) == Sampling::supersample)
        out << "With supersampling the shader runs at each sample; the numbers of the light are "
               "those of the pixel's centre.\n\n";
    print_formulas(out, report->formulas, not_in_use);
}

} // namespace

void pixel_command(const PixelOptions& options, std::ostream& out) {
    const Session session = open_view(options.view);
    const Frame frame = shown_frame(session);
    const glm::ivec2 pixel = pixel_of(options.pixel, frame.settings.viewport);
    const Cursor to = in_frame(session.cursor, frame.pass);
    const PixelHistory history = pixel_history(frame, pixel);
    const PixelEntry* const winner = winner_of(history);
    const std::optional<FragmentReport> report = options.formulas && winner != nullptr
                                                     ? fragment_report(frame, winner->cursor)
                                                     : std::nullopt;
    if (options.json) {
        Json answer = to_json(frame, history, to);
        if (options.formulas)
            answer["formulas"] = report ? formulas_json(report->formulas) : Json::array();
        print_json(answer, out);
    } else {
        print_text(frame, history, to, out);
        print_texture(frame, history, out);
        print_shadow(frame, history, out);
        print_tests(frame, history, to, out);
        if (options.formulas) print_fragment(frame, report, out);
    }
}

} // namespace rasterwalk
