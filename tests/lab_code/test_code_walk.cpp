// The code is walked together with the moments of the time axis: it meets the same ones, in the
// same order, in both directions, and is found at each of them.

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.h"
#include "lab_code/code_frame.h"
#include "lab_code/code_walk.h"
#include "pipeline/draw.h"
#include "pipeline/replay.h"
#include "pipeline/shadow_pass.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

namespace {

const LabCode& walked_code() {
    static const LabCode code = read_lab_code(lessons_folder() + "/code");
    return code;
}

Frame walked_frame(const Scene& scene, const StageInfo& info, bool tests_pixels = false) {
    Settings settings = default_settings(scene);
    set_step(settings, info.step);
    if (tests_pixels) {
        settings.coverage = Coverage::edge_functions;
        settings.cull = Cull::face_normal;
    }
    if (scene.space == SceneSpace::world) {
        settings.viewport = {60, 50};
        settings.camera.focal_length = 55.0f;
    }
    return prepare_frame(scene, settings);
}

std::vector<Cursor> moments_of_time(const Frame& frame) {
    const Timeline timeline(frame);
    std::vector<Cursor> moments;
    for (Cursor at = timeline.first(); at != cursor_end;
         at = timeline.next(at, Granularity::moment))
        moments.push_back(at);
    return moments;
}

/// One line on; false if there is none.
bool step(CodeWalk& walk) {
    walk.set_out(CodeGoal::line);
    return walk.go_on(1'000'000) == CodeArrival::arrived;
}

/// The functions that are being carried out, with their lines.
std::string whereabouts(const CodeMachine& machine) {
    std::string text;
    for (const CodeCall& call : machine.calls())
        text += machine.program().functions[static_cast<std::size_t>(call.function)].name + ":" +
                std::to_string(call.line) + " ";
    return text;
}

std::string innermost(const CodeMachine& machine) {
    const CodeCall call = machine.calls().back();
    return machine.program().functions[static_cast<std::size_t>(call.function)].name;
}

/// The number of the line with these words in it, from 1; 0: there is none.
int line_with(const CodeWalk& walk, const std::string& words) {
    for (std::size_t i = 0; i < walk.lines().size(); ++i) {
        if (walk.lines()[i].text.find(words) != std::string::npos) return static_cast<int>(i) + 1;
    }
    return 0;
}

} // namespace

/// Fails with the first moment that the code meets at another time.
void require_same_moments(const Frame& frame) {
    const std::vector<Cursor> moments = moments_of_time(frame);
    CodeWalk walk;
    walk.take(walked_code(), frame, 1);
    REQUIRE(walk.missing() == "");
    Framebuffer planes;
    clear(planes, frame);
    walk.seek({moments.front(), 0}, planes);
    std::vector<Cursor> met{walk.place().cursor};
    while (step(walk)) {
        if (walk.place().cursor != met.back()) met.push_back(walk.place().cursor);
    }
    const std::size_t both = std::min(met.size(), moments.size());
    for (std::size_t i = 0; i < both; ++i) {
        if (met[i] != moments[i]) FAIL(to_text(met[i]) << " for " << to_text(moments[i]));
    }
    CHECK(met.size() == moments.size());
    CHECK(walk.place() == CodePlace{cursor_end, 0});
}

TEST_CASE("Stepping the code meets the moments of time, in their order") {
    for (const Scene& scene : {lab_room(), small_scene()}) {
        for (const StageInfo& info : stage_list()) {
            if (!is_of_use(info, scene)) continue;
            CAPTURE(scene.name, std::string(info.name));
            require_same_moments(walked_frame(scene, info));
        }
    }
}

TEST_CASE("Pixels that are tested and triangles that are culled are moments of the code too") {
    const Scene scene = lab_room();
    for (const StageInfo& info : stage_list()) {
        CAPTURE(std::string(info.name));
        const Frame whole = walked_frame(scene, info, true);
        require_same_moments(whole);
        Settings settings = whole.settings;
        set_from_text(settings, "box_walk=interval");
        require_same_moments(prepare_frame(scene, settings));
        set_from_text(settings, "cull=fragment_normal");
        require_same_moments(prepare_frame(scene, settings));
    }
}

