#pragma once

// Both runs of a mistake of the laboratory, on its own scene, and all that they did.

#include <map>
#include <string_view>
#include <vector>

#include "inspect/stats.h"
#include "laboratory/bug.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "support/recorder.h"

namespace rasterwalk::test {

/// One run, drawn while a recorder watched.
struct DrawnRun {
    Frame frame;
    Framebuffer picture;
    Recorder reported{true};
    FrameStats stats;

    DrawnRun(const Scene& scene, const Settings& settings) : frame(prepare_frame(scene, settings)) {
        clear(picture, frame);
        draw(frame, {}, picture, &reported);
        stats = frame_stats(frame);
    }
    bool is_drawn(int column, int row) const { return picture.owner[picture.at(column, row)] >= 0; }
};

struct BugRuns {
    Session session;
    DrawnRun wrong, right;

    explicit BugRuns(std::string_view id)
        : session(session_of(id)), wrong(*session.scene, session.a.settings),
          right(*session.scene, session.b->settings) {}

  private:
    static Session session_of(std::string_view id) {
        Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
        open_bug(find_bug(read_bugs(), id), session);
        return session;
    }
};

/// The number of pixels whose colour differs.
inline int different_pixels(const Framebuffer& a, const Framebuffer& b) {
    int different = 0;
    for (std::size_t at = 0; at < a.colour.size(); ++at)
        different += a.colour[at] != b.colour[at] ? 1 : 0;
    return different;
}

/// The leftmost and the rightmost column of a row.
struct Columns {
    int left, right;
    friend bool operator==(const Columns&, const Columns&) = default;
};

/// The rows of a triangle, by their numbers in the picture.
using RowsOfTriangle = std::map<int, Columns>;

inline void widen(RowsOfTriangle& rows, int column, int row) {
    const auto [found, is_new] = rows.try_emplace(row, Columns{column, column});
    found->second.left = std::min(found->second.left, column);
    found->second.right = std::max(found->second.right, column);
}

/// The rows of a triangle as the run's table has them, without those that no sample reached.
inline RowsOfTriangle rows_of_table(const DrawnRun& run, int triangle) {
    PolygonRows table;
    compute_rows(run.frame, triangle, table);
    RowsOfTriangle rows;
    for (int r = 0; r < table.size(); ++r) {
        const auto i = static_cast<std::size_t>(r);
        if (!table.is_empty_row(r))
            rows[table.first_row + r] = {table.left[i].column, table.right[i].column};
    }
    return rows;
}

/// The lowest row of a triangle's vertices.
inline int lowest_row(const Frame& frame, int triangle) {
    int lowest = INT_MIN;
    for (const ScreenVertex& vertex : frame.triangle_vertices(triangle))
        lowest = std::max(lowest, vertex.row);
    return lowest;
}
inline int highest_row(const Frame& frame, int triangle) {
    int highest = INT_MAX;
    for (const ScreenVertex& vertex : frame.triangle_vertices(triangle))
        highest = std::min(highest, vertex.row);
    return highest;
}

} // namespace rasterwalk::test
