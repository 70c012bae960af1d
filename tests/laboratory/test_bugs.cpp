// The bug laboratory: every mistake shows its described symptom, on its own scene, and nothing
// else.

#include "laboratory/bug.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "compare/compare.h"
#include "explain/vertex_spaces.h"
#include "inspect/edge_lines.h"
#include "inspect/stats.h"
#include "lessons/lesson_link.h"
#include "mistakes/coverage.h"
#include "picture/pixel_facts.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/moved_point.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::vector<Bug>& bugs() {
    static const std::vector<Bug> all = read_bugs();
    return all;
}

/// Both runs of a bug on its own scene, drawn and counted.
struct Runs {
    Session session;
    Frame wrong, correct;
    Framebuffer wrong_picture, correct_picture;
    FrameStats wrong_stats, correct_stats;

    explicit Runs(std::string_view id) {
        session = open_session(lessons_folder() + "/scenes/lab-room.toml");
        open_bug(find_bug(bugs(), id), session);
        draw_again();
    }
    Runs(const Runs&) = delete;
    Runs& operator=(const Runs&) = delete;

    void draw_again() {
        wrong = prepare_frame(*session.scene, session.a.settings);
        correct = prepare_frame(*session.scene, session.b->settings);
        wrong_stats = frame_stats(wrong, cursor_end, wrong_picture);
        correct_stats = frame_stats(correct, cursor_end, correct_picture);
    }
    std::size_t pixel_count() const { return wrong_picture.colour.size(); }
    std::int64_t different_pixels() const {
        return pixel_difference(wrong_picture, correct_picture).different;
    }
};

/// Every plane is the same to the last bit.
bool same_planes(const Framebuffer& a, const Framebuffer& b) {
    return a.colour == b.colour && a.depth == b.depth && a.owner == b.owner &&
           a.overdraw == b.overdraw;
}

/// Both have the same fragments with the same fate; only colours can differ.
bool same_but_for_colour(const Framebuffer& a, const Framebuffer& b) {
    return a.depth == b.depth && a.owner == b.owner && a.overdraw == b.overdraw;
}

/// All work of a frame, in chronological order.
std::vector<FragmentEvent> fragments_of(const Frame& frame) {
    Recorder recorder;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    return recorder.fragments;
}

/// The fragment of this moment, or none.
const FragmentEvent* fragment_at(const std::vector<FragmentEvent>& all, const Cursor& cursor) {
    const auto found = std::lower_bound(
        all.begin(), all.end(), cursor,
        [](const FragmentEvent& event, const Cursor& time) { return event.cursor < time; });
    return found != all.end() && found->cursor == cursor ? &*found : nullptr;
}

/// Row tables of all triangles that are drawn.
std::vector<PolygonRows> tables_of(const Frame& frame) {
    std::vector<PolygonRows> tables;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        compute_polygon_rows(frame.triangle_vertices(t), frame.settings, tables.emplace_back());
    }
    return tables;
}

/// The light at the visible point of every pixel, under the rules of another frame.
std::vector<LightTerms> lights_of(const Frame& frame, const LightRules& rules) {
    Recorder recorder;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    std::vector<LightTerms> lights(framebuffer.colour.size());
    for (const FragmentEvent& event : recorder.fragments) {
        if (event.fate != Fate::written) continue;
        const Vertex& corner = frame.scene->corner(event.cursor.triangle, 0);
        lights[framebuffer.at(event.fragment.column, event.fragment.row)] = reflected_light(
            recover_varyings(event.fragment, frame.settings.interpolation).position_world,
            corner.normal, corner.reflectance, frame.settings.light, rules);
    }
    return lights;
}

