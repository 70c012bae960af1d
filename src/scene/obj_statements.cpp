#include "scene/obj_statements.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "scene/obj_words.h"
#include "scene/point_colours.h"

namespace rasterwalk {

namespace {

/// Statements that have no effect here, and why.
struct UnusedStatement {
    std::string_view word, why;
};

constexpr std::string_view no_lines = "points and lines are not drawn, only faces";
constexpr std::string_view no_curves = "curves and curved surfaces are not drawn";
constexpr std::string_view no_display = "it only controls how other programs show the model";
constexpr UnusedStatement unused_statements[] = {
    {"s", "smoothing groups are not used; normals are either given or smoothed by angle"},
    {"p", no_lines},
    {"l", no_lines},
    {"vp", no_curves},
    {"cstype", no_curves},
    {"deg", no_curves},
    {"bmat", no_curves},
    {"step", no_curves},
    {"curv", no_curves},
    {"curv2", no_curves},
    {"surf", no_curves},
    {"parm", no_curves},
    {"trim", no_curves},
    {"hole", no_curves},
    {"scrv", no_curves},
    {"sp", no_curves},
    {"end", no_curves},
    {"con", no_curves},
    {"mg", no_display},
    {"bevel", no_display},
    {"c_interp", no_display},
    {"d_interp", no_display},
    {"lod", no_display},
    {"shadow_obj", no_display},
    {"trace_obj", no_display},
    {"usemap", no_display},
    {"maplib", no_display},
};
constexpr std::string_view unknown_statement = "it is not a statement of the OBJ format";
constexpr std::string_view more_than_a_place =
    "what follows the three numbers of a point is not a colour and is not used";

class StatementReader {
  public:
    StatementReader(std::string_view text, const std::string& path, WatchedSteps& watched,
                    ObjLibraries& libraries, ObjReporter& reporter)
        : lines_(text), bytes_(text.size()), path_(path), watched_(watched), libraries_(libraries),
          reporter_(reporter), name_(visible_line(std::filesystem::path(path).stem().string())) {}

    ObjStatements read() {
        while (lines_.next()) {
            std::string_view rest = lines_.text();
            const std::string_view word = take_word(rest);
            if (word == "#MRGB")
                colours_.add_polypaint(trimmed(rest));
            else if (!word.empty() && word.front() != '#')
                read_statement(word, rest);
            watched_.step([&] { return bytes_read(); });
        }
        watched_.ask(bytes_read());
        file_.lines = lines_.line_count();
        file_.line_marks = lines_.take_marks();
        file_.colours = colours_.colours(file_.positions.size());
        if (colours_.are_bytes()) {
            reporter_.note(path_, colours_.line_of_bytes(),
                           "the colours of the points are taken to run from 0 to 255.");
        }
        return std::move(file_);
    }

  private:
    ReadingState bytes_read() const {
        return {ReadingPart::bytes, static_cast<std::int64_t>(bytes_ - lines_.bytes_left()),
                static_cast<std::int64_t>(bytes_)};
    }

    template <class Say>
    void fault(Say say) {
        reporter_.fault(path_, lines_.line(), say);
    }
    template <class Say>
    void fault(ObjFaultKind kind, Say say) {
        reporter_.fault(kind, path_, lines_.line(), say);
    }
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw InputError(visible_line(path_), lines_.line(), sentence);
    }

    void read_statement(std::string_view word, std::string_view rest) {
        if (word == "v") return read_position(rest);
        if (word == "vt") return read_texcoord(rest);
        if (word == "vn") return read_normal(rest);
        if (word == "f" || word == "fo") return read_face(rest);
        if (word == "o" || word == "g") return begin_group(word, rest);
        if (word == "usemtl") return use_material(rest);
        if (word == "mtllib") return libraries_.read(trimmed(rest), lines_.line());
        const auto known =
            std::find_if(std::begin(unused_statements), std::end(unused_statements),
                         [&](const UnusedStatement& unused) { return unused.word == word; });
        reporter_.skip(path_, lines_.line(), word,
                       known != std::end(unused_statements) ? known->why : unknown_statement);
    }

    /// Reads as many numbers as there is room for.
    /// @param kind of the faults
    /// @return how many there are; nothing, and a fault, if a word is not a number or if there are
    /// fewer than `fewest`
    std::optional<int> read_numbers(ObjFaultKind kind, std::string_view what,
                                    std::string_view& rest, int fewest, std::span<double> numbers) {
        int count = 0;
        for (double& number : numbers) {
            const std::string_view word = take_number_word(rest);
            if (word.empty()) break;
            const std::optional<double> read = parse_model_number(word);
            if (!read) {
                fault(kind, [&] {
                    if (has_decimal_comma(word)) return decimal_comma_sentence(word, what);
                    return fmt::format("{} is not a valid number for '{}', which is left out.",
                                       in_quotes(word), what);
                });
                return std::nullopt;
            }
            number = *read;
            ++count;
        }
        if (count >= fewest) return count;
        fault(kind, [&] {
            return fmt::format("'{}' needs {} numbers but has {}; it is left out.", what, fewest,
                               count);
        });
        return std::nullopt;
    }

