#include "outside/outside_drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "outside/shrunken_picture.h"
#include "stages/polygon_rows.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

/// A picture of more samples than this is drawn with one a pixel, or with larger pixels.
constexpr std::int64_t most_samples = 3'000'000;

/// What is drawn at most of a scene that never gets done, samples.
constexpr std::int64_t most_work = 2'000'000'000;

/// What a triangle costs before its first sample, samples.
constexpr std::int64_t triangle_work = 100;

/// A small scene is drawn whole, unless its triangles are hostile: half a room is no room.
constexpr std::int64_t small_scene_factor = 6;

/// A surface must win against the same surface, worked out once more.
constexpr double same_surface = 1.0005;

/// The smallest share of its colour that a side turned away from the light has.
constexpr double shaded = 0.72;

const glm::dvec3 light_direction(0.36, -0.80, -0.48);

/// How much is seen of the picture where nothing is drawn: it is a pane of glass there.
constexpr float glass = 0.4f;

/// The ids of what is no triangle: pixels of the picture.
constexpr std::int32_t nothing = -1;
constexpr std::int32_t first_pixel_id = -2;

OutsideEye scaled(OutsideEye eye, double scale) {
    eye.focal_length *= scale;
    eye.middle *= scale;
    return eye;
}

/// So many triangles of a large scene follow each other as in the mesh, because they lie beside
/// each other in memory.
constexpr int triangles_in_a_row = 64;

/// The n-th triangle to be drawn. Those of a large scene come from everywhere in turn, so that the
/// first of them show the whole.
int triangle_in_turn(int n, int count) {
    const int groups = count / triangles_in_a_row;
    const int group = n / triangles_in_a_row;
    if (count <= most_ordered || group >= groups) return n;
    // About the golden section of their number, and without a divisor in common with it.
    auto step = static_cast<std::int64_t>(0.6180339887 * groups);
    while (std::gcd(step, static_cast<std::int64_t>(groups)) != 1)
        ++step;
    return static_cast<int>(group * step % groups) * triangles_in_a_row + n % triangles_in_a_row;
}

struct WorldTriangle {
    std::array<glm::dvec3, triangle_corners> corners;
    glm::dvec3 normal{0.0}; ///< into the room and out of the blocks; not of unit length
};

WorldTriangle world_triangle(const Scene& scene, int triangle) {
    WorldTriangle world;
    for (int i = 0; i < triangle_corners; ++i)
        world.corners[static_cast<std::size_t>(i)] = scene.corner(triangle, i).position;
    const auto& [a, b, c] = world.corners;
    world.normal = glm::cross(c - a, b - a);
    return world;
}

/// Is this a wall that the eye would see from its back, and the camera from its front? It stands
/// between the eye and the room.
bool is_culled(const WorldTriangle& triangle, const glm::dvec3& eye, const glm::dvec3& camera) {
    const glm::dvec3& corner = triangle.corners[0];
    return glm::dot(triangle.normal, eye - corner) <= 0.0 &&
           glm::dot(triangle.normal, camera - corner) > 0.0;
}

glm::vec3 own_colour(const Scene& scene, int triangle) {
    glm::vec3 sum(0.0f);
    for (int i = 0; i < triangle_corners; ++i)
        sum += scene.corner(triangle, i).reflectance;
    return sum / static_cast<float>(triangle_corners);
}

/// Lighter or darker by where it faces, so that neighbouring sides are told apart.
float shade_of(const glm::dvec3& normal) {
    const double length = glm::length(normal);
    if (!(length > 0.0)) return 1.0f;
    const double cosine = std::abs(glm::dot(normal, light_direction)) / length;
    return static_cast<float>(shaded + (1.0 - shaded) * cosine);
}

glm::vec3 over_ground(const OutsideStyle& style, const glm::vec3& colour, float share) {
    return glm::mix(style.ground, glm::clamp(colour, 0.0f, 1.0f), share);
}

/// In the space of the eye.
SeenPolygon seen_triangle(const WorldTriangle& triangle, const OutsideEye& eye) {
    std::array<glm::dvec3, triangle_corners> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = eye.seen(triangle.corners[i]);
    return clipped_to_near(corners, eye.near_distance);
}