std::string fault_of(const std::string& text) {
    try {
        parse_bugs(text, "bugs.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

const std::string whole_bug = "[[bug]]\nid = \"B9\"\nname = \"n\"\nsentence = \"s\"\n"
                              "symptom = \"y\"\nlook = \"l\"\ncure = \"c\"\nsection = \"e\"\n"
                              "scene = \"scenes/lab-room.toml\"\nset = [\"spans=last_dropped\"]\n";

std::string with(const std::string& from, const std::string& to) {
    std::string text = whole_bug;
    text.replace(text.find(from), from.size(), to);
    return text;
}

} // namespace

TEST_CASE("The laboratory has the promised mistakes, each with its complete description") {
    const std::set<std::string> promised{
        "B1",   "B2",   "B3",   "B4",   "B5",   "B6",   "B7",   "B8",   "B9",   "B10",  "B11",
        "B12",  "B13",  "B14",  "B15",  "B16",  "B17a", "B17b", "B17c", "B17d", "B18",  "B19",
        "B20a", "B20b", "B20c", "B20d", "B21",  "B22",  "B24",  "B25",  "B27",  "B30",  "B31",
        "B32",  "B33",  "B34",  "B35",  "B36",  "B38",  "B39",  "B40a", "B40b", "B40c", "B41",
        "B42",  "B43",  "B23",  "B50",  "B51",  "B61",  "B63",  "B65",  "B66",  "B67",  "B55",
        "B56",  "B57",  "B58",  "B59",  "B60",  "B70",  "B71",  "B72",  "B73",  "B74",  "B75",
        "B76",  "B77a", "B77b", "B78",  "B79",  "B80",  "B81",  "B82",  "B86",  "B87",  "B88a",
        "B88b", "B89",  "B90",  "B91",  "B92",  "B93",  "B94",  "B95",  "B97",  "B17e", "B98a",
        "B98b", "B98c", "B99",  "B100", "B101", "B102"};
    std::set<std::string> ids, names;
    std::vector<std::string> sections;
    for (const Bug& bug : bugs()) {
        INFO(bug.id);
        ids.insert(bug.id);
        if (sections.empty() || sections.back() != bug.section) sections.push_back(bug.section);
        names.insert(bug.name);
        for (const std::string& text : {bug.sentence, bug.symptom, bug.look, bug.cure})
            CHECK(text.ends_with('.'));
        CHECK(std::filesystem::is_regular_file(lessons_folder() + "/" + bug.scene));
        CHECK_FALSE(bug.code.starts_with('\n'));
    }
    CHECK(ids == promised);
    // In the order of the lab's sections, so that each is one group in the list.
    CHECK(sections == std::vector<std::string>{
                          "Drawing points", "Drawing edges", "Moving the camera",
                          "Filled triangles", "Depth buffer", "Illumination", "Light per pixel",
                          "Beyond the lab: geometry", "Beyond the lab: depth",
                          "Beyond the lab: light", "Beyond the lab: coverage",
                          "Beyond the lab: blending", "Beyond the lab: textures",
                          "Beyond the lab: normal maps", "Beyond the lab: shadows"});
    CHECK(names.size() == ids.size());
}

TEST_CASE("Both runs of a bug differ in its settings and in nothing else") {
    for (const Bug& bug : bugs()) {
        INFO(bug.id);
        Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
        set_rounding(session.a.settings,
                     Rounding::round); // forgotten: bugs start from the lab's rules
        session.cursor = cursor_begin;
        apply_bug(bug, session);
        REQUIRE(session.b);
        CHECK(session.cursor == cursor_begin);
        CHECK(step_of(session.a.settings) == step_of(session.b->settings));
        Settings correct = session.b->settings;
        CHECK_FALSE(session.a.settings == correct);
        for (const auto& [name, value] : bug.set)
            set_from_text(correct, name + "=" + value);
        CHECK(session.a.settings == correct);
        Settings handout = with_handout_rules(session.a.settings);
        handout.light = session.b->settings.light;
        for (const auto& [name, value] : bug.against)
            set_from_text(handout, name + "=" + value);
        set_step(handout, step_of(session.b->settings));
        CHECK(handout == session.b->settings);
    }
}

TEST_CASE("A bug is found by its id in upper or lower case, and a wrong id gets the nearest") {
    CHECK(find_bug(bugs(), "b20A").id == "B20a");
    CHECK_THROWS_AS(find_bug(bugs(), ""), UsageError);
    CHECK_THROWS_WITH(find_bug(bugs(), "B28"), ContainsSubstring("there is no bug 'B28'"));
    CHECK_THROWS_WITH(find_bug(bugs(), std::string(5000, 'x')),
                      !ContainsSubstring(std::string(30, 'x')));
}

TEST_CASE("A file of bugs is read strictly, and every fault has its line") {
    CHECK(fault_of(whole_bug) == "accepted");
    CHECK_THAT(fault_of(with("id = \"B9\"", "id = \"9\"")),
               ContainsSubstring("bugs.toml:2: 'id' must be B"));
    CHECK_THAT(fault_of(with("B9", "B9ab")), ContainsSubstring("bugs.toml:2: "));
    CHECK_THAT(fault_of(with("name = \"n\"\n", "")), ContainsSubstring("'name'"));
    CHECK_THAT(fault_of(with("look", "hint")), ContainsSubstring("bugs.toml:6: "));
    CHECK_THAT(fault_of(with("scenes/lab-room.toml", "../lab-room.toml")),
               ContainsSubstring("bugs.toml:9: 'scene' must be a file in this folder"));
    CHECK_THAT(fault_of(with("scenes/lab-room.toml", "scenes/../../x.toml")),
               ContainsSubstring("bugs.toml:9: "));
    CHECK_THAT(fault_of(with("spans=last_dropped", "spans=last")),
               ContainsSubstring("bugs.toml:10: spans cannot be 'last'"));
    CHECK_THAT(fault_of(with("\"spans=last_dropped\"", "7")),
               ContainsSubstring("bugs.toml:10: each entry"));
    CHECK_THAT(fault_of(with("[\"spans=last_dropped\"]", "[]")),
               ContainsSubstring("bugs.toml:10: 'set'"));
    CHECK_THAT(fault_of(whole_bug + whole_bug), ContainsSubstring("two bugs with the id 'B9'"));
    CHECK_THAT(fault_of("[[bugs]]\n"), ContainsSubstring("bugs.toml:1: "));
    CHECK_THROWS_AS(read_bugs("/nowhere/bugs.toml"), AccessError);
}

TEST_CASE("B1: a sum of steps ends short, and one sample falls above the table") {
    const Runs runs("B1");
    CHECK(runs.wrong_stats.rows_outside == 1);
    CHECK(runs.correct_stats.rows_outside == 0);
    CHECK(runs.different_pixels() == 1);
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    apply_bug(find_bug(bugs(), "B1"), session);
    CHECK(frame_stats(prepare_frame(*session.scene, session.a.settings)).rows_outside == 4);
    CHECK(frame_stats(prepare_frame(*session.scene, session.b->settings)).rows_outside == 0);
}

TEST_CASE("B2: cutting toward zero leaves the first row and column black") {
    const Runs runs("B2");
    int wrong = 0, correct = 0;
    for (int i = 0; i < 500; ++i) {
        for (const glm::ivec2 pixel : {glm::ivec2(i, 0), glm::ivec2(0, i)}) {
            const std::size_t at = runs.wrong_picture.at(pixel.x, pixel.y);
            wrong += runs.wrong_picture.owner[at] >= 0 ? 1 : 0;
            correct += runs.correct_picture.owner[at] >= 0 ? 1 : 0;
        }
    }
    CHECK(runs.wrong_stats.uncovered == 998);
    CHECK(wrong < 5);
    CHECK(correct > 990);
}

TEST_CASE("B3: affine interpolation changes colours alone, most along the walls") {
    const Runs runs("B3");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    CHECK(runs.different_pixels() == 229956);
    const PixelFacts facts = pixel_facts(runs.wrong, cursor_end, {.affine_error = true});
    CHECK(*std::max_element(facts.affine_error.begin(), facts.affine_error.end()) > 0.45f);
}

TEST_CASE("B4: a second 1/z pulls every place toward the origin, and leaves coverage alone") {
    const Runs runs("B4");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    CHECK(runs.different_pixels() == 247928);
    const auto wrong = fragments_of(runs.wrong), correct = fragments_of(runs.correct);
    REQUIRE(wrong.size() == correct.size());
    for (const FragmentEvent& event : wrong) {
        const Cursor& cursor = event.cursor;
        if (cursor.step != 0) continue; // the left end: there it is exactly one 1/z too many
        const FragmentEvent* found = fragment_at(correct, cursor);
        if (!found) FAIL(to_text(cursor) << " is drawn only by the mistake");
        const FragmentEvent& right = *found;
        const glm::vec3 place =
            recover_varyings(event.fragment, runs.wrong.settings.interpolation).position_world;
        const glm::vec3 true_place =
            recover_varyings(right.fragment, runs.correct.settings.interpolation).position_world;
        if (glm::distance(place, true_place * right.fragment.inv_w) > 1e-5f) {
            FAIL(to_text(cursor) << " is not one 1/z too near");
        }
    }
}

TEST_CASE("B5: edges by rows lose columns, and pass the lab's printed table") {
    const Runs runs("B5");
    CHECK(runs.different_pixels() == 7);
    CHECK(runs.wrong_stats.fragments < runs.correct_stats.fragments);
    const auto at = [](int column, int row) {
        return ScreenVertex{{}, column, row, 1.0f, 1.0f, 1.0f, {}};
    };
    const std::vector<ScreenVertex> printed{at(10, 5), at(5, 10), at(15, 15)};
    PolygonRows by_rows, by_axis;
    compute_polygon_rows(printed, runs.wrong.settings, by_rows);
    compute_polygon_rows(printed, runs.correct.settings, by_axis);
    CHECK(by_rows.left == by_axis.left);
    CHECK(by_rows.right == by_axis.right);
}

TEST_CASE("B6: a triangle left of the picture leaves a line of pixels in column 0") {
    const Runs runs("B6");
    int phantoms = 0;
    for (int row = 0; row < 16; ++row) {
        for (int column = 0; column < 20; ++column) {
            const std::size_t at = runs.wrong_picture.at(column, row);
            CHECK(runs.correct_picture.owner[at] != 0);
            const bool phantom =
                runs.wrong_picture.overdraw[at] > runs.correct_picture.overdraw[at];
            phantoms += phantom ? 1 : 0;
            if (phantom) CHECK(column == 0);
            if (column > 0) CHECK(runs.wrong_picture.owner[at] == runs.correct_picture.owner[at]);
        }
    }
    CHECK(phantoms == 13); // twelve rows of the left triangle, one of that half in the picture
}

TEST_CASE("B7: rows that were never set are counted, and none of them is drawn") {
    const Runs runs("B7");
    CHECK(runs.wrong_stats.empty_rows == 5);
    CHECK(runs.correct_stats.empty_rows == 0);
    CHECK(same_planes(runs.wrong_picture, runs.correct_picture));
    CHECK(row_pixel_count_wrapped(empty_left, empty_right) == 3);
    CHECK(row_pixel_count_wrapped(7, 9) == 3);
    CHECK(row_pixel_count_wrapped(500, 0) == -499);
    Results results;
    update(runs.session, results);
    REQUIRE(results.a.warnings.size() == 1);
    CHECK(results.a.warnings[0].sentence ==
          "5 rows that no edge sample reached: right − left + 1 is 3 there, and none of those "
          "pixels are in the picture");
}

TEST_CASE("B8: rows of one pixel vanish, and only they") {
    const Runs runs("B8");
    int single = 0;
    for (const PolygonRows& table : tables_of(runs.correct)) {
        for (int r = 0; r < table.size(); ++r)
            single += row_span({}, table, r).count == 1 ? 1 : 0;
    }
    CHECK(single == 15);
    CHECK(runs.correct_stats.fragments - runs.wrong_stats.fragments == single);
    CHECK(runs.different_pixels() == single);
    // The post, one column wide, is gone; the beam, one row thick, is not.
    CHECK(std::count(runs.wrong_picture.owner.begin(), runs.wrong_picture.owner.end(), 0) == 0);
    CHECK(std::count(runs.wrong_picture.owner.begin(), runs.wrong_picture.owner.end(), 1) == 13);
}

TEST_CASE("B9: every row of every triangle lacks its last fragment, and no other changes") {
    const Runs runs("B9");
    const auto wrong = fragments_of(runs.wrong), correct = fragments_of(runs.correct);
    std::size_t last = 0;
    const std::vector<PolygonRows> tables = tables_of(runs.correct);
    for (const FragmentEvent& event : correct) {
        const Cursor& cursor = event.cursor;
        const PolygonRows& table = tables[static_cast<std::size_t>(cursor.triangle)];
        const bool is_last = cursor.step + 1 == row_span({}, table, cursor.index).count;
        last += is_last ? 1 : 0;
        const FragmentEvent* found = fragment_at(wrong, cursor);
        if ((found != nullptr) == is_last)
            FAIL(to_text(cursor) << " should be the other way round");
        if (found && !same_bits(found->fragment, event.fragment))
            FAIL(to_text(cursor) << " has other numbers");
    }
    CHECK(wrong.size() + last == correct.size());
    CHECK(last == 328789 - 323544);
    CHECK(runs.wrong_stats.uncovered == 1497);
}

TEST_CASE("B10: the first row and the first column are black, and nothing else") {
    const Runs runs("B10");
    CHECK(runs.correct_stats.uncovered == 0);
    for (int row = 0; row < 12; ++row) {
        for (int column = 0; column < 16; ++column) {
            const std::size_t at = runs.wrong_picture.at(column, row);
            const bool is_first = column == 0 || row == 0;
            CHECK((runs.wrong_picture.overdraw[at] == 0) == is_first);
            if (!is_first) CHECK(runs.wrong_picture.colour[at] == runs.correct_picture.colour[at]);
        }
    }
}

TEST_CASE("B11: with an int step lines are level, upright or at 45 degrees") {
    const Runs runs("B11");
    const PolygonCorners v = runs.wrong.triangle_vertices(0);
    for (int e = 0; e < 3; ++e) {
        const ScreenVertex &a = v[e], &b = v[(e + 1) % 3];
        const LineStep line = runs.wrong.stages.line_step(
            line_end(a), line_end(b), {runs.wrong.stages.edge_sample_count(a, b)});
        for (const float step : {line.x, line.y})
            CHECK((step == 0.0f || std::abs(step) == 1.0f));
    }
    CHECK(runs.wrong_stats.fragments == runs.correct_stats.fragments); // as many samples
    CHECK(runs.different_pixels() == 41);
}

TEST_CASE("B12: edges to the right or down lack two samples, the others none") {
    const auto at = [](int column, int row) {
        return ScreenVertex{{}, column, row, 1.0f, 1.0f, 1.0f, {}};
    };
    for (int d = 1; d < 9; ++d) {
        const int right = d + 1, wrong = std::max(d - 1, 1);
        CHECK(edge_sample_count(at(0, 0), at(d, 0), EdgeSamples::shifted) == wrong);
        CHECK(edge_sample_count(at(0, 0), at(0, d), EdgeSamples::shifted) == wrong);
        CHECK(edge_sample_count(at(0, 0), at(d, d), EdgeSamples::shifted) == wrong);
        CHECK(edge_sample_count(at(d, 0), at(0, 0), EdgeSamples::shifted) == right);
        CHECK(edge_sample_count(at(0, d), at(0, 0), EdgeSamples::shifted) == right);
    }
    const Runs runs("B12");
    CHECK(runs.correct_stats.fragments - runs.wrong_stats.fragments == 4);
    CHECK(runs.different_pixels() == 10);
}

TEST_CASE("B38: only lines going right and gently down are correct") {
    const Runs runs("B38");
    CHECK(count_edge_ends(runs.correct) == EdgeEnds{3, 0});
    CHECK(count_edge_ends(runs.wrong) == EdgeEnds{3, 3});
    // Edges 0 and 2 go left and keep one sample; edge 1 goes up and stays level.
    CHECK(row_history(runs.wrong, 0).edge_samples == std::vector<int>{1, 13, 1});
    CHECK(runs.different_pixels() == 33);
}

TEST_CASE("B39: lines fall short along their shorter axis, and keep their number of samples") {
    const Runs runs("B39");
    CHECK(row_history(runs.wrong, 0).edge_samples == row_history(runs.correct, 0).edge_samples);
    CHECK(count_edge_ends(runs.wrong) == EdgeEnds{3, 2});
    CHECK(runs.different_pixels() == 14);
}

TEST_CASE("B13: triangles that reach behind the camera are drawn mirrored, and within bounds") {
    const Runs runs("B13");
    CHECK(runs.correct_stats.left_out.of(Rejection::behind_camera) == 6);
    CHECK(runs.wrong_stats.left_out.total() == 0);
    int mirrored = 0;
    for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
        for (const ScreenVertex& vertex : runs.wrong.triangle_vertices(t)) {
            mirrored += vertex.inv_w < 0.0f ? 1 : 0;
            CHECK(std::abs(vertex.column) < 17000);
        }
        // Triangles wholly in front of the camera are the same.
        if (!runs.correct.is_drawn(t)) continue;
        for (int v = 0; v < 3; ++v) {
            CHECK(same_bits(runs.wrong.triangle_vertices(t)[v],
                            runs.correct.triangle_vertices(t)[v]));
        }
    }
    CHECK(mirrored == 9);
    CHECK(runs.different_pixels() > 10000);
}

TEST_CASE("B14: the triangle with a vertex in column -1 is missing, and no other") {
    const Runs runs("B14");
    CHECK(runs.correct_stats.left_out.total() == 0);
    CHECK(runs.wrong_stats.left_out.of(Rejection::taken_for_behind) == 1);
    for (int t = 0; t < 4; ++t) {
        int in_column = 0;
        for (const ScreenVertex& vertex : runs.correct.triangle_vertices(t))
            in_column += vertex.column == -1 ? 1 : 0;
        CHECK(runs.wrong.is_drawn(t) == (in_column == 0));
    }
    CHECK(runs.different_pixels() == 54);
}

TEST_CASE("B15: vertices are moved to the border, and the wall is bent") {
    const Runs runs("B15");
    int moved = 0;
    for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
        for (int i = 0; i < triangle_corners; ++i) {
            const ScreenVertex& wrong = runs.wrong.given_vertex(t, i).pixel;
            const ScreenVertex& correct = runs.correct.given_vertex(t, i).pixel;
            CHECK(wrong.column == std::clamp(correct.column, 0, 199));
            CHECK(wrong.row == std::clamp(correct.row, 0, 159));
            CHECK(wrong.inv_w == correct.inv_w);
            moved += wrong.column != correct.column ? 1 : 0;
        }
    }
    CHECK(moved == 3);
    CHECK(runs.different_pixels() > 2000);
}

