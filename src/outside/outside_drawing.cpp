#include "outside/outside_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "outside/eye_line.h"
#include "outside/eye_pane.h"
#include "outside/eye_texture.h"
#include "outside/fill_progress.h"
#include "outside/outside_eye.h"

namespace rasterwalk {

namespace {

/// A picture with more samples than this is drawn with one per pixel, or with larger pixels.
constexpr std::int64_t most_samples = 3'000'000;

/// No side has more samples than the engine's guard band leaves room for.
constexpr int longest_side = 8000;
static_assert(longest_side < fast::guard_band);

/// The most work on a scene that never gets done.
constexpr std::int64_t most_work = 2'000'000'000;

/// The cost of a triangle up to its first sample, and of a sample in the box around it.
constexpr double triangle_work = 40.0, sample_work = 0.02;

/// A small scene is drawn in one call, unless its triangles are very large, because half a room
/// looks wrong.
constexpr std::int64_t small_scene_factor = 6;

/// A surface must win against the same surface computed again.
constexpr float same_surface = 1.0005f;

/// The opacity of the picture where nothing is drawn, like a pane of glass.
constexpr float glass = 0.4f;

/// The ids of what is not a triangle: nothing, or pixels of the picture.
constexpr std::int32_t nothing = -1;
constexpr std::int32_t first_pixel_id = -2;

/// In the fourth byte of a sample's colour: a line of the outline.
constexpr std::uint32_t line_flag = std::uint32_t{1} << 24;

OutsideEye scaled(OutsideEye eye, double scale) {
    eye.focal_length *= scale;
    eye.middle *= scale;
    return eye;
}

/// This many triangles of a large scene are drawn in the order of the mesh, because they are next
/// to each other in memory.
constexpr int triangles_in_a_row = 64;

/// The n-th triangle to draw. In a large scene they come from everywhere in turn, so that the first
/// ones show the whole.
int triangle_in_turn(int n, int count) {
    const int groups = count / triangles_in_a_row;
    const int group = n / triangles_in_a_row;
    if (count <= most_ordered || group >= groups) return n;
    // About the golden section of their number, and coprime to it.
    auto step = static_cast<std::int64_t>(0.6180339887 * groups);
    while (std::gcd(step, static_cast<std::int64_t>(groups)) != 1)
        ++step;
    return static_cast<int>(group * step % groups) * triangles_in_a_row + n % triangles_in_a_row;
}

glm::vec3 over_ground(const OutsideStyle& style, const glm::vec3& colour, float share) {
    return glm::mix(style.ground, glm::clamp(colour, 0.0f, 1.0f), share);
}

/// The texture of a triangle; none if it has no texture that is shown.
EyeTexture eye_texture(const OutsideSubject& subject, int triangle, const OutsideEye& eye) {
    if (!is_textured(subject.frame)) return {};
    return {subject.frame, triangle, eye_corners(*subject.scene, triangle, eye), eye};
}

bool is_triangle_of(const Scene& scene, std::optional<int> triangle) {
    return triangle && *triangle >= 0 && *triangle < scene.triangle_count();
}

/// The most that a triangle can cost: as if it were as near as its first corner allows.
std::int64_t work_of(const WorldTriangle& triangle, const OutsideEye& eye, glm::ivec2 size) {
    const double extent = triangle.extent;
    const double z = glm::dot(glm::dvec3(triangle.corner) - eye.position, eye.rotation[2]);
    const double side = eye.focal_length * extent / std::max(z - extent, eye.near_distance);
    const auto within = [side](int most) { return side < most ? side : most; };
    return static_cast<std::int64_t>(triangle_work + sample_work * within(size.x) * within(size.y));
}

/// The camera of the fast engine for a part of the eye's picture.
/// @param eye in samples
FastEye fast_eye(const OutsideEye& eye, const Rectangle& samples) {
    return {.size = {samples.right - samples.left, samples.bottom - samples.top},
            .position = eye.position,
            .rotation = eye.rotation,
            .focal_length = static_cast<float>(eye.focal_length),
            .middle = eye.middle - glm::dvec2(samples.left, samples.top),
            .near = static_cast<float>(eye.near_distance)};
}

/// The point shown by a sample, in the space of the eye.
glm::dvec3 place_at(const OutsideEye& eye, int column, int row, float inv_z) {
    return eye.ray({column + 0.5, row + 0.5}) / static_cast<double>(inv_z);
}

/// The pixels of a row: the mean of `a_side` x `a_side` samples each.
/// @param stride samples from row to row
template <int a_side>
void resolve_row(const std::uint32_t* from, int stride, int pixels, std::uint8_t* to) {
    // One sample or four: their mean is a shift. Red and blue are summed in one number.
    constexpr int shift = a_side == 2 ? 2 : 0;
    for (int i = 0; i < pixels; ++i, from += a_side, to += 4) {
        std::uint32_t red_blue = 0, green = 0;
        for (int y = 0; y < a_side; ++y) {
            for (int x = 0; x < a_side; ++x) {
                const std::uint32_t colour = from[y * stride + x];
                red_blue += colour & 0xFF00FFU;
                green += (colour >> 8) & 0xFFU;
            }
        }
        to[0] = static_cast<std::uint8_t>((red_blue & 0xFFFFU) >> shift);
        to[1] = static_cast<std::uint8_t>(green >> shift);
        to[2] = static_cast<std::uint8_t>((red_blue >> 16) >> shift);
        to[3] = 255;
    }
}

/// Tests whether points on a triangle are in what clipping leaves of it.
class InsideTest {
  public:
    /// @param seen the corners of the triangle, in the space of the eye
    InsideTest(const WorldClipping& clipping,
               const std::array<glm::dvec3, triangle_corners>& in_eye, const OutsideEye& eye)
        : is_cut_(clipping.is_cut) {
        const glm::dvec3 normal = glm::cross(in_eye[1] - in_eye[0], in_eye[2] - in_eye[0]);
        const std::vector<WorldCorner>& corners = clipping.corners;
        for (std::size_t i = 0; corners.size() >= 3 && i < corners.size(); ++i) {
            const glm::dvec3 from = eye.in_eye(corners[i].place);
            const glm::dvec3 to = eye.in_eye(corners[(i + 1) % corners.size()].place);
            const glm::dvec3 inward = glm::cross(normal, to - from);
            sides_.push_back({inward, glm::dot(inward, from)});
        }
    }
    bool is_cut() const { return is_cut_; }
    bool has(const glm::dvec3& place) const {
        return !sides_.empty() && std::all_of(sides_.begin(), sides_.end(), [&](const Side& side) {
            return glm::dot(side.inward, place) >= side.least;
        });
    }