TEST_CASE("The edges that a plane cuts are moments of the code too") {
    const Scene floor = read_scene(lessons_folder() + "/scenes/one-corner-behind.toml");
    for (const char* clip : {"near", "all", "guard_band", "whole_only", "wrong_t", "after_division",
                             "clamped", "uncut_varyings"}) {
        for (const float z : {0.0f, 1.5f, 2.5f}) {
            for (const StageInfo& info : stage_list()) {
                CAPTURE(clip, z, std::string(info.name));
                Settings settings = walked_frame(floor, info).settings;
                set_from_text(settings, std::string("clip=") + clip);
                settings.camera.position.z = z;
                const Frame frame = prepare_frame(floor, settings);
                if (!frame.has_moments(0)) continue;
                require_same_moments(frame);
            }
        }
    }
    Settings cheap = walked_frame(floor, *find_stage("depth")).settings;
    set_from_text(cheap, "reject=cheap");
    require_same_moments(prepare_frame(floor, cheap));
    // A triangle with two corners behind the camera, and one that is cut away and culled.
    const Scene room = lab_room();
    Settings settings = walked_frame(room, *find_stage("pixel_light")).settings;
    set_from_text(settings, "clip=all");
    set_from_text(settings, "reject=outcodes");
    settings.camera.position = {0.0f, 0.0f, -0.9f};
    for (const char* cull : {"none", "face_normal", "screen_area"}) {
        CAPTURE(cull);
        set_from_text(settings, std::string("cull=") + cull);
        require_same_moments(prepare_frame(room, settings));
    }
}

TEST_CASE("The rows of polygons that are cut are found at the same moments") {
    const Scene room = lab_room();
    Settings settings = walked_frame(room, *find_stage("depth"), true).settings;
    settings.camera.position = {0.1f, 0.2f, -0.9f};
    for (const char* clip : {"none", "near", "all", "guard_band", "after_division"}) {
        for (const char* walk : {"all", "interval"}) {
            CAPTURE(clip, walk);
            set_from_text(settings, std::string("clip=") + clip);
            set_from_text(settings, std::string("box_walk=") + walk);
            require_same_moments(prepare_frame(room, settings));
        }
    }
    // Without tests of pixels: row by row.
    set_from_text(settings, "fill_rule=top_left");
    for (const char* coverage : {"scan_conversion", "active_edges"}) {
        CAPTURE(coverage);
        set_from_text(settings, std::string("coverage=") + coverage);
        set_from_text(settings, "clip=all");
        require_same_moments(prepare_frame(room, settings));
    }
    // The faces of a shadow map are drawn so.
    settings = walked_frame(room, *find_stage("pixel_light")).settings;
    set_from_text(settings, "shadows=map");
    settings.shadow_resolution = 64;
    for (int face = 0; face < shadow_face_count; ++face) {
        CAPTURE(face);
        require_same_moments(prepare_pass(room, settings, pass_of_face(face)));
    }
}

TEST_CASE("Pixels with samples are drawn and resolved at the same moments") {
    for (const char* samples : {"samples=4", "supersample=2"}) {
        CAPTURE(samples);
        const Scene scene = lab_room();
        Settings settings = walked_frame(scene, *find_stage("depth")).settings;
        set_from_text(settings, "coverage=edge_functions");
        set_from_text(settings, samples);
        const Frame frame = prepare_frame(scene, settings);
        require_same_moments(frame);
        const std::vector<Cursor> moments = moments_of_time(frame);
        Replay replay;
        replay.begin(frame);
        CodeWalk walk;
        walk.take(walked_code(), frame, 1);
        for (std::size_t i = 0; i < moments.size(); i += 1 + moments.size() / 50) {
            CAPTURE(to_text(moments[i]));
            CHECK(walk.seek({moments[i], 0}, replay.at(moments[i])) == CodePlace{moments[i], 0});
            CHECK(walk.is_there());
        }
        walk.seek({cursor_end, 0}, replay.at(cursor_end));
        CHECK(walk.is_there());
    }
}

TEST_CASE("The squares of Warnock's algorithm are moments of the code too") {
    for (const char* name : {"three-needles", "lab-room"}) {
        CAPTURE(name);
        const Scene scene = read_scene(lessons_folder() + "/scenes/" + name + ".toml");
        Settings settings = walked_frame(scene, *find_stage("depth")).settings;
        set_from_text(settings, "hidden=warnock");
        const Frame frame = prepare_frame(scene, settings);
        REQUIRE(frame.squares != nullptr);
        require_same_moments(frame);
    }
}

