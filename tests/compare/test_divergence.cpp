#include "compare/divergence.h"

#include <bit>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "compare/compare.h"
#include "picture/view_image.h"
#include "settings/setting_table.h"
#include "stages/light.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/recorder.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// What a run shows at one moment, as bits.
struct Seen {
    std::vector<std::uint32_t> work; ///< of the vertex or the edge sample
    std::vector<std::vector<std::uint32_t>> fragments;

    friend bool operator==(const Seen&, const Seen&) = default;
};

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value + 0.0f); // -0 is 0
}
std::uint32_t bits(int value) {
    return static_cast<std::uint32_t>(value);
}

void add(std::vector<std::uint32_t>& seen, const glm::vec3& v) {
    seen.insert(seen.end(), {bits(v.x), bits(v.y), bits(v.z)});
}

/// Everything that a run shows, by its moments: the plain walk.
/// @param as_shown colours as the screen shows them
/// @param with_ways edge samples and tested pixels too
std::map<Cursor, Seen> everything(const Frame& frame, bool with_light, bool as_shown = false,
                                  bool with_ways = true) {
    Recorder recorder(true);
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    std::map<Cursor, Seen> all;
    for (const VertexEvent& event : recorder.vertices) {
        std::vector<std::uint32_t>& work = all[event.cursor].work;
        const ScreenVertex& pixel = event.vertex.pixel;
        work = {bits(pixel.column), bits(pixel.row), bits(pixel.depth),
                event.vertex.has_pixel ? 1U : 0U};
        if (with_light) {
            const Vertex& vertex = frame.scene->corner(event.cursor.triangle, event.cursor.index);
            glm::vec3 normal = frame.stages.light_normal(vertex.normal, frame.settings.camera);
            const glm::vec3 sight = vertex.position - frame.settings.camera.position;
            const bool is_two_sided = frame.settings.light_rules.sides == LightSides::two;
            if (is_two_sided && glm::dot(normal, sight) > 0.0f) normal = -normal;
            add(work, reflected_light(vertex.position, normal, vertex.reflectance,
                                      light_rule(frame.settings), frame.settings.light_rules)
                          .reflected);
        }
    }
    for (const ClipEvent& event : recorder.clip_steps) {
        std::vector<std::uint32_t>& work = all[event.cursor].work;
        work = {event.step.keeps_from ? 1U : 0U};
        if (!event.step.is_cut) continue;
        work.push_back(bits(event.step.t));
        for (int i = 0; i < 4; ++i)
            work.push_back(bits(event.step.cut.position_clip[i]));
    }
    // A tested triangle that faces the camera goes on as if it had not been tested.
    for (const CullEvent& event : recorder.culls) {
        if (event.test.is_back) all[event.cursor].work = {1U};
    }
    for (const TestEvent& event : recorder.tests) {
        if (!with_ways) break;
        all[event.cursor].work = {bits(event.test.column), bits(event.test.row),
                                  event.test.is_inside ? 1U : 0U};
    }
    for (const SampleEvent& event : recorder.samples) {
        if (!with_ways) break;
        all[event.cursor].work = {bits(event.sample.fragment.column),
                                  bits(event.sample.fragment.row),
                                  event.sample.write.inside ? 1U : 0U};
    }
    for (const FragmentEvent& event : recorder.fragments) {
        std::vector<std::uint32_t> seen{bits(event.fragment.column), bits(event.fragment.row),
                                        static_cast<std::uint32_t>(event.fate)};
        // A mark has no depth.
        if (has_fragments(frame.settings.stage)) seen.push_back(bits(event.depth));
        const glm::vec3 shown = shown_colour(event.after, frame.stages.screen);
        if (event.fate == Fate::written) add(seen, as_shown ? shown : event.after);
        all[event.cursor].fragments.push_back(seen);
    }
    return all;
}

using Differences = std::map<Cursor, DivergenceKind>;

