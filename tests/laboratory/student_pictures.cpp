#include "laboratory/student_pictures.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace rasterwalk::test {

namespace {

using P = StudentProgram;
using M = StudentMistakes;

/// A word of the lists below, and what it sets.
struct Word {
    std::string_view word;
    void (*set)(StudentProgram&);
};

// Most students raise the power of the lamp, often to 14, because 1.1 hardly shows.
constexpr Word words[] = {
    {"fill", [](P& p) { p.stage = StudentStage::fill; }},
    {"depth", [](P& p) { p.stage = StudentStage::depth; }},
    {"vertex", [](P& p) { p.stage = StudentStage::vertex_light; }},
    {"pixel", [](P& p) { p.stage = StudentStage::pixel_light; }},
    {"500x500", [](P& p) { p.width = p.height = 500; }},
    {"320x240", [](P& p) { p.width = 320, p.height = 240; }},
    {"sum_cut", [](P& p) { p.vertex_cut = VertexCut::sum_cut; }},
    {"floor", [](P& p) { p.vertex_cut = VertexCut::floor; }},
    {"round", [](P& p) { p.vertex_cut = VertexCut::round; }},
    {"zinv_first", [](P& p) { p.vertex_product = VertexProduct::zinv_first; }},
    {"by_z", [](P& p) { p.vertex_product = VertexProduct::by_z; }},
    {"z_first", [](P& p) { p.vertex_product = VertexProduct::z_first; }},
    {"lines_rounded", [](P& p) { p.lines_rounded = true; }},
    {"multiply_step", [](P& p) { p.walk = Walk::multiply_step; }},
    {"blend_ends", [](P& p) { p.walk = Walk::blend_ends; }},
    {"straight", [](P& p) { p.vertex_light_straight = true; }},
    {"bytes_rounded", [](P& p) { p.bytes_rounded = true; }},
    {"power_14", [](P& p) { p.power = glm::vec3(14.0f); }},
    {"power_9.1", [](P& p) { p.power = glm::vec3(9.1f); }},
    {"power_30", [](P& p) { p.power = glm::vec3(30.0f); }},
    {"warm_power",
     [](P& p) {
         p.power = {14.0f, 11.0f, 7.0f};
     }},
    {"indirect_0.2", [](P& p) { p.indirect = glm::vec3(0.2f); }},
    {"no_indirect", [](P& p) { p.indirect = glm::vec3(0.0f); }},
    {"lamp_left",
     [](P& p) {
         p.lamp = {-0.1f, -0.2f, -0.4f};
     }},
    {"lamp_low",
     [](P& p) {
         p.lamp = {0.3f, 0.4f, -0.9f};
     }},
    {"lamp_in_front",
     [](P& p) {
         p.lamp = {0.0f, -0.3f, -1.6f};
     }},
    {"camera_left",
     [](P& p) {
         p.camera = {-0.25f, -0.1f, -3.001f};
     }},
    {"camera_back",
     [](P& p) {
         p.camera = {0.1f, 0.15f, -3.4f};
     }},
    {"camera_near",
     [](P& p) {
         p.camera = {0.0f, 0.0f, -2.5f};
     }},
    {"camera_inside",
     [](P& p) {
         p.camera = {0.2f, -0.3f, 0.9f};
     }},
    {"camera_aside",
     [](P& p) {
         p.camera = {1.6f, 0.0f, -3.001f};
     }},
    {"camera_above",
     [](P& p) {
         p.camera = {0.0f, -0.39f, -3.54f}, p.yaw = -0.03f;
     }},
    {"camera_right",
     [](P& p) {
         p.camera = {0.4f, -0.05f, -2.75f}, p.yaw = 0.15f;
     }},
    {"yaw_0.2", [](P& p) { p.yaw = 0.2f; }},
    {"yaw_-0.4", [](P& p) { p.yaw = -0.4f; }},
    {"zoom_0.8", [](P& p) { p.zoom = 0.8f; }},
    {"zoom_1.36", [](P& p) { p.zoom = 1.36f; }},
    {"zoom_1.2", [](P& p) { p.zoom = 1.2f; }},
    {"zoom_1.25", [](P& p) { p.zoom = 1.25f; }},
};

/// A line of the list: the mistakes, and how the rest is drawn.
struct Line {
    const char* mistakes;
    const char* words;
    bool is_camera_known = false;
};

constexpr Line right_ones[] = {
    {"", "fill"},
    {"", "depth"},
    {"", "vertex"},
    {"", "pixel"},
    {"", "pixel bytes_rounded"},
    {"", "vertex bytes_rounded"},
    {"", "depth 320x240"},
    {"", "pixel 320x240"},
    {"", "pixel 500x500"},
};

constexpr Line equally_right_ones[] = {
    {"", "depth sum_cut"},
    {"", "pixel sum_cut"},
    {"", "pixel zinv_first"},
    {"", "depth by_z"},
    {"", "pixel z_first 320x240"},
    {"", "fill floor"},
    {"", "pixel round"},
    {"", "depth lines_rounded"},
    {"", "pixel multiply_step"},
    {"", "depth blend_ends lines_rounded"},
    {"", "vertex straight"},
    {"", "vertex straight power_14"},
    {"", "vertex power_9.1 sum_cut"},
    {"", "pixel power_14"},
    {"", "pixel warm_power"},
    {"", "pixel power_14 indirect_0.2"},
    {"", "pixel power_9.1 no_indirect"},
    {"", "pixel lamp_left power_9.1"},
    {"", "pixel lamp_low power_14 indirect_0.2"},
    {"", "vertex lamp_in_front power_14"},
    {"", "depth camera_left"},
    {"", "depth yaw_0.2"},
    {"", "fill yaw_-0.4"},
    {"", "depth zoom_0.8"},
    {"", "pixel zoom_1.25"},
    {"", "depth camera_back yaw_0.2"},
    {"", "pixel camera_left power_14"},
    {"", "pixel sum_cut lines_rounded"},
    {"", "pixel sum_cut lamp_left power_14"},
    {"", "vertex straight sum_cut bytes_rounded power_14"},
};

constexpr Line single_ones[] = {
    {"B3", "pixel power_14"},
    {"B3", "pixel power_9.1 lamp_left"},
    {"B3", "pixel power_14 sum_cut"},
    {"B4", "pixel power_14"},
    {"B5", "fill"},
    {"B5", "fill sum_cut"},
    {"B5", "pixel 500x500"},
    {"B6", "fill camera_aside yaw_0.2 zoom_1.25", true},
    {"B8", "fill"},
    {"B9", "fill"},
    {"B9", "depth sum_cut"},
    {"B9", "pixel camera_left"},
    {"B10", "depth sum_cut"},
    {"B11", "fill"},
    {"B11", "depth 320x240"},
    {"B12", "fill"},
    {"B16", "depth camera_near", true},
    {"B17a", "depth"},
    {"B17b", "depth"},
    {"B17d", "depth"},
    {"B20a", "pixel power_14"},
    {"B20a", "vertex power_14 straight"},
    {"B20b", "pixel power_14"},
    {"B20b", "pixel power_14 bytes_rounded"},
    {"B20c", "pixel"},
    {"B20c", "pixel power_14"},
    {"B20d", "pixel power_14"},
    {"B21", "pixel power_14"},
    {"B21", "vertex power_9.1"},
    {"B22", "pixel power_30"},
    {"B24", "depth yaw_0.2", true},
    {"B25", "depth"},
    {"B61", "depth"},
    {"B70", "depth camera_inside", true},
    {"B71", "depth yaw_0.2", true},
    {"B73", "depth"},
    {"B74", "depth"},
    {"B75", "depth"},
    {"B75", "pixel power_14"},
    {"B76", "pixel power_14"},
    {"B77a", "pixel"},
    {"B77b", "pixel power_14"},
    {"B78", "pixel power_14"},
    {"B79", "depth"},
    {"B79", "pixel power_14 sum_cut"},
    {"B80", "pixel power_14"},
    {"B81", "pixel power_14"},
    {"B86", "pixel power_14"},
    {"B87", "pixel power_14"},
    {"B88a", "depth"},
    {"B89", "depth"},
    {"B90", "depth"},
    {"B91", "depth camera_above zoom_1.36", true},
    {"B92", "fill"},
    {"B92", "depth sum_cut"},
    {"B93", "depth camera_right zoom_1.2", true},
    {"B94", "fill"},
    {"B95", "fill"},
};

constexpr Line pairs[] = {
    {"B5 B3", "pixel power_14"},
    {"B5 B3", "pixel power_9.1 lamp_left sum_cut"},
    {"B9 B20b", "pixel power_14"},
    {"B9 B20b", "pixel power_14 sum_cut"},
    {"B79 B9", "depth"},
    {"B79 B3", "pixel power_14"},
    {"B5 B17d", "depth"},
    {"B9 B17d", "depth sum_cut"},
    {"B11 B79", "fill"},
    {"B3 B21", "pixel power_14"},
    {"B4 B20a", "pixel power_14"},
    {"B5 B20d", "pixel power_14"},
    {"B9 B78", "pixel power_14"},
    {"B78 B3", "pixel power_14"},
    {"B80 B5", "pixel power_14"},
    {"B80 B20a", "pixel power_14"},
    {"B22 B5", "pixel power_30"},
    {"B25 B79", "depth"},
    {"B25 B5", "fill sum_cut"},
    {"B73 B9", "depth"},
    {"B81 B5", "pixel power_14"},
    {"B61 B9", "depth"},
    {"B75 B79", "depth"},
    {"B86 B9", "pixel power_14"},
    {"B94 B79", "fill"},
    {"B92 B3", "pixel power_14"},
    {"B12 B20a", "pixel power_14"},
    {"B95 B17d", "depth"},
    {"B21 B9", "vertex power_14 straight"},
    {"B24 B9", "depth yaw_0.2", true},
};

const KnownMistake& known_mistake(const std::string& id) {
    const auto& all = known_mistakes();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const KnownMistake& known) { return known.id == id; });
    if (found == all.end()) throw std::invalid_argument("no known mistake " + id);
    return *found;
}

