#pragma once

// What was found in a model file, and what of that the model does not have.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.h"

namespace rasterwalk {

/// How much a model file holds. In 64 bits, so that no file can make a count overflow.
struct ObjCounts {
    std::int64_t lines = 0;            ///< of the model file, without its material files
    std::int64_t positions = 0;        ///< statements v
    std::int64_t texcoords = 0;        ///< statements vt
    std::int64_t normals = 0;          ///< statements vn
    std::int64_t faces = 0;            ///< statements f that are drawn
    std::int64_t corners = 0;          ///< of these faces
    std::int64_t triangles = 0;        ///< into which they are cut
    std::int64_t vertices = 0;         ///< of the mesh: corners that differ
    std::int64_t computed_normals = 0; ///< corners whose normal the file does not give
    std::int64_t parts = 0;            ///< runs of faces of one object, group and material
    std::int64_t materials = 0;        ///< statements newmtl
    std::int64_t textures = 0;         ///< images that are drawn: map_Kd, norm, bump, disp
    std::int64_t faults = 0;           ///< statements with something wrong

    friend bool operator==(const ObjCounts&, const ObjCounts&) = default;
};

/// A count as the report names it.
struct ObjCountInfo {
    std::string_view name, help;
    std::int64_t ObjCounts::*count;
};

/// All counts, in the order they are reported.
inline constexpr std::array obj_count_list{
    ObjCountInfo{"lines", "lines of the model file", &ObjCounts::lines},
    ObjCountInfo{"positions", "points in space: v", &ObjCounts::positions},
    ObjCountInfo{"texcoords", "points in a texture: vt", &ObjCounts::texcoords},
    ObjCountInfo{"normals", "normals given in the file: vn", &ObjCounts::normals},
    ObjCountInfo{"faces", "polygons that are drawn: f", &ObjCounts::faces},
    ObjCountInfo{"corners", "corners of these faces", &ObjCounts::corners},
    ObjCountInfo{"triangles", "triangles into which they are cut", &ObjCounts::triangles},
    ObjCountInfo{"vertices", "corners that differ in at least one number; each is shaded once",
                 &ObjCounts::vertices},
    ObjCountInfo{"computed_normals", "corners whose normal is computed because none is given",
                 &ObjCounts::computed_normals},
    ObjCountInfo{"parts", "runs of faces of one object, group and material", &ObjCounts::parts},
    ObjCountInfo{"materials", "materials: newmtl, in the files that mtllib names",
                 &ObjCounts::materials},
    ObjCountInfo{"textures", "images that are drawn: map_Kd, norm, bump, disp",
                 &ObjCounts::textures},
    ObjCountInfo{"faults", "statements with something wrong in them, which is left out",
                 &ObjCounts::faults},
};
static_assert(sizeof(ObjCounts) == obj_count_list.size() * sizeof(std::int64_t),
              "every count has its row");

/// A remark about a statement, or about several that are alike: what is wrong and what is done
/// instead, or what is right and easily overlooked.
struct ObjFault {
    std::string path;       ///< of the model or of its materials, as messages show it
    int line = 0;           ///< of the first, from 1
    std::string sentence;   ///< of the first; ends with a full stop
    std::int64_t count = 1; ///< statements it applies to

    friend bool operator==(const ObjFault&, const ObjFault&) = default;
};

/// Statements of one kind that are right, or unknown, and have no effect.
struct ObjSkipped {
    std::string statement; ///< its first word, as it can be shown
    std::string why;       ///< "curves and curved surfaces are not drawn"
    std::string path;      ///< of the first one
    int line = 0;          ///< of the first one, from 1
    std::int64_t count = 0;

    friend bool operator==(const ObjSkipped&, const ObjSkipped&) = default;
};

struct ObjReport {
    ObjCounts counts;
    std::vector<ObjFault> faults;    ///< the first `most_faults` of them, in the order of reading
    std::vector<ObjFault> notes;     ///< what is right and easily overlooked; as many at most
    std::vector<ObjSkipped> skipped; ///< in the order the kinds were met

    friend bool operator==(const ObjReport&, const ObjReport&) = default;
};

/// Faults that a file may be full of: the report has one line for each kind.
enum class ObjFaultKind : std::uint8_t {
    position,            ///< a statement v that cannot be read
    colour,              ///< what follows its point
    texcoord,            ///< a statement vt
    normal,              ///< a statement vn
    normal_of_no_length, ///< so it has no direction
    missing_texcoord,    ///< a face names one that does not exist
    missing_normal,      ///< the same
    strange_texcoord,    ///< a face has something else in its place
    strange_normal,      ///< the same
    strange_corner,      ///< a corner names more than there is to name
};

/// Fills a report while a model and its materials are read.
class ObjReporter {
  public:
    /// Adds to this report, which must outlive it.
    explicit ObjReporter(ObjReport& report) : report_(report) {}

    /// Counts a fault, and keeps it if there is room.
    /// @param say makes the sentence; called only if it is kept
    template <class Say>
    void fault(std::string_view path, int line, Say say) {
        ++report_.counts.faults;
        if (has_room()) keep(path, line, say());
    }

    /// Counts a fault that a file may be full of: the first of each kind is kept, and the others
    /// are counted with it. Each kind counts once per line.
    /// @param path the same for all faults of a kind
    template <class Say>
    void fault(ObjFaultKind kind, std::string_view path, int line, Say say) {
        Repeated& known = repeated_[static_cast<std::size_t>(kind)];
        if (known.last_line == line) return;
        known.last_line = line;
        if (known.index < 0) {
            known.index = static_cast<int>(report_.faults.size());
            return fault(path, line, say);
        }
        ++report_.counts.faults;
        const auto index = static_cast<std::size_t>(known.index);
        if (index < report_.faults.size()) ++report_.faults[index].count;
    }

    /// Keeps a note if there is room.
    void note(std::string_view path, int line, std::string sentence);

    /// Counts a statement that has no effect. Beyond `most_skipped_kinds`, all kinds count as one.
    /// @param statement its first word
    void skip(std::string_view path, int line, std::string_view statement, std::string_view why);

    ObjReport& report() { return report_; }

  private:
    /// What is known about a kind of fault that is reported once.
    struct Repeated {
        int index = -1;    ///< of the first in the list; its end if there was no room; -1: none yet
        int last_line = 0; ///< that it was found in
    };

    bool has_room() const;
    void keep(std::string_view path, int line, std::string sentence);

    ObjReport& report_;
    std::map<std::string, std::size_t, std::less<>> kinds_; ///< the index in `skipped` by the word
    std::array<Repeated, enum_words<ObjFaultKind>.size()> repeated_;
};

/// "m.obj:7: 'f' names normal 1, but the file has 0; the normal is computed. There are 11 more like
/// it."
std::string fault_line(const ObjFault& fault);

/// " There are 11 more like it."; empty if there are none.
std::string more_like_it(const ObjFault& fault);

/// The faults as sentences with file:line; a last one counts those that were not kept.
std::vector<std::string> fault_lines(const ObjReport& report);

/// The notes as sentences with file:line.
std::vector<std::string> remark_lines(const ObjReport& report);

/// The same for what was skipped: "m.obj:3: 4 statements 's' are skipped: ..."
std::vector<std::string> skipped_lines(const ObjReport& report);

/// The first fault, and how many more there are, as one notice; empty if there is none.
std::string fault_notice(const ObjReport& report);

} // namespace rasterwalk
