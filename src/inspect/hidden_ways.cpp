#include "inspect/hidden_ways.h"

#include <algorithm>

#include "base/enum_words.h"

namespace rasterwalk {

namespace {

// The sizes of what has to be remembered, bytes.
constexpr std::int64_t number_bytes = 4, float_bytes = 4;
constexpr std::int64_t plane_bytes = 4 * float_bytes;
constexpr std::int64_t node_bytes = plane_bytes + 3 * number_bytes; // both sides, and its pieces
constexpr std::int64_t corner_bytes = 3 * float_bytes;
constexpr std::int64_t row_bytes = 2 * number_bytes + 2 * float_bytes; // its ends, their depths

std::int64_t tree_bytes(const BspTree& tree) {
    std::int64_t bytes = node_bytes * std::ssize(tree.nodes);
    for (const BspPiece& piece : tree.pieces)
        bytes += number_bytes + (piece.is_cut ? triangle_corners * corner_bytes : 0);
    return bytes;
}

HiddenCounts counts_of(const WarnockSquares& squares) {
    HiddenCounts counts{squares.comparisons, 0, squares.count(), 0};
    for (const PolygonRows& table : squares.tables)
        counts.memory += row_bytes * table.size();
    return counts;
}

} // namespace

HiddenCounts hidden_counts(const Frame& frame, const DrawTally& tally) {
    if (frame.squares != nullptr) return counts_of(*frame.squares);
    if (hidden_rule(frame.settings) == Hidden::depth_buffer || frame.list == nullptr) {
        if (depth_rule(frame.settings) == DepthTest::off) return {};
        const Viewport& size = frame.settings.viewport;
        const std::int64_t pixels = std::int64_t{size.width} * size.height;
        if (frame.has_samples())
            return {tally.samples_compared, 0, 0, float_bytes * sample_count * pixels};
        return {tally.fragments - tally.depth_outside, 0, 0, float_bytes * pixels};
    }
    const DrawnList& list = *frame.list;
    if (list.divided == nullptr) {
        return {list.comparisons, 0, 0,
                (float_bytes + number_bytes) * static_cast<std::int64_t>(list.depths.size())};
    }
    const BspTree& tree = list.divided->tree;
    return {list.comparisons, tree.splits, 0, tree_bytes(tree)};
}

Settings counted_settings(const Settings& settings) {
    Settings counted = settings;
    counted.hidden = Hidden::depth_buffer;
    counted.draw_order = DrawOrder::scene;
    counted.engine = Engine::steps;
    counted.stage = Stage::depth;
    counted.depth_test = DepthTest::inverse_z;
    counted.depth_format = DepthFormat::inv_z;
    counted.depth_index = DepthIndex::row_major;
    counted.depth_clear = counted.depth_epsilon = 0.0f;
    counted.shading = Shading::unlit;
    counted.light = {};
    return counted;
}

void HiddenWaysWork::begin(const Scene& scene, const Settings& settings,
                           std::optional<Hidden> only) {
    scene_ = &scene;
    settings_ = counted_settings(settings);
    wanted_ = {Hidden::depth_buffer};
    for (std::size_t i = 1; i < enum_words<Hidden>.size(); ++i) {
        const auto way = static_cast<Hidden>(i);
        if (!only || *only == way) wanted_.push_back(way);
    }
    ways_.clear();
    is_begun_ = false;
}

void HiddenWaysWork::advance(const WorkLimit& limit) {
    double left = limit.at_once;
    while (!is_done() && left > 0.0) {
        if (!is_begun_) {
            Settings settings = settings_;
            settings.hidden = wanted_[ways_.size()];
            drawing_.begin(*scene_, settings);
            is_begun_ = true;
        }
        left -= drawing_.advance(std::min(left, limit.slice));
        if (drawing_.is_done()) count();
    }
}

/// The triangle of the scene that each pixel of the drawn picture shows; -1: none.
std::vector<int> HiddenWaysWork::shown() const {
    const Scene& scene = *drawing_.frame().scene;
    std::vector<int> triangles = drawing_.picture().owner;
    for (int& triangle : triangles)
        triangle = triangle < 0 ? -1 : scene_triangle(scene, triangle);
    return triangles;
}

std::int64_t HiddenWaysWork::count_wrong() const {
    const Viewport size = drawing_.frame().settings.viewport;
    const std::vector<int> pixels = shown();
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(column);
    };
    std::int64_t wrong = 0;
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            bool is_near = by_buffer_[at(column, row)] == pixels[at(column, row)];
            for (int y = std::max(row - 1, 0); !is_near && y <= std::min(row + 1, size.height - 1);
                 ++y) {
                for (int x = std::max(column - 1, 0); x <= std::min(column + 1, size.width - 1);
                     ++x)
                    is_near = is_near || by_buffer_[at(x, y)] == pixels[at(column, row)];
            }
            wrong += is_near ? 0 : 1;
        }
    }
    return wrong;
}

void HiddenWaysWork::count() {
    const Frame& frame = drawing_.frame();
    HiddenWay way;
    way.way = hidden_rule(frame.settings);
    way.is_possible =
        way.way == Hidden::depth_buffer || frame.list != nullptr || frame.squares != nullptr;
    way.triangles = frame.triangle_count();
    way.counts = hidden_counts(frame, drawing_.tally());
    if (way.way == Hidden::depth_buffer) by_buffer_ = shown();
    if (way.is_possible) way.wrong = count_wrong();
    ways_.push_back(way);
    is_begun_ = false;
}

std::vector<HiddenWay> hidden_ways(const Scene& scene, const Settings& settings,
                                   std::optional<Hidden> only) {
    HiddenWaysWork work;
    work.begin(scene, settings, only);
    while (!work.is_done())
        work.advance();
    return work.ways();
}

} // namespace rasterwalk
