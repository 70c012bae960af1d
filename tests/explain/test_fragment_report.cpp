#include "explain/fragment_report.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "explain/vertex_report.h"
#include "inspect/pixel_history.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/formula_checks.h"
#include "support/made_scene.h"
#include "support/random.h"
#include "support/samples.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using rasterwalk::test::same_bits;

namespace {

constexpr Quantity places[] = {quantity_of(&Varyings::position_world, 0),
                               quantity_of(&Varyings::position_world, 1),
                               quantity_of(&Varyings::position_world, 2)};
constexpr Quantity colours[] = {quantity_of(&Varyings::illumination, 0),
                                quantity_of(&Varyings::illumination, 1),
                                quantity_of(&Varyings::illumination, 2)};

/// Keeps a given number of the drawn fragments, each with the same chance.
std::vector<FragmentEvent> some_fragments(const Frame& frame, int count) {
    std::vector<FragmentEvent> kept;
    int seen = 0;
    test::Random random{1};
    const Observer sample{.fragment = [&](const FragmentEvent& event) {
        if (seen++ < count) {
            kept.push_back(event);
            return;
        }
        const int place = random.integer(0, seen - 1);
        if (place < count) kept[static_cast<std::size_t>(place)] = event;
    }};
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &sample);
    return kept;
}

float result(const FragmentReport& report, const std::string& id) {
    const Formula* const formula = find_formula(report.formulas, id);
    if (formula == nullptr) FAIL("no formula " << id);
    return formula->result.value;
}

/// Does the setting of this name contain this number?
bool setting_has(const Settings& settings, const std::string& name, float value) {
    Settings copy = settings;
    const Setting* const setting = find_setting(name);
    if (setting == nullptr) return false;
    if (const auto* number = std::get_if<NumberSetting>(&setting->kind)) {
        return number->value(copy) == value;
    }
    if (const auto* vector = std::get_if<VectorSetting>(&setting->kind)) {
        const glm::vec3 v = vector->value(copy);
        return v.x == value || v.y == value || v.z == value;
    }
    return false;
}

/// The end of the row as the drawing's own row table has it, if the drawing interpolates this way.
void check_row_end(const FragmentReport& report, const PolygonRows& rows, const std::string& id,
                   const FormulaInput& input, const std::string& where) {
    const RowEnd& end =
        input.source.is_right ? rows.right[report.cursor.index] : rows.left[report.cursor.index];
    constexpr std::array<const char*, interpolation_count> in_force{
        ".carried", ".affine", ".carried_mixed", ".carried_twice", ".carried", ".carried"};
    const char* const suffix = in_force[static_cast<std::size_t>(report.interpolation)];
    std::optional<float> expected;
    if (id == "column") expected = static_cast<float>(end.column);
    if (id == "zinv") expected = end.inv_w;
    if (id == "z.affine") expected = end.z;
    for (const Quantity q : places) {
        if (id == std::string(quantity_info(q).words.id) + suffix) {
            expected = part_of(end.varyings, q);
        }
    }
    if (input.symbol == "zl" || input.symbol == "zr") expected = end.inv_w;
    if (input.source.row != rows.first_row + report.cursor.index)
        FAIL(where << id << " names row " << input.source.row);
    if (expected && !same_bits(*expected, input.number.value)) {
        FAIL(where << id << ": " << input.symbol << " is " << input.number.value
                   << " and the row table has " << *expected);
    }
}

