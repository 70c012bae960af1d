// A wrong turning: two threads take the triangles in turn, and share one depth buffer without a
// lock. Between a thread's test of a pixel and its write, the other can write something nearer,
// which is then lost: the picture depends on who was faster, and differs from run to run.
//
// In C++ two plain accesses to the same memory, one of them a write, would be undefined behaviour.
// Here each single access is atomic, so that the program stays defined and nothing else can go
// wrong than their order. A program without that shows the same, or worse.

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "engines/ladder/rungs.h"
#include "engines/ladder/screen_triangle.h"

namespace rasterwalk::rungs::two_threads_one_buffer {

namespace {

/// What the threads share.
struct SharedPlanes {
    std::unique_ptr<std::atomic<float>[]> depth;
    std::unique_ptr<std::atomic<std::uint32_t>[]> colour;
};

glm::vec3 pixel_colour(int x, int y, float zinv, const ScreenTriangle& triangle,
                       const PixelLight& light, const Lab& lab) {
    const Surface& surface = triangle.surface;
    glm::vec3 carried(0.0f);
    if (lab.is_light_per_vertex || surface.is_bent)
        carried = glm::vec3(triangle.carried.start + triangle.carried.right * double(x) +
                            triangle.carried.down * double(y));
    if (lab.is_light_per_vertex) return carried * (1.0f / zinv);
    const glm::vec3 ray(light.ray_start + light.ray_step * glm::vec2(x, y), 1.0f);
    const glm::vec3 to_light = light.lamp * zinv - ray;
    const glm::vec3 normal = surface.is_bent ? carried : surface.normal;
    const float square = surface.is_bent ? glm::dot(normal, normal) : 1.0f;
    const float distance2 = glm::dot(to_light, to_light);
    const float share =
        glm::dot(to_light, normal) / (4.0f * pi * distance2 * std::sqrt(distance2 * square));
    return surface.reflectance *
           (lab.light.power * (std::max(0.0f, share) * zinv * zinv) + lab.light.indirect);
}

void draw_triangle(const ScreenTriangle& triangle, const PixelLight& light, const Lab& lab,
                   SharedPlanes& shared) {
    const auto step = static_cast<float>(triangle.zinv.right);
    for (int y = triangle.top; y <= triangle.bottom; ++y) {
        const Span span = span_of(y, triangle);
        const auto first = static_cast<float>(triangle.zinv.start + triangle.zinv.down * y +
                                              triangle.zinv.right * triangle.left);
        for (int x = span.begin; x <= span.end; ++x) {
            const float zinv = first + static_cast<float>(x - triangle.left) * step;
            const std::size_t place = place_of(x, y, lab.picture.size);
            if (zinv <= shared.depth[place].load(std::memory_order_relaxed)) continue;
            // From here on the test may no longer be true.
            const glm::vec3 colour = pixel_colour(x, y, zinv, triangle, light, lab);
            shared.depth[place].store(zinv, std::memory_order_relaxed);
            shared.colour[place].store(to_bytes(colour), std::memory_order_relaxed);
        }
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture, WorkerPool& pool) {
    const Lab lab = begin_picture(settings, picture);
    const PixelLight light = pixel_light(lab);
    const std::size_t pixels = picture.depth.size();
    SharedPlanes shared{std::make_unique<std::atomic<float>[]>(pixels),
                        std::make_unique<std::atomic<std::uint32_t>[]>(pixels)};
    std::vector<std::optional<ScreenTriangle>> triangles;
    for (int t = 0; t < scene.triangle_count(); ++t)
        triangles.push_back(screen_triangle(scene, t, lab));
    std::atomic<int> arrived{0};
    pool.run([&](int thread) {
        const auto count = static_cast<std::size_t>(pool.count());
        for (std::size_t first = 0, turn = 1; first < triangles.size(); first += count, ++turn) {
            // They begin each pair of triangles together.
            ++arrived;
            while (arrived < static_cast<int>(turn) * pool.count())
                std::this_thread::yield();
            const std::size_t t = first + static_cast<std::size_t>(thread);
            if (t < triangles.size() && triangles[t])
                draw_triangle(*triangles[t], light, lab, shared);
        }
    });
    for (std::size_t place = 0; place < pixels; ++place) {
        picture.depth[place] = shared.depth[place];
        picture.colour[place] = shared.colour[place];
    }
}

} // namespace rasterwalk::rungs::two_threads_one_buffer
