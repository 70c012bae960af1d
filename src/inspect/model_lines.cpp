#include "inspect/model_lines.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/quoted.h"
#include "scene/model_scene.h"
#include "scene/obj_words.h"

namespace rasterwalk {

namespace {

/// One of the kinds of numbers that a corner names.
struct NamedKind {
    std::string_view statement;
    int ObjCorner::*index;
    std::vector<int> ModelSource::*lines;
    int FileCorner::*line;
};
constexpr std::array named_kinds{
    NamedKind{"v", &ObjCorner::position, &ModelSource::position_lines, &FileCorner::position_line},
    NamedKind{"vt", &ObjCorner::texcoord, &ModelSource::texcoord_lines, &FileCorner::texcoord_line},
    NamedKind{"vn", &ObjCorner::normal, &ModelSource::normal_lines, &FileCorner::normal_line}};

/// Cuts lines into pieces, one after another: a face may go on from line to line.
class LineCutter {
  public:
    FileLine cut(std::string_view line, int number) {
        const bool is_first = !goes_on_;
        if (is_first) begin(line, number);
        FileLine cut;
        cut.number = number;
        cut.face = face_;
        cut.use = is_aside_ ? FileLineUse::aside : FileLineUse::unmarked;
        std::string_view content = line;
        goes_on_ = !is_comment_ && take_backslash(content);
        room_ = most_line_bytes;
        std::size_t shown = 0;
        // A line can have megabytes: no more of it is split than can be shown, and a byte that
        // says that there is more.
        const std::string_view head = content.substr(0, most_line_bytes + 1);
        const bool has_corners = face_ > 0 && !is_over_;
        std::string_view rest = has_corners ? head : std::string_view();
        if (is_first) take_word(rest);
        for (std::string_view word = take_number_word(rest); !word.empty() && room_ > 0;
             word = take_number_word(rest)) {
            const auto begin = static_cast<std::size_t>(word.data() - line.data());
            add(cut, line.substr(shown, begin - shown), -1);
            add(cut, word, corner_++);
            shown = begin + word.size();
        }
        // A comment reaches to the end of the statement.
        if (has_corners)
            is_over_ = content.size() >= most_line_bytes || head.find('#', shown) != head.npos;
        add(cut, line.substr(shown), -1);
        return cut;
    }

  private:
    void begin(std::string_view line, int number) {
        std::string_view rest = line;
        const std::string_view word = take_word(rest);
        is_comment_ = is_comment(line);
        is_aside_ = is_comment_ || word == "usemtl" || word == "mtllib";
        face_ = word == "f" || word == "fo" ? number : 0;
        corner_ = 0;
        is_over_ = false;
    }

