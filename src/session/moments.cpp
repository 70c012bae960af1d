#include "session/moments.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/error.h"
#include "base/quoted.h"
#include "inspect/clip_history.h"
#include "pipeline/shadow_pass.h"
#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

/// "the samples s0 to s103", or "only the sample s0". The letter is the first of the word.
std::string pieces(const std::string& word, int first, int last) {
    const auto numbered = [&word](int number) {
        return word.substr(0, 1).append(std::to_string(number));
    };
    if (first == last) return "only the " + word + " " + numbered(first);
    return "the " + word + "s " + numbered(first) + " to " + numbered(last);
}

std::string stage_name(const Frame& frame) {
    return std::string(stage_info(frame.settings).name);
}

std::string edge_sentence(const Frame& frame, const Cursor& cursor, const std::string& triangle) {
    if (frame.settings.stage < Stage::edges) {
        return "in the " + stage_name(frame) + " stage a triangle has no edges";
    }
    if (frame.settings.stage >= Stage::rows && !walks_edges(frame.stages)) {
        return "coverage=" + std::string(word_of(frame.settings.coverage)) +
               " walks no edges in the " + stage_name(frame) + " stage";
    }
    const Timeline timeline(frame);
    const PhaseMoments& edges = timeline.moments(cursor.triangle).of(Phase::edges);
    const int count = static_cast<int>(edges.pieces.size());
    if (cursor.index >= count) return "a triangle has edges e0 to e" + std::to_string(count - 1);
    const int samples = edges.pieces[cursor.index].count;
    return "edge e" + std::to_string(cursor.index) + " of " + triangle + " has " +
           pieces("sample", 0, samples - 1);
}

std::string test_sentence(const Frame& frame, const Cursor& cursor, const std::string& triangle) {
    if (frame.settings.stage < Stage::rows)
        return "in the " + stage_name(frame) + " stage no pixel is tested";
    if (!tests_pixels(frame.stages)) return "only coverage=edge_functions tests pixels";
    const Timeline timeline(frame);
    const PhaseMoments& tests = timeline.moments(cursor.triangle).of(Phase::tests);
    return triangle + " has " + pieces("box row", 0, static_cast<int>(tests.pieces.size()) - 1);
}

std::string row_sentence(const Frame& frame, const Cursor& cursor, const std::string& triangle) {
    if (frame.settings.stage < Stage::rows) {
        return "in the " + stage_name(frame) + " stage a triangle has no rows";
    }
    const Timeline timeline(frame);
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    return triangle + " has " + pieces("row", 0, moments.rows.size() - 1);
}

std::string clip_sentence(const Frame& frame, const Cursor& cursor, const std::string& triangle) {
    if (!frame.has_clip_events(cursor.triangle)) return "no plane cuts " + triangle;
    const Timeline timeline(frame);
    const PhaseMoments& planes = timeline.moments(cursor.triangle).of(Phase::clip);
    const auto plane = static_cast<std::size_t>(cursor.index);
    if (plane < planes.pieces.size() && planes.pieces[plane].count > 0) {
        return "the " + plane_name(cursor.index) + " p" + std::to_string(cursor.index) + " has " +
               pieces("step", 0, planes.pieces[plane].count - 1) + " for " + triangle;
    }
    std::string those;
    for (std::size_t p = 0; p < planes.pieces.size(); ++p) {
        if (planes.pieces[p].count == 0) continue;
        those.append(those.empty() ? "p" : ", p").append(std::to_string(p));
    }
    if (those.empty()) return "no plane cuts " + triangle;
    return triangle + " is cut by planes " + those;
}

std::string cull_sentence(const Frame& frame, const Cursor& cursor, const std::string& triangle) {
    if (frame.is_cull_tested(cursor.triangle)) return "culling is a single moment";
    return frame.rejection(cursor.triangle) == Rejection::clipped_away
               ? "clipping leaves nothing of " + triangle
               : "no triangle is culled";
}

std::string resolve_sentence(const Frame& frame) {
    if (!frame.has_samples()) return "pixels have one sample each, and are not resolved";
    const Viewport& picture = frame.settings.viewport;
    return fmt::format("the picture has the rows s0 to s{}, with the columns c0 to c{}",
                       picture.height - 1, picture.width - 1);
}