/// Which part of the triangle at work is filled.
class FilledPart {
  public:
    FilledPart(const OutsideSubject& subject, int triangle)
        : subject_(subject), triangle_(triangle) {
        const Frame& frame = subject.frame;
        is_whole_ = frame.is_drawn(triangle) && triangle < subject.cursor.triangle;
        // One that has not come to its rows yet is not filled at all.
        has_rows_ = !is_whole_ && frame.is_drawn(triangle) && frame.settings.stage >= Stage::rows &&
                    subject.cursor > Cursor{triangle, Phase::rows, 0, 0};
        if (has_rows_) compute_rows(frame, triangle, rows_, nullptr, VaryingSet());
    }
    bool is_whole() const { return is_whole_; }
    bool is_empty() const { return !is_whole_ && (!has_rows_ || rows_.size() == 0); }

    /// Is what the camera sees in this place of its picture filled?
    /// @param pixel from its corner
    bool has(const glm::dvec2& pixel) const {
        const double row = std::floor(pixel.y) - rows_.first_row;
        const auto index = static_cast<int>(std::clamp(row, 0.0, rows_.size() - 1.0));
        int step = 0;
        if (has_fragments(subject_.frame.settings.stage)) {
            const double column =
                std::floor(pixel.x) - rows_.left[static_cast<std::size_t>(index)].column;
            const int last = std::max(rows_.pixel_count(index) - 1, 0);
            step = static_cast<int>(std::clamp(column, 0.0, static_cast<double>(last)));
        }
        return Cursor{triangle_, Phase::rows, index, step} < subject_.cursor;
    }

  private:
    const OutsideSubject& subject_;
    int triangle_;
    bool is_whole_ = false, has_rows_ = false;
    PolygonRows rows_;
};

} // namespace

bool OutsideDrawing::update(const OutsideSubject& subject, const OutsideLook& look,
                            std::int64_t work_at_once) {
    take_scene(subject);
    const int count = subject.scene->triangle_count();
    const int begun = std::clamp(subject.cursor.triangle, 0, count);
    const BaseKey base{subject.frame_number, look, count <= most_ordered ? begun : count};
    const bool is_new = base_key_ != base;
    if (is_new) begin_base(look);
    base_key_ = base;
    const MomentKey moment{subject.cursor, subject.triangle, subject.picture_number};
    if (base_is_done_ && moment_key_ == moment) return false;
    if (!base_is_done_) draw_base(subject, look.style, work_at_once);
    moment_key_ = moment;
    grid_ = base_;
    draw_triangle_at_work(subject, look.style);
    draw_picture(subject);
    resolve();
    ++number_;
    return true;
}

void OutsideDrawing::take_scene(const OutsideSubject& subject) {
    if (scene_ != subject.scene) {
        scene_ = subject.scene;
        things_.box = box_of(*scene_);
        outline_ = outline_of(*scene_);
        base_key_ = std::nullopt;
    }
    const Settings& settings = subject.frame.settings;
    things_.plane = picture_plane(settings.camera, settings.viewport, things_.box);
    things_.lamp = settings.light.position;
}

void OutsideDrawing::begin_base(const OutsideLook& look) {
    const glm::ivec2 size = glm::max(look.size, glm::ivec2(1));
    const std::int64_t pixels = static_cast<std::int64_t>(size.x) * size.y;
    samples_ = 4 * pixels <= most_samples ? 2 : 1;
    pixel_size_ = 1;
    while (pixels / pixel_size_ / pixel_size_ > most_samples)
        ++pixel_size_;
    image_.width = std::max(size.x / pixel_size_, 1);
    image_.height = std::max(size.y / pixel_size_, 1);
    eye_ = eye_of(look.view, things_, size, look.margin);
    sample_eye_ = scaled(eye_, static_cast<double>(samples_) / pixel_size_);
    clear(base_, samples_ * glm::ivec2(image_.width, image_.height),
          packed_colour(look.style.ground));
    base_is_done_ = false;
    next_ = 0;
    work_ = 0;
}