void check_sources(const Frame& frame, const FragmentReport& report, const std::string& where) {
    PolygonRows rows;
    test::compute_polygon_rows(frame.triangle_vertices(report.cursor.triangle), frame.settings,
                               rows);
    const VertexReport vertex = vertex_report(frame, report.cursor.triangle, 0);
    for (const Formula& formula : report.formulas) {
        for (const FormulaInput& input : formula.inputs) {
            const Source& source = input.source;
            const Formula* named = nullptr;
            bool found = true;
            switch (source.kind) {
            case SourceKind::given:
                found = !source.name.empty();
                break;
            case SourceKind::setting:
                found = setting_has(frame.settings, source.name, input.number.value);
                break;
            case SourceKind::vertex:
                REQUIRE(source.vertex == 0);
                named = find_formula(vertex.formulas, source.name);
                found = named != nullptr && same_bits(named->result.value, input.number.value);
                break;
            case SourceKind::row_end:
                check_row_end(report, rows, formula.id, input, where);
                break;
            case SourceKind::moment:
                found = source.moment < report.cursor;
                break;
            case SourceKind::texel: {
                const ShadowMap& map = *frame.occluders.map;
                const std::vector<float>& face =
                    map.faces[static_cast<std::size_t>(source.face)].inv_depth;
                const int at = source.row * map.resolution + source.column;
                found = same_bits(face[static_cast<std::size_t>(at)], input.number.value);
                break;
            }
            case SourceKind::formula:
                named = find_formula(report.formulas, source.name);
                found = named != nullptr && same_bits(named->result.value, input.number.value);
                break;
            }
            if (!found) {
                FAIL(where << formula.id << ": " << input.symbol << " = " << input.number.value
                           << " does not come from " << source_text(source) << ' ' << source.name);
            }
        }
    }
}

/// What the report shows is what draw() used and did.
/// @param is_ndc smaller is nearer
void check_against_event(const FragmentReport& report, const FragmentEvent& event, bool is_ndc,
                         const std::string& where) {
    const auto expect = [&](const char* what, float shown_number, float used) {
        if (!same_bits(shown_number, used)) {
            FAIL(where << what << " shows " << shown_number << ", draw used " << used);
        }
    };
    if (report.pixel != glm::ivec2(event.fragment.column, event.fragment.row)) {
        FAIL(where << "reports on another pixel");
    }
    expect("column", result(report, "column"), static_cast<float>(event.fragment.column));
    expect("zinv", result(report, "zinv"), event.fragment.inv_w);
    expect("z.affine", result(report, "z.affine"), event.fragment.z);
    expect("depth", result(report, "depth"), event.depth);
    expect("margin", result(report, "margin"),
           is_ndc ? event.stored - event.depth : event.depth - event.stored);
    if (report.fate != event.fate) FAIL(where << "has a different fate");
    const Varyings used = test::recover_varyings(event.fragment, report.interpolation);
    for (const Quantity q : places) {
        expect("place", result(report, formula_id(q, report.interpolation)), part_of(used, q));
    }
    for (int c = 0; c < 3; ++c) {
        expect("before", report.before[c], event.before[c]);
        expect("after", report.after[c], event.after[c]);
        const std::string name = std::string(quantity_info(colours[c]).words.id);
        std::string id = "pixel_light.R." + name;
        if (report.shading == Shading::gouraud) {
            id = formula_id(colours[c], report.interpolation);
        } else if (report.shading == Shading::unlit) {
            expect("colour", report.colour[c],
                   event.fate == Fate::written ? event.after[c] : report.colour[c]);
            continue;
        }
        expect("shaded", result(report, id), report.colour[c]);
        if (event.fate == Fate::written) expect("colour", result(report, id), event.after[c]);
    }
}

struct Case {
    std::string name;
    Settings settings;
};

std::vector<Case> cases_of(const Scene& scene) {
    std::vector<Case> cases;
    for (const test::Variant& variant : test::rule_variants()) {
        for (const test::Pose& pose : test::room_poses()) {
            for (const StripStep& stage :
                 {StripStep{Stage::fill}, StripStep::vertex_light, StripStep::pixel_light}) {
                Settings settings = default_settings(scene);
                variant.apply(settings);
                set_step(settings, stage);
                settings.camera = pose.camera;
                settings.viewport = pose.viewport;
                settings.light.power = glm::vec3(14.0f);
                cases.push_back({variant.name + ", " + pose.name + ", stage " +
                                     std::to_string(strip_place(stage)) + ": ",
                                 settings});
            }
        }
    }
    return cases;
}