TEST_CASE("B17a and B17b: nothing passes the depth test, and as much is tested") {
    for (const char* id : {"B17a", "B17b"}) {
        const Runs runs(id);
        CHECK(std::count(runs.wrong_picture.owner.begin(), runs.wrong_picture.owner.end(), -1) ==
              250000);
        CHECK(runs.wrong_picture.overdraw == runs.correct_picture.overdraw);
        CHECK(runs.wrong_stats.shaded == 0);
    }
}

TEST_CASE("B17b: fragments nearer than one unit pass a buffer that starts at 1") {
    Runs runs("B17b");
    runs.session.a.settings.camera.position.z = runs.session.b->settings.camera.position.z = -1.2f;
    runs.draw_again();
    int shown = 0;
    for (std::size_t i = 0; i < runs.pixel_count(); ++i) {
        const bool is_near = runs.correct_picture.depth[i] > 1.0f;
        if ((runs.wrong_picture.owner[i] >= 0) != is_near) FAIL("pixel " << i);
        shown += is_near ? 1 : 0;
    }
    CHECK(shown > 0);
}

TEST_CASE("B17c: the depth picture is mirrored in its diagonal, and the colours are the same") {
    const Runs runs("B17c");
    CHECK(runs.wrong_picture.colour == runs.correct_picture.colour);
    const Image wrong = view_image(runs.wrong_picture, View::depth);
    const Image correct = view_image(runs.correct_picture, View::depth);
    CHECK_FALSE(wrong.rgba == correct.rgba);
    for (int row = 0; row < 500; ++row) {
        for (int column = 0; column < 500; ++column) {
            const std::size_t a = 4 * (static_cast<std::size_t>(row) * 500 + column);
            const std::size_t b = 4 * (static_cast<std::size_t>(column) * 500 + row);
            if (wrong.rgba[a] != correct.rgba[b] || wrong.rgba[a + 1] != correct.rgba[b + 1])
                FAIL("pixel " << column << ',' << row);
        }
    }
}