void OutsideDrawing::draw_base(const OutsideSubject& subject, const OutsideStyle& style,
                               std::int64_t work_at_once) {
    const int count = subject.scene->triangle_count();
    const std::int64_t end =
        work_ + work_at_once * (count <= most_ordered ? small_scene_factor : 1);
    while (next_ < count && work_ < end)
        work_ += triangle_work + draw_triangle(subject, style, triangle_in_turn(next_++, count));
    base_is_done_ = next_ >= count || work_ >= most_work;
    if (base_is_done_) draw_outline(style);
}

std::int64_t OutsideDrawing::draw_triangle(const OutsideSubject& subject, const OutsideStyle& style,
                                           int triangle) {
    const Scene& scene = *subject.scene;
    const WorldTriangle world = world_triangle(scene, triangle);
    if (is_culled(world, eye_.position, things_.plane.eye)) return 0;
    const SeenPolygon seen = seen_triangle(world, sample_eye_);
    if (seen.count < triangle_corners) return 0;
    const bool is_coming =
        !subject.frame.is_drawn(triangle) ||
        (scene.triangle_count() <= most_ordered && triangle >= subject.cursor.triangle);
    const std::uint32_t colour =
        packed_colour(over_ground(style, own_colour(scene, triangle) * shade_of(world.normal),
                                  is_coming ? style.coming : style.drawn));
    return for_each_sample(sample_eye_, seen.all(), base_.size, [&](const SampleHit& hit) {
        const auto inv_z = static_cast<float>(hit.inv_z);
        if (!(inv_z > base_.inv_z[hit.index])) return;
        base_.inv_z[hit.index] = inv_z;
        base_.colour[hit.index] = colour;
        base_.id[hit.index] = triangle;
    });
}

void OutsideDrawing::draw_outline(const OutsideStyle& style) {
    const std::uint32_t colour = packed_colour(style.line);
    for (const OutlineEdge& edge : outline_) {
        draw_line(sample_eye_, sample_eye_.seen(edge.from), sample_eye_.seen(edge.to), colour,
                  samples_, base_);
    }
}

void OutsideDrawing::draw_triangle_at_work(const OutsideSubject& subject,
                                           const OutsideStyle& style) {
    const Scene& scene = *subject.scene;
    if (!subject.triangle || *subject.triangle < 0 || *subject.triangle >= scene.triangle_count()) {
        return;
    }
    const int triangle = *subject.triangle;
    const FilledPart filled(subject, triangle);
    const SeenPolygon seen = seen_triangle(world_triangle(scene, triangle), sample_eye_);
    if (seen.count < triangle_corners) return;
    const glm::vec3 own = own_colour(scene, triangle);
    const std::uint32_t lit = packed_colour(over_ground(style, own, 1.0f));
    const std::uint32_t dark = packed_colour(over_ground(style, own, style.drawn));
    const PicturePlane& plane = things_.plane;
    // From the space of the eye outside to that of the camera.
    const glm::dvec3 shift = (sample_eye_.position - plane.eye) * plane.rotation;
    for_each_sample(sample_eye_, seen.all(), grid_.size, [&](const SampleHit& hit) {
        if (hit.inv_z * same_surface < static_cast<double>(grid_.inv_z[hit.index])) return;
        bool is_filled = filled.is_whole();
        if (!is_filled && !filled.is_empty()) {
            const glm::dvec3 turned = (sample_eye_.rotation * hit.place()) * plane.rotation;
            const std::optional<glm::dvec2> pixel = plane.pixel_of(turned + shift);
            is_filled = pixel && filled.has(*pixel);
        }
        grid_.inv_z[hit.index] = static_cast<float>(hit.inv_z);
        grid_.colour[hit.index] = is_filled ? lit : dark;
        grid_.id[hit.index] = triangle;
    });
}