TEST_CASE("A line that is looked up is the one that stepping comes to") {
    const Scene scene = lab_room();
    Random random(4801);
    for (const StageInfo& info : stage_list()) {
        CAPTURE(std::string(info.name));
        const Frame frame = walked_frame(scene, info);
        const Timeline timeline(frame);
        Replay replay;
        replay.begin(frame);
        CodeWalk stepped, found;
        stepped.take(walked_code(), frame, 1);
        found.take(walked_code(), frame, 1);
        for (int round = 0; round < rounds(40, 6); ++round) {
            const Cursor start = timeline.at_place(random.real(0.0, 1.0));
            if (start == cursor_end) continue;
            stepped.seek({start, 0}, replay.at(start));
            for (int line = random.integer(1, 60); line > 0 && step(stepped);)
                --line;
            const CodePlace place = stepped.place();
            if (place.cursor == cursor_end) continue;
            CAPTURE(to_text(start), to_text(place.cursor), place.lines);
            CHECK(found.seek(place, replay.at(place.cursor)) == place);
            CHECK(whereabouts(found.machine()) == whereabouts(stepped.machine()));
        }
    }
}

TEST_CASE("Going on to a later moment comes to the same line as starting over") {
    const Scene scene = lab_room();
    Random random(4806);
    for (const char* set :
         {"hidden=depth_buffer", "hidden=warnock", "coverage=edge_functions", "samples=4"}) {
        CAPTURE(set);
        Settings settings = walked_frame(scene, *find_stage("depth")).settings;
        if (std::string(set) == "samples=4") settings.coverage = Coverage::edge_functions;
        set_from_text(settings, set);
        const Frame frame = prepare_frame(scene, settings);
        const Timeline timeline(frame);
        Replay replay;
        replay.begin(frame);
        CodeWalk going, beginning;
        going.take(walked_code(), frame, 1);
        for (int round = 0; round < rounds(20, 4); ++round) {
            Cursor at = timeline.at_place(random.real(0.0, 0.9));
            for (int step = 0; step < 8 && at != cursor_end; ++step) {
                const CodePlace place{at, random.integer(0, 2)};
                const CodePlace came = going.seek(place, replay.at(at));
                beginning.take(walked_code(), frame,
                               static_cast<std::uint64_t>(100 * round + step));
                CAPTURE(to_text(at), place.lines);
                CHECK(beginning.seek(place, replay.at(at)) == came);
                CHECK(whereabouts(beginning.machine()) == whereabouts(going.machine()));
                for (int skipped = random.integer(1, 3); skipped > 0 && at != cursor_end; --skipped)
                    at = timeline.next(at, Granularity::moment);
            }
        }
    }
}

TEST_CASE("The last line of a moment is the one before the next moment's first") {
    const Scene scene = lab_room();
    const Frame frame = walked_frame(scene, *find_stage("vertex_light"));
    const Timeline timeline(frame);
    Replay replay;
    replay.begin(frame);
    CodeWalk walk;
    walk.take(walked_code(), frame, 1);
    Random random(4802);
    for (int round = 0; round < rounds(100, 10); ++round) {
        const Cursor at = timeline.at_place(random.real(0.0, 1.0));
        if (at == cursor_end) continue;
        CAPTURE(to_text(at));
        const CodePlace last = walk.seek({at, -1}, replay.at(at));
        CHECK(last.cursor == at);
        const bool goes_on = step(walk);
        const Cursor next = timeline.next(at, Granularity::moment);
        CHECK(goes_on == (next != cursor_end));
        CHECK(walk.place() == CodePlace{next, 0});
        // A place beyond it is the last line.
        CHECK(walk.seek({at, last.lines + 7}, replay.at(at)) == last);
    }
}