TEST_CASE("B17c: in a picture that is not square the cells outside are not written") {
    for (const Viewport size : {Viewport{60, 40}, Viewport{40, 60}}) {
        Runs runs("B17c");
        runs.session.a.settings.viewport = runs.session.b->settings.viewport = size;
        runs.session.a.settings.camera.focal_length = runs.session.b->settings.camera.focal_length =
            40.0f;
        runs.draw_again();
        std::int64_t outside = 0;
        for (int row = 0; row < size.height; ++row) {
            for (int column = 0; column < size.width; ++column) {
                const std::size_t at = runs.wrong_picture.at(column, row);
                if (column < 40 && row < 40) {
                    CHECK(runs.wrong_picture.depth[at] == runs.correct_picture.depth[at]);
                    CHECK(runs.wrong_picture.owner[at] == runs.correct_picture.owner[at]);
                } else {
                    CHECK(runs.wrong_picture.depth[at] == 0.0f);
                    outside += runs.wrong_picture.overdraw[at];
                }
            }
        }
        CHECK(outside > 0);
        CHECK(runs.wrong_stats.depth_outside == outside);
        Results results;
        update(runs.session, results);
        REQUIRE_FALSE(results.a.warnings.empty());
        CHECK_THAT(results.a.warnings[0].sentence,
                   ContainsSubstring("[x][y] is outside the depth buffer"));
    }
}

TEST_CASE("B17d: every pixel shows the farthest of its fragments") {
    const Runs runs("B17d");
    std::vector<float> farthest(runs.pixel_count(), 1000.0f);
    for (const FragmentEvent& event : fragments_of(runs.wrong)) {
        float& depth = farthest[runs.wrong_picture.at(event.fragment.column, event.fragment.row)];
        depth = std::min(depth, event.fragment.depth);
    }
    CHECK(runs.wrong_picture.depth == farthest);
    CHECK(runs.wrong_picture.overdraw == runs.correct_picture.overdraw);
    CHECK(runs.different_pixels() == 40173);
}

TEST_CASE("B18: the same picture to the last bit, and every fragment shaded") {
    const Runs runs("B18");
    CHECK(same_planes(runs.wrong_picture, runs.correct_picture));
    CHECK(runs.wrong_stats.shaded == 328789);
    CHECK(runs.correct_stats.shaded == 293357);
    const Comparison comparison = compare_runs(runs.wrong, runs.correct);
    CHECK(comparison.is_same());
}

TEST_CASE("B19: with a power of 1.1 the direct light is a tenth of the indirect") {
    const Runs runs("B19");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    const std::vector<LightTerms> lights = lights_of(runs.wrong, {});
    double sum = 0.0;
    for (const LightTerms& light : lights)
        sum += static_cast<double>(light.direct.r);
    CHECK(sum / 250000.0 == Approx(0.046).margin(0.002));
}

