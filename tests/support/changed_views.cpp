// Changed views: links, saved views, moments; and what is kept between runs.

#include <string>

#include "lessons/progress.h"
#include "opening/opened_view.h"
#include "opening/view_link.h"
#include "pipeline/cursor.h"
#include "session/session.h"
#include "support/changed_formats.h"
#include "view/state_file.h"

namespace rasterwalk::test {

namespace {

FileOutcome progress_outcome(const std::string& bytes, const TemporaryFolder&) {
    return text_outcome([&] {
        const std::string text = progress_text(parse_progress(bytes, "x"));
        return problem_of_copy(text, progress_text(parse_progress(text, "x")));
    });
}

FileOutcome view_outcome(const std::string& bytes, const TemporaryFolder& folder) {
    ViewOptions options;
    options.file = folder.write("v.walk.toml", bytes);
    return text_outcome(options.file, options.file, [&] {
        const std::string text = view_text(open_view(options), options.file);
        folder.write("v.walk.toml", text);
        return problem_of_copy(text, view_text(open_view(options), options.file));
    });
}

FileOutcome link_outcome(const std::string& bytes, const TemporaryFolder&) {
    return word_outcome([&] {
        const std::string link = view_link(open_view(parse_view_link(bytes)));
        return problem_of_copy(link, view_link(open_view(parse_view_link(link))));
    });
}

FileOutcome cursor_outcome(const std::string& bytes, const TemporaryFolder&) {
    const std::optional<Cursor> cursor = parse_cursor(bytes);
    if (!cursor) return {false, ""};
    const std::optional<Cursor> again = parse_cursor(to_text(*cursor));
    return {true, again == cursor ? "" : "written and read again, it is different."};
}

const std::string progress_seed =
    "last_lesson = \"04-edges\"\n[lessons.04-edges]\nlast_step = 2\nsteps = [0, 1, 2]\n"
    "tasks = [\"a\"]\n";
const std::string view_seed =
    "scene = \"scenes/one-triangle.toml\"\nset = [\"stage=rows\", \"rounding=floor\"]\n"
    "cursor = \"t0/e1/s2\"\ntab = \"rows\"\ntriangle = 0\npixel = \"3,4\"\nview = \"depth\"\n";

std::vector<std::string> view_words(const std::vector<std::string>& signs) {
    std::vector<std::string> words{
        "scene",        "stage",    "set",          "cursor",
        "tab",          "triangle", "pixel",        "view",
        "zoom",         "vertices", "bug",          "compare",
        "overlay",      "lesson",   "step",         "texture",
        "size",         "coverage", "samples",      "hidden",
        "bsp",          "painter",  "shadows",      "map",
        "tessellation", "64",       "..",           "/",
        "end",          "t99/r1",   "p1:t2",        "nan",
        "-1",           "4096",     "B9",           "depth",
        "rays",         "warnock",  "camera.yaw",   "row",
        "1e30",         "\x80",     "2,3/40,5/1,9", "scenes/lab-room.toml",
        "05-row-table", "clip",     "mistakes",     "0"};
    words.insert(words.end(), signs.begin(), signs.end());
    return words;
}

} // namespace

std::vector<ChangedFormat> view_formats() {
    return {
        {"link",
         {"#scene=scenes/one-triangle.toml&stage=edges&to=t0/e1/s2&pixel=3,4&view=depth",
          "#lesson=05-row-table&step=3", "#scene=scenes/fence.toml&set=rounding%3Dfloor&bug=B9",
          "#stage=depth&set=hidden%3Dpainter&b=depth_test%3Dlinear_z&tab=rows&row=9"},
         view_words({"&", "=", "%", "%3D", "%00", "%2e%2e%2f", "#", "&set=", "&b=", ","}),
         link_outcome},
        {"view", {view_seed}, view_words(toml_words), view_outcome},
        {"progress", {progress_seed}, toml_words, progress_outcome},
        {"cursor",
         {"t12/e2/s14", "p1:t2/r37/c5", "w12/t3/r37/c5", "t0/p0/s2", "t3/k", "s37/c5", "p6:end"},
         {"t", "/", "e", "s", "end", "p", ":", "-1", "2147483647", "2147483648", " ", "w", "\x80"},
         cursor_outcome},
    };
}

} // namespace rasterwalk::test