    /// Adds a piece, as far as there is room in the line.
    void add(FileLine& line, std::string_view text, int corner) {
        if (text.empty() || room_ == 0) return;
        std::size_t end = std::min(room_, text.size());
        // Not within a character of several bytes.
        while (end > 0 && end < text.size() &&
               (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
            --end;
        std::string shown = visible_line(text.substr(0, end));
        std::replace(shown.begin(), shown.end(), '\t', ' ');
        if (text.size() > room_) shown += "…";
        line.pieces.push_back({std::move(shown), corner});
        room_ -= std::min(room_, text.size());
    }

    bool goes_on_ = false; ///< the next line belongs to this statement
    bool is_comment_ = false, is_aside_ = false, is_over_ = false;
    std::size_t room_ = 0; ///< bytes of the line that can still be shown
    int face_ = 0, corner_ = 0;
};

/// The reader's own sentence about a line; sets its use.
void add_sentence(const ModelSource& source, const ObjReport& report, FileLine& line) {
    const std::string path = visible_line(source.path);
    const auto is_here = [&](const auto& remark) {
        return remark.line == line.number && remark.path == path;
    };
    const auto fault = std::find_if(report.faults.begin(), report.faults.end(), is_here);
    if (fault != report.faults.end()) {
        line.use = FileLineUse::faulty;
        line.sentence = fault->sentence + more_like_it(*fault);
        if (fault->count > 1) line.sentence += " Only the first is marked.";
        return;
    }
    const auto note = std::find_if(report.notes.begin(), report.notes.end(), is_here);
    if (note != report.notes.end()) line.sentence = note->sentence;
    if (line.pieces.empty()) return;
    std::string_view rest = line.pieces.front().text;
    const std::string_view word = take_word(rest);
    // A point has more than its place if it has anything after it.
    const auto skipped =
        std::find_if(report.skipped.begin(), report.skipped.end(), [&](const ObjSkipped& one) {
            return one.path == path && one.statement == word &&
                   (word != "v" || one.line == line.number);
        });
    if (skipped == report.skipped.end()) return;
    if (word != "v") line.use = FileLineUse::aside;
    line.sentence = fmt::format("skipped: {}.", skipped->why);
}

/// The number of the statement on this line among those of its kind; -1 if it is none of them.
int number_on_line(const std::vector<int>& lines, int line) {
    const auto found = std::lower_bound(lines.begin(), lines.end(), line);
    return found != lines.end() && *found == line ? static_cast<int>(found - lines.begin()) : -1;
}

/// The triangles of a face, from the first to behind the last.
struct FaceTriangles {
    int first = 0, last = 0;
};

FaceTriangles triangles_of_face(const ModelSource& source, int line) {
    const auto [first, last] = std::equal_range(
        source.triangles.begin(), source.triangles.end(), TriangleOrigin{line, {}},
        [](const TriangleOrigin& a, const TriangleOrigin& b) { return a.line < b.line; });
    return {static_cast<int>(first - source.triangles.begin()),
            static_cast<int>(last - source.triangles.begin())};
}

/// The number, in ModelSource::corners, of a face's first corner.
int first_corner_of(const ModelSource& source, int line) {
    const FaceTriangles face = triangles_of_face(source, line);
    int first = static_cast<int>(source.corners.size());
    for (int t = face.first; t < face.last; ++t) {
        for (const int corner : source.triangles[static_cast<std::size_t>(t)].corners)
            first = std::min(first, corner);
    }
    return first;
}

/// The first vertex of these triangles that is wanted; one of the preferred triangle comes before.
template <class IsWanted>
std::optional<ModelVertex> find_vertex(const ModelSource& source, FaceTriangles among,
                                       int preferred, IsWanted is_wanted) {
    const auto in_triangle = [&](int t) -> std::optional<ModelVertex> {
        const TriangleOrigin& origin = source.triangles[static_cast<std::size_t>(t)];
        for (int v = 0; v < triangle_corners; ++v) {
            const auto corner =
                static_cast<std::size_t>(model_corners[static_cast<std::size_t>(v)]);
            if (is_wanted(origin.corners[corner])) return ModelVertex{t, v};
        }
        return std::nullopt;
    };
    if (preferred >= among.first && preferred < among.last) {
        if (const auto found = in_triangle(preferred)) return found;
    }
    for (int t = among.first; t < among.last; ++t) {
        if (const auto found = in_triangle(t)) return found;
    }
    return std::nullopt;
}

} // namespace

std::vector<FileLine> file_lines(const ModelSource& source, const ObjReport& report, int first,
                                 int count) {
    std::vector<FileLine> lines;
    // From a mark before it, since a statement may begin on an earlier line.
    const int start =
        std::max((first - 1) / lines_per_mark * lines_per_mark + 1 - lines_per_mark, 1);
    std::string_view rest = text_from_line(source, start);
    LineCutter cutter;
    for (int number = start; !rest.empty() && number < first + count; ++number) {
        FileLine line = cutter.cut(take_line(rest), number);
        if (number < first) continue;
        add_sentence(source, report, line);
        lines.push_back(std::move(line));
    }
    return lines;
}

int model_triangle(const Frame& frame, int drawn) {
    return scene_triangle(*frame.scene, drawn) / frame.triangles_of_each();
}

std::optional<int> drawn_triangle(const Frame& frame, int of_model) {
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (model_triangle(frame, t) == of_model) return t;
    }
    return std::nullopt;
}

bool is_from_file(const Frame& frame, int drawn) {
    const std::vector<TriangleSource>& sources = frame.scene->sources;
    const bool is_cut = !sources.empty() && sources[static_cast<std::size_t>(drawn)].is_cut;
    return !is_cut && frame.triangles_of_each() == 1;
}

std::optional<FileCorner> file_corner(const Frame& frame, int drawn, int vertex) {
    const ModelSource* const source = frame.given->model_source.get();
    if (source == nullptr || source->corners.empty() || !is_from_file(frame, drawn))
        return std::nullopt;
    const TriangleOrigin& origin =
        source->triangles[static_cast<std::size_t>(model_triangle(frame, drawn))];
    const int index =
        origin.corners[static_cast<std::size_t>(model_corners[static_cast<std::size_t>(vertex)])];
    FileCorner corner;
    corner.line = origin.line;
    corner.number = index - first_corner_of(*source, origin.line);
    corner.names = source->corners[static_cast<std::size_t>(index)];
    for (const NamedKind& kind : named_kinds) {
        const int named = corner.names.*kind.index;
        if (named >= 0) corner.*kind.line = (source->*kind.lines)[static_cast<std::size_t>(named)];
    }
    return corner;
}

std::string corner_words(const ModelSource& source, const FileCorner& corner) {
    std::string_view rest = text_from_line(source, corner.line);
    LineCutter cutter;
    std::string word;
    for (int number = corner.line; word.empty() && !rest.empty(); ++number) {
        const FileLine line = cutter.cut(take_line(rest), number);
        if (line.face != corner.line) break;
        for (const FilePiece& piece : line.pieces) {
            if (piece.corner == corner.number) word = piece.text + " ";
        }
    }
    if (word.empty()) word = fmt::format("[{}] ", corner.number);
    std::string words = "corner " + word + "→";
    for (const NamedKind& kind : named_kinds) {
        const int named = corner.names.*kind.index;
        if (named >= 0)
            words +=
                fmt::format("{} {} {}", words.ends_with("→") ? "" : ",", kind.statement, named + 1);
    }
    return words;
}

std::optional<ModelVertex> vertex_of_line(const ModelSource& source, const FileLine& line,
                                          int corner, int preferred) {
    if (line.face > 0) {
        const int wanted = first_corner_of(source, line.face) + corner;
        return find_vertex(source, triangles_of_face(source, line.face), preferred,
                           [&](int index) { return corner < 0 || index == wanted; });
    }
    const FaceTriangles all{0, static_cast<int>(source.triangles.size())};
    for (const NamedKind& kind : named_kinds) {
        const int number = number_on_line(source.*kind.lines, line.number);
        if (number < 0) continue;
        return find_vertex(source, all, preferred, [&](int index) {
            return source.corners[static_cast<std::size_t>(index)].*kind.index == number;
        });
    }
    return std::nullopt;
}

} // namespace rasterwalk