TEST_CASE("B20a: only surfaces facing away from the lamp have direct light") {
    const Runs runs("B20a");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    const std::vector<LightTerms> right = lights_of(runs.correct, {});
    const std::vector<LightTerms> wrong = lights_of(runs.wrong, runs.wrong.settings.light_rules);
    int lit = 0;
    for (std::size_t i = 0; i < runs.pixel_count(); ++i) {
        CHECK_FALSE((right[i].cosine > 0.0f && wrong[i].cosine > 0.0f));
        if (runs.wrong_picture.owner[i] < 0) continue;
        if (runs.wrong_picture.colour[i] != wrong[i].reflected) FAIL("pixel " << i);
        lit += wrong[i].cosine > 0.0f ? 1 : 0;
    }
    CHECK(lit == 249002 - 245950);
}

TEST_CASE("B20b, B20c, B20d: the direct light is r, 4 pi and 1/r times what it should be") {
    for (const char* id : {"B20b", "B20c", "B20d"}) {
        const Runs runs(id);
        INFO(id);
        CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
        CHECK(runs.different_pixels() == 245950); // where there is direct light
        const std::vector<LightTerms> right = lights_of(runs.correct, {});
        for (std::size_t i = 0; i < runs.pixel_count(); i += 7) {
            if (!(right[i].cosine > 0.01f)) continue;
            const float r = std::sqrt(right[i].distance2);
            const float factor = id[3] == 'b' ? r : id[3] == 'c' ? 12.566371f : 1.0f / r;
            // R = rho (D + N), and rho is known from the correct run.
            const float rho = right[i].reflected.r / (right[i].direct.r + 0.5f);
            const float expected = rho * (factor * right[i].direct.r + 0.5f);
            if (std::abs(runs.wrong_picture.colour[i].r - expected) > 1e-4f * expected)
                FAIL("pixel " << i << " has " << runs.wrong_picture.colour[i].r << ", not "
                              << expected);
        }
    }
}

TEST_CASE("B21: the colour is the direct light plus the reflectance") {
    const Runs runs("B21");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    const std::vector<LightTerms> right = lights_of(runs.correct, {});
    for (std::size_t i = 0; i < runs.pixel_count(); ++i) {
        const int owner = runs.wrong_picture.owner[i];
        if (owner < 0) continue;
        const glm::vec3& rho = runs.session.scene->corner(owner, 0).reflectance;
        if (runs.wrong_picture.colour[i] != right[i].direct + rho) FAIL("pixel " << i);
    }
}

TEST_CASE("B22: the shown bytes differ exactly where a channel does not fit 8 bits") {
    const Runs runs("B22");
    CHECK(same_planes(runs.wrong_picture, runs.correct_picture));
    const Image wrong = view_image(runs.wrong_picture, View::colour);
    const Image correct = view_image(runs.correct_picture, View::colour);
    int wrapped = 0;
    for (std::size_t i = 0; i < runs.pixel_count(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float channel = 255.0f * runs.wrong_picture.colour[i][c];
            const std::size_t at = 4 * i + static_cast<std::size_t>(c);
            if (wrong.rgba[at] != static_cast<int>(channel) % 256) FAIL("pixel " << i);
            if (channel < 256.0f && wrong.rgba[at] != correct.rgba[at]) FAIL("pixel " << i);
            wrapped += channel >= 256.0f ? 1 : 0;
        }
    }
    CHECK(wrapped > 1000);
    CHECK(pixel_difference(runs.wrong_picture, runs.correct_picture).shown > 1000);
}

TEST_CASE("B24: the camera turns to the other side by the same angle") {
    const Runs runs("B24");
    Settings other_side = runs.session.b->settings;
    other_side.camera.yaw = -other_side.camera.yaw;
    const Framebuffer picture = draw_frame(prepare_frame(*runs.session.scene, other_side));
    CHECK(same_planes(runs.wrong_picture, picture));
    CHECK(runs.different_pixels() > 100000);
    Settings straight = runs.session.a.settings;
    straight.camera.yaw = 0.0f;
    const Framebuffer not_turned = draw_frame(prepare_frame(*runs.session.scene, straight));
    straight.rotation = Rotation::row_vector;
    CHECK(same_planes(not_turned, draw_frame(prepare_frame(*runs.session.scene, straight))));
}

TEST_CASE("B25: every vertex is turned about the middle of the picture") {
    const Runs runs("B25");
    for (std::size_t v = 0; v < runs.wrong.vertices.size(); ++v) {
        const ScreenVertex &wrong = runs.wrong.vertices[v], &correct = runs.correct.vertices[v];
        CHECK(wrong.column - 250 == 250 - correct.column);
        CHECK(wrong.row - 250 == 250 - correct.row);
        CHECK(wrong.inv_w == correct.inv_w);
    }
}

TEST_CASE("B27: the same picture to the last bit, with every sample looked at for every row") {
    const Runs runs("B27");
    CHECK(same_planes(runs.wrong_picture, runs.correct_picture));
    std::int64_t samples = 0, comparisons = 0;
    const std::vector<PolygonRows> tables = tables_of(runs.correct);
    for (int t = 0; t < runs.correct.triangle_count(); ++t) {
        const PolygonCorners v = runs.correct.triangle_vertices(t);
        for (int e = 0; e < 3; ++e) {
            const int count = edge_sample_count(v[e], v[(e + 1) % 3], EdgeSamples::longest_axis);
            samples += count;
            comparisons += std::int64_t{count} * tables[static_cast<std::size_t>(t)].size();
        }
    }
    CHECK(runs.correct_stats.row_lookups == samples);
    CHECK(runs.wrong_stats.row_lookups == comparisons);
    CHECK(compare_runs(runs.wrong, runs.correct).is_same());
}

TEST_CASE("B30: with both ends of a row neighbours draw their shared edge twice") {
    const Runs runs("B30");
    const auto twice = [](const Frame& frame) {
        const PixelFacts facts = pixel_facts(frame, cursor_end, {.drawn_twice = true});
        return std::count_if(facts.drawn_twice.begin(), facts.drawn_twice.end(),
                             [](const DrawnTwice& pair) { return bool(pair); });
    };
    const auto wrong = twice(runs.wrong), correct = twice(runs.correct);
    CHECK(wrong > 3000);
    CHECK(correct < wrong / 2);
    CHECK(runs.wrong_stats.fragments == 328789);
}

TEST_CASE("B16: at z = -2.5 twelve of the room's thirty triangles are dropped") {
    const Runs runs("B16");
    CHECK(runs.correct_stats.left_out.total() == 0);
    int dropped = 0;
    for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
        bool reaches_out = false;
        for (int v = 0; v < 3; ++v) {
            const glm::dvec3 p(runs.session.scene->corner(t, v).position);
            const double depth = p.z + 2.5;
            reaches_out |= std::max(std::abs(p.x), std::abs(p.y)) * 500.0 / depth > 250.0;
        }
        dropped += reaches_out ? 1 : 0;
        CHECK((runs.wrong.rejection(t) == Rejection::partly_outside) == reaches_out);
    }
    CHECK(dropped == 12);
    CHECK(runs.wrong_stats.left_out.total() == 12);
}

