// Most lab programs cut the sum, int(f x/z + W/2), which is just as correct. Every mistake must be
// found even then.

#include <algorithm>

#include "laboratory/bug_rule.h"
#include "laboratory/diagnose.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "support/effort.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace sum_cut {

Image picture_of(const Scene& scene, const Settings& settings) {
    return view_image(draw_frame(prepare_frame(scene, settings)), View::colour);
}

TEST_CASE("Every mistake is named even if vertices are cut after adding the middle") {
    const Scene room = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    constexpr int side = 200;
    Settings reference = default_settings(room);
    reference.viewport = {side, side};
    reference.camera.focal_length = side;
    std::vector<std::string> ids;
    for (const Bug& bug : bugs)
        ids.push_back(bug.id);
    int shown = 0;
    for (const std::string& id : some_of(ids, 10)) {
        const Bug& bug = find_bug(bugs, id);
        Settings right = correct_run(bug, reference);
        right.camera = reference.camera;
        right.vertex_rounding = VertexRounding::truncate_sum;
        Settings wrong = right;
        apply_bug_rule(bug, wrong);
        constexpr std::int64_t least_pixels = 20;
        const Image picture = picture_of(room, wrong);
        const bool is_reported = wrong.vertex_rounding == right.vertex_rounding &&
                                 changes_rule(bug) && !is_made_by(bug, reference);
        if (!is_reported || differences_of(picture, picture_of(room, right)).pixels < least_pixels)
            continue;
        ++shown;
        const Diagnosis diagnosis = diagnose_picture(picture, room, reference, bugs);
        INFO(id << ": " << diagnosis.verdict);
        const std::vector<std::string> named = diagnosis.candidates.empty()
                                                   ? std::vector<std::string>{}
                                                   : diagnosis.candidates.front().ids();
        CHECK(std::find(named.begin(), named.end(), id) != named.end());
    }
    CHECK(shown > 0);
}

} // namespace sum_cut
} // namespace