    template <class List>
    void check_room(const List& list, std::string_view many) const {
        if (list.size() >= most_model_points)
            refuse(fmt::format("the model has more than {} {}.", most_model_points, many));
    }

    // One that cannot be read keeps its number, so that the numbers of all later ones stay right.

    void read_position(std::string_view rest) {
        check_room(file_.positions, indexed_kinds[0].many);
        file_.position_lines.push_back(lines_.line());
        std::array<double, 3> place{};
        if (read_numbers(ObjFaultKind::position, "v", rest, 3, place)) {
            file_.positions.emplace_back(place[0], place[1], place[2]);
            read_colour(rest);
        } else {
            file_.positions.emplace_back(std::numeric_limits<double>::quiet_NaN());
        }
    }

    /// Reads what follows the coordinates of the last point.
    void read_colour(std::string_view rest) {
        std::array<std::string_view, 5> words;
        std::size_t count = 0;
        while (count < words.size() && !(words[count] = take_number_word(rest)).empty())
            ++count;
        if (count == 0) return;
        if (count != 3 && count != 4)
            return reporter_.skip(path_, lines_.line(), "v", more_than_a_place);
        std::array<double, 4> numbers{};
        for (std::size_t i = 0; i < count; ++i) {
            const std::optional<double> number = parse_model_number(words[i]);
            if (!number) {
                return fault(ObjFaultKind::colour, [&] {
                    return fmt::format("{} is not a valid number for a colour; the point is white.",
                                       in_quotes(words[i]));
                });
            }
            numbers[i] = *number;
        }
        colours_.add(file_.positions.size() - 1, std::span(numbers).first(count), lines_.line());
    }

    void read_texcoord(std::string_view rest) {
        check_room(file_.texcoords, indexed_kinds[1].many);
        file_.texcoord_lines.push_back(lines_.line());
        std::array<double, 2> place{};
        if (read_numbers(ObjFaultKind::texcoord, "vt", rest, 1, place)) {
            file_.texcoords.emplace_back(place[0], place[1]);
        } else {
            file_.texcoords.emplace_back(std::numeric_limits<float>::quiet_NaN());
        }
    }

    void read_normal(std::string_view rest) {
        check_room(file_.normals, indexed_kinds[2].many);
        file_.normal_lines.push_back(lines_.line());
        std::array<double, 3> direction{};
        file_.normals.emplace_back(0.0f);
        if (!read_numbers(ObjFaultKind::normal, "vn", rest, 3, direction)) return;
        const glm::dvec3 normal(direction[0], direction[1], direction[2]);
        const double length = glm::length(normal);
        if (length > 0.0) {
            file_.normals.back() = glm::vec3(normal / length);
            return;
        }
        fault(ObjFaultKind::normal_of_no_length, [] {
            return "a normal of length 0 has no direction; a computed one is used in its place.";
        });
    }

    /// Reports what is wrong with the index of a corner: a missing point for each face, but other
    /// faults, which cost no face, by kind.
    template <class Say>
    void index_fault(std::size_t kind, bool is_strange, Say say) {
        if (kind == 0) return fault(say);
        const bool is_texcoord = kind == 1;
        if (is_strange) {
            fault(is_texcoord ? ObjFaultKind::strange_texcoord : ObjFaultKind::strange_normal, say);
        } else {
            fault(is_texcoord ? ObjFaultKind::missing_texcoord : ObjFaultKind::missing_normal, say);
        }
    }

    /// A part of a corner: "7", "-1", or nothing.
    /// @return the index from 0, -1 if there is none; nothing, and a fault, if it is wrong
    std::optional<int> read_index(std::string_view word, std::size_t kind, std::size_t count) {
        if (word.empty()) return -1;
        std::int64_t number = 0;
        const std::from_chars_result read =
            std::from_chars(word.data(), word.data() + word.size(), number);
        const bool is_number = read.ptr == word.data() + word.size();
        const bool is_in_range = read.ec == std::errc{};
        if (!is_number || read.ec == std::errc::invalid_argument) {
            index_fault(kind, true, [&] {
                return fmt::format("{} is not the number of a {}; {}", in_quotes(word),
                                   indexed_kinds[kind].one, indexed_kinds[kind].outcome);
            });
            return std::nullopt;
        }
        const auto known = static_cast<std::int64_t>(count);
        if (is_in_range && number > 0 && number <= static_cast<std::int64_t>(most_model_points))
            return static_cast<int>(number - 1);
        if (is_in_range && number < 0 && -known <= number) return static_cast<int>(known + number);
        index_fault(kind, false, [&] {
            if (is_in_range && number == 0) {
                return fmt::format("{} are counted from 1, but 'f' names 0; {}",
                                   indexed_kinds[kind].many, indexed_kinds[kind].outcome);
            }
            return fmt::format("'f' names {} {}, but the file has {} so far; {}",
                               indexed_kinds[kind].one, word.substr(0, 24), count,
                               indexed_kinds[kind].outcome);
        });
        return std::nullopt;
    }

