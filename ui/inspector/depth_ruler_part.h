#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

struct Ui;
struct PixelHistory;
struct Cursor;
struct DepthRules;

/// A depth that is marked on the ruler.
struct DepthMark {
    double z = 0.0;      ///< in front of the camera, world units
    float stored = 0.0f; ///< in the buffer
    std::string name;    ///< "t12", "v0"
};

/// The depths that the buffer can tell apart, from the near plane to the far one, and enlarged
/// around one of the marks. Draws nothing in a scene without a camera.
/// @param owner  before the names of its widgets: "history."
/// @param chosen the mark that it is enlarged around
void draw_depth_ruler(Ui& ui, std::string_view owner, const std::vector<DepthMark>& marks,
                      std::size_t chosen);

/// More marks would be one smear.
inline constexpr std::size_t most_depth_marks = 64;

/// The marks of a history, and the one that the ruler is enlarged around.
struct HistoryMarks {
    std::vector<DepthMark> marks; ///< at most most_depth_marks
    std::size_t chosen = 0;       ///< the fragment shown, or else the one that stays, or the first
};

/// The fragments of a pixel that have a depth: the first ones, and always the chosen one.
/// @param shown the fragment shown; may be null
HistoryMarks marks_of_history(const PixelHistory& history, const Cursor* shown,
                              const DepthRules& rules);

/// Draws the ruler of the fragments of a pixel, around the one shown; nothing without a depth test,
/// or where the buffer is finer than can matter.
void draw_ruler_of_history(Ui& ui, const PixelHistory& history);

} // namespace rasterwalk
