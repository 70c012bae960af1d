#include "tests/support/random_session.h"

#include <filesystem>

#include "facts/facts.h"
#include "lessons/lesson_run.h"
#include "picture/view_image.h"
#include "pipeline/timeline.h"
#include "session/bench.h"
#include "session/content.h"
#include "session/second_run.h"
#include "session/tabs.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

namespace {

constexpr int largest_side = 700; ///< of a picture

struct Changer {
    Random& random;
    Settings& settings;

    float number(float smallest, float largest) const {
        // Often a round one, as a student types it.
        const float value =
            random.number(static_cast<double>(smallest), static_cast<double>(largest));
        return random.integer(0, 1) == 0 ? value : std::clamp(std::round(value), smallest, largest);
    }
    void operator()(const ChoiceSetting& kind) const {
        kind.write(settings, random.integer(0, static_cast<int>(kind.words.size()) - 1));
    }
    void operator()(const NumberSetting& kind) const {
        kind.value(settings) = number(kind.smallest, kind.largest);
    }
    void operator()(const WholeSetting& kind) const {
        constexpr int largest_tried = 3; // of many triangles a picture takes long
        const int most = std::max(std::min(kind.largest, largest_tried), kind.smallest + kind.step);
        kind.value(settings) = allowed_value(kind, random.integer(kind.smallest, most));
    }
    void operator()(const VectorSetting& kind) const {
        for (int i = 0; i < 3; ++i)
            kind.value(settings)[i] = number(kind.smallest, kind.largest);
        if (kind.is_colour && random.integer(0, 1) == 0) {
            kind.value(settings) = glm::vec3(kind.value(settings).x);
        }
    }
    void operator()(const SizeSetting& kind) const {
        kind.value(settings) = {random.integer(1, largest_side), random.integer(1, largest_side)};
    }
    void operator()(const BoxSetting& kind) const {
        const ViewBox box{number(kind.smallest, kind.largest), number(kind.smallest, kind.largest),
                          number(kind.smallest, kind.largest), number(kind.smallest, kind.largest)};
        const ViewBox near_axis{-random.number(0.01, 1), random.number(0.01, 1),
                                -random.number(0.01, 1), random.number(0.01, 1)};
        kind.value(settings) = is_allowed(box, kind) ? box : near_axis;
    }
};

void change_some(Random& random, Settings& settings, int one_in) {
    for (const Setting& setting : setting_table()) {
        if (random.integer(1, one_in) == 1) std::visit(Changer{random, settings}, setting.kind);
    }
}

Session started(Random& random) {
    const char* const scenes[] = {"lab-room", "one-triangle", "fence", "linear-z", "slivers"};
    const char* const lessons[] = {"01-pinhole-camera", "05-row-table", "11-perspective",
                                   "12-float-traps"};
    const std::string scene = scenes[random.integer(0, 4)];
    Session session = open_session(lessons_folder() + "/scenes/" + scene + ".toml");
    if (random.integer(0, 2) > 0) return session;
    const Lesson lesson =
        read_lesson(lessons_folder() + "/" + lessons[random.integer(0, 3)] + ".md");
    open_step(session, lesson, random.integer(0, static_cast<int>(lesson.steps.size()) - 1));
    // In a lesson, a scene other than its own may be open.
    if (random.integer(0, 3) == 0) {
        set_scene(session, *open_session(lessons_folder() + "/scenes/" + scene + ".toml").scene);
    }
    return session;
}

void select_some(Random& random, Session& session) {
    const Viewport& size = session.a.settings.viewport;
    const auto maybe = [&](int count) {
        return random.integer(0, 2) == 0 ? std::nullopt
                                         : std::optional(random.integer(0, count - 1));
    };
    Selection& selection = session.selection;
    selection.triangle = maybe(session.scene->triangle_count());
    selection.vertex = maybe(3);
    selection.row = maybe(size.height);
    selection.pixel = std::nullopt;
    if (random.integer(0, 1) == 0) {
        selection.pixel = {random.integer(0, size.width - 1), random.integer(0, size.height - 1)};
    }
}

void look_somehow(Random& random, Session& session) {
    session.tab = tab_names()[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(tab_names().size()) - 1))];
    session.page = static_cast<SidePage>(random.integer(0, 2));
    session.view = static_cast<View>(random.integer(0, 3));
    session.overlays.bits =
        static_cast<std::uint8_t>(random.integer(0, 1) * random.integer(0, 255));
    session.compare_view = static_cast<CompareView>(random.integer(0, compare_view_count - 1));
    if (random.integer(0, 2) == 0) session.wipe = random.number(0, 1);
    session.depth_range = std::nullopt;
    if (random.integer(0, 1) == 0) {
        const float smallest = random.number(0, 2);
        session.depth_range = DepthInterval{smallest, smallest + random.number(0, 2)};
    }
    session.canvas = {};
    session.canvas.grid = random.integer(0, 3) > 0;
    session.canvas.row_table = random.integer(0, 3) > 0;
    session.canvas.fates = random.integer(0, 3) > 0;
    session.canvas.numbers = static_cast<CellNumbers>(random.integer(0, cell_numbers_count - 1));
    if (random.integer(0, 2) == 0) session.canvas.field_edge = random.integer(0, 2);
    session.canvas.shows = static_cast<CanvasShows>(random.integer(0, canvas_shows_count - 1));
    OutsideView& outside = session.canvas.outside;
    outside.is_camera = random.integer(0, 5) == 0;
    if (!outside.is_camera && random.integer(0, 1) == 0) {
        outside.yaw = random.number(-4, 4);
        outside.pitch = random.number(-1.5, 1.5);
        if (random.integer(0, 1) == 0) {
            outside.distance = random.number(0.01, 100);
            outside.target = {random.number(-9, 9), random.number(-9, 9), random.number(-9, 9)};
        }
    }
    if (random.integer(0, 1) == 0) {
        session.canvas.zoom = random.number(0.25, 64);
        session.canvas.centre = {random.number(-50, 800), random.number(-50, 800)};
    }
}

} // namespace