void OutsideDrawing::draw_picture(const OutsideSubject& subject) {
    const Viewport size = things_.plane.size;
    const Image& picture = subject.picture;
    if (picture.width != size.width || picture.height != size.height || size.width < 1 ||
        size.height < 1) {
        return;
    }
    std::array<glm::dvec3, 4> corners = things_.plane.corners();
    for (glm::dvec3& corner : corners)
        corner = sample_eye_.seen(corner);
    const SeenPolygon seen = clipped_to_near(corners, sample_eye_.near_distance);
    if (seen.count < triangle_corners) return;
    // One pixel to the right and one down, as they lie on the pane.
    const glm::dvec3 right = (corners[1] - corners[0]) / static_cast<double>(size.width);
    const glm::dvec3 down = (corners[3] - corners[0]) / static_cast<double>(size.height);
    const glm::dvec3 across = right / glm::dot(right, right);
    const glm::dvec3 along = down / glm::dot(down, down);
    const double samples_a_pixel =
        sample_eye_.focal_length * glm::length(right) /
        std::max(0.25 * (corners[0].z + corners[1].z + corners[2].z + corners[3].z),
                 sample_eye_.near_distance);
    const ShrunkenPicture shown = shrunken(picture, subject.framebuffer, samples_a_pixel, glass);
    for_each_sample(sample_eye_, seen.all(), grid_.size, [&](const SampleHit& hit) {
        // Seen almost along itself the pane has no depth that could be worked out.
        if (!(hit.inv_z > 0.0) || hit.inv_z < static_cast<double>(grid_.inv_z[hit.index])) return;
        const glm::dvec3 place = hit.place() - corners[0];
        const double x = glm::dot(place, across), y = glm::dot(place, along);
        if (!std::isfinite(x) || !std::isfinite(y)) return;
        const int column =
            static_cast<int>(std::clamp(x, 0.0, static_cast<double>(size.width - 1)));
        const int row = static_cast<int>(std::clamp(y, 0.0, static_cast<double>(size.height - 1)));
        grid_.inv_z[hit.index] = static_cast<float>(hit.inv_z);
        grid_.id[hit.index] = first_pixel_id - (row * size.width + column);
        grid_.colour[hit.index] = laid_over(shown.at(column, row), grid_.colour[hit.index]);
    });
}

void OutsideDrawing::resolve() {
    image_.rgba.resize(4 * static_cast<std::size_t>(image_.width) *
                       static_cast<std::size_t>(image_.height));
    // One sample a pixel, or four: their mean is a shift. Red and blue are summed in one number.
    const int shift = samples_ == 2 ? 2 : 0;
    std::size_t byte = 0;
    for (int row = 0; row < image_.height; ++row) {
        for (int column = 0; column < image_.width; ++column) {
            std::uint32_t red_blue = 0, green = 0;
            for (int y = 0; y < samples_; ++y) {
                const std::size_t first = grid_.at(samples_ * column, samples_ * row + y);
                for (int x = 0; x < samples_; ++x) {
                    const std::uint32_t colour = grid_.colour[first + static_cast<std::size_t>(x)];
                    red_blue += colour & 0xFF00FFU;
                    green += (colour >> 8) & 0xFFU;
                }
            }
            image_.rgba[byte++] = static_cast<std::uint8_t>((red_blue & 0xFFFFU) >> shift);
            image_.rgba[byte++] = static_cast<std::uint8_t>(green >> shift);
            image_.rgba[byte++] = static_cast<std::uint8_t>((red_blue >> 16) >> shift);
            image_.rgba[byte++] = 255;
        }
    }
}

OutsidePick OutsideDrawing::at(glm::vec2 place) const {
    OutsidePick pick;
    const float scale = static_cast<float>(samples_) / static_cast<float>(pixel_size_);
    const glm::vec2 sample = glm::floor(scale * place);
    if (!(sample.x >= 0.0f && sample.y >= 0.0f && sample.x < static_cast<float>(grid_.size.x) &&
          sample.y < static_cast<float>(grid_.size.y))) {
        return pick;
    }
    const std::int32_t id =
        grid_.id[grid_.at(static_cast<int>(sample.x), static_cast<int>(sample.y))];
    if (id > nothing) pick.triangle = id;
    if (id > nothing || id == nothing) return pick;
    const std::int32_t number = first_pixel_id - id;
    const int width = std::max(things_.plane.size.width, 1);
    pick.pixel = {number % width, number / width};
    return pick;
}

} // namespace rasterwalk