/// A ray through the middle of a pixel against the plane of a triangle, in double, from the
/// vertices of the scene, without using the pipeline.
class RayCaster {
  public:
    RayCaster(const Scene& scene, const Settings& settings) : scene_(scene), settings_(settings) {
        const double cy = std::cos(double(settings.camera.yaw));
        const double sy = std::sin(double(settings.camera.yaw));
        const double cp = std::cos(double(settings.camera.pitch));
        const double sp = std::sin(double(settings.camera.pitch));
        // The columns of R are the camera's right, down and forward axes.
        right_ = {cy, 0.0, -sy};
        down_ = {sp * sy, cp, sp * cy};
        forward_ = {cp * sy, -sp, cp * cy};
    }

    /// The point of the triangle's plane that is seen at this place of the picture, pixels from its
    /// middle.
    glm::dvec3 hit(int triangle, double x, double y) const {
        const glm::dvec3 a = corner(triangle, 0);
        const glm::dvec3 normal = glm::cross(corner(triangle, 1) - a, corner(triangle, 2) - a);
        const glm::dvec3 eye(settings_.camera.position);
        const double f = settings_.camera.focal_length;
        const glm::dvec3 ray = right_ * (x / f) + down_ * (y / f) + forward_;
        return eye + ray * (glm::dot(a - eye, normal) / glm::dot(ray, normal));
    }

    /// Where a point is seen, pixels from the middle of the picture.
    glm::dvec2 pixel_at(const glm::dvec3& point) const {
        const glm::dvec3 d = point - glm::dvec3(settings_.camera.position);
        const double f = settings_.camera.focal_length;
        const double z = glm::dot(d, forward_);
        return {f * glm::dot(d, right_) / z, f * glm::dot(d, down_) / z};
    }

    /// The place by affine interpolation: the corners blended by the areas that they span in the
    /// picture.
    glm::dvec3 affine(int triangle, double x, double y) const {
        const glm::dvec2 a = pixel_at(corner(triangle, 0)), b = pixel_at(corner(triangle, 1)),
                         c = pixel_at(corner(triangle, 2));
        const glm::dvec2 p(x, y);
        const auto area = [](const glm::dvec2& u, const glm::dvec2& v) {
            return u.x * v.y - u.y * v.x;
        };
        const double whole = area(b - a, c - a);
        const double wa = area(b - p, c - p) / whole, wb = area(c - p, a - p) / whole;
        return wa * corner(triangle, 0) + wb * corner(triangle, 1) +
               (1.0 - wa - wb) * corner(triangle, 2);
    }

  private:
    glm::dvec3 corner(int triangle, int v) const {
        return glm::dvec3(scene_.corner(triangle, v).position);
    }
    const Scene& scene_;
    const Settings& settings_;
    glm::dvec3 right_, down_, forward_;
};

} // namespace

TEST_CASE("Fragments of the room report what draw used, and follow from it") {
    const Scene room = test::lab_room();
    const int of_each = test::rounds(40, 6);
    const std::vector<Case> cases = test::some_of(cases_of(room), 8);
    int fragments = 0, written = 0, failed = 0, stored_by_someone = 0;
    for (const Case& c : cases) {
        const Frame frame = prepare_frame(room, c.settings);
        for (const FragmentEvent& event : some_fragments(frame, of_each)) {
            const std::string where = c.name + to_text(event.cursor) + " ";
            const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
            if (!report) FAIL(where << "has no report");
            check_against_event(*report, event, depth_kind(frame) == ClipDepth::ndc, where);
            for (const Formula& formula : report->formulas) {
                const float again = evaluate(formula);
                if (!same_bits(again, formula.result.value)) {
                    FAIL(where << formula.id << " = " << formula.expression << " = "
                               << with_numbers(formula) << " gives " << again << " and shows "
                               << formula.result.value);
                }
            }
            check_sources(frame, *report, where);
            ++fragments;
            ++(event.fate == Fate::written ? written : failed);
            stored_by_someone += report->stored_by ? 1 : 0;
            const bool is_clear = event.stored == depth_clear_rule(c.settings, SceneSpace::world);
            // Where rows have only columns, 0 is also what fragments store.
            const bool may_look_clear = c.settings.row_search == RowSearch::column_only;
            if (is_clear ? report->stored_by && !may_look_clear : !report->stored_by) {
                FAIL(where << "does not know who stored " << event.stored);
            }
        }
    }
    CHECK(10 * fragments > 9 * of_each * static_cast<int>(cases.size()));
    CHECK(5 * written > fragments);
    CHECK(25 * failed > fragments);
    CHECK(5 * stored_by_someone > fragments);
}

