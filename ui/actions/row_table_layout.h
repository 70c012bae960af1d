#pragma once

#include <optional>
#include <vector>

struct ImFont;

namespace rasterwalk {

struct Ui;

/// Where the texts of the row table next to the picture are, screen pixels from its left edge. Used
/// by the canvas before it places the picture, and by what enlarges a triangle.
struct RowTableLayout {
    /// The columns of one end; texts are flush right.
    struct End {
        float left = 0.0f, right = 0.0f; ///< of all its columns
        float number = 0.0f;             ///< right end of its column x
        float writer = 0.0f;             ///< right end of the name of what wrote it
        float depth = 0.0f;              ///< right end of its 1/z, if that has a column
    };
    float width = 0.0f; ///< 0: there is no room for it
    float entry = 0.0f; ///< right end of the entries
    End ends[2];        ///< left, right
    bool has_writers = false;
    bool has_depths = false; ///< next to the numbers; if not, below them where a row is high enough
    bool is_flat = false;    ///< 1/z is the same everywhere, and left out
    bool is_large = false;   ///< to be read from afar: no small letters for the main numbers
    ImFont* numbers = nullptr; ///< the letters of the columns
};

/// Is there a row table to show next to the picture, if the zoom gives room for it?
bool wants_row_table(const Ui& ui);

/// Does the inspector show the rows, and nothing over them, in a lecture?
bool is_lecture_of_rows(const Ui& ui);

/// In a lecture whose inspector would show the rows, the table next to the picture replaces it:
/// large, and only once.
bool has_row_table_for_inspector(const Ui& ui);

/// That table over this width, screen pixels; none if its texts or its lines have no room. Where
/// the rows of the picture are low its numbers are as large as the smallest letters of a lecture.
std::optional<RowTableLayout> large_row_table(const Ui& ui, float width);

/// The smallest zoom at which its lines are as high as the rows of the picture.
float large_row_table_zoom(const Ui& ui);

/// The smallest zoom at which the lines of the table are as high as the rows of the picture.
float row_table_zoom(const Ui& ui);

/// The tables that a canvas of this width may have next to the picture, the roomiest first.
std::vector<RowTableLayout> row_table_layouts(const Ui& ui, float canvas_width);

} // namespace rasterwalk
