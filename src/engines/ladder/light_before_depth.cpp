// A wrong turning: the same as depth_first.cpp, but a pixel gets its light before its depth is
// tested. The picture is the same; the light of every hidden pixel was for nothing.

#include "engines/ladder/depth_first.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk::rungs::light_before_depth {

namespace {

void draw_polygon_rows(int rows, const RowTable& table, const Surface& surface, const Lab& lab) {
    const Viewport size = lab.picture.size;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows); ++i) {
        const Pixel& left = table.left_pixels[i];
        const Pixel& right = table.right_pixels[i];
        if (left.x > right.x) continue; // no sample has reached the row
        if (left.y < 0 || left.y >= size.height) continue;
        const RowSteps row = row_between(left, right);
        float zinv = left.zinv;
        for (int x = left.x; x <= right.x; ++x, zinv += row.step_zinv) {
            if (x < 0 || x >= size.width) continue;
            const std::size_t place = place_of(x, left.y, size);
            const std::uint32_t colour =
                to_bytes(pixel_colour(x - left.x, zinv, row, surface, lab));
            if (zinv <= lab.picture.depth[place]) continue;
            lab.picture.depth[place] = zinv;
            lab.picture.colour[place] = colour;
        }
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    for_each_row_table(scene, lab, [&](int rows, const RowTable& table, const Surface& surface) {
        draw_polygon_rows(rows, table, surface, lab);
    });
}

} // namespace rasterwalk::rungs::light_before_depth