  private:
    /// On the inner side of an edge, dot(inward, place) >= least.
    struct Side {
        glm::dvec3 inward;
        double least;
    };
    bool is_cut_;
    std::vector<Side> sides_;
};

} // namespace

/// The colours of triangles that are not at work.
class OutsideDrawing::BasePainter {
  public:
    BasePainter(const OutsideDrawing& drawing, const OutsideSubject& subject,
                const OutsideStyle& style)
        : drawing_(drawing), subject_(subject), style_(style),
          is_ordered_(subject.scene->triangle_count() <= most_ordered),
          has_textures_(is_textured(subject.frame)) {}

    /// The colour of a triangle without texture.
    std::uint32_t plain(int triangle) const { return shown(triangle, glm::vec3(1.0f)); }

    /// The colour at a sample. Fastest for samples of one triangle in a row.
    std::uint32_t at(int triangle, int column, int row, float inv_z) {
        const std::uint32_t colour = drawing_.colours_[static_cast<std::size_t>(triangle)];
        if (!has_textures_) return colour;
        if (triangle != last_) texture_ = eye_texture(subject_, triangle, drawing_.sample_eye_);
        last_ = triangle;
        if (!texture_.is_there()) return colour;
        return shown(triangle, texture_.at(place_at(drawing_.sample_eye_, column, row, inv_z)));
    }

  private:
    std::uint32_t shown(int triangle, const glm::vec3& texture) const {
        const bool is_coming =
            !subject_.frame.is_drawn(triangle) || (is_ordered_ && triangle >= drawing_.begun_);
        const glm::vec3& own = drawing_.triangles_[static_cast<std::size_t>(triangle)].colour;
        return packed_colour(
            over_ground(style_, own * texture, is_coming ? style_.coming : style_.drawn));
    }