Differences differences(const Frame& a, const Frame& b) {
    const bool with_light = step_of(a.settings) == StripStep::vertex_light &&
                            step_of(b.settings) == StripStep::vertex_light;
    const bool as_shown = a.settings.colour_over_one != b.settings.colour_over_one ||
                          a.settings.encoding != b.settings.encoding ||
                          a.settings.channel_order != b.settings.channel_order;
    // Where the runs find pixels in different ways, only what they find is compared.
    const auto way = [](const Frame& frame) {
        return frame.settings.stage < Stage::rows ? Coverage::rows : frame.settings.coverage;
    };
    const auto walks = [&](const Frame& frame) { return way(frame) == Coverage::rows; };
    const auto tests = [&](const Frame& frame) { return way(frame) == Coverage::edge_functions; };
    const bool same_way = walks(a) == walks(b) && tests(a) == tests(b) &&
                          (!tests(a) || a.settings.box_walk == b.settings.box_walk);
    const std::map<Cursor, Seen> in_a = everything(a, with_light, as_shown, same_way);
    const std::map<Cursor, Seen> in_b = everything(b, with_light, as_shown, same_way);
    Differences found;
    for (const auto& [cursor, seen] : in_a) {
        const auto other = in_b.find(cursor);
        const std::size_t there = other == in_b.end() ? 0 : other->second.fragments.size();
        if (other == in_b.end() || seen.fragments.size() > there) {
            found[cursor] = DivergenceKind::missing;
        } else if (seen.fragments.size() < there) {
            found[cursor] = DivergenceKind::extra;
        } else if (!(seen == other->second)) {
            found[cursor] = DivergenceKind::other;
        }
    }
    for (const auto& [cursor, seen] : in_b) {
        if (!in_a.contains(cursor)) found[cursor] = DivergenceKind::extra;
    }
    return found;
}

std::vector<DivergenceGroup> groups_of(const Differences& differences) {
    std::map<std::tuple<int, Phase, DivergenceKind>, DivergenceGroup> groups;
    for (const auto& [cursor, kind] : differences) {
        DivergenceGroup& group = groups[{cursor.triangle, cursor.phase, kind}];
        const std::int64_t count = group.count + 1;
        if (count == 1) group = {cursor.triangle, cursor.phase, kind, 0, cursor, cursor};
        group.count = count;
        group.last = cursor;
    }
    std::vector<DivergenceGroup> list;
    list.reserve(groups.size());
    for (const auto& [key, group] : groups)
        list.push_back(group);
    return list;
}

/// Fails unless the divergences are those that the plain walk finds.
void require_true_divergences(const Frame& a, const Frame& b) {
    const Comparison comparison = compare_runs(a, b);
    const DivergenceList& found = comparison.divergences;
    if (!have_same_moments(a, b)) {
        // Moments of different lists cannot be compared.
        REQUIRE(found.count == 0);
        REQUIRE(comparison.only_pictures.ends_with("so only the pictures are compared."));
        REQUIRE(comparison.is_same() == (comparison.pixels.different == 0));
        return;
    }
    const Differences expected = differences(a, b);
    REQUIRE(found.count == static_cast<std::int64_t>(expected.size()));
    REQUIRE(found.first.has_value() == !expected.empty());
    if (found.first) {
        REQUIRE(to_text(found.first->cursor) == to_text(expected.begin()->first));
        REQUIRE(found.first->kind == expected.begin()->second);
        REQUIRE(found.first->text.ends_with("."));
    }
    REQUIRE(found.groups == groups_of(expected));
}

/// Calls `use` with pairs of values of each choice setting.
/// @param fewest pairs of each setting at each stage, if effort is low
/// @param apart if effort is low, a setting is tried only at every `apart`-th stage, starting one
/// stage later for each setting
void for_each_pair(const Scene& scene, std::size_t fewest, int apart,
                   const std::function<void(const Frame&, const Frame&)>& use) {
    int begin = 0;
    if (effort() >= 0.5) apart = 1;
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        // Only the steps have moments.
        if (choice == nullptr || setting.name == "engine") continue;
        for (int stage = begin++ % apart; stage < stage_count; stage += apart) {
            if (setting.name == "stage" && stage > 0) break;
            Settings settings = default_settings(scene);
            set_step(settings, stage_list()[static_cast<std::size_t>(stage)].step);
            std::vector<Frame> frames;
            for (const std::string_view word : choice->words) {
                set_value(settings, setting, word);
                frames.push_back(prepare_frame(scene, settings));
            }
            // Each stage begins with a different pair, so that a few tries reach many of them.
            const std::size_t pairs = frames.size() * frames.size();
            for (const std::size_t i : spread(pairs, fewest)) {
                const std::size_t pair = (i + static_cast<std::size_t>(stage)) % pairs;
                const Frame& a = frames[pair / frames.size()];
                const Frame& b = frames[pair % frames.size()];
                const std::string of_a = value_text(setting, a.settings);
                const std::string of_b = value_text(setting, b.settings);
                CAPTURE(setting.name, stage, of_a, of_b);
                use(a, b);
            }
        }
    }
}

Scene small_room() {
    Scene scene = lab_room();
    scene.viewport = {36, 28};
    scene.camera.focal_length = 30.0f;
    return scene;
}

} // namespace