    /// A corner: a, a/b, a//c or a/b/c. Without a point there is no corner; anything else that is
    /// wrong is reported and left out of it.
    bool read_corner(std::string_view word) {
        const std::array counts_before{file_.positions.size(), file_.texcoords.size(),
                                       file_.normals.size()};
        std::array<int, 3> indices{-1, -1, -1};
        std::string_view rest = word;
        for (std::size_t kind = 0; kind < indices.size(); ++kind) {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const std::optional<int> index =
                read_index(rest.substr(0, slash), kind, counts_before[kind]);
            if (kind == 0 && !index) return false;
            indices[kind] = index.value_or(-1);
            rest.remove_prefix(std::min(slash + 1, rest.size()));
        }
        if (indices[0] < 0) {
            fault([&] {
                return fmt::format("{} is not a corner (a, a/b, a//c or a/b/c); {}",
                                   in_quotes(word), face_left_out);
            });
            return false;
        }
        if (!rest.empty()) {
            fault(ObjFaultKind::strange_corner, [&] {
                return fmt::format("{} is not a corner (a, a/b, a//c or a/b/c); what follows its "
                                   "third part is not used.",
                                   in_quotes(word));
            });
        }
        file_.corners.push_back({indices[0], indices[1], indices[2]});
        return true;
    }

    void read_face(std::string_view rest) {
        const std::size_t first = file_.corners.size();
        bool is_sound = true;
        for (std::string_view word = take_number_word(rest); is_sound && !word.empty();
             word = take_number_word(rest)) {
            is_sound = read_corner(word);
            if (file_.triangles + static_cast<std::int64_t>(file_.corners.size() - first) - 2 >
                max_triangles)
                refuse(fmt::format("the model has more than {} triangles.", max_triangles));
        }
        const std::size_t count = file_.corners.size() - first;
        if (is_sound && count < 3) {
            is_sound = false;
            fault([&] {
                return fmt::format("'f' has {} {}, but a face has at least three; {}", count,
                                   count == 1 ? "corner" : "corners", face_left_out);
            });
        }
        if (!is_sound) {
            file_.corners.resize(first);
            return;
        }
        file_.triangles += static_cast<std::int64_t>(count) - 2;
        if (is_part_over_) begin_part();
        file_.faces.push_back({lines_.line(), static_cast<int>(first), static_cast<int>(count),
                               static_cast<int>(file_.parts.size()) - 1});
    }

    void begin_group(std::string_view word, std::string_view rest) {
        const std::string_view name = trimmed(rest);
        constexpr std::size_t longest_name = 200;
        name_ = name.empty() ? std::string(word == "g" ? "default" : "object")
                             : visible_line(name.substr(0, longest_name));
        is_part_over_ = true;
    }

    void use_material(std::string_view rest) {
        // Each part keeps a copy: a name of megabytes would fill the memory.
        material_ = trimmed(rest).substr(0, longest_material_name);
        material_line_ = lines_.line();
        is_part_over_ = true;
    }

    void begin_part() {
        is_part_over_ = false;
        if (!file_.parts.empty() && file_.parts.back().name == name_ &&
            file_.parts.back().material == material_)
            return;
        if (file_.parts.size() < most_model_parts) {
            file_.parts.push_back({name_, material_, material_line_});
            return;
        }
        if (std::exchange(has_too_many_parts_, true)) return;
        fault([] {
            return fmt::format("the model has more than {} parts; the faces from here on belong to "
                               "the last one.",
                               most_model_parts);
        });
    }

    ObjLines lines_;
    std::size_t bytes_; ///< of the whole text
    const std::string& path_;
    WatchedSteps& watched_;
    ObjLibraries& libraries_;
    ObjReporter& reporter_;
    ObjStatements file_;
    PointColours colours_;

    std::string name_, material_; ///< of the faces to come
    int material_line_ = 0;
    bool is_part_over_ = true;
    bool has_too_many_parts_ = false;
};

} // namespace

ObjStatements read_statements(std::string_view text, const std::string& path, WatchedSteps& watched,
                              ObjLibraries& libraries, ObjReporter& reporter) {
    return StatementReader(text, path, watched, libraries, reporter).read();
}

} // namespace rasterwalk
