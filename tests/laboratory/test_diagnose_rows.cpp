#include <algorithm>

#include "base/error.h"
#include "inspect/row_history.h"
#include "laboratory/diagnose.h"
#include "pipeline/frame.h"
#include "support/samples.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

ScreenVertex place(int column, int row) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    vertex.depth = vertex.inv_w = vertex.z = 1.0f;
    return vertex;
}

std::string table_text(const std::vector<ScreenVertex>& vertices, const Settings& settings) {
    PolygonRows rows;
    compute_polygon_rows(vertices, settings, rows);
    return rows_text(rows);
}

Diagnosis diagnose(const std::string& text, const std::vector<glm::ivec2>& polygon,
                   std::string* about = nullptr) {
    const Scene scene = lab_room();
    std::string compared_with;
    const Diagnosis diagnosis = diagnose_rows(parse_printed_rows(text, "rows.txt"), polygon, scene,
                                              default_settings(scene), read_bugs(), compared_with);
    if (about != nullptr) *about = compared_with;
    return diagnosis;
}

const std::vector<ScreenVertex> lab{place(10, 5), place(5, 10), place(15, 15)};
const std::vector<ScreenVertex> shallow{place(2, 3), place(30, 8), place(11, 19)};
const std::vector<glm::ivec2> shallow_points{{2, 3}, {30, 8}, {11, 19}};

} // namespace

TEST_CASE("Printed rows are read in the lab's form, with blanks and other lines between") {
    const std::vector<PrintedRow> rows =
        parse_printed_rows("Polygon:\n Start: (10,5). End: (10,5).\r\n\nStart:(-9, 6).End: (10,6)\n"
                           "done",
                           "rows.txt");
    CHECK(rows == std::vector<PrintedRow>{{{10, 5}, {10, 5}}, {{-9, 6}, {10, 6}}});
}

TEST_CASE("What is not a row is reported with its line") {
    CHECK_THROWS_WITH(parse_printed_rows("Start: (1,2). End: (1,2).\nStart: 1,2\n", "rows.txt"),
                      Catch::Matchers::StartsWith("rows.txt:2: a row must look like"));
    CHECK_THROWS_WITH(parse_printed_rows("Start: (1,2). End: (99999999999,2).", "rows.txt"),
                      Catch::Matchers::StartsWith("rows.txt:1: "));
    CHECK_THROWS_WITH(parse_printed_rows("hello", "rows.txt"), ContainsSubstring("lines like"));
    CHECK_THROWS_AS(parse_printed_rows("", "rows.txt"), InputError);
}

TEST_CASE("The correct table has no difference, and its polygon is found") {
    const Settings handout;
    std::string about;
    CHECK(diagnose(table_text(lab, handout), {}, &about).verdict == "no difference");
    CHECK(about == "the polygon (10,5) (5,10) (15,15)");
    const Scene scene = lab_room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const PolygonCorners vertices = frame.triangle_vertices(14);
    const std::string text = table_text({vertices.begin(), vertices.end()}, handout);
    CHECK(diagnose(text, {}, &about).is_same());
    CHECK(about == "triangles[14] (short block)");
    CHECK(diagnose(table_text(shallow, handout), shallow_points).is_same());
}

TEST_CASE("The table of every bug is recognized if the bug changes it") {
    const Settings handout;
    int changed = 0;
    for (const Bug& bug : read_bugs()) {
        const std::string text = table_text(shallow, wrong_run(bug, handout));
        if (text == table_text(shallow, correct_run(bug, handout))) continue;
        if (text == table_text(shallow, handout)) continue;
        ++changed;
        CAPTURE(bug.id);
        const Diagnosis diagnosis = diagnose(text, shallow_points);
        REQUIRE_FALSE(diagnosis.candidates.empty());
        const std::vector<std::string>& ids = diagnosis.candidates.front().ids();
        CHECK(std::find(ids.begin(), ids.end(), bug.id) != ids.end());
        CHECK_THAT(diagnosis.verdict, ContainsSubstring("Exact match"));
    }
    CHECK(changed >= 3);
}

TEST_CASE("Faults in a table are named even if no bug makes them") {
    const Diagnosis diagnosis = diagnose("Start: (10,5). End: (9,5).\n"
                                         "Start: (9,6). End: (9,6).\n"
                                         "Start: (8,7). End: (10,7).\n"
                                         "Start: (7,8). End: (10,8).\n"
                                         "Start: (6,9). End: (11,9).\n"
                                         "Start: (5,10). End: (11,10).\n"
                                         "Start: (7,11). End: (12,11).\n"
                                         "Start: (9,12). End: (12,12).\n"
                                         "Start: (11,13). End: (13,13).\n"
                                         "Start: (13,14). End: (13,14).\n"
                                         "Start: (15,15). End: (14,15).\n",
                                         {});
    CHECK(diagnosis.verdict == "Exact match: The last column of every row is missing.");
}