TEST_CASE("For every two values of a choice the divergences are those of a plain walk: triangles") {
    const Scene scene = small_scene();
    for_each_pair(scene, 3, 1, require_true_divergences);
}

TEST_CASE("For every two values of a choice the divergences are those of a plain walk: the room") {
    const Scene scene = small_room();
    for_each_pair(scene, 2, 4, require_true_divergences);
}

TEST_CASE("Where triangles are cut and culled the divergences are those of a plain walk") {
    const Scene scene = cut_scene();
    for (const StageInfo& info : stage_list()) {
        std::vector<Frame> frames;
        for (const CutRules& rules : cut_rules)
            frames.push_back(cut_frame(scene, info.step, rules));
        for (const Frame& a : frames) {
            for (const Frame& b : frames)
                require_true_divergences(a, b);
        }
    }
}

TEST_CASE("The first difference names plane and edge, or why a triangle is culled") {
    const Scene scene = cut_scene();
    const Frame near = cut_frame(scene, {Stage::fill}, {Clip::near, Cull::none, Reject::none});
    const Frame all = cut_frame(scene, {Stage::fill}, {Clip::all, Cull::none, Reject::none});
    const std::optional<Divergence> first = next_divergence(near, all, cursor_begin);
    REQUIRE(first);
    CHECK(first->cursor.phase == Phase::clip);
    CHECK(first->cursor.index > 0);
    CHECK(first->kind == DivergenceKind::extra);
    const std::string plane(word_of(static_cast<ClipPlane>(first->cursor.index)));
    CHECK(first->text.starts_with(plane + " plane, edge 0: A does nothing; B "));
    const Frame culled =
        cut_frame(scene, {Stage::fill}, {Clip::near, Cull::screen_area, Reject::none});
    const std::optional<Divergence> back = next_divergence(near, culled, cursor_begin);
    REQUIRE(back);
    CHECK(back->cursor.phase == Phase::cull);
    CHECK(culled.rejection(back->cursor.triangle) == Rejection::back_facing);
    CHECK(back->text.starts_with("A does not cull; B culls: area times w = -"));
    CHECK(back->text.ends_with("its corners go round counterclockwise on the screen."));
}

TEST_CASE("For different cameras and lamps the divergences are those of a plain walk") {
    const Scene scene = small_room();
    for (const StripStep& stage :
         {StripStep{Stage::rows}, StripStep::vertex_light, StripStep::pixel_light}) {
        Settings settings = default_settings(scene);
        set_step(settings, stage);
        const Frame a = prepare_frame(scene, settings);
        settings.camera.position.z = -0.6f; // some triangles are behind it
        require_true_divergences(a, prepare_frame(scene, settings));
        require_true_divergences(prepare_frame(scene, settings), a);
        settings.camera = scene.camera;
        settings.light.power = glm::vec3(14.0f);
        require_true_divergences(a, prepare_frame(scene, settings));
    }
}

TEST_CASE("Triangles with more fragments than are kept at once are compared") {
    Scene scene = pixel_scene({{{{-200, -90, 1}, {900, 40, 2}, {100, 800, 3}}},
                               {{{0, 0, 1}, {500, 0, 1}, {0, 600, 1.5f}}}},
                              {400, 300});
    const Settings settings = default_settings(scene);
    Settings other = settings;
    other.interpolation = Interpolation::affine;
    other.line_walk = LineWalk::exact;
    require_true_divergences(prepare_frame(scene, settings), prepare_frame(scene, other));
}

TEST_CASE("Wild cameras, lamps and lenses are compared without harm") {
    Scene scene = lab_room();
    scene.viewport = {70, 50};
    Random random(11);
    for (int i = 0; i < rounds(60, 3); ++i) {
        const auto wild = [&] {
            Settings settings = default_settings(scene);
            set_step(
                settings,
                stage_list()[static_cast<std::size_t>(random.integer(0, stage_count - 1))].step);
            settings.camera.position = {random.real(-2.0, 2.0), random.real(-2.0, 2.0),
                                        random.real(-4.0, 1.0)};
            settings.camera.yaw = static_cast<float>(random.real(-4.0, 4.0));
            settings.camera.focal_length = static_cast<float>(random.real(1.0, 3000.0));
            settings.light.power = glm::vec3(static_cast<float>(random.real(0.0, 10000.0)));
            for (const Setting& setting : setting_table()) {
                const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
                if (choice == nullptr || setting.name == "stage") continue;
                const int words = static_cast<int>(choice->words.size());
                choice->write(settings, random.integer(0, words - 1));
            }
            return settings;
        };
        const Frame a = prepare_frame(scene, wild()), b = prepare_frame(scene, wild());
        require_true_divergences(a, b);
    }
}