BroughtPicture picture_of_line(StudentKind kind, const Line& line) {
    BroughtPicture picture;
    picture.name = line.mistakes;
    picture.name += picture.name.empty() ? "" : ": ";
    picture.name += line.words;
    picture.kind = kind;
    apply_words(line.words, picture.program);
    std::istringstream ids(line.mistakes);
    for (std::string id; ids >> id;) {
        picture.mistakes.push_back(known_mistake(id));
        picture.mistakes.back().make(picture.program.mistakes);
    }
    picture.is_camera_known = line.is_camera_known;
    return picture;
}

template <std::size_t count>
std::vector<BroughtPicture> pictures_of_lines(StudentKind kind, const Line (&lines)[count]) {
    std::vector<BroughtPicture> pictures;
    for (const Line& line : lines)
        pictures.push_back(picture_of_line(kind, line));
    return pictures;
}

} // namespace

const std::vector<KnownMistake>& known_mistakes() {
    static const std::vector<KnownMistake> all = {
        {"B3", {}, false, [](M& m) { m.position_straight = true; }},
        {"B4", {}, false, [](M& m) { m.multiplied_twice = true; }},
        {"B5", {}, false, [](M& m) { m.edges_by_rows = true; }},
        {"B6", {}, false, [](M& m) { m.rows_begin_at_window = true; }},
        {"B8", {}, false, [](M& m) { m.single_pixels_skipped = true; }},
        {"B9", {}, false, [](M& m) { m.last_column_lost = true; }},
        {"B10", {}, false, [](M& m) { m.zero_is_outside = true; }},
        {"B11", {}, false, [](M& m) { m.whole_steps = true; }},
        {"B12", {}, false, [](M& m) { m.one_inside_abs = true; }},
        {"B16", {}, false, [](M& m) { m.dropped_partly_outside = true; }},
        // These two and B90 leave the whole picture black.
        {"B17a", {"B17b", "B90"}, false, [](M& m) { m.depth_reversed = true; }},
        {"B17b", {"B17a", "B90"}, false, [](M& m) { m.depth_clear = 1.0f; }},
        {"B17d", {}, false, [](M& m) { m.depth_reversed = true, m.depth_clear = 1000.0f; }},
        {"B20a", {}, false, [](M& m) { m.light_vector_reversed = true; }},
        {"B20b", {}, false, [](M& m) { m.light_vector_as_long = true; }},
        {"B20c", {"B77a"}, true, [](M& m) { m.four_pi_forgotten = true; }},
        {"B20d", {}, false, [](M& m) { m.distance_cubed = true; }},
        {"B21", {}, false, [](M& m) { m.reflectance_added = true; }},
        {"B22", {}, false, [](M& m) { m.colour_wraps = true; }},
        {"B24", {}, false, [](M& m) { m.rotation_transposed = true; }},
        {"B25", {}, false, [](M& m) { m.focal_length_negative = true; }},
        {"B61", {}, false, [](M& m) { m.depth_epsilon = 0.05f; }},
        {"B70", {}, false, [](M& m) { m.camera_added = true; }},
        {"B71", {}, false, [](M& m) { m.rotated_first = true; }},
        {"B73", {}, false, [](M& m) { m.axes_exchanged = true; }},
        {"B74", {}, false, [](M& m) { m.half_forgotten = true; }},
        {"B75", {}, false, [](M& m) { m.distance_for_z = true; }},
        {"B76", {}, false, [](M& m) { m.light_vector_with_w = true; }},
        {"B77a", {"B20c"}, true, [](M& m) { m.pi_by_wrong_atan = true; }},
        {"B77b", {}, true, [](M& m) { m.pi_is_three = true; }},
        {"B78", {}, false, [](M& m) { m.reflectance_twice = true; }},
        {"B79", {}, false, [](M& m) { m.red_and_blue_swapped = true; }},
        {"B80", {}, false, [](M& m) { m.gamma_applied = true; }},
        {"B81", {}, false, [](M& m) { m.culled_by_lamp = true; }},
        {"B86", {}, false, [](M& m) { m.never_divided = true; }},
        {"B87", {}, false, [](M& m) { m.divided_twice = true; }},
        {"B88a", {}, false, [](M& m) { m.depth_or_equal = true; }},
        {"B89", {}, false, [](M& m) { m.depth_falls_along_row = true; }},
        {"B90", {"B17a", "B17b"}, false, [](M& m) { m.ends_take_only_x = true; }},
        {"B91", {}, false, [](M& m) { m.last_sample_lost = true; }},
        {"B92", {}, false, [](M& m) { m.step_over_count = true; }},
        {"B93", {}, false, [](M& m) { m.samples_clamped = true; }},
        {"B94", {}, false, [](M& m) { m.third_edge_lost = true; }},
        {"B95", {}, false, [](M& m) { m.last_row_lost = true; }},
    };
    return all;
}

