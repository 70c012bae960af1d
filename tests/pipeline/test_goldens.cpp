// The room's pictures, every bit of them. The goldens are in tests/golden/room.txt, one line per
// picture; with RASTERWALK_BLESS=1 in the environment this test writes them instead.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/project_root.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

struct Counts {
    DrawTally tally;
    unsigned max_overdraw = 0;
    int uncovered = 0;
    Framebuffer framebuffer;
};

Counts draw_counted(const Frame& frame) {
    Counts counts;
    // The farthest depth that a buffer can hold, whatever depth_clear says.
    const ClipDepth kind = depth_kind(frame);
    PictureRules rules;
    rules.depth_clear = farthest_depth(kind);
    rules.depth_kind = kind;
    clear(counts.framebuffer, frame.settings.viewport, {0, 0}, rules);
    counts.tally = draw(frame, {}, counts.framebuffer);
    for (const std::uint32_t overdraw : counts.framebuffer.overdraw) {
        counts.max_overdraw = std::max(counts.max_overdraw, overdraw);
        counts.uncovered += overdraw == 0 ? 1 : 0;
    }
    return counts;
}

std::string golden_line(const std::string& name, const Frame& frame) {
    const Counts counts = draw_counted(frame);
    std::ostringstream line;
    line << name << ": fragments " << counts.tally.fragments << ", max_overdraw "
         << counts.max_overdraw << ", uncovered " << counts.uncovered << ", outside "
         << counts.tally.samples_outside << " -> " << hash_text(counts.framebuffer);
    return line.str();
}

std::string stage_name(const StripStep& step) {
    return std::string(stage_list()[static_cast<std::size_t>(strip_place(step))].name);
}

struct Picture {
    std::string name;
    Frame frame;
};

/// A picture for every stage under the handout's rules, the exact rules and visible light; for
/// every other rule; and for every other camera.
std::vector<Picture> golden_pictures(const Scene& room) {
    const std::vector<Variant> presets{
        {"handout", [](Settings&) {}},
        {"exact",
         [](Settings& s) {
             set_rounding(s, Rounding::floor);
             s.line_walk = LineWalk::exact;
         }},
        {"visible light", [](Settings& s) { s.light.power = glm::vec3(14.0f); }},
    };
    std::vector<Picture> pictures;
    for (const Variant& preset : presets) {
        for (const StageInfo& info : stage_list()) {
            pictures.push_back(
                {preset.name + ", " + std::string(info.name), frame_of(room, info.step, preset)});
        }
    }
    for (const Variant& variant : rule_variants()) {
        if (variant.name == "handout") continue;
        for (const StripStep& stage :
             {StripStep{Stage::rows}, StripStep::vertex_light, StripStep::pixel_light}) {
            pictures.push_back(
                {variant.name + ", " + stage_name(stage), frame_of(room, stage, variant)});
        }
    }
    for (const Pose& pose : room_poses()) {
        if (&pose == &room_poses().front()) continue; // the handout's own
        const Variant view{"camera " + pose.name, [&](Settings& s) {
                               s.camera = pose.camera;
                               s.viewport = pose.viewport;
                           }};
        pictures.push_back({view.name, frame_of(room, StripStep::pixel_light, view)});
    }
    return pictures;
}

} // namespace

TEST_CASE("The room has the handout's numbers at every stage that fills") {
    const Scene room = lab_room();
    CHECK(room.triangle_count() == 30);
    for (const StripStep& stage : {StripStep{Stage::fill}, StripStep{Stage::depth},
                                   StripStep::vertex_light, StripStep::pixel_light}) {
        const Counts counts = draw_counted(frame_of(room, stage, rule_variants().front()));
        CAPTURE(stage_name(stage));
        CHECK(counts.tally.fragments == 328'789);
        CHECK(counts.max_overdraw == 8);
        CHECK(counts.uncovered == 998);
        CHECK(counts.tally.samples_outside == 4);
    }
}

TEST_CASE("In the handout's picture row 0 is black, and so is nearly all of column 0") {
    const Scene room = lab_room();
    const Framebuffer picture = draw_frame(frame_of(room, Stage::fill, rule_variants().front()));
    int row_0 = 0, column_0 = 0, elsewhere = 0;
    for (int row = 0; row < 500; ++row) {
        for (int column = 0; column < 500; ++column) {
            if (picture.overdraw[picture.at(column, row)] > 0) continue;
            (row == 0 ? row_0 : column == 0 ? column_0 : elsewhere) += 1;
        }
    }
    CHECK(row_0 == 500);
    CHECK(column_0 == 498);
    CHECK(elsewhere == 0);
}

TEST_CASE("The room's pictures match their goldens, bit for bit") {
    const std::string path = project_root() + "/tests/golden/room.txt";
    const Scene room = lab_room();
    const std::vector<Picture> pictures = golden_pictures(room);
    if (const char* bless = std::getenv("RASTERWALK_BLESS"); bless && std::string(bless) == "1") {
        std::ofstream file(path);
        for (const Picture& picture : pictures)
            file << golden_line(picture.name, picture.frame) << '\n';
        REQUIRE(file.flush());
        WARN(path << " is written");
        return;
    }
    std::ifstream file(path);
    std::vector<std::string> goldens;
    for (std::string line; std::getline(file, line);)
        goldens.push_back(line);
    REQUIRE(goldens.size() == pictures.size());
    for (const std::size_t i : spread(pictures.size(), 12))
        CHECK(goldens[i] == golden_line(pictures[i].name, pictures[i].frame));
}