TEST_CASE("From any moment to the next divergence and to the previous one") {
    const Scene scene = small_scene();
    Random random(7);
    for (const Variant& variant : rule_variants()) {
        for (const StripStep& stage :
             {StripStep{Stage::edges}, StripStep{Stage::rows}, StripStep::pixel_light}) {
            const Frame a = frame_of(scene, stage, rule_variants().front());
            const Frame b = frame_of(scene, stage, variant);
            CAPTURE(variant.name, strip_place(stage));
            const Differences all = differences(a, b);
            for (int i = 0; i < rounds(12, 4); ++i) {
                const Cursor cursor = i == 0 ? cursor_end : any_cursor(random, 9);
                const std::optional<Divergence> next = next_divergence(a, b, cursor);
                const auto expected = all.lower_bound(cursor);
                REQUIRE(next.has_value() == (expected != all.end()));
                if (next) REQUIRE(next->cursor == expected->first);
                const std::optional<Divergence> previous = previous_divergence(a, b, cursor);
                REQUIRE(previous.has_value() == (expected != all.begin()));
                if (previous) REQUIRE(previous->cursor == std::prev(expected)->first);
            }
        }
    }
}

TEST_CASE("At any moment you can ask whether the runs differ there") {
    const Scene scene = small_scene();
    for (const Variant& variant : some_of(rule_variants(), 4)) {
        for (const StripStep& stage : {StripStep{Stage::points}, StripStep{Stage::edges},
                                       StripStep{Stage::rows}, StripStep::pixel_light}) {
            const Frame a = frame_of(scene, stage, rule_variants().front());
            const Frame b = frame_of(scene, stage, variant);
            CAPTURE(variant.name, strip_place(stage));
            const Differences all = differences(a, b);
            std::set<Cursor> moments;
            for (const auto& [cursor, seen] : everything(a, false))
                moments.insert(cursor);
            for (const auto& [cursor, seen] : everything(b, false))
                moments.insert(cursor);
            Framebuffer picture_a, picture_b, scratch;
            clear(picture_a, a);
            clear(picture_b, b);
            Cursor before = cursor_begin;
            for (const Cursor& cursor : moments) {
                draw(a, {before, cursor, {}}, picture_a);
                draw(b, {before, cursor, {}}, picture_b);
                before = cursor;
                const std::optional<Divergence> here =
                    divergence_at(a, picture_a, b, picture_b, cursor, scratch);
                const auto expected = all.find(cursor);
                REQUIRE(here.has_value() == (expected != all.end()));
                if (!here) continue;
                REQUIRE(here->cursor == cursor);
                REQUIRE(here->kind == expected->second);
                const std::optional<Divergence> walked = next_divergence(a, b, cursor);
                REQUIRE(walked->text == here->text);
                REQUIRE(walked->only_rounding == here->only_rounding);
            }
        }
    }
}

TEST_CASE("A frame compared up to a moment") {
    const Scene scene = small_room();
    const Frame a = frame_of(scene, StripStep::pixel_light, rule_variants().front());
    const Variant floor{"", [](Settings& s) { set_rounding(s, Rounding::floor); }};
    const Frame b = frame_of(scene, StripStep::pixel_light, floor);
    const Differences all = differences(a, b);
    REQUIRE(all.size() > 20);
    const Cursor middle = std::next(all.begin(), 15)->first;
    const Comparison comparison = compare_runs(a, b, middle);
    CHECK(comparison.divergences.count == 15);
    Framebuffer picture_a, picture_b;
    clear(picture_a, a);
    clear(picture_b, b);
    draw(a, {cursor_begin, middle, {}}, picture_a);
    draw(b, {cursor_begin, middle, {}}, picture_b);
    CHECK(comparison.pixels == pixel_difference(picture_a, picture_b));
    CHECK(compare_runs(a, b, cursor_begin).is_same());
}

