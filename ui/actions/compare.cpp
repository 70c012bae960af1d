#include "ui/actions/compare.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "engines/program_drawing.h"
#include "laboratory/quiz.h"
#include "session/walk.h"
#include "settings/setting_table.h"
#include "settings/value_words.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Seconds from one showing of A to the next.
constexpr float blink_period = 1.0f;

const ComparePair& pair_for(const StripStep& step) {
    const std::span<const ComparePair> pairs = compare_pairs();
    const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const ComparePair& pair) {
        return pair.first_step <= step && step <= pair.last_step;
    });
    return found == pairs.end() ? pairs.front() : *found;
}

/// The pixel of a fragment, if the moment is one in that frame.
std::optional<glm::ivec2> pixel_of(const Frame& frame, const Cursor& cursor) {
    if (cursor.phase != Phase::rows || !has_fragments(frame.settings.stage)) return std::nullopt;
    const Timeline timeline(frame);
    if (!timeline.exists(cursor)) return std::nullopt;
    const PolygonRows& rows = timeline.moments(cursor.triangle).rows;
    return glm::ivec2(rows.left[cursor.index].column + cursor.step, rows.first_row + cursor.index);
}

/// The next divergence after a moment; of a student's program only one is known.
std::optional<Cursor> divergence_from(const Results& results, const Cursor& from) {
    if (results.b->is_of_program()) {
        const std::optional<Divergence>& only = results.comparison.whole().divergences.first;
        // Nothing comes after the end, where the program may go on.
        const bool is_ahead = only && only->cursor >= from && from != cursor_end;
        return is_ahead ? std::optional(only->cursor) : std::nullopt;
    }
    const auto found = next_divergence(results.a.frame, results.b->frame, from);
    return found ? std::optional(found->cursor) : std::nullopt;
}

/// The last one before it.
std::optional<Cursor> divergence_before(const Results& results, const Cursor& to) {
    if (results.b->is_of_program()) {
        const std::optional<Divergence>& only = results.comparison.whole().divergences.first;
        return only && only->cursor < to ? std::optional(only->cursor) : std::nullopt;
    }
    const auto found = previous_divergence(results.a.frame, results.b->frame, to);
    return found ? std::optional(found->cursor) : std::nullopt;
}

/// Run A alone in a small window would look as if nothing were being compared.
void show_both(Ui& ui) {
    CompareView& view = ui.session.compare_view;
    if (view == CompareView::run_a && !ui.compare.has_small) view = CompareView::wipe;
}

} // namespace

const ComparePair* shown_pair(const Session& session) {
    // During a quiz it would give the mistake away.
    return hides_settings(session) ? nullptr : pair_of_runs(session);
}

void begin_pair(Ui& ui, const ComparePair& pair) {
    const bool is_first = !ui.session.b;
    start_pair(ui.session, pair);
    if (is_first) show_both(ui);
}

void toggle_compare(Ui& ui) {
    if (ui.session.b) {
        end_comparison(ui.session);
    } else if (ui.session.quiz) {
        compare_with(ui.session, quiz_reference(ui.session));
        show_both(ui);
    } else {
        begin_pair(ui, pair_for(step_of(ui.session.a.settings)));
        open_compare_tab(ui);
    }
}

void stand_at(Ui& ui, const Cursor& cursor) {
    go_to(ui.session, Timeline(ui.results.a.frame), cursor);
    if (cursor == cursor_end) return; // a program goes on where our picture is whole
    Selection& selection = ui.session.selection;
    selection.triangle = cursor.triangle;
    selection.pixel = std::nullopt;
    if (cursor.phase == Phase::vertices) selection.vertex = cursor.index;
    std::optional<glm::ivec2> pixel = pixel_of(ui.results.a.frame, cursor);
    if (!pixel && ui.results.b) pixel = pixel_of(ui.results.b->frame, cursor);
    if (!pixel || !ui.results.a.framebuffer->contains(pixel->x, pixel->y)) return;
    select_pixel(ui, *pixel);
}

