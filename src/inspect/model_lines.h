#pragma once

// The lines of a model's file as they can be shown, and what a triangle has to do with them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/frame.h"
#include "scene/model_source.h"
#include "scene/obj_report.h"

namespace rasterwalk {

/// A piece of a line.
struct FilePiece {
    std::string text; ///< in printable form
    int corner = -1;  ///< of the line's face, from 0; -1: it is no corner
};

/// What the reader's report says about a line. It names only the first fault of each kind and the
/// first `most_faults` of all, so that a line can be faulty and unmarked.
enum class FileLineUse : std::uint8_t {
    unmarked, ///< neither of the following is known
    aside,    ///< a comment, a material, or what has no effect
    faulty,   ///< something in it is wrong
};

/// A line of the file.
struct FileLine {
    int number = 0; ///< from 1
    std::vector<FilePiece> pieces;
    FileLineUse use = FileLineUse::unmarked;
    /// The reader's own, if it has one about this line, and how many faults like it there are.
    std::string sentence;
    int face = 0; ///< the line on which the statement of its face begins; 0: it is of no face
};

/// The most bytes of a line that are shown. Corners after them are not recognized.
inline constexpr std::size_t most_line_bytes = 300;

/// Consecutive lines of a file whose text is kept; fewer where it ends. A statement that begins
/// 64 lines or more before the first of them is not recognized.
/// @param first from 1
std::vector<FileLine> file_lines(const ModelSource& source, const ObjReport& report, int first,
                                 int count);

/// The triangle of the model that a drawn one is, or is a piece of.
int model_triangle(const Frame& frame, int drawn);

/// The first drawn triangle that is this one of the model, or is a piece of it; none if there is
/// none.
std::optional<int> drawn_triangle(const Frame& frame, int of_model);

/// Are the vertices of a drawn triangle in the file? Not if tessellation or a plane has made them.
bool is_from_file(const Frame& frame, int drawn);

/// A corner of a face as the file gives it.
struct FileCorner {
    int line = 0;    ///< on which the statement of its face begins, from 1
    int number = 0;  ///< among the corners of the face, from 0
    ObjCorner names; ///< what is used of what it names
    int position_line = 0, texcoord_line = 0, normal_line = 0; ///< of v, vt, vn; 0: none is used
};

/// A vertex of a drawn triangle in the file. None if the text is not kept, or if the triangle
/// is not from the file; see is_from_file().
/// @param vertex 0..2
std::optional<FileCorner> file_corner(const Frame& frame, int drawn, int vertex);

/// "corner 5/1/1 → v 5, vt 1, vn 1", with the corner as the file writes it; with its number in the
/// face, "corner [62]", where it comes after what is shown of the line.
std::string corner_words(const ModelSource& source, const FileCorner& corner);

/// A vertex of a triangle of the model.
struct ModelVertex {
    int triangle = 0;
    int vertex = 0; ///< 0..2, in the scene's order

    friend bool operator==(const ModelVertex&, const ModelVertex&) = default;
};

/// What a click on a line leads to: for a face its first triangle, or the first with this corner;
/// for v, vt and vn the first vertex that uses it. None if no drawn triangle does.
/// @param corner of the face; -1: any
/// @param preferred a triangle that is chosen if it is one of several
std::optional<ModelVertex> vertex_of_line(const ModelSource& source, const FileLine& line,
                                          int corner, int preferred);

} // namespace rasterwalk
