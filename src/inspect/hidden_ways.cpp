#include "inspect/hidden_ways.h"

#include <algorithm>

#include "base/enum_words.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

/// How much farther away than the nearest a surface is before showing it is wrong: where two
/// surfaces meet, each is as right as the other.
constexpr double wrong_from = 1e-3;

// The sizes of what has to be remembered, bytes.
constexpr std::int64_t number_bytes = 4, float_bytes = 4;
constexpr std::int64_t plane_bytes = 4 * float_bytes;
constexpr std::int64_t node_bytes = plane_bytes + 3 * number_bytes; // both sides, and its pieces
constexpr std::int64_t corner_bytes = 3 * float_bytes;

std::int64_t tree_bytes(const BspTree& tree) {
    std::int64_t bytes = node_bytes * std::ssize(tree.nodes);
    for (const BspPiece& piece : tree.pieces)
        bytes += number_bytes + (piece.is_cut ? triangle_corners * corner_bytes : 0);
    return bytes;
}

} // namespace

HiddenCounts hidden_counts(const Frame& frame, const DrawTally& tally) {
    if (frame.list == nullptr) {
        if (depth_rule(frame.settings) == DepthTest::off) return {};
        const Viewport& size = frame.settings.viewport;
        return {tally.fragments, 0, float_bytes * size.width * size.height};
    }
    const DrawnList& list = *frame.list;
    if (list.divided == nullptr) {
        return {list.comparisons, 0,
                (float_bytes + number_bytes) * static_cast<std::int64_t>(list.depths.size())};
    }
    const BspTree& tree = list.divided->tree;
    return {list.comparisons, tree.splits, tree_bytes(tree)};
}

HiddenWaysWork::HiddenWaysWork(const Scene& scene, const Settings& settings)
    : scene_(&scene), settings_(settings) {}

bool HiddenWaysWork::is_done() const {
    return ways_.size() == enum_words<Hidden>.size();
}

void HiddenWaysWork::advance(const WorkLimit& limit) {
    double left = limit.at_once;
    while (!is_done() && left > 0.0) {
        if (!is_begun_) {
            Settings settings = settings_;
            settings.hidden = static_cast<Hidden>(ways_.size());
            settings.engine = Engine::steps;
            settings.stage = Stage::depth;
            settings.depth_test = DepthTest::inverse_z;
            settings.depth_format = DepthFormat::inv_z;
            settings.depth_index = DepthIndex::row_major;
            settings.depth_clear = settings.depth_epsilon = 0.0f;
            drawing_.begin(*scene_, settings);
            is_begun_ = true;
        }
        left -= drawing_.advance(std::min(left, limit.slice));
        if (drawing_.is_done()) count();
    }
}

/// What each pixel of the picture that was drawn shows.
std::vector<HiddenWaysWork::Shown> HiddenWaysWork::shown() const {
    const Framebuffer& picture = drawing_.picture();
    const Frame& frame = drawing_.frame();
    const DepthRules rules = depth_rules(frame.settings, frame.scene->space);
    std::vector<Shown> pixels(picture.owner.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (picture.owner[i] < 0) continue;
        pixels[i] = {scene_triangle(*frame.scene, picture.owner[i]),
                     z_of_depth(picture.depth[i], rules)};
    }
    return pixels;
}

void HiddenWaysWork::count() {
    const Frame& frame = drawing_.frame();
    HiddenWay way;
    way.way = hidden_rule(frame.settings);
    way.is_possible = way.way == Hidden::depth_buffer || frame.list != nullptr;
    way.triangles = frame.triangle_count();
    way.counts = hidden_counts(frame, drawing_.tally());
    if (way.way == Hidden::depth_buffer) {
        by_buffer_ = shown();
    } else if (way.is_possible) {
        const std::vector<Shown> pixels = shown();
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Shown &here = pixels[i], &nearest = by_buffer_[i];
            const bool is_another = here.triangle >= 0 && here.triangle != nearest.triangle;
            way.wrong += is_another && here.z > (1.0 + wrong_from) * nearest.z ? 1 : 0;
        }
    }
    ways_.push_back(way);
    is_begun_ = false;
}

std::vector<HiddenWay> hidden_ways(const Scene& scene, const Settings& settings) {
    HiddenWaysWork work(scene, settings);
    while (!work.is_done())
        work.advance();
    return work.ways();
}

} // namespace rasterwalk