TEST_CASE("A walk goes over a call, out of one, and to a line") {
    const Scene scene = lab_room();
    const Frame frame = walked_frame(scene, *find_stage("depth"));
    Framebuffer planes;
    clear(planes, frame);
    CodeWalk walk;
    walk.take(walked_code(), frame, 1);
    walk.seek({Timeline(frame).first(), 0}, planes);
    REQUIRE(innermost(walk.machine()) == "DrawPolygon");
    REQUIRE(step(walk));
    CHECK(innermost(walk.machine()) == "VertexShader");
    for (const CodeGoal goal : {CodeGoal::out, CodeGoal::over}) {
        walk.set_out(goal);
        REQUIRE(walk.go_on(1000) == CodeArrival::arrived);
        CHECK(innermost(walk.machine()) == "DrawPolygon");
    }
    const int line = line_with(walk, "leftPixels[row] = line[k]");
    REQUIRE(line > 0);
    walk.set_out(CodeGoal::meeting, line);
    // In parts, as over several frames.
    CodeArrival arrival = CodeArrival::on_the_way;
    int parts = 0;
    for (; arrival == CodeArrival::on_the_way; ++parts)
        arrival = walk.go_on(50);
    REQUIRE(arrival == CodeArrival::arrived);
    CHECK(parts > 1);
    CHECK(innermost(walk.machine()) == "ComputePolygonRows");
    CHECK(walk.machine().calls().back().line == line);
    CHECK(walk.place().cursor == Cursor(0, Phase::edges, 0, 0));
}

TEST_CASE("A walk stops where the condition of a line holds") {
    const Scene scene = lab_room();
    const Frame frame = walked_frame(scene, *find_stage("rows"));
    Framebuffer planes;
    clear(planes, frame);
    CodeWalk walk;
    walk.take(walked_code(), frame, 1);
    const int line = line_with(walk, "leftPixels[row] = line[k]");
    const ChosenLine asked = walk.lines()[static_cast<std::size_t>(line - 1)];
    walk.take(walked_code(), frame, 1, {{asked.file, asked.line, "line[k].x == 20"}});
    walk.seek({Timeline(frame).first(), 0}, planes);
    walk.set_out(CodeGoal::meeting);
    REQUIRE(walk.go_on(10'000'000) == CodeArrival::arrived);
    CHECK(walk.machine().calls().back().line == line);

    // The same by the events: the first sample in column 20 that becomes a left end.
    Cursor first = cursor_end;
    Observer observer;
    observer.edge_sample = [&](const SampleEvent& event) {
        if (first == cursor_end && event.sample.write.left && event.sample.fragment.column == 20)
            first = event.cursor;
    };
    Framebuffer drawn;
    clear(drawn, frame);
    draw(frame, {}, drawn, &observer);
    CHECK(to_text(walk.place().cursor) == to_text(first));
    const auto is_refused = [&](const ChosenLine& line, const std::string& condition) {
        try {
            walk.take(walked_code(), frame, 1, {{line.file, line.line, condition}});
        } catch (const InputError&) {
            return true;
        }
        return false;
    };
    for (const char* wrong :
         {"nonsense < 3", "row = 3", "k++", "leftPixels.resize(0)", "row +", "line",
          "Interpolate(a, b, line)", "(row > 3 ? leftPixels : rightPixels).size() > 5"}) {
        CAPTURE(wrong);
        CHECK(is_refused(asked, wrong));
    }
    CHECK(is_refused(asked, std::string(20'000, '(')));
    std::string sum = "row";
    for (int i = 0; i < 5000; ++i)
        sum += " + row";
    CHECK(is_refused(asked, sum + " > 3"));
    const ChosenLine brace = walk.lines()[static_cast<std::size_t>(line_with(walk, "{")) - 1];
    CHECK(is_refused(brace, "1 > 0"));
    // A loop's own variable is known from its second beginning on.
    const ChosenLine loop =
        walk.lines()[static_cast<std::size_t>(line_with(walk, "for (int k = 0; k < n; ++k)")) - 1];
    CHECK_FALSE(is_refused(loop, "k == 3"));
    // The walk is as it was.
    walk.take(walked_code(), frame, 1);
    walk.seek({Timeline(frame).first(), 0}, planes);
    CHECK(step(walk));
}

TEST_CASE("Walking back and forth in the code does not use up its memory") {
    const Scene scene = lab_room();
    const Frame frame = walked_frame(scene, *find_stage("vertex_light"));
    const Timeline timeline(frame);
    Replay replay;
    replay.begin(frame);
    CodeWalk walk;
    walk.take(walked_code(), frame, 1);
    const auto go_everywhere = [&] {
        for (int place = 0; place < 200; ++place) {
            const Cursor at = timeline.at_place(0.005 * place);
            walk.seek({at, 2}, replay.at(at));
        }
        return walk.machine().list_words();
    };
    const std::int64_t once = go_everywhere();
    CHECK(once > 0);
    for (int again = 0; again < 5; ++again)
        CHECK(go_everywhere() == once);
    CHECK(step(walk));
}

} // namespace rasterwalk::test
