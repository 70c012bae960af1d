#include "mine/picture_check.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "laboratory/bug.h"
#include "laboratory/diagnose.h"
#include "laboratory/equal_rules.h"
#include "laboratory/image_variant.h"
#include "picture/view_image.h"
#include "pipeline/frame_drawing.h"
#include "stages/put_pixel.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

Image drawn_image(const Scene& scene, const Settings& settings) {
    FrameDrawing drawing;
    drawing.begin(scene, settings);
    while (!drawing.is_done())
        drawing.advance(std::numeric_limits<double>::infinity());
    return view_image(drawing.picture(), View::colour);
}

/// The rules in which right programs of the lab differ before light is computed.
constexpr std::array<std::string_view, 3> rule_names{"vertex_rounding", "line_rounding",
                                                     "line_walk"};

/// The room has six colours of surfaces; a picture with more of them is lit.
constexpr std::size_t most_flat_colours = 12;

ImageDistance distance_to(const Image& picture, const Scene& scene, const Settings& settings) {
    ImageMeasure measure;
    measure.measure_to(drawn_image(scene, settings), picture, picture.height);
    return measure.distance();
}

/// How many pixels are black.
std::size_t black_pixels(const Image& picture) {
    std::size_t black = 0;
    for (std::size_t at = 0; at < picture.rgba.size(); at += 4)
        black += is_black(&picture.rgba[at]) ? 1 : 0;
    return black;
}

bool is_all_black(const Image& picture) {
    return !picture.rgba.empty() && black_pixels(picture) == picture.rgba.size() / 4;
}

/// Less than a third of it is drawn on: points or edges.
bool is_mostly_black(const Image& picture) {
    return 3 * black_pixels(picture) > 2 * (picture.rgba.size() / 4);
}

/// Has it no more pixels than the triangles have corners? Edges have many more, and points in the
/// wrong places are nearer to the right edges than to the right points.
bool has_only_points(const Image& picture, const Scene& scene) {
    const auto corners = 3 * static_cast<std::size_t>(scene.triangle_count());
    return picture.rgba.size() / 4 - black_pixels(picture) <= corners;
}

/// The number of different colours, but no more than one above most_flat_colours.
std::size_t colours_in(const Image& picture) {
    std::set<std::array<std::uint8_t, 3>> colours;
    for (std::size_t at = 0; at < picture.rgba.size() && colours.size() <= most_flat_colours;
         at += 4)
        colours.insert({picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]});
    return colours.size();
}

/// Everything that is not black in white.
Image in_white(Image picture) {
    for (std::size_t at = 0; at < picture.rgba.size(); at += 4)
        if (!is_black(&picture.rgba[at])) std::fill_n(&picture.rgba[at], 3, std::uint8_t{255});
    return picture;
}

const std::uint8_t* pixel_at(const Image& image, int column, int row) {
    return &image.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(column))];
}

std::optional<glm::ivec2> first_difference(const Image& a, const Image& b) {
    for (int row = 0; row < a.height; ++row)
        for (int column = 0; column < a.width; ++column)
            if (!is_same_pixel(pixel_at(a, column, row), pixel_at(b, column, row)))
                return glm::ivec2{column, row};
    return std::nullopt;
}

} // namespace

Image image_of(const Recording& recording) {
    Image image{recording.window.width, recording.window.height, {}};
    image.rgba.reserve(4 * recording.picture.size());
    for (const glm::vec3& colour : recording.picture) {
        for (int channel = 0; channel < 3; ++channel)
            image.rgba.push_back(to_byte(colour[channel]));
        image.rgba.push_back(255);
    }
    return image;
}

StripStep nearest_step(const Image& picture, const Scene& scene, const Settings& settings) {
    const bool is_outline = is_mostly_black(picture);
    const bool are_points = is_outline && has_only_points(picture, scene);
    const bool is_lit = colours_in(picture) > most_flat_colours;
    StripStep nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const StageInfo& info : stage_list()) {
        const Stage stage = info.step.stage;
        if (stage == Stage::rows || (is_outline != (stage < Stage::rows)) ||
            (are_points && stage != Stage::points) ||
            (!is_outline && is_lit != (stage == Stage::shade)))
            continue;
        Settings tried = settings;
        set_step(tried, info.step);
        const ImageDistance distance = distance_to(picture, scene, tried);
        const double apart = distance.other_surface + distance.mean / 255.0;
        if (apart >= least) continue;
        least = apart;
        nearest = info.step;
    }
    return nearest;
}

Settings with_nearest_rules(const Image& picture, const Scene& scene, const Settings& settings,
                            const std::vector<std::string>& known) {
    // The second round finds what the first one missed because another rule was still wrong.
    constexpr int rounds = 2;
    Settings nearest = settings;
    double least = distance_to(picture, scene, nearest).other_surface;
    for (int round = 0; round < rounds; ++round)
        for (const Assignments& rule : equal_rules()) {
            const std::string& name = rule.front().first;
            if (std::find(rule_names.begin(), rule_names.end(), name) == rule_names.end() ||
                std::find(known.begin(), known.end(), name) != known.end())
                continue;
            const Settings tried = by_equal_rule(rule, nearest);
            if (tried == nearest) continue;
            if (least == 0.0) return nearest; // nothing is nearer
            const double apart = distance_to(picture, scene, tried).other_surface;
            if (apart >= least) continue;
            least = apart;
            nearest = tried;
        }
    return nearest;
}

Image with_their_ties(const PictureCheck& check, const Scene& scene) {
    Settings later = check.reference;
    later.depth_test = DepthTest::or_equal;
    const Image other = drawn_image(scene, later);
    Image ours = check.right;
    for (std::size_t at = 0; at < ours.rgba.size(); at += 4)
        if (is_same_pixel(&other.rgba[at], &check.theirs.rgba[at]))
            std::copy_n(&other.rgba[at], 4, &ours.rgba[at]);
    return ours;
}

bool PictureCheck::has_black_picture() const {
    return is_all_black(theirs) || is_all_black(right);
}

PictureCheck check_picture(const Recording& recording, const Scene& scene, const Settings& settings,
                           const std::vector<std::string>& known, const std::vector<Bug>& bugs,
                           std::chrono::milliseconds patience,
                           const std::function<bool()>& is_stopped) {
    PictureCheck check;
    check.theirs = image_of(recording);
    check.reference = settings;
    check.pixels = static_cast<std::int64_t>(recording.picture.size());
    set_step(check.reference, nearest_step(check.theirs, scene, settings));
    // Points and edges may have any colour, as long as they are where they belong.
    if (!has_fragments(check.reference.stage)) check.theirs = in_white(check.theirs);
    check.reference = with_nearest_rules(check.theirs, scene, check.reference, known);
    DiagnosisWork work(check.theirs, "the picture of your program", scene, check.reference, bugs,
                       has_only_points(check.theirs, scene));
    const auto begin = std::chrono::steady_clock::now();
    while (!work.is_done()) {
        work.advance(frame_limit);
        const bool is_over = std::chrono::steady_clock::now() - begin > patience;
        if (is_over || (is_stopped && is_stopped())) work.stop_searching();
    }
    check.diagnosis = work.found();
    check.right = work.right_picture();
    check.different = check.diagnosis.different;
    check.is_right = check.diagnosis.is_same();
    if (!check.is_right) check.first = first_difference(check.theirs, check.right);
    return check;
}

} // namespace rasterwalk
