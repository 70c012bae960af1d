// Interpolation with weights between affine's and those of perspective, compared with sums of the
// corners' values in long double.

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/draw.h"
#include "pipeline/observer.h"
#include "settings/choose_stages.h"
#include "settings/setting_table.h"
#include "support/choices.h"
#include "support/frames.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings mixed_settings(const Scene& scene, float mix) {
    Settings settings = default_settings(scene);
    settings.interpolation = Interpolation::mixed;
    settings.interpolation_mix = mix;
    return settings;
}

} // namespace

TEST_CASE("The weight runs in a straight line from 1 to d/z, and the unit of length cancels") {
    Random random(46);
    for (int i = 0; i < 2000; ++i) {
        Stages stages;
        stages.mixed_weight = {random.number(0, 1), random.number(0.1, 20)};
        const float z = random.number(0.1, 50);
        const long double m = stages.mixed_weight.mix, d = stages.mixed_weight.depth;
        const auto wanted = static_cast<double>(1 - m + m * d / z);
        CHECK(static_cast<double>(mixed_weight(1 / z, stages)) == Approx(wanted).epsilon(1e-6));
        Stages in_halves = stages;
        in_halves.mixed_weight.depth *= 2.0f;
        CHECK(mixed_weight(1 / (2 * z), in_halves) == Approx(mixed_weight(1 / z, stages)));
    }
}

TEST_CASE("A value under mixed weights is the mean of the corners' by these weights") {
    const Scene room = lab_room();
    for (const float mix : {0.0f, 0.3f, 0.5f, 0.85f, 1.0f}) {
        Settings settings = mixed_settings(room, mix);
        settings.coverage = Coverage::edge_functions;
        settings.snap = Snap::subpixel;
        set_step(settings, {Stage::shade, Shading::phong});
        const Frame frame = prepare_frame(room, settings);
        // The room's origin is in its middle, and the camera looks straight at it.
        const long double d = -settings.camera.position.z;
        double worst = 0.0;
        int tested = 0;
        const Observer observer{.fragment = [&](const FragmentEvent& event) {
            if (++tested % 97 != 0) return;
            const PolygonCorners corners = frame.triangle_vertices(event.cursor.triangle);
            std::array<long double, 3> x{}, y{};
            for (std::size_t i = 0; i < 3; ++i) {
                x[i] = std::round(corners[i].position.x * 256.0L) / 256.0L;
                y[i] = std::round(corners[i].position.y * 256.0L) / 256.0L;
            }
            const long double px = event.fragment.column + 0.5L, py = event.fragment.row + 0.5L;
            long double sum = 0, above = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
                const long double part = (x[j] - px) * (y[k] - py) - (x[k] - px) * (y[j] - py);
                const Vertex& vertex = room.mesh.corner(event.cursor.triangle, static_cast<int>(i));
                const long double z = vertex.position.z + d;
                const long double weight = part * (1 - mix + mix * d / z);
                sum += weight;
                above += weight * vertex.position.z;
            }
            const float shown = recover_varyings(event.fragment, frame.stages).position_world.z;
            worst = std::max(worst, std::abs(static_cast<double>(above / sum) - shown));
        }};
        Framebuffer target;
        clear(target, frame);
        draw(frame, {}, target, &observer);
        CAPTURE(mix, tested);
        CHECK(tested > 10000);
        CHECK(worst < 2e-5);
    }
}

TEST_CASE("Mixed interpolation ends at the affine and at the perspective-correct picture") {
    for (const char* const name : {"lab-room", "checkered-room"}) {
        const Scene scene = lesson_scene(name);
        const auto drawn = [&](const Settings& settings) {
            Settings shaded = settings;
            set_step(shaded, {Stage::shade, Shading::phong});
            return draw_frame(prepare_frame(scene, shaded));
        };
        for (const float mix : {0.0f, 0.5f, 1.0f}) {
            const Framebuffer mixed = drawn(mixed_settings(scene, mix));
            for (const Interpolation end : {Interpolation::affine, Interpolation::perspective}) {
                Settings settings = default_settings(scene);
                settings.interpolation = end;
                const Framebuffer other = drawn(settings);
                std::size_t differing = 0;
                for (std::size_t i = 0; i < other.colour.size(); ++i) {
                    const glm::vec3 off = glm::abs(other.colour[i] - mixed.colour[i]);
                    if (std::max({off.r, off.g, off.b}) > 0.01f) ++differing;
                }
                const bool is_same = mix == (end == Interpolation::affine ? 0.0f : 1.0f);
                CAPTURE(name, mix, std::string(word_of(end)), differing, other.colour.size());
                // Where a border between texels goes through a pixel's centre, rounding decides.
                CHECK((differing < other.colour.size() / 100) == is_same);
            }
        }
    }
}