TEST_CASE("The other interpolation is what drawing with that setting gives") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    set_step(settings, StripStep::vertex_light);
    const Frame frame = prepare_frame(room, settings);
    settings.interpolation = Interpolation::affine;
    const Frame other = prepare_frame(room, settings);
    for (const FragmentEvent& event : some_fragments(other, test::rounds(500, 150))) {
        const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
        REQUIRE(report);
        if (!same_bits(report->under(Interpolation::affine).position_world,
                       event.fragment.varyings.position_world) ||
            !same_bits(report->under(Interpolation::affine).illumination,
                       event.fragment.varyings.illumination)) {
            FAIL(to_text(event.cursor) << " has different affine values");
        }
    }
}

TEST_CASE("The other lighting is what drawing with that stage gives") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    set_step(settings, StripStep::vertex_light);
    const Frame by_vertex = prepare_frame(room, settings);
    set_step(settings, StripStep::pixel_light);
    const Frame by_pixel = prepare_frame(room, settings);
    const int of_each = test::rounds(500, 150);
    int written = 0;
    const auto check = [&](const Frame& drawn, const Frame& reported, bool per_vertex) {
        for (const FragmentEvent& event : some_fragments(drawn, of_each)) {
            if (event.fate != Fate::written) continue;
            const std::optional<FragmentReport> report = fragment_report(reported, event.cursor);
            REQUIRE(report);
            const glm::vec3 colour =
                per_vertex ? report->light_per_vertex : report->light.reflected;
            if (!same_bits(colour, event.after)) {
                FAIL(to_text(event.cursor) << " has different light under the other stage");
            }
            ++written;
        }
    };
    check(by_vertex, by_pixel, true);
    check(by_pixel, by_vertex, false);
    CHECK(written > of_each);
}

TEST_CASE(
    "The perspective-correct place is where a ray meets the triangle; the affine one is not") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    set_rounding(settings, Rounding::round);
    settings.line_walk = LineWalk::exact;
    const Frame frame = prepare_frame(room, settings);
    const RayCaster rays(room, settings);
    double largest_shift = 0.0, largest_distance = 0.0, largest_affine = 0.0,
           largest_disagreement = 0.0;
    int fragments = 0;
    const int wanted = test::rounds(4000, 1000);
    for (const FragmentEvent& event : some_fragments(frame, wanted)) {
        const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
        REQUIRE(report);
        const double x = report->pixel.x - settings.viewport.width / 2;
        const double y = report->pixel.y - settings.viewport.height / 2;
        const int t = event.cursor.triangle;
        const glm::dvec3 hit = rays.hit(t, x, y);
        const glm::dvec3 right_way(report->under(Interpolation::perspective).position_world);
        const glm::dvec3 wrong_way(report->under(Interpolation::affine).position_world);
        const double shift = glm::length(rays.pixel_at(right_way) - glm::dvec2(x, y));
        largest_shift = std::max(largest_shift, shift);
        largest_distance = std::max(largest_distance, glm::length(right_way - hit));
        largest_affine = std::max(largest_affine, glm::length(wrong_way - hit));
        const glm::dvec3 shown(result(*report, "x.off"), result(*report, "y.off"),
                               result(*report, "z_world.off"));
        const glm::dvec3 oracle = glm::abs(rays.affine(t, x, y) - hit);
        largest_disagreement = std::max(largest_disagreement, glm::length(shown - oracle));
        ++fragments;
    }
    // Measured: 0.74 pixels, 0.082 world units, 0.0084 world units. The first is the price of row
    // ends and vertices that are whole pixels, and the second the same seen on the blocks' steep
    // sides. The affine place is wrong by 0.48.
    CHECK(4 * fragments > 3 * wanted);
    CHECK(largest_shift < 1.0);
    CHECK(largest_distance < 0.1);
    CHECK(largest_affine > 0.4);
    CHECK(largest_disagreement < 0.01);
}