namespace {

/// The drawn corners of a triangle, back in camera space; the camera is at the origin and looks
/// along z.
std::vector<glm::dvec3> places_before_camera(const Frame& frame, int triangle) {
    const glm::dvec2 middle(frame.settings.viewport.width / 2, frame.settings.viewport.height / 2);
    const double f = frame.settings.camera.focal_length;
    std::vector<glm::dvec3> places;
    for (const ScreenVertex& corner : frame.triangle_vertices(triangle)) {
        const glm::dvec2 across = (glm::dvec2(corner.position) - middle) / f;
        const double z = corner.z;
        places.push_back({across.x * z, across.y * z, z});
    }
    return places;
}

} // namespace

TEST_CASE("B31: cut corners are where the wrong t puts them, not at the near plane") {
    const Runs runs("B31");
    // From z = -2 to z = 3: t = 2.1 / 3, where 2.1 / 5 is right.
    const double wrong_z = -2.0 + 2.1 / 3.0 * 5.0;
    int wrong_corners = 0, right_corners = 0;
    for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
        for (const glm::dvec3& place : places_before_camera(runs.wrong, t))
            wrong_corners += std::abs(place.z - wrong_z) < 1e-4 ? 1 : 0;
        for (const glm::dvec3& place : places_before_camera(runs.correct, t))
            right_corners += std::abs(place.z - 0.1) < 1e-4 ? 1 : 0;
    }
    CHECK(right_corners == 12);
    CHECK(wrong_corners == right_corners);
    CHECK(runs.wrong_stats.uncovered > runs.correct_stats.uncovered);
}

TEST_CASE("B32: triangles cut after the division are mirrored, and stay in the picture") {
    const Runs runs("B32");
    int mirrored = 0;
    for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
        if (!runs.wrong.is_drawn(t)) continue;
        for (const ScreenVertex& corner : runs.wrong.triangle_vertices(t)) {
            mirrored += corner.inv_w < 0.0f ? 1 : 0;
            if (!runs.wrong.is_cut(t)) continue;
            CHECK(corner.position.x >= -0.01f);
            CHECK(corner.position.x <= 200.01f);
            CHECK(corner.position.y >= -0.01f);
            CHECK(corner.position.y <= 160.01f);
        }
    }
    CHECK(mirrored > 0);
    CHECK(runs.different_pixels() > 1000);
}

TEST_CASE("B33: corners behind the near plane keep x and y, and are put on it") {
    const Runs runs("B33");
    const double c = std::cos(0.4), s = std::sin(0.4); // of the camera's yaw
    int moved = 0;
    for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
        const std::vector<glm::dvec3> places = places_before_camera(runs.wrong, t);
        REQUIRE(places.size() == 3);
        for (int v = 0; v < 3; ++v) {
            const glm::dvec3 given(runs.session.scene->corner(t, v).position);
            const double z = s * given.x + c * given.z;
            const glm::dvec3 expected(c * given.x - s * given.z, given.y, std::max(z, 0.1));
            CHECK(glm::distance(places[static_cast<std::size_t>(v)], expected) < 1e-3);
            moved += z < 0.1 ? 1 : 0;
        }
    }
    CHECK(moved == 9);
    CHECK(runs.different_pixels() > 500); // straight ahead in the corridor it would be one
    CHECK(runs.wrong_stats.left_out.total() == 0);
}

TEST_CASE("B34: the left wall is culled as soon as the camera turns away from it") {
    const Runs runs("B34");
    const double yaw = 0.08;
    int wrongly_culled = 0;
    for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
        const glm::dvec3 normal(runs.session.scene->corner(t, 0).normal);
        const double along = normal.x * std::sin(yaw) + normal.z * std::cos(yaw);
        CHECK((runs.wrong.rejection(t) == Rejection::back_facing) == (along > 0.0));
        const bool is_lost = along > 0.0 && runs.correct.is_drawn(t);
        wrongly_culled += is_lost ? 1 : 0;
        if (is_lost) CHECK(part_name(*runs.session.scene, t) == "left wall");
    }
    CHECK(wrongly_culled == 2);
    CHECK(runs.wrong_stats.uncovered > runs.correct_stats.uncovered);
}

TEST_CASE("B35: the camera is at the origin, wherever it is put") {
    const Runs runs("B35");
    Settings at_origin = runs.session.b->settings;
    at_origin.camera.position = glm::vec3(0.0f);
    const Framebuffer picture = draw_frame(prepare_frame(*runs.session.scene, at_origin));
    CHECK(same_planes(runs.wrong_picture, picture));
    CHECK(runs.different_pixels() > 100000);
    // Walking changes nothing, turning does.
    Settings elsewhere = runs.session.a.settings;
    elsewhere.camera.position = {0.7f, -0.4f, 2.0f};
    CHECK(same_planes(draw_frame(prepare_frame(*runs.session.scene, elsewhere)), picture));
    elsewhere.camera.yaw = 0.3f;
    at_origin.camera.yaw = 0.3f;
    const Framebuffer turned = draw_frame(prepare_frame(*runs.session.scene, elsewhere));
    CHECK(same_planes(turned, draw_frame(prepare_frame(*runs.session.scene, at_origin))));
    CHECK_FALSE(same_planes(turned, picture));
    // The translation has gone into w, and the lab's lines have no matrix to put it into.
    const SpacesOfVertex spaces = spaces_of_vertex(runs.wrong, 8, 1, MatrixOrder::column_vectors);
    const auto camera = std::find_if(spaces.places.begin(), spaces.places.end(),
                                     [](const SpacePlace& p) { return p.space == "camera"; });
    REQUIRE(camera != spaces.places.end());
    CHECK(glm::distance(camera->place, glm::dvec4(1.0, 1.0, 1.0, 1.0 + 3.001)) < 1e-6);
    Settings by_lab = runs.session.a.settings;
    by_lab.transform = Transform::lab;
    const Framebuffer lab_picture = draw_frame(prepare_frame(*runs.session.scene, by_lab));
    CHECK(lab_picture.owner == runs.correct_picture.owner);
    CHECK(lab_picture.colour == runs.correct_picture.colour);
}

