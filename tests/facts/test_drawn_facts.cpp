// Facts checked against what was drawn, under every value of every setting: whatever function is
// in a slot of the table of stages, a fact says what that function has done.

#include <algorithm>
#include <cmath>

#include "facts/facts.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "support/bits.h"
#include "support/choices.h"
#include "support/effort.h"
#include "support/recorder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace drawn_facts_tests {

using test::Choice;

/// A session with its results, and what lessons can ask of them.
class Asked {
  public:
    explicit Asked(const std::string& scene)
        : session(open_session(lessons_folder() + "/scenes/" + scene + ".toml")) {}

    void show(const Settings& settings) {
        session.a.settings = settings;
        session.selection = {};
        session.cursor = cursor_end;
        update_all();
    }
    void update_all() { update(session, results); }
    const Frame& frame() const { return results.a.frame; }
    /// None where there is no such number.
    std::optional<double> number(std::string_view name) {
        const Value value = Facts(session, results, &cache)(name);
        if (!is_there(value)) return std::nullopt;
        return std::get<double>(value);
    }

    Session session;
    Results results;

  private:
    FactCache cache;
};

test::Recorder record(const Frame& frame) {
    test::Recorder recorder;
    Framebuffer picture;
    clear(picture, frame);
    draw(frame, {}, picture, &recorder);
    return recorder;
}

const FragmentEvent* written_at(const test::Recorder& recorder, const Cursor& cursor) {
    const auto found = std::find_if(
        recorder.fragments.begin(), recorder.fragments.end(), [&](const FragmentEvent& event) {
            return event.cursor == cursor && event.fate == Fate::written;
        });
    return found == recorder.fragments.end() ? nullptr : &*found;
}

/// The last fragment written on the pixel of a randomly chosen one.
const FragmentEvent* some_winner(const test::Recorder& recorder, test::Random& random) {
    const std::vector<FragmentEvent>& all = recorder.fragments;
    if (all.empty()) return nullptr;
    const Fragment& at =
        all[static_cast<std::size_t>(random.integer(0, static_cast<int>(all.size()) - 1))].fragment;
    const auto found = std::find_if(all.rbegin(), all.rend(), [&](const FragmentEvent& event) {
        return event.fate == Fate::written && event.fragment.column == at.column &&
               event.fragment.row == at.row;
    });
    return found == all.rend() ? nullptr : &*found;
}

/// Fails unless the fact exists and is the number that was drawn.
void expect(Asked& asked, const char* fact, float drawn, const std::string& where) {
    const std::optional<double> said = asked.number(fact);
    if (!said) FAIL(where << ": there is no " << fact << ", drawn is " << drawn);
    const auto number = static_cast<float>(*said);
    if (number != drawn && !(std::isnan(number) && std::isnan(drawn)))
        FAIL(where << ": " << fact << " is " << number << ", drawn is " << drawn);
}

/// How far apart the affine and the perspective-correct picture are at a fragment that neither
/// hides nor blends; none for others.
std::optional<float> drawn_apart(const Frame& frame, const Cursor& cursor) {
    if (frame.blends || frame.has_samples()) return std::nullopt;
    glm::vec3 colours[2];
    for (const Interpolation way : {Interpolation::perspective, Interpolation::affine}) {
        Settings settings = frame.settings;
        settings.interpolation = way;
        const test::Recorder recorder = record(prepare_frame(*frame.given, settings));
        const FragmentEvent* const event = written_at(recorder, cursor);
        if (event == nullptr) return std::nullopt;
        colours[way == Interpolation::affine ? 1 : 0] = event->after;
    }
    const glm::vec3 apart = glm::abs(colours[1] - colours[0]);
    const float largest = std::max({apart.x, apart.y, apart.z});
    return std::isfinite(apart.x + apart.y + apart.z) ? std::optional(largest) : std::nullopt;
}

