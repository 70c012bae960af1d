// The lab's loop without a vector for edges and rows: a pixel is used as soon as interpolation has
// made it, and then forgotten. Only the ends of the rows are kept.

#include "engines/ladder/no_vectors.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk::rungs::no_vectors {

namespace {

void draw_polygon_rows(int rows, const RowTable& table, const Surface& surface, const Lab& lab) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows); ++i) {
        const Pixel& left = table.left_pixels[i];
        const Pixel& right = table.right_pixels[i];
        if (left.x > right.x) continue; // no sample has reached the row
        interpolate(left, right, right.x - left.x + 1,
                    [&](const Pixel& pixel) { pixel_shader(pixel, surface, lab); });
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    for_each_row_table(scene, lab, [&](int rows, const RowTable& table, const Surface& surface) {
        draw_polygon_rows(rows, table, surface, lab);
    });
}

} // namespace rasterwalk::rungs::no_vectors