TEST_CASE("A difference no larger than rounding errors is distinguished from a real one") {
    // Edges along the axes and the diagonal are walked without error; 1/z in the rows is not.
    const Scene scene = pixel_scene({{{{0, 0, 1}, {30, 0, 3}, {0, 30, 7}}}}, {32, 32});
    const Variant& handout = rule_variants().front();
    const Variant exact{"", [](Settings& s) { s.line_walk = LineWalk::exact; }};
    const DivergenceList rounding =
        compare_runs(frame_of(scene, Stage::fill, handout), frame_of(scene, Stage::fill, exact))
            .divergences;
    REQUIRE(rounding.first);
    CHECK(rounding.first->only_rounding);
    CHECK_FALSE(rounding.first_beyond_rounding);
    const Variant affine{"", [](Settings& s) { s.interpolation = Interpolation::affine; }};
    const DivergenceList real = compare_runs(frame_of(scene, StripStep::pixel_light, handout),
                                             frame_of(scene, StripStep::pixel_light, affine))
                                    .divergences;
    REQUIRE(real.first_beyond_rounding);
    CHECK_FALSE(real.first_beyond_rounding->only_rounding);
}

namespace {

/// The cause of the first divergence of two runs of the room.
std::string cause(const Scene& scene, const StripStep& stage, const std::string& set_in_b,
                  const std::string& in_both = "stage=fill") {
    Settings settings = default_settings(scene);
    set_from_text(settings, in_both);
    set_step(settings, stage);
    const Frame a = prepare_frame(scene, settings);
    set_from_text(settings, set_in_b);
    const Frame b = prepare_frame(scene, settings);
    // The walk ends there; that this is the first of the whole list is tested above.
    const std::optional<Divergence> first = next_divergence(a, b, cursor_begin);
    return first ? to_text(first->cursor) + ": " + first->text : "";
}

} // namespace

TEST_CASE("The cause is given in words and numbers") {
    const Scene steep = pixel_scene({{{{0, 2, 1}, {3, 1, 1}, {6, 2, 1}}}}, {10, 6});
    CHECK(cause(steep, {Stage::fill}, "line_walk=exact") ==
          "t0/e0/s3: edge 0, line[3] of 4. A: y = 0.9999999 is cut to 0, above the first row 1. "
          "B: y = 1.");
    CHECK(cause(steep, {Stage::fill}, "edge_samples=rows") ==
          "t0/e0/s1: edge 0, line[1] of 4. A: x = 1. B: x = 3.");
    const Scene room = lab_room();
    CHECK(cause(room, {Stage::depth}, "depth_test=off") ==
          "t1/r0/c0: pixel (126, 374): 1/z = 0.249938 is hidden by 0.249938 in A; 0.249938 is "
          "written without a test in B.");
    CHECK(cause(room, {Stage::fill}, "line_walk=exact") ==
          "t0/e0/s373: edge 0, line[373] of 374. A: y = 498.997 is cut to 498. B: y = 499.");
    CHECK(cause(room, {Stage::edges}, "rounding=floor") ==
          "t0/v0: vertices[0]: in A projected to (-124.969, 124.969) from the middle, cut to "
          "pixel (126, 374); in B projected to (-124.969, 124.969) from the middle, rounded down "
          "to pixel (125, 374).");
    CHECK(cause(room, {Stage::depth}, "depth_test=linear_z") ==
          "t0/r0/c1: pixel (127, 374): the depth value is 0.250607 in A, 0.250273 in B.");
    // 0.1 · (100 − 4.001) / 99.9 / 4.001.
    CHECK(cause(room, {Stage::points}, "depth_format=reversed_32") ==
          "t0/v0: vertices[0]: the depth value is 0.249938 in A, 0.0240178 in B.");
    CHECK(cause(room, {Stage::points}, "camera.position=0,0,-0.5") ==
          "t0/v0: B leaves the triangle out: a vertex lies on or behind the camera plane.");
    CHECK(cause(room, {Stage::points}, "stage=edges") ==
          "t0/v0: only A puts a mark on the picture; the stages are points and edges.");
    CHECK(cause(room, {Stage::edges}, "stage=fill") ==
          "t0/e0/s0: only A puts a mark on the picture; the stages are edges and fill.");
    // The same pixels are found, whichever pixels of the box are tested.
    CHECK(cause(room, {Stage::depth}, "box_walk=interval", "coverage=edge_functions").empty());
    CHECK(cause(room, StripStep::vertex_light, "light.power=2.2") ==
          "t0/v0: vertices[0]: its light is (0.0762945, 0.381473, 0.0762945) in A, (0.0775891, "
          "0.387945, 0.0775891) in B.");
    CHECK(cause(room, StripStep::pixel_light, "light.power=2.2") ==
          "t0/r0/c0: pixel (126, 374): the colour is (0.0762945, 0.381473, 0.0762945) in A, "
          "(0.0775891, 0.387945, 0.0775891) in B; green differs by 0.00647.");
}