void check_pixel(Asked& asked, const FragmentEvent& event, const std::string& where) {
    asked.session.selection.pixel = glm::ivec2(event.fragment.column, event.fragment.row);
    asked.session.cursor = event.cursor;
    asked.update_all();
    expect(asked, "pixel.red", event.after.r, where);
    expect(asked, "pixel.green", event.after.g, where);
    expect(asked, "pixel.blue", event.after.b, where);
    expect(asked, "pixel.depth", event.depth, where);
    expect(asked, "pixel.zinv", event.fragment.inv_w, where);
    expect(asked, "pixel.owner", static_cast<float>(event.cursor.triangle), where);
    if (asked.frame().squares != nullptr) return; // there a fragment is no moment
    expect(asked, "cursor.column", static_cast<float>(event.fragment.column), where);
    expect(asked, "cursor.row", static_cast<float>(event.fragment.row), where);
}

void check_vertices(Asked& asked, const test::Recorder& recorder, int triangle,
                    const std::string& where) {
    for (const VertexEvent& event : recorder.vertices) {
        if (event.cursor.triangle != triangle) continue;
        asked.session.selection.triangle = triangle;
        asked.session.selection.vertex = event.cursor.index;
        asked.update_all();
        if (!event.vertex.has_pixel) {
            CHECK_FALSE(asked.number("vertex.column"));
            continue;
        }
        expect(asked, "vertex.column", static_cast<float>(event.vertex.pixel.column), where);
        expect(asked, "vertex.row", static_cast<float>(event.vertex.pixel.row), where);
        expect(asked, "vertex.zinv", event.vertex.pixel.inv_w, where);
        expect(asked, "vertex.depth", event.vertex.pixel.depth, where);
    }
    asked.session.selection.triangle = triangle;
    asked.update_all();
    const bool is_culled = asked.frame().rejection(triangle) == Rejection::back_facing;
    expect(asked, "polygon.culled", is_culled ? 1.0f : 0.0f, where);
}

struct Seen {
    int pixels = 0, errors = 0, large_errors = 0;
};

void check_choice(Asked& asked, const Choice& choice, test::Random& random, Seen& seen) {
    asked.show(choice.settings);
    const test::Recorder recorder = record(asked.frame());
    const FragmentEvent* const event = some_winner(recorder, random);
    if (event == nullptr) return;
    FragmentEvent shown = *event;
    if (asked.frame().has_samples()) { // what the samples make together
        const Framebuffer picture = draw_frame(asked.frame());
        shown.after = picture.colour[picture.at(event->fragment.column, event->fragment.row)];
    }
    check_pixel(asked, shown, choice.name + ", " + to_text(event->cursor));
    ++seen.pixels;
    if (const std::optional<float> apart = drawn_apart(asked.frame(), event->cursor)) {
        expect(asked, "pixel.light_error", *apart, choice.name + ", " + to_text(event->cursor));
        ++seen.errors;
        seen.large_errors += *apart > 0.001f ? 1 : 0;
    }
    check_vertices(asked, recorder, event->cursor.triangle, choice.name);
}

TEST_CASE("Under every setting the facts of pixels and vertices are what was drawn") {
    test::Random random(2);
    Seen seen;
    for (const char* const name : {"lab-room", "cylinder", "studs", "receding-wall", "two-panes"}) {
        Asked asked(name);
        const Scene& scene = *asked.session.scene;
        for (const Choice& choice : test::some_of(test::single_choices(scene, "shading=phong"), 8))
            check_choice(asked, choice, random, seen);
        for (const char* const shading :
             {"shading=unlit", "shading=flat", "shading=gouraud", "shading=phong"}) {
            for (const Choice& choice :
                 test::mixed_choices(scene, shading, test::rounds(25, 4), random))
                check_choice(asked, choice, random, seen);
        }
    }
    CHECK(seen.pixels > 80);
    CHECK(2 * seen.errors > seen.pixels);
    CHECK(10 * seen.large_errors > seen.errors);
}