/// What would be possible in place of a cursor that does not exist.
std::string possible(const Frame& frame, const Cursor& cursor) {
    if (cursor.pass < 0)
        return "the picture is drawn in a single pass; only shadows=map has passes before it";
    if (frame.squares != nullptr)
        return fmt::format("the picture has the squares w0 to w{}, and ",
                           std::max(frame.squares->count() - 1, 0)) +
               "triangles have no moments of their own";
    if (cursor.square >= 0) return "the picture is not divided into squares";
    if (is_resolve(cursor)) return resolve_sentence(frame);
    if (cursor.triangle >= frame.triangle_count()) {
        return "the scene has " + pieces("triangle", 0, frame.triangle_count() - 1);
    }
    const std::string triangle = "triangle t" + std::to_string(cursor.triangle);
    const bool ends_early = cursor.phase > Phase::cull && !frame.is_drawn(cursor.triangle);
    if (ends_early || !frame.has_moments(cursor.triangle)) {
        return triangle +
               " is left out: " + std::string(words(frame.rejection(cursor.triangle)).sentence);
    }
    switch (cursor.phase) {
    case Phase::vertices:
        return "a triangle has vertices v0 to v" + std::to_string(triangle_corners - 1);
    case Phase::clip:
        return clip_sentence(frame, cursor, triangle);
    case Phase::cull:
        return cull_sentence(frame, cursor, triangle);
    case Phase::edges:
        return edge_sentence(frame, cursor, triangle);
    case Phase::tests:
        return test_sentence(frame, cursor, triangle);
    case Phase::rows:
        return row_sentence(frame, cursor, triangle);
    case Phase::resolve:
        break;
    }
    return {};
}

/// Does the cursor name a row of a row table, or of a box?
bool is_row(const Timeline& timeline, const Cursor& cursor) {
    const Frame& frame = timeline.frame();
    if (cursor.square >= 0 || cursor.phase < Phase::tests || frame.settings.stage < Stage::rows ||
        cursor.triangle >= frame.triangle_count() || !frame.is_drawn(cursor.triangle))
        return false;
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    const auto index = static_cast<std::size_t>(cursor.index);
    return index < moments.of(cursor.phase).pieces.size();
}

[[noreturn]] void refuse(const Frame& frame, const Cursor& cursor, const std::string& text) {
    throw UsageError("there is no moment " + text + ": " + possible(frame, cursor) + ".");
}

/// @param given with its pass
/// @param text the moment as written
Cursor find_moment(const Frame& frame, const Cursor& given, const std::string& text) {
    if (given == cursor_end) return given;
    if (given.pass != frame.pass) refuse(frame, given, text);
    const Cursor cursor = in_frame(given, frame.pass);
    const auto found = [&](const Cursor& moment) { return in_pass(moment, frame.pass); };
    const Timeline timeline(frame);
    // The fragments in a square are no moments: they stand for it.
    const bool is_in_square =
        frame.squares != nullptr && cursor.square >= 0 && cursor.square < frame.squares->count();
    if (is_in_square) return found(moment_of_square(cursor.square));
    // The text need not know how many columns a row has, or where the picture begins in it: a
    // column outside stands for the next moment.
    if (is_row(timeline, cursor)) return found(timeline.at_or_after(cursor));
    if (!timeline.exists(cursor)) refuse(frame, cursor, text);
    return given;
}

/// The frame of the pass in which a moment is to be looked for.
Frame frame_for(const Scene& scene, const Settings& settings, const Cursor& cursor) {
    return prepare_pass(scene, settings, pass_of(cursor, settings, scene.space));
}

/// "square w12".
std::string square_name(int square, const Language& language) {
    return tr(language, "square {}", to_text(moment_of_square(square)));
}

/// "column 3", or "columns 0 to 7".
std::string columns_text(int first, int end, const Language& language) {
    return end - first == 1 ? tr(language, "column {}", first)
                            : tr(language, "columns {} to {}", first, end - 1);
}

std::string rows_text(int first, int end, const Language& language) {
    return end - first == 1 ? tr(language, "row {}", first)
                            : tr(language, "rows {} to {}", first, end - 1);
}

std::string describe_square(const Frame& frame, int number, const Language& language) {
    const WarnockSquare& square = (*frame.squares)[number];
    const Rectangle& pixels = square.pixels;
    std::string text =
        fmt::format("{}: {}, {} · {}",
                    tr(language, "{} of {}", square_name(number, language), frame.squares->count()),
                    columns_text(pixels.left, pixels.right, language),
                    rows_text(pixels.top, pixels.bottom, language),
                    tr(words(square.reason).in_short, language));
    if (square.surface < 0) return text;
    return text + fmt::format(": {} ({})", triangle_name(square.surface),
                              part_name(*frame.scene, square.surface));
}

/// A fragment in a square: no moment of its own.
std::string describe_in_square(const Frame& frame, const Cursor& cursor, const Language& language) {
    const PolygonRows& rows = frame.squares->rows(cursor.triangle);
    return fmt::format(
        "{} · {} ({}) · {}, {} · {}", square_name(cursor.square, language),
        element_name_of(triangle_form, cursor.triangle, frame.triangle_count(), language),
        part_name(*frame.scene, cursor.triangle),
        tr(language, "row {}", rows.first_row + cursor.index),
        element_name_of(phase_info(cursor.phase).piece, cursor.index, rows.size(), language),
        element_name_of(phase_info(cursor.phase).step, cursor.step,
                        row_span(frame.stages, rows, cursor.index).count, language));
}

/// The name of a piece of a phase.
/// @param count number of all pieces of the phase
std::string piece_name(const Cursor& cursor, int count, const Language& language) {
    if (cursor.phase == Phase::clip) return std::string(tr(plane_name(cursor.index), language));
    return element_name_of(phase_info(cursor.phase).piece, cursor.index, count, language);
}