void select_pixel(Ui& ui, glm::ivec2 pixel) {
    ui.session.selection.pixel = pixel;
    ui.session.selection.row = pixel.y;
}

void go_to_next_divergence(Ui& ui) {
    if (!ui.results.b) {
        ui.session.notice = "There is only one run. Press C to compare.";
        return;
    }
    Cursor from = ui.results.a.cursor;
    if (from != cursor_end) ++from.step;
    const std::optional<Cursor> found = divergence_from(ui.results, from);
    if (found) stand_at(ui, *found);
    ui.session.notice = found ? "" : "The runs do not differ again after this moment.";
}

void go_to_previous_divergence(Ui& ui) {
    if (!ui.results.b) {
        ui.session.notice = "There is only one run. Press C to compare.";
        return;
    }
    const std::optional<Cursor> found = divergence_before(ui.results, ui.results.a.cursor);
    if (found) stand_at(ui, *found);
    ui.session.notice = found ? "" : "The runs do not differ before this moment.";
}

bool is_comparing(const Ui& ui) {
    return ui.results.b != nullptr;
}

bool is_blinking(const Ui& ui) {
    return is_comparing(ui) && ui.session.compare_view == CompareView::blink &&
           !ui.compare.blink_is_held;
}

bool blink_shows_b(const Ui& ui) {
    return ui.compare.blink_seconds >= 0.5f * blink_period;
}

void advance_blinking(Ui& ui, float seconds) {
    float& since = ui.compare.blink_seconds;
    since = std::fmod(since + seconds, blink_period);
}

double seconds_to_blink(const Ui& ui) {
    if (!is_blinking(ui)) return std::numeric_limits<double>::infinity();
    constexpr float half = 0.5f * blink_period;
    return static_cast<double>(half - std::fmod(ui.compare.blink_seconds, half));
}

namespace {

/// The run's name where run B is a student's program; empty where it is not.
std::string program_words(const Session& session, bool of_b) {
    if (!session.b || session.b->program == nullptr) return {};
    return of_b ? session.b->program->name : "ours, by its rules";
}

} // namespace

std::string run_words(const Session& session, bool of_b) {
    if (hides_settings(session)) return of_b ? "the correct run" : "with a mistake";
    if (const std::string words = program_words(session, of_b); !words.empty()) return words;
    constexpr std::size_t most_named = 2;
    const std::vector<RunDifference> differences = run_differences(session);
    if (differences.empty()) return "the same settings";
    const Settings& settings = of_b ? session.b->settings : session.a.settings;
    std::string words;
    for (std::size_t i = 0; i < std::min(differences.size(), most_named); ++i) {
        const Setting& setting = *find_setting(differences[i].setting);
        std::string title(setting.title);
        title.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(title.front())));
        words.append(i > 0 ? ", " : "").append(title).append(": ");
        words += value_words(setting, settings);
    }
    if (differences.size() > most_named)
        words += " and " + std::to_string(differences.size() - most_named) + " more";
    return words;
}

std::vector<std::string> run_forms(const Session& session, bool of_b) {
    std::vector<std::string> forms{run_words(session, of_b)};
    const std::vector<RunDifference> differences = run_differences(session);
    if (hides_settings(session) || differences.size() != 1 || session.b->program != nullptr)
        return forms;
    const Setting& setting = *find_setting(differences.front().setting);
    // A number or a mere "on" does not say what it is about.
    const std::string value = value_words(setting, of_b ? session.b->settings : session.a.settings);
    if (std::holds_alternative<ChoiceSetting>(setting.kind) && value != "on" && value != "off")
        forms.push_back(value);
    return forms;
}