TEST_CASE("The divisor of values has the same name in each of a fragment's formulas") {
    const Scene scene = test::lab_room();
    for (const float mix : {0.0f, 0.5f, 1.0f}) {
        Settings settings = default_settings(scene);
        settings.stage = Stage::depth;
        settings.projection_mix = mix;
        const Frame frame = prepare_frame(scene, settings);
        std::optional<FragmentReport> report;
        for (int t = 0; t < frame.triangle_count() && !report; ++t)
            report = fragment_report(frame, {t, Phase::rows, 5, 0});
        REQUIRE(report);
        const std::string word = mix > 0.0f ? "1/w" : "1/z", other = mix > 0.0f ? "1/z" : "1/w";
        const Formula* const weight = find_formula(report->formulas, "zinv");
        REQUIRE(weight != nullptr);
        CHECK(weight->name == word);
        CHECK(weight->help == quantity_in(frame, Quantity::zinv).words.help);
        for (const Formula& formula : report->formulas) {
            if (formula.id.rfind("depth", 0) == 0) continue; // depth names it differently
            CAPTURE(formula.id, mix);
            CHECK(formula.name.find(other) == std::string::npos);
            CHECK(formula.expression.find(other) == std::string::npos);
            CHECK(formula.help.find(other) == std::string::npos);
        }
    }
}

TEST_CASE("Moments without a fragment in the picture have no report") {
    const Scene scene = test::small_scene();
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    const Frame frame = prepare_frame(scene, settings);
    const Cursor none[] = {cursor_begin,
                           cursor_end,
                           {0, Phase::edges, 0, 0},
                           {0, Phase::rows, 99, 0},
                           {0, Phase::rows, 0, 99},
                           {0, Phase::rows, -1, 0},
                           {0, Phase::rows, 0, -1},
                           {-1, Phase::rows, 0, 0},
                           {2, Phase::rows, 0, 0},
                           {5, Phase::rows, 0, 0},
                           {99, Phase::rows, 0, 0}};
    for (const Cursor& cursor : none) {
        INFO(to_text(cursor));
        CHECK_FALSE(fragment_report(frame, cursor));
    }
    CHECK(fragment_report(frame, {0, Phase::rows, 0, 0}));
    settings.stage = Stage::rows;
    CHECK_FALSE(fragment_report(prepare_frame(scene, settings), {0, Phase::rows, 0, 0}));
}

TEST_CASE("Every fragment of a small scene has a report, even with extreme values") {
    const Scene scene = test::small_scene();
    for (const test::Variant& variant : test::some_of(test::rule_variants(), 6)) {
        Settings settings = default_settings(scene);
        variant.apply(settings);
        settings.light.position = scene.corner(0, 0).position; // the lamp on a vertex
        const Frame frame = prepare_frame(scene, settings);
        for (const FragmentEvent& event : some_fragments(frame, 1'000'000)) {
            const std::string where = variant.name + ": " + to_text(event.cursor) + " ";
            const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
            if (!report) FAIL(where << "has no report");
            check_against_event(*report, event, depth_kind(frame) == ClipDepth::ndc, where);
            for (const Formula& formula : report->formulas) {
                if (!same_bits(evaluate(formula), formula.result.value)) {
                    FAIL(where << formula.id << " does not follow from its inputs");
                }
            }
        }
    }
}