Session random_session(Random& random) {
    Session session = started(random);
    if (random.integer(0, 3) > 0) change_some(random, session.a.settings, random.integer(1, 20));
    for (int i = 0; is_bench(*session.scene) && i < random.integer(0, 3); ++i) {
        const int last = session.scene->triangle_count() - 1;
        move_bench_vertex(session, random.integer(0, last), random.integer(0, 2),
                          {random.integer(-30, 60), random.integer(-30, 60)});
    }
    if (is_bench(*session.scene) && !session.scene->examples.empty() && random.integer(0, 2) == 0) {
        const auto& examples = session.scene->examples;
        show_bench_example(session, examples[static_cast<std::size_t>(
                                        random.integer(0, static_cast<int>(examples.size()) - 1))]);
    }
    if (random.integer(0, 4) > 0) select_some(random, session);
    if (random.integer(0, 4) > 0) look_somehow(random, session);
    if (random.integer(0, 2) == 0) {
        Settings other = session.a.settings;
        change_some(random, other, 8);
        compare_with(session, other);
    }
    if (random.integer(0, 2) == 0) {
        session.cursor = {random.integer(0, 30),
                          static_cast<Phase>(random.integer(0, phase_count - 1)),
                          random.integer(0, 40), random.integer(0, 40)};
    }
    const Frame frame = prepare_frame(*session.scene, session.a.settings);
    session.cursor = Timeline(frame).at_or_after(session.cursor);
    // A selection that a new picture size has put outside is dropped.
    Selection& selection = session.selection;
    const Viewport& size = session.a.settings.viewport;
    if (selection.row && *selection.row >= size.height) selection.row = std::nullopt;
    if (selection.pixel &&
        (selection.pixel->x >= size.width || selection.pixel->y >= size.height)) {
        selection.pixel = std::nullopt;
    }
    return session;
}

void check_same_view(const Session& is, const Session& expected) {
    CHECK(std::filesystem::equivalent(is.scene->path, expected.scene->path));
    CHECK(moved_triangles(*is.scene, *expected.scene).empty());
    CHECK(is.a.settings == expected.a.settings);
    for (const RunDifference& difference : run_differences(is.a.settings, expected.a.settings))
        UNSCOPED_INFO(difference.setting << " is " << difference.a << ", not " << difference.b);
    CHECK(is.b.has_value() == expected.b.has_value());
    CHECK(is.b == expected.b);
    CHECK(is.compare_view == expected.compare_view);
    CHECK(is.wipe == expected.wipe);
    CHECK(to_text(is.cursor) == to_text(expected.cursor));
    CHECK(is.selection == expected.selection);
    CHECK(is.view == expected.view);
    CHECK(is.overlays == expected.overlays);
    CHECK(is.canvas.zoom == expected.canvas.zoom);
    if (is.canvas.zoom > 0.0f) CHECK(is.canvas.centre == expected.canvas.centre);
    CHECK(is.canvas.grid == expected.canvas.grid);
    CHECK(is.canvas.row_table == expected.canvas.row_table);
    CHECK(is.canvas.fates == expected.canvas.fates);
    CHECK(is.canvas.numbers == expected.canvas.numbers);
    CHECK(is.canvas.shows == expected.canvas.shows);
    CHECK(is.canvas.outside == expected.canvas.outside);
    CHECK(is.tab == expected.tab);
    CHECK(is.page == expected.page);
    CHECK(is.depth_range == expected.depth_range);
    CHECK(is.lesson == expected.lesson);
    CHECK(is.step == expected.step);
    CHECK(is.lesson_folder == expected.lesson_folder);
}

} // namespace rasterwalk::test