TEST_CASE("B36: light falls as if normals were moved by minus the camera's position") {
    const Runs runs("B36");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    CHECK(runs.different_pixels() > 100000);
    const glm::dvec3 eye(runs.session.a.settings.camera.position);
    const glm::dvec3 lamp(runs.session.a.settings.light.position);
    int lit = 0;
    for (const FragmentEvent& event : fragments_of(runs.wrong)) {
        if (event.fate != Fate::written || event.cursor.step % 5 != 0) continue;
        const Vertex& corner = runs.session.scene->corner(event.cursor.triangle, 0);
        const glm::dvec3 place(
            recover_varyings(event.fragment, runs.wrong.settings.interpolation).position_world);
        const glm::dvec3 r = lamp - place, n = glm::normalize(glm::dvec3(corner.normal) - eye);
        const double cosine = std::max(0.0, glm::dot(glm::normalize(r), n));
        const double light = 14.0 * cosine / (4.0 * 3.14159265358979 * glm::dot(r, r)) + 0.5;
        const glm::dvec3 expected = light * glm::dvec3(corner.reflectance);
        if (glm::distance(glm::dvec3(event.after), expected) > 1e-4)
            FAIL(to_text(event.cursor) << " does not have the light of the moved normal");
        lit += cosine > 0.0 ? 1 : 0;
    }
    CHECK(lit > 1000);
    // Nothing is moved if the camera is at the origin.
    Settings wrong = runs.session.a.settings, correct = runs.session.b->settings;
    for (Settings* const settings : {&wrong, &correct}) {
        settings->camera.position = glm::vec3(0.0f);
        settings->clip = Clip::all;
    }
    CHECK(same_but_for_colour(draw_frame(prepare_frame(*runs.session.scene, wrong)),
                              draw_frame(prepare_frame(*runs.session.scene, correct))));
    CHECK(pixel_difference(draw_frame(prepare_frame(*runs.session.scene, wrong)),
                           draw_frame(prepare_frame(*runs.session.scene, correct)))
              .largest < 1e-5f);
    // Light at the vertices goes wrong as well.
    wrong = runs.session.a.settings;
    set_step(wrong, StripStep::vertex_light);
    correct = wrong;
    correct.normal_w = NormalW::zero;
    CHECK(pixel_difference(draw_frame(prepare_frame(*runs.session.scene, wrong)),
                           draw_frame(prepare_frame(*runs.session.scene, correct)))
              .different > 100000);
}

namespace {

/// The light of the pixel shader at each written fragment, wrong and right, with its terms.
struct LitPixel {
    std::size_t pixel = 0;
    Varyings varyings;
    int triangle = 0;
};

std::vector<LitPixel> lit_pixels(const Frame& frame) {
    std::vector<LitPixel> lit;
    Framebuffer picture = draw_frame(frame);
    for (const FragmentEvent& event : fragments_of(frame)) {
        const std::size_t at = picture.at(event.fragment.column, event.fragment.row);
        if (event.fate != Fate::written || picture.owner[at] != event.cursor.triangle) continue;
        lit.push_back({at, recover_varyings(event.fragment, frame.settings.interpolation),
                       event.cursor.triangle});
    }
    return lit;
}

/// How many triangles cover a pixel, by a second implementation.
int covering(const Frame& frame, int column, int row, FillRule rule) {
    int count = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        std::vector<GridPoint> corners;
        for (const ScreenVertex& v : frame.triangle_vertices(t))
            corners.push_back({pixel_centre(v.column), pixel_centre(v.row)});
        count += is_covered(corners, {pixel_centre(column), pixel_centre(row)}, rule) ? 1 : 0;
    }
    return count;
}

/// Is every pixel covered as often as the second implementation says?
void require_rule(const Frame& frame, const Framebuffer& picture, FillRule rule) {
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            const int expected = covering(frame, column, row, rule);
            if (static_cast<int>(picture.overdraw[picture.at(column, row)]) != expected)
                FAIL("column " << column << " row " << row << " is not covered " << expected
                               << " times");
        }
    }
}

} // namespace

TEST_CASE("B23: light falls on normals that get shorter away from the corners") {
    const Runs runs("B23");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    int dimmer = 0, bent = 0;
    for (const LitPixel& lit : lit_pixels(runs.correct)) {
        const bool is_bent = runs.session.scene->mesh.differences(lit.triangle).normals;
        const glm::vec3& wrong = runs.wrong_picture.colour[lit.pixel];
        const glm::vec3& right = runs.correct_picture.colour[lit.pixel];
        if (!is_bent && wrong != right) FAIL("pixel " << lit.pixel << " of a flat end differs");
        if (!is_bent) continue;
        ++bent;
        // Direct light is proportional to the length, the highlight to its 50th power; neither
        // grows.
        if (wrong.r > right.r + 1e-6f) FAIL("pixel " << lit.pixel << " is brighter");
        dimmer += wrong.r < right.r - 1e-4f ? 1 : 0;
    }
    CHECK(bent > 5000);
    CHECK(dimmer > bent / 4);
}

TEST_CASE("B50: the only extra light is highlights on places that do not see the lamp") {
    const Runs runs("B50");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    int shining = 0;
    const glm::vec3 lamp = runs.correct.settings.light.position;
    for (const LitPixel& lit : lit_pixels(runs.correct)) {
        const glm::vec3& wrong = runs.wrong_picture.colour[lit.pixel];
        const glm::vec3& right = runs.correct_picture.colour[lit.pixel];
        if (wrong == right) continue;
        if (glm::dot(lit.varyings.normal, lamp - lit.varyings.position_world) > 1e-4f)
            FAIL("pixel " << lit.pixel << " sees the lamp and differs");
        if (!(wrong.r > right.r)) FAIL("pixel " << lit.pixel << " has lost light");
        shining += wrong.r > right.r + 1.0f / 255.0f ? 1 : 0;
    }
    CHECK(shining > 100);
}

TEST_CASE("B51: n times a half vector that is too long is raised to the exponent") {
    const Runs runs("B51");
    CHECK(same_but_for_colour(runs.wrong_picture, runs.correct_picture));
    const double exponent = 50.0;
    int brighter = 0;
    for (const LitPixel& lit : lit_pixels(runs.correct)) {
        const double right = runs.correct_picture.colour[lit.pixel].r;
        const double wrong = runs.wrong_picture.colour[lit.pixel].r;
        if (runs.session.scene->corner(lit.triangle, 0).shine == Shine{}) continue;
        const glm::dvec3 at(lit.varyings.position_world);
        const glm::dvec3 n = glm::normalize(glm::dvec3(lit.varyings.normal));
        const glm::dvec3 l = glm::normalize(glm::dvec3(runs.correct.settings.light.position) - at);
        const glm::dvec3 v = glm::normalize(glm::dvec3(runs.correct.settings.camera.position) - at);
        const double length = glm::length(l + v);
        if (glm::dot(n, l) < 1e-3) continue;
        const double area = 4.0 * 3.14159265358979 *
                            glm::dot(glm::dvec3(runs.correct.settings.light.position) - at,
                                     glm::dvec3(runs.correct.settings.light.position) - at);
        const double highlight = 0.7 * runs.correct.settings.light.power.r / area *
                                 std::pow(std::max(glm::dot(n, l + v) / length, 0.0), exponent);
        const double expected = right + highlight * (std::pow(length, exponent) - 1.0);
        if (std::abs(wrong - expected) > 1e-3 * (1.0 + std::abs(expected)))
            FAIL("pixel " << lit.pixel << " has " << wrong << ", not " << expected);
        brighter += wrong > right + 0.1 ? 1 : 0;
    }
    CHECK(brighter > 1000);
}