std::string run_assignments(const Session& session, bool of_b) {
    if (hides_settings(session)) return run_words(session, of_b);
    std::string lines = program_words(session, of_b);
    for (const RunDifference& difference : run_differences(session)) {
        lines.append(lines.empty() ? "" : "\n").append(difference.setting).append(" = ");
        lines += of_b ? difference.b : difference.a;
    }
    return lines.empty() ? "the same settings" : lines;
}

std::string comparison_offered(const Session& session) {
    if (session.quiz) return "A: with the mistake, B: the correct run";
    const Settings& a = session.a.settings;
    return "A: the picture as it is, B: with " +
           std::string(offer_of(pair_for(step_of(a)), a).title);
}

std::string grouped(std::int64_t number) {
    std::string digits = std::to_string(number);
    for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3;
         at > (number < 0 ? 1 : 0); at -= 3)
        digits.insert(static_cast<std::size_t>(at), " ");
    return digits;
}

namespace {

/// What the steps are working on.
std::string steps_words(const Results& results) {
    const auto words = [](const char* what, int done, int of) {
        return std::string(what) + " " + grouped(done) + " of " + grouped(of) + " " +
               unit_for(grouped(of), "triangles");
    };
    const auto drawn = [&](const char* what, const RunResults& run) {
        if (run.engine == Engine::rays) {
            const Viewport size = run.frame.settings.viewport;
            const std::int64_t pixels = std::int64_t{size.width} * size.height;
            return std::string(what) + " " +
                   grouped(static_cast<std::int64_t>(run.planes.rays.pixels())) + " of " +
                   grouped(pixels) + " pixels";
        }
        const int triangles = run.frame.triangle_count();
        return words(what, std::min(run.replay.drawn().triangle, triangles), triangles);
    };
    const auto prepared = [&](const char* what, const RunResults& run) {
        const Frame& frame = run.next.frame;
        return words(what, frame.triangle_count(), static_cast<int>(frame.triangles.size()));
    };
    if (results.a.is_frame_late) return prepared("prepared", results.a);
    if (results.b && results.b->is_frame_late) return prepared("run B: prepared", *results.b);
    if (!results.a.is_drawn()) return drawn("drawn", results.a);
    if (results.b && !results.b->is_drawn()) return drawn("run B: drawn", *results.b);
    if (results.history_work) {
        return words("checked for the pixel", results.history_work->triangles_done(),
                     results.a.frame.triangle_count());
    }
    const ComparisonWork& work = results.comparison.work;
    return work.is_done() ? "" : words("compared", work.triangles_done(), work.triangles());
}

} // namespace

std::string work_words(const Results& results) {
    if (!results.a.preview.is_shown) return steps_words(results);
    if (results.hand.has_moved()) return "fast engine, while it moves";
    return "fast engine, until the steps are drawn: " + steps_words(results);
}

std::vector<std::string> difference_forms(const PixelDifference& pixels) {
    if (pixels.different == 0) return {"no pixel differs", "none differs"};
    // Visible differences come first: only those can differ in a picture from a file.
    const bool is_seen = pixels.shown > 0, is_all_seen = pixels.shown == pixels.different;
    const std::int64_t number = is_seen ? pixels.shown : pixels.different;
    const bool is_one = number == 1;
    const std::string count = grouped(number);
    const std::string look = is_all_seen || !is_seen
                                 ? (is_one ? " differs" : " differ")
                                 : (is_one ? " looks different" : " look different");
    const std::string pixels_differ = count + (is_one ? " pixel" : " pixels") + look;
    const std::string others = is_all_seen ? ""
                               : is_seen   ? " of " + grouped(pixels.different) + " that differ"
                                           : ", too little to see";
    const std::string largest =
        pixels_differ + others + " · largest " + fixed(static_cast<double>(pixels.largest), 3);
    const bool has_unseen = is_seen && !is_all_seen;
    return {largest + " · mean " + fixed(pixels.mean, 4), largest, pixels_differ, count + look,
            has_unseen ? count + " seen" : count + look};
}

} // namespace rasterwalk
