// Two threads: the picture is divided into bands of rows, and each thread draws every second band.
// They share no pixel, so neither waits for the other, and it does not matter who is first.

#include <algorithm>
#include <optional>
#include <vector>

#include "engines/ladder/many_rows.h"
#include "engines/ladder/rungs.h"
#include "engines/ladder/screen_triangle.h"

namespace rasterwalk::rungs::bands {

namespace {

constexpr int band_height = 16;
/// Triangles at a time, so that what is known about them stays in the cache.
constexpr int batch_size = 1024;

/// Every band of a thread.
void draw_bands(const ScreenTriangle& triangle, int thread, int threads, const PixelLight& light,
                const Lab& lab) {
    for (int band = triangle.top / band_height; band * band_height <= triangle.bottom; ++band) {
        if (band % threads == thread)
            draw_rows(triangle, band * band_height, (band + 1) * band_height, light, lab);
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture, WorkerPool& pool) {
    const Lab lab = begin_picture(settings, picture);
    const PixelLight light = pixel_light(lab);
    std::vector<std::optional<ScreenTriangle>> batch(batch_size);
    for (int first = 0; first < scene.triangle_count(); first += batch_size) {
        const int count = std::min(batch_size, scene.triangle_count() - first);
        pool.run([&](int thread) {
            for (int i = thread; i < count; i += pool.count())
                batch[static_cast<std::size_t>(i)] = screen_triangle(scene, first + i, lab);
        });
        pool.run([&](int thread) {
            for (int i = 0; i < count; ++i) {
                const auto& triangle = batch[static_cast<std::size_t>(i)];
                if (triangle) draw_bands(*triangle, thread, pool.count(), light, lab);
            }
        });
    }
}

} // namespace rasterwalk::rungs::bands