TEST_CASE("With the light reversed the light error is still that of the two pictures") {
    Asked asked("lab-room");
    Settings settings = default_settings(*asked.session.scene);
    settings.light_rules.direction = LightDirection::from_light;
    settings.viewport = {100, 100};
    settings.camera.focal_length = 100.0f;
    asked.show(settings);
    int equal = 0;
    for (int row = 5; row < 100; row += 10) {
        const glm::ivec2 pixel(50, row);
        asked.session.selection.pixel = pixel;
        asked.update_all();
        const auto at = fragment_on_pixel(asked.frame(), pixel, cursor_end);
        if (!at) continue;
        const std::optional<float> apart = drawn_apart(asked.frame(), *at);
        REQUIRE(apart);
        CAPTURE(row);
        CHECK(asked.number("pixel.light_error") == static_cast<double>(*apart));
        equal += *apart == 0.0f ? 1 : 0;
    }
    CHECK(equal > 3);
}

TEST_CASE("The pixels of a row are counted by the function that draws them") {
    // If the step along y is cut to 0, only the rows of the vertices get samples.
    Asked asked("shallow");
    Settings settings = default_settings(*asked.session.scene);
    settings.stage = Stage::fill;
    settings.line_walk = LineWalk::integer_step;
    for (const EmptyRows rule : {EmptyRows::skipped, EmptyRows::overflow}) {
        settings.empty_rows = rule;
        asked.show(settings);
        int empty_row_count = 0;
        for (int t = 0; t < asked.frame().triangle_count(); ++t) {
            PolygonRows rows;
            compute_rows(asked.frame(), t, rows);
            double sum = 0.0;
            for (int r = 0; r < rows.size(); ++r) {
                asked.session.selection.triangle = t;
                asked.session.selection.row = rows.first_row + r;
                asked.update_all();
                const std::optional<double> count = asked.number("table.count");
                REQUIRE(count);
                sum += *count;
                if (!rows.is_empty_row(r)) continue;
                CHECK(*count == (rule == EmptyRows::overflow ? 3.0 : 0.0));
                ++empty_row_count;
            }
            CHECK(asked.number("table.fragments") == sum);
        }
        CHECK(empty_row_count == 5);
    }
}

TEST_CASE("t at the near plane is where the function that clips puts the corner") {
    Asked asked("corridor");
    for (const Clip clip : {Clip::near, Clip::all, Clip::guard_band, Clip::wrong_t}) {
        Settings settings = default_settings(*asked.session.scene);
        settings.clip = clip;
        asked.show(settings);
        asked.session.selection.triangle = 0;
        asked.update_all();
        CAPTURE(word_of(clip));
        const std::optional<double> t = asked.number("triangle.near_t");
        REQUIRE(t);
        const auto given = asked.frame().given_clip_vertices(0);
        // From the corner in front, along the first edge that crosses the plane.
        std::size_t first = 0;
        const auto is_in = [&](std::size_t i) {
            return given[i % given.size()].position_clip.w >= settings.near;
        };
        while (is_in(first) == is_in(first + 1))
            ++first;
        float in = given[first].position_clip.w;
        float out = given[(first + 1) % given.size()].position_clip.w;
        if (!is_in(first)) std::swap(in, out);
        const auto cut = static_cast<double>(in) + *t * static_cast<double>(out - in);
        // clip_all() may go on to cut at the sides; then the corner is reported, not drawn.
        const test::Recorder recorder = record(asked.frame());
        const bool is_reported = std::any_of(
            recorder.clip_steps.begin(), recorder.clip_steps.end(), [&](const ClipEvent& event) {
                return event.step.is_cut && event.step.plane == ClipPlane::near &&
                       static_cast<double>(event.step.cut.position_clip.w) ==
                           Approx(cut).margin(1e-4);
            });
        CHECK(is_reported);
    }
}

} // namespace drawn_facts_tests
} // namespace