TEST_CASE("B40a: with E >= 0 the pixels of a shared edge are drawn twice") {
    const Runs runs("B40a");
    require_rule(runs.wrong, runs.wrong_picture, FillRule::inclusive);
    require_rule(runs.correct, runs.correct_picture, FillRule::top_left);
    const auto twice = [](const Framebuffer& picture) {
        return std::count(picture.overdraw.begin(), picture.overdraw.end(), 2u);
    };
    CHECK(twice(runs.wrong_picture) == 9);
    CHECK(twice(runs.correct_picture) == 0);
    CHECK(runs.wrong_picture.owner[runs.wrong_picture.at(7, 5)] == 1);
    CHECK(runs.correct_picture.owner[runs.correct_picture.at(7, 5)] == 0);
    CHECK(runs.different_pixels() > 0);
}

TEST_CASE("B40b: with E > 0 a crack is left between neighbours") {
    const Runs runs("B40b");
    require_rule(runs.wrong, runs.wrong_picture, FillRule::exclusive);
    for (int i = 4; i < 11; ++i) {
        CHECK(runs.wrong_picture.owner[runs.wrong_picture.at(i, i - 2)] == -1);
        CHECK(runs.correct_picture.owner[runs.correct_picture.at(i, i - 2)] == 0);
    }
}

TEST_CASE("B40c: without top edges a level crack is left, and slanted edges are correct") {
    const Runs runs("B40c");
    int lost = 0;
    for (int row = 0; row < 15; ++row) {
        for (int column = 0; column < 21; ++column) {
            const std::size_t at = runs.wrong_picture.at(column, row);
            if (runs.wrong_picture.owner[at] == runs.correct_picture.owner[at]) continue;
            ++lost;
            CHECK(runs.wrong_picture.owner[at] == -1);
            // The hexagon's top, from column 6 to 14, and the edge from 2 to 18 in its middle.
            CHECK(((row == 2 && column >= 6 && column < 14) ||
                   (row == 7 && column >= 2 && column < 18)));
        }
    }
    CHECK(lost == 8 + 16);
    CHECK(owns_left_only(left_side));
    CHECK_FALSE(owns_left_only(top_side));
    CHECK_FALSE(owns_left_only(right_side));
    CHECK_FALSE(owns_left_only(bottom_side));
}

TEST_CASE("B41: pixels tested at their corner are those of a polygon half a pixel further on") {
    for (const Coverage coverage :
         {Coverage::edge_functions, Coverage::scan_conversion, Coverage::active_edges}) {
        Runs runs("B41");
        runs.session.a.settings.coverage = coverage;
        runs.draw_again();
        std::vector<std::vector<GridPoint>> triangles;
        for (int t = 0; t < runs.wrong.triangle_count(); ++t) {
            std::vector<GridPoint>& corners = triangles.emplace_back();
            for (const ScreenVertex& v : runs.wrong.triangle_vertices(t))
                corners.push_back({pixel_centre(v.column), pixel_centre(v.row)});
        }
        for (int row = 0; row < 15; ++row) {
            for (int column = 0; column < 21; ++column) {
                int expected = 0;
                for (const std::vector<GridPoint>& corners : triangles) {
                    const GridPoint asked{256 * column, 256 * row};
                    expected += is_covered(corners, asked, FillRule::top_left) ? 1 : 0;
                }
                const std::size_t at = runs.wrong_picture.at(column, row);
                if (static_cast<int>(runs.wrong_picture.overdraw[at]) != expected)
                    FAIL(word_of(coverage) << ": column " << column << " row " << row);
            }
        }
        CHECK(runs.wrong_picture.owner[runs.wrong_picture.at(8, 2)] == -1); // the top
        CHECK(runs.wrong_picture.owner[runs.wrong_picture.at(2, 7)] == -1); // the left tip
        CHECK(runs.correct_picture.owner[runs.correct_picture.at(8, 2)] >= 0);
        CHECK(runs.correct_picture.owner[runs.correct_picture.at(2, 7)] >= 0);
    }
}

TEST_CASE("B42: depth is moved from each corner to the next, and the outline stays") {
    const Runs runs("B42");
    const auto wrong = fragments_of(runs.wrong), correct = fragments_of(runs.correct);
    CHECK(wrong.size() == correct.size());
    CHECK(runs.wrong_picture.overdraw == runs.correct_picture.overdraw);
    CHECK(runs.different_pixels() == 696);
    for (const FragmentEvent& event : wrong) {
        const auto v = runs.wrong.triangle_vertices(event.cursor.triangle);
        const auto area = [&](const glm::dvec2& p, std::size_t from) {
            const ScreenVertex &a = v[from % 3], &b = v[(from + 1) % 3];
            return (b.column - a.column) * (p.y - a.row) - (b.row - a.row) * (p.x - a.column);
        };
        const glm::dvec2 p(event.fragment.column, event.fragment.row);
        const double whole = area(p, 0) + area(p, 1) + area(p, 2);
        double depth = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            depth += area(p, i) / whole * static_cast<double>(v[i].depth);
        if (std::abs(depth - static_cast<double>(event.fragment.depth)) > 1e-6)
            FAIL(to_text(event.cursor) << " does not have the depth of the edges at its corners");
    }
    const Weights weights = weights_of_own_edges({65536, 2 * 65536, 5 * 65536}, 8 * 65536);
    CHECK(weights == Weights{0.125f, 0.25f, 0.625f});
}

TEST_CASE("B43: z mixed by the weights is too far, and surfaces behind show through") {
    const Runs runs("B43");
    int farther = 0, of_other = 0;
    for (const FragmentEvent& event : fragments_of(runs.wrong)) {
        if (event.cursor.step % 5 != 0) continue;
        const Fragment& f = event.fragment;
        const double truth = 1.0 / static_cast<double>(f.inv_w);
        // The arithmetic mean is never less than the harmonic mean.
        if (static_cast<double>(f.z) < truth * (1.0 - 1e-5))
            FAIL(to_text(event.cursor) << " is nearer than it should be");
        farther += static_cast<double>(f.z) > 1.5 * truth ? 1 : 0;
    }
    for (std::size_t at = 0; at < runs.pixel_count(); ++at) {
        const int wrong = runs.wrong_picture.owner[at], correct = runs.correct_picture.owner[at];
        if (wrong < 0 || correct < 0) continue;
        const int part = part_of(*runs.session.scene, wrong);
        of_other += part != part_of(*runs.session.scene, correct) ? 1 : 0;
    }
    CHECK(farther > 1000);
    CHECK(of_other > 1000);
}
