#pragma once

// Where a model comes from: the text of its file, and which of its lines each triangle was made of.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files.h"
#include "scene/mesh.h"

namespace rasterwalk {

/// Indices of a corner of a face, from 0; -1: not given, or there is none of this number.
struct ObjCorner {
    int position = 0, texcoord = -1, normal = -1;

    friend bool operator==(const ObjCorner&, const ObjCorner&) = default;
};

/// What a triangle was made of.
struct TriangleOrigin {
    int line = 0; ///< on which the statement of its face begins, from 1
    /// Indices in ModelSource::corners.
    std::array<int, triangle_corners> corners{};

    friend bool operator==(const TriangleOrigin&, const TriangleOrigin&) = default;
};

/// A model's file as it was read.
struct ModelSource {
    std::string path;
    FileState state;       ///< of the file when it was read; FileState{} if the text was given
    std::size_t bytes = 0; ///< of the file
    int lines = 0;         ///< of the file
    std::vector<TriangleOrigin> triangles; ///< of the model, in its order

    // Empty if the file is larger than `most_kept_model_text`:

    std::string text;
    std::vector<std::uint32_t> line_marks; ///< where lines 1, 65, 129 ... begin in the text
    std::vector<ObjCorner> corners;        ///< of all faces that are drawn, and of some others
    std::vector<int> position_lines;       ///< the line of each statement v, from 1, ascending
    std::vector<int> texcoord_lines;       ///< the same of vt
    std::vector<int> normal_lines;         ///< the same of vn

    friend bool operator==(const ModelSource&, const ModelSource&) = default;
};

/// Every how many lines the text has a mark.
inline constexpr int lines_per_mark = 64;

/// The text from the beginning of a line to the end; empty beyond the last line.
/// @param line from 1
std::string_view text_from_line(const ModelSource& source, int line);

/// The source of a scene's model, which copies of the scene share; null if the scene is no model.
class SharedModelSource {
  public:
    SharedModelSource() = default;
    explicit SharedModelSource(std::shared_ptr<const ModelSource> source)
        : source_(std::move(source)) {}

    const ModelSource* get() const { return source_.get(); }
    const std::shared_ptr<const ModelSource>& shared() const { return source_; }

    /// The same source, whether or not it is shared.
    friend bool operator==(const SharedModelSource& a, const SharedModelSource& b) {
        if (a.source_ == b.source_) return true;
        return a.source_ && b.source_ && *a.source_ == *b.source_;
    }

  private:
    std::shared_ptr<const ModelSource> source_;
};

} // namespace rasterwalk