void apply_words(const std::string& text, StudentProgram& program) {
    program.width = program.height = 200;
    std::istringstream in(text);
    for (std::string word; in >> word;) {
        const auto* const found =
            std::find_if(std::begin(words), std::end(words),
                         [&](const Word& known) { return known.word == word; });
        if (found == std::end(words)) throw std::invalid_argument("no word " + word);
        found->set(program);
    }
}

std::vector<BroughtPicture> student_pictures() {
    const std::array<std::vector<BroughtPicture>, 5> lists = {
        pictures_of_lines(StudentKind::right, right_ones),
        pictures_of_lines(StudentKind::equally_right, equally_right_ones),
        pictures_of_lines(StudentKind::single, single_ones),
        pictures_of_lines(StudentKind::pair, pairs), pictures_of_unknown_mistakes()};
    // Each list is spread evenly over the result.
    std::vector<std::pair<double, BroughtPicture>> placed;
    for (const std::vector<BroughtPicture>& list : lists) {
        for (std::size_t i = 0; i < list.size(); ++i)
            placed.emplace_back((static_cast<double>(i) + 0.5) / static_cast<double>(list.size()),
                                list[i]);
    }
    std::stable_sort(placed.begin(), placed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<BroughtPicture> pictures;
    for (auto& [place, picture] : placed)
        pictures.push_back(std::move(picture));
    return pictures;
}

} // namespace rasterwalk::test