Cursor read_moment(const std::string& text) {
    const std::optional<Cursor> cursor = parse_cursor(text);
    if (cursor) return *cursor;
    throw UsageError(in_quotes(text) +
                     " is not a moment; moments are written t12, t12/v1, t12/p2/s1, t12/k, "
                     "t12/e2/s14, t12/b4/c7, t12/r37/c5, s37/c5, w12, p1:t12 or end.");
}

std::string describe_in_frame(const Frame& frame, const Cursor& cursor, const Language& language) {
    if (is_square(cursor)) return describe_square(frame, cursor.square, language);
    if (cursor.square >= 0) return describe_in_square(frame, cursor, language);
    if (is_resolve(cursor))
        return tr(language, "all triangles are drawn · samples become pixels · row {}, column {}",
                  cursor.index, cursor.step);
    const Timeline timeline(frame);
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    const PhaseInfo& phase = phase_info(cursor.phase);
    const PhaseMoments& of_phase = moments.of(cursor.phase);
    const bool is_row = cursor.phase == Phase::rows, is_test = cursor.phase == Phase::tests;
    const TestedRow box_row = is_test ? tested_row(moments.rows.tested, cursor.index) : TestedRow();
    const int row = is_test ? box_row.row : moments.rows.first_row + cursor.index;
    std::string text = fmt::format(
        "{} ({}) · {}{}",
        element_name_of(triangle_form, cursor.triangle, frame.triangle_count(), language),
        part_words(*frame.scene, cursor.triangle),
        is_row || is_test ? tr(language, "row {}", row) + ", " : "",
        piece_name(cursor, static_cast<int>(of_phase.pieces.size()), language));
    if (phase.step.empty()) return text;
    if (is_row && !has_fragments(frame.settings.stage))
        return tr(language, "{}: its two ends", text);
    // The whole row, although only the part in the picture has moments; of the box, only the part
    // that is tested.
    const int steps = is_row    ? row_span(frame.stages, moments.rows, cursor.index).count
                      : is_test ? box_row.right - box_row.left
                                : of_phase.pieces[cursor.index].count;
    return text + " · " + element_name_of(phase.step, cursor.step, steps, language);
}

/// Does the frame have this work, or only another run? A fragment in a square has no moment.
bool is_in_frame(const Frame& frame, Cursor cursor) {
    cursor.pass = 0;
    if (frame.squares == nullptr) return cursor != cursor_end && Timeline(frame).exists(cursor);
    return cursor.square >= 0 && cursor.square < frame.squares->count();
}

} // namespace

Cursor moment_of(const Frame& frame, const std::string& text) {
    return find_moment(frame, read_moment(text), text);
}

Cursor moment_of(const Frame& frame, const Cursor& cursor) {
    return find_moment(frame, cursor, to_text(cursor));
}

Cursor moment_of(const Scene& scene, const Settings& settings, const std::string& text) {
    const Cursor cursor = read_moment(text);
    return find_moment(frame_for(scene, settings, cursor), cursor, text);
}

Cursor moment_of(const Scene& scene, const Settings& settings, const Cursor& cursor) {
    return moment_of(frame_for(scene, settings, cursor), cursor);
}

Cursor existing_moment(const Scene& scene, const Settings& settings, const Cursor& cursor) {
    const Frame frame = frame_for(scene, settings, cursor);
    return in_pass(Timeline(frame).at_or_after(in_frame(cursor, frame.pass)), frame.pass);
}

std::string describe_moment(const Frame& frame, const Cursor& cursor, const Language& language) {
    if (!is_in_frame(frame, cursor)) return moment_name(cursor, language);
    const std::string text = describe_in_frame(frame, cursor, language);
    return frame.pass < 0 ? pass_name(frame.pass, language) + " · " + text : text;
}

std::string describe_square_in_short(const Frame& frame, int square, const Language& language) {
    const WarnockSquare& of = (*frame.squares)[square];
    const std::string text = fmt::format("{} · {}", square_name(square, language),
                                         tr(words(of.reason).in_short, language));
    return of.surface < 0 ? text : text + ": " + triangle_name(of.surface);
}

std::string moment_name(const Cursor& cursor, const Language& language) {
    if (cursor == cursor_end) return std::string(tr("end of the frame", language));
    if (is_square(cursor)) return square_name(cursor.square, language);
    const PhaseInfo& phase = phase_info(cursor.phase);
    const std::string piece = cursor.phase == Phase::clip
                                  ? std::string(tr(plane_name(cursor.index), language))
                                  : element_name(phase.piece, cursor.index, language);
    const std::string step =
        phase.step.empty() ? "" : ", " + element_name(phase.step, cursor.step, language);
    if (is_resolve(cursor)) return tr(language, "samples of {}", piece + step);
    const std::string square =
        cursor.square >= 0 ? square_name(cursor.square, language) + ", " : "";
    return square + triangle_name(cursor.triangle) + ", " + piece + step;
}

} // namespace rasterwalk