    const OutsideDrawing& drawing_;
    const OutsideSubject& subject_;
    const OutsideStyle& style_;
    bool is_ordered_, has_textures_;
    int last_ = -1;
    EyeTexture texture_;
};

bool OutsideDrawing::update(const OutsideSubject& subject, const OutsideLook& look,
                            std::int64_t work_at_once) {
    take_scene(subject);
    const BaseKey base{subject.frame_number, look};
    const int count = subject.scene->triangle_count();
    const bool is_ordered = count <= most_ordered && !is_square(subject.cursor);
    const int begun = is_ordered ? std::clamp(subject.cursor.triangle, 0, count) : count;
    if (base_key_ != base) {
        // Noted as begun only when it is, so that after an exception it is begun again.
        const std::optional<BaseKey> before = std::exchange(base_key_, std::nullopt);
        begin_base(look);
        const bool has_colours = before && before->frame_number == base.frame_number &&
                                 before->look.style == look.style && begun_ == begun;
        begun_ = begun;
        if (!has_colours) colour_all(subject, look.style);
        base_key_ = base;
    }
    const MomentKey moment{subject.cursor, subject.triangle, subject.picture_number};
    if (base_is_done_ && moment_key_ == moment) return false;
    // What has changed since the image was made; everything, if it has not been made yet.
    const bool is_whole = !moment_key_ || !base_is_done_;
    Rectangle changed = is_whole ? base_.all() : changed_by(subject, moment, *moment_key_);
    moment_key_ = std::nullopt;
    changed = around(changed, recolour(subject, look.style, begun));
    if (!base_is_done_) {
        base_key_ = std::nullopt; // for the same reason
        draw_base(subject, look.style, work_at_once);
        base_key_ = base;
    }
    compose(subject, look.style, changed);
    moment_key_ = moment;
    ++number_;
    return true;
}

/// The samples in which this moment may look different from the last one, apart from the colours of
/// the scene's triangles.
Rectangle OutsideDrawing::changed_by(const OutsideSubject& subject, const MomentKey& now,
                                     const MomentKey& last) const {
    Rectangle changed;
    if (now.cursor != last.cursor || now.triangle != last.triangle) {
        changed = around(box_of_triangle(last.triangle), box_of_triangle(now.triangle));
    }
    if (now.picture_number == last.picture_number) return changed;
    const std::optional<EyePane> pane = eye_pane(outside_scene_.plane, sample_eye_);
    if (!pane) return changed;
    const Viewport size = outside_scene_.plane.size;
    const bool is_known = subject.picture_before == last.picture_number &&
                          shown_.block == block_size(subject.picture, pane->samples_a_pixel);
    Rectangle pixels{0, 0, size.width, size.height};
    if (is_known && !is_empty(subject.picture_changed)) {
        const auto down = [&](int pixel) { return pixel / shown_.block * shown_.block; };
        const auto up = [&](int pixel) { return down(pixel + shown_.block - 1); };
        const Rectangle& p = subject.picture_changed;
        pixels = {down(p.left), down(p.top), up(p.right), up(p.bottom)};
    } else if (is_known) {
        pixels = {};
    }
    return around(changed, box_of_pixels(*pane, sample_eye_, pixels, base_.all()));
}

Rectangle OutsideDrawing::box_of_triangle(std::optional<int> triangle) const {
    if (!is_triangle_of(*scene_, triangle)) return {};
    return box_around(sample_eye_, eye_corners(*scene_, *triangle, sample_eye_), base_.all());
}

void OutsideDrawing::colour_all(const OutsideSubject& subject, const OutsideStyle& style) {
    const BasePainter painter(*this, subject, style);
    colours_.resize(triangles_.size());
    for (std::size_t i = 0; i < colours_.size(); ++i)
        colours_[i] = painter.plain(static_cast<int>(i));
}

/// Gives a new colour to triangles that have been begun since, or are yet to come again.
/// @return a box of samples that contains them
Rectangle OutsideDrawing::recolour(const OutsideSubject& subject, const OutsideStyle& style,
                                   int begun) {
    const int first = std::min(begun, begun_), end = std::max(begun, begun_);
    begun_ = begun;
    BasePainter painter(*this, subject, style);
    Rectangle box;
    for (int triangle = first; triangle < end; ++triangle) {
        box = around(box, box_of_triangle(triangle));
        colours_[static_cast<std::size_t>(triangle)] = painter.plain(triangle);
    }
    for (int row = box.top; row < box.bottom; ++row) {
        for (int column = box.left; column < box.right; ++column) {
            const std::size_t sample = base_.at(column, row);
            const std::int32_t id = base_.id[sample];
            if (id < first || id >= end || (base_.colour[sample] & line_flag) != 0) continue;
            base_.colour[sample] = painter.at(id, column, row, base_.inv_z[sample]);
        }
    }
    return box;
}

/// Lays what belongs to the moment over these samples of the base.
void OutsideDrawing::compose(const OutsideSubject& subject, const OutsideStyle& style,
                             const Rectangle& samples) {
    resize(grid_, base_.size);
    const auto count = static_cast<std::size_t>(samples.right - samples.left);
    for (int row = samples.top; row < samples.bottom; ++row) {
        const auto first = static_cast<std::ptrdiff_t>(base_.at(samples.left, row));
        const auto copy = [&](const auto& from, auto& to) {
            std::copy_n(from.begin() + first, count, to.begin() + first);
        };
        copy(base_.inv_z, grid_.inv_z);
        copy(base_.colour, grid_.colour);
        copy(base_.id, grid_.id);
    }
    draw_triangle_at_work(subject, style, samples);
    draw_picture(subject, samples);
    if (!is_empty(samples)) resolve(samples);
}

void OutsideDrawing::take_scene(const OutsideSubject& subject) {
    if (scene_ != subject.scene) {
        const Scene& scene = *subject.scene;
        scene_ = nullptr; // in case memory runs out
        outside_scene_.box = box_of(scene);
        outline_ = outline_of(scene);
        triangles_ = world_triangles(scene);
        shape_.emplace(scene.mesh);
        base_key_ = std::nullopt;
        shown_number_ = 0; // pictures of another session may have the same numbers
        scene_ = subject.scene;
    }
    const Settings& settings = subject.frame.settings;
    outside_scene_.plane =
        picture_plane(settings.camera, settings.viewport, outside_scene_.box,
                      vertex_rules(settings, subject.frame.scene->space).projection);
    outside_scene_.lamp = light_rule(settings).position;
}

void OutsideDrawing::begin_base(const OutsideLook& look) {
    const glm::ivec2 size = glm::max(look.size, glm::ivec2(1));
    const std::int64_t pixels = static_cast<std::int64_t>(size.x) * size.y;
    const int side = std::max(size.x, size.y);
    samples_ = 4 * pixels <= most_samples && 2 * side <= longest_side ? 2 : 1;
    pixel_size_ = 1;
    while (pixels / pixel_size_ / pixel_size_ > most_samples || side / pixel_size_ > longest_side)
        ++pixel_size_;
    image_.width = std::max(size.x / pixel_size_, 1);
    image_.height = std::max(size.y / pixel_size_, 1);
    eye_ = eye_of(look.view, outside_scene_, size, look.margin);
    sample_eye_ = scaled(eye_, static_cast<double>(samples_) / pixel_size_);
    resize(base_, samples_ * glm::ivec2(image_.width, image_.height));
    base_is_done_ = false;
    moment_key_ = std::nullopt;
    at_work_.triangle = std::nullopt;
    next_ = 0;
    work_ = 0;
}

/// The triangles to draw in one call.
std::vector<std::int32_t> OutsideDrawing::next_triangles(std::int64_t work_at_once) {
    const int count = scene_->triangle_count();
    const std::int64_t end =
        work_ + work_at_once * (count <= most_ordered ? small_scene_factor : 1);
    std::vector<std::int32_t> numbers;
    while (next_ < count && work_ < end) {
        const int number = triangle_in_turn(next_++, count);
        const WorldTriangle& triangle = triangles_[static_cast<std::size_t>(number)];
        if (is_culled(triangle, eye_.position, outside_scene_.plane.eye)) continue;
        numbers.push_back(number);
        work_ += work_of(triangle, sample_eye_, base_.size);
    }
    base_is_done_ = next_ >= count || work_ >= most_work;
    return numbers;
}

void OutsideDrawing::draw_base(const OutsideSubject& subject, const OutsideStyle& style,
                               std::int64_t work_at_once) {
    const bool is_first = next_ == 0; // the base still holds an earlier picture
    shape_->draw(fast_eye(sample_eye_, base_.all()), next_triangles(work_at_once), drawn_);
    const std::uint32_t ground = packed_colour(style.ground);
    BasePainter painter(*this, subject, style);
    for (int row = 0; row < base_.size.y; ++row) {
        for (int column = 0; column < base_.size.x; ++column) {
            const std::size_t from = drawn_.at(column, row), to = base_.at(column, row);
            const float inv_z = drawn_.inv_z[from];
            const int triangle = drawn_.owner[from];
            if (!is_first && !(inv_z > base_.inv_z[to])) continue;
            base_.inv_z[to] = inv_z;
            base_.id[to] = triangle;
            base_.colour[to] = triangle >= 0 ? painter.at(triangle, column, row, inv_z) : ground;
        }
    }
    if (base_is_done_) draw_outline(style);
}

void OutsideDrawing::draw_outline(const OutsideStyle& style) {
    const std::uint32_t colour = packed_colour(style.line) | line_flag;
    for (const OutlineEdge& edge : outline_) {
        draw_line(sample_eye_, sample_eye_.in_eye(edge.from), sample_eye_.in_eye(edge.to), colour,
                  samples_, base_);
    }
}

void OutsideDrawing::find_triangle_at_work(std::optional<int> triangle) {
    if (triangle == at_work_.triangle) return;
    at_work_.triangle = std::nullopt; // in case memory runs out
    at_work_.box = box_of_triangle(triangle);
    if (!is_empty(at_work_.box)) {
        const std::array<std::int32_t, 1> number{*triangle};
        shape_->draw(fast_eye(sample_eye_, at_work_.box), number, at_work_.picture);
    }
    at_work_.triangle = triangle;
}

void OutsideDrawing::draw_triangle_at_work(const OutsideSubject& subject, const OutsideStyle& style,
                                           const Rectangle& samples) {
    const Scene& scene = *subject.scene;
    if (!is_triangle_of(scene, subject.triangle)) return;
    const int triangle = *subject.triangle;
    find_triangle_at_work(triangle);
    const Rectangle& box = at_work_.box;
    const Rectangle area = intersection(box, samples);
    if (is_empty(area)) return;
    const EyeTexture texture = eye_texture(subject, triangle, sample_eye_);
    const FillProgress filled(subject.frame, subject.cursor, triangle);
    const glm::vec3 own = own_colour(scene, triangle);
    const std::uint32_t lit = packed_colour(over_ground(style, own, 1.0f));
    const std::uint32_t dark = packed_colour(over_ground(style, own, style.drawn));
    const std::uint32_t cut_off =
        packed_colour(over_ground(style, style.cut_off, style.cut_off_share));
    const InsideTest inside(subject.clipping, eye_corners(scene, triangle, sample_eye_),
                            sample_eye_);
    const PicturePlane& plane = outside_scene_.plane;
    // From the space of the eye outside to camera space.
    const glm::dvec3 shift = (sample_eye_.position - plane.eye) * plane.rotation;
    const auto colour_at = [&](const glm::dvec3& place) {
        if (inside.is_cut() && !inside.has(place)) return cut_off;
        bool is_filled = filled.is_whole();
        if (!is_filled && !filled.is_empty()) {
            const glm::dvec3 turned = (sample_eye_.rotation * place) * plane.rotation;
            const std::optional<glm::dvec2> pixel = plane.pixel_of(turned + shift);
            is_filled = pixel && filled.has(*pixel);
        }
        if (!texture.is_there()) return is_filled ? lit : dark;
        return packed_colour(
            over_ground(style, own * texture.at(place), is_filled ? 1.0f : style.drawn));
    };
    for (int row = area.top; row < area.bottom; ++row) {
        for (int column = area.left; column < area.right; ++column) {
            const std::size_t from = at_work_.picture.at(column - box.left, row - box.top);
            const std::size_t to = grid_.at(column, row);
            const float inv_z = at_work_.picture.inv_z[from];
            if (at_work_.picture.owner[from] < 0 || inv_z * same_surface < grid_.inv_z[to])
                continue;
            grid_.inv_z[to] = inv_z;
            grid_.id[to] = triangle;
            grid_.colour[to] = colour_at(place_at(sample_eye_, column, row, inv_z));
        }
    }
}

/// The picture in blocks; only those that have changed are made again.
void OutsideDrawing::shrink_picture(const OutsideSubject& subject, double samples_a_pixel) {
    const Image& picture = subject.picture;
    const int block = block_size(picture, samples_a_pixel);
    const bool is_same_size = shown_number_ != 0 && shown_.block == block;
    if (is_same_size && shown_number_ == subject.picture_number) return;
    const bool is_known = is_same_size && shown_number_ == subject.picture_before;
    shown_number_ = 0;
    if (is_known) {
        downsample_again(picture, subject.framebuffer, glass, subject.picture_changed, shown_);
    } else {
        shown_ = downsampled(picture, subject.framebuffer, block, glass);
    }
    shown_number_ = subject.picture_number;
}

void OutsideDrawing::draw_picture(const OutsideSubject& subject, const Rectangle& samples) {
    const Viewport size = outside_scene_.plane.size;
    const Image& picture = subject.picture;
    if (picture.width != size.width || picture.height != size.height) return;
    const std::optional<EyePane> pane = eye_pane(outside_scene_.plane, sample_eye_);
    if (!pane) return;
    shrink_picture(subject, pane->samples_a_pixel);
    const Rectangle box = box_around(sample_eye_, pane->corners, samples);
    for (int row = box.top; row < box.bottom; ++row) {
        for (int column = box.left; column < box.right; ++column) {
            const glm::dvec3 ray = sample_eye_.ray({column + 0.5, row + 0.5});
            const double inv_z = glm::dot(pane->inv_z, ray);
            const std::size_t sample = grid_.at(column, row);
            // Seen edge-on, the pane has no depth that can be computed.
            if (!(inv_z > 0.0) || inv_z * sample_eye_.near_distance > 1.0 ||
                inv_z < static_cast<double>(grid_.inv_z[sample]))
                continue;
            const glm::dvec2 place = pane->pixel_of(ray / inv_z);
            if (!(place.x >= 0.0 && place.y >= 0.0 && place.x < size.width &&
                  place.y < size.height))
                continue;
            const glm::ivec2 pixel(place);
            grid_.inv_z[sample] = static_cast<float>(inv_z);
            grid_.id[sample] = first_pixel_id - (pixel.y * size.width + pixel.x);
            grid_.colour[sample] = over(shown_.at(pixel.x, pixel.y), grid_.colour[sample]);
        }
    }
}

/// Makes the pixels of the image that contain these samples.
void OutsideDrawing::resolve(const Rectangle& samples) {
    image_.rgba.resize(4 * static_cast<std::size_t>(image_.width) *
                       static_cast<std::size_t>(image_.height));
    const int left = samples.left / samples_, right = (samples.right + samples_ - 1) / samples_;
    const int top = samples.top / samples_, bottom = (samples.bottom + samples_ - 1) / samples_;
    for (int row = top; row < bottom; ++row) {
        const std::uint32_t* const from = &grid_.colour[grid_.at(samples_ * left, samples_ * row)];
        std::uint8_t* const to =
            &image_
                 .rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
                            static_cast<std::size_t>(left))];
        if (samples_ == 2)
            resolve_row<2>(from, grid_.size.x, right - left, to);
        else
            resolve_row<1>(from, grid_.size.x, right - left, to);
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
    const int width = std::max(outside_scene_.plane.size.width, 1);
    pick.pixel = {number % width, number / width};
    return pick;
}

} // namespace rasterwalk