TEST_CASE("A pixel shows the fragment that owns it, and before that the one it will show") {
    const Scene room = test::lab_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    const Framebuffer whole = draw_frame(frame);
    test::Random random(5);
    for (int i = 0; i < 300; ++i) {
        const glm::ivec2 pixel{random.integer(0, 499), random.integer(0, 499)};
        INFO("pixel " << pixel.x << ',' << pixel.y);
        const std::int32_t owner = whole.owner[whole.at(pixel.x, pixel.y)];
        const std::optional<Cursor> last = fragment_on_pixel(frame, pixel, cursor_end);
        REQUIRE(last.has_value() == (owner >= 0));
        if (!last) continue;
        CHECK(last->triangle == owner);
        CHECK(fragment_report(frame, *last)->pixel == pixel);
        CHECK(fragment_on_pixel(frame, pixel, cursor_begin) == last);
        CHECK(fragment_on_pixel(frame, pixel, *last)->triangle <= owner);
    }
    CHECK_FALSE(fragment_on_pixel(frame, {-1, 0}, cursor_end));
    CHECK_FALSE(fragment_on_pixel(frame, {0, 500}, cursor_end));
}

TEST_CASE("With samples a row is that of the frame, and each formula gives its number") {
    const Scene scene = test::small_scene();
    const std::vector<std::vector<std::string>> ways{
        {"stage=fill", "hidden=warnock"},
        {"stage=pixel_light", "hidden=warnock"},
        {"stage=depth", "sample_rule=late_clamp"},
        {"stage=depth", "sample_rule=centre_depth"},
        {"stage=depth", "depth_test=linear_z"},
        {"stage=depth", "depth_test=linear_z", "sample_rule=centre_depth"},
        {"stage=depth", "depth_format=ndc_32", "sample_rule=late_clamp"},
        {"stage=fill", "weight_edge=own"},
        {"stage=fill", "weight_edge=own", "coverage=scan_conversion"},
        {"stage=fill", "weight_edge=own", "coverage=active_edges"},
        {"stage=rows"}};
    int checked = 0, rows_checked = 0;
    for (const std::vector<std::string>& way : ways) {
        Settings settings = default_settings(scene);
        set_from_text(settings, "coverage=edge_functions");
        std::string name;
        for (const std::string& assignment : way) {
            set_from_text(settings, assignment);
            name += assignment + " ";
        }
        settings.samples = 4;
        CAPTURE(name);
        const Frame frame = prepare_frame(scene, settings);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            if (!frame.is_drawn(t)) continue;
            PolygonRows rows;
            compute_rows(frame, t, rows);
            for (int r = 0; r < rows.size(); ++r) {
                const std::optional<CarriedRow> row = carried_row(frame, t, r);
                REQUIRE(row.has_value() == !rows.is_empty_row(r));
                if (!row) continue;
                const RowEnds& ends = row->under(Interpolation::perspective);
                CHECK(ends.left.column == rows.left[static_cast<std::size_t>(r)].column);
                CHECK(ends.right.column == rows.right[static_cast<std::size_t>(r)].column);
                ++rows_checked;
            }
        }
        if (!frame.has_samples()) continue; // squares and marks have none
        for (const FragmentEvent& event : some_fragments(frame, 40)) {
            const std::optional<FragmentReport> report = fragment_report(frame, event.cursor);
            REQUIRE(report);
            CHECK(report->covered == event.covered);
            test::check_formulas(frame, report->formulas, name + to_text(event.cursor));
            ++checked;
        }
    }
    CHECK(checked > 100);
    CHECK(rows_checked > 100);
}

TEST_CASE("A resolved pixel with samples shows the winner of its history") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    settings.viewport = {60, 60};
    settings.camera.focal_length = 60.0f;
    set_from_text(settings, "coverage=edge_functions");
    settings.samples = 4;
    const Frame frame = prepare_frame(room, settings);
    test::Random random(6);
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        const glm::ivec2 pixel{random.integer(0, 59), random.integer(0, 59)};
        CAPTURE(pixel.x, pixel.y);
        const PixelHistory history = pixel_history(frame, pixel);
        const std::optional<Cursor> shown = fragment_on_pixel(frame, pixel, cursor_end);
        REQUIRE(shown.has_value() == (history.winner >= 0));
        if (!shown) continue;
        CHECK(*shown == history.entries[static_cast<std::size_t>(history.winner)].cursor);
        CHECK(fragment_on_pixel(frame, pixel, cursor_begin) == shown);
        ++found;
    }
    CHECK(found > 50);
}
