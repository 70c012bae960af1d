// The lab's loop with the depth test first: along a row only 1/z is stepped. All other values are
// worked out for the pixels that pass the test, and only those that their light needs.

#include "engines/ladder/depth_first.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk::rungs::depth_first {

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    for_each_row_table(scene, lab, [&](int rows, const RowTable& table, const Surface& surface) {
        draw_rows_depth_first(rows, table, surface, lab, pixel_colour);
    });
}

} // namespace rasterwalk::rungs::depth_first
