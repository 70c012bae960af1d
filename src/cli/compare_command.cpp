#include "cli/compare_command.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "cli/json.h"
#include "compare/compare.h"
#include "engines/engine_planes.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/shadow_pass.h"
#include "session/second_run.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

Settings settings_of_run(const Settings& common, const std::vector<std::string>& assignments) {
    Settings settings = common;
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

std::string_view kind_name(DivergenceKind kind) {
    constexpr std::array<std::string_view, 3> names{"missing", "extra", "other"};
    return names[static_cast<std::size_t>(kind)];
}

/// The settings in which the runs differ, as assignments: "interpolation=affine".
struct RunTexts {
    std::vector<std::string> a, b;
    /// Why the steps draw a run that asks for another engine: lines.
    std::vector<std::string> refusals;
};

RunTexts run_texts(const Frame& in_a, const Frame& in_b) {
    const Settings &a = in_a.settings, &b = in_b.settings;
    RunTexts texts;
    for (const auto& [name, frame] : {std::pair{"A", &in_a}, {"B", &in_b}}) {
        const std::string refusal = engine_refuses(*frame->scene, frame->settings);
        if (!refusal.empty())
            texts.refusals.push_back(fmt::format("{}: {}, so the steps draw", name, refusal));
    }
    for (const RunDifference& difference : run_differences(a, b)) {
        texts.a.push_back(fmt::format("{}={}", difference.setting, difference.a));
        texts.b.push_back(fmt::format("{}={}", difference.setting, difference.b));
    }
    return texts;
}

Json to_json(const Frame& frame, const DivergenceGroup& group) {
    return {{"count", group.count},
            {"first", moment_text(frame, group.first)},
            {"kind", kind_name(group.kind)},
            {"last", moment_text(frame, group.last)},
            {"name", part_name(*frame.scene, group.triangle)},
            {"phase", phase_info(group.phase).word},
            {"triangle", group.triangle}};
}

/// Why only the pictures were compared, and why they differ.
void add_reasons(const Comparison& comparison, Json& object) {
    Json reasons = Json::object();
    for (const PixelReasonWords& words : pixel_reason_list())
        reasons[std::string(words.name)] = comparison.reasons.count(words.reason);
    object["only_pictures"] = comparison.only_pictures;
    object["reasons"] = std::move(reasons);
    const std::optional<DifferentPixel>& first = comparison.reasons.first();
    if (!first) return;
    object["cause"] = first->text;
    object["first_pixel"] = {first->place.x, first->place.y};
}

/// The same as text.
void print_reasons(const Comparison& comparison, std::ostream& out) {
    out << comparison.only_pictures << '\n';
    for (const PixelReasonWords& words : pixel_reason_list()) {
        const std::int64_t count = comparison.reasons.count(words.reason);
        if (count > 0) out << fmt::format("{:<20}{}\n", words.title, count);
    }
    const std::optional<DifferentPixel>& first = comparison.reasons.first();
    if (!first) return;
    out << fmt::format("first_pixel         {},{}\n    {}\n", first->place.x, first->place.y,
                       first->text);
}

void print_comparison(const Frame& frame, const RunTexts& runs, const Comparison& comparison,
                      std::ostream& out) {
    const DivergenceList& list = comparison.divergences;
    const auto &first = list.first, &larger = list.first_beyond_rounding;
    Json groups = Json::array();
    for (const DivergenceGroup& group : list.groups)
        groups.push_back(to_json(frame, group));
    Json object{{"a", texts_to_json(runs.a)}, {"b", texts_to_json(runs.b)}};
    if (first) object["cause"] = first->text;
    if (!comparison.only_pictures.empty()) add_reasons(comparison, object);
    if (larger) object["cause_beyond_rounding"] = larger->text;
    if (!runs.refusals.empty()) object["refusals"] = texts_to_json(runs.refusals);
    object["different_pixels"] = comparison.pixels.different;
    object["different_rows"] = comparison.different_rows;
    object["divergence_count"] = list.count;
    object["divergences"] = std::move(groups);
    if (larger) object["first_beyond_rounding"] = moment_text(frame, larger->cursor);
    if (first) object["first_divergence"] = moment_text(frame, first->cursor);
    object["largest_difference"] = comparison.pixels.largest;
    object["mean_difference"] = comparison.pixels.mean;
    object["pixels"] = comparison.pixels.pixels;
    object["shown_pixels"] = comparison.pixels.shown;
    // Missing ones come last, as null.
    for (const char* const key :
         {"first_divergence", "cause", "first_beyond_rounding", "cause_beyond_rounding"}) {
        object.emplace(key, nullptr);
    }
    print_json(object, out);
}

std::string joined(const std::vector<std::string>& texts) {
    return texts.empty() ? "as B" : fmt::format("{}", fmt::join(texts, "  "));
}

/// More groups than this are left to --json.
constexpr std::size_t most_groups_printed = 20;

void print_text(const Frame& frame, const RunTexts& runs, const Comparison& comparison,
                std::ostream& out) {
    const PixelDifference& pixels = comparison.pixels;
    const DivergenceList& list = comparison.divergences;
    out << "A: " << joined(runs.a) << "\nB: " << (runs.b.empty() ? "as A" : joined(runs.b)) << '\n'
        << fmt::format("{}{}", fmt::join(runs.refusals, "\n"), runs.refusals.empty() ? "" : "\n")
        << "different_pixels    " << pixels.different << " of " << pixels.pixels << '\n'
        << "shown_pixels        " << pixels.shown << '\n'
        << "largest_difference  " << significant(static_cast<double>(pixels.largest), 6) << '\n'
        << "mean_difference     " << significant(pixels.mean, 6) << '\n';
    if (!comparison.only_pictures.empty()) {
        print_reasons(comparison, out);
        return;
    }
    out << "different_rows      " << comparison.different_rows << '\n'
        << "divergences         " << list.count << '\n'
        << "first_divergence    " << (list.first ? moment_text(frame, list.first->cursor) : "none")
        << '\n';
    if (!list.first) return;
    const auto print = [&](const Divergence& divergence) {
        out << "    " << kind_text(divergence.kind) << ", "
            << part_words(*frame.scene, divergence.cursor.triangle) << ": " << divergence.text
            << '\n';
    };
    print(*list.first);
    const std::optional<Divergence>& larger = list.first_beyond_rounding;
    if (larger && larger->cursor != list.first->cursor) {
        out << "beyond rounding     " << moment_text(frame, larger->cursor) << '\n';
        print(*larger);
    }
    out << '\n';
    for (std::size_t i = 0; i < std::min(list.groups.size(), most_groups_printed); ++i) {
        const DivergenceGroup& group = list.groups[i];
        out << fmt::format("t{:<4} {:<9} {:<13} {:>9}  first {}\n", group.triangle,
                           phase_info(group.phase).word, kind_text(group.kind), group.count,
                           moment_text(frame, group.first));
    }
    if (list.groups.size() > most_groups_printed) {
        out << "... and " << list.groups.size() - most_groups_printed
            << " more; --json has all of them.\n";
    }
}

/// Draws both frames up to the moment, and writes B minus A.
void write_difference(const Frame& a, const Frame& b, const Cursor& to, float largest,
                      const std::string& path) {
    const auto drawn = [&](const Frame& frame) {
        Framebuffer framebuffer;
        draw_by_engine(frame, to, framebuffer);
        return framebuffer;
    };
    const Viewport size = a.settings.viewport;
    const std::vector<float> values = signed_difference(drawn(a), drawn(b), View::colour);
    write_png(difference_image(values, size, difference_limit(largest)), path);
}

} // namespace

ExitCode compare_command(const CompareOptions& options, std::ostream& out) {
    const Session session = open_view(options.view);
    const Run& run_b = session.b ? *session.b : session.a;
    const auto frame_of = [&](const Settings& settings, const std::vector<std::string>& texts) {
        const Settings run = settings_of_run(settings, texts);
        return prepare_pass(*session.scene, run,
                            pass_of(session.cursor, run, session.scene->space));
    };
    const Frame a = frame_of(session.a.settings, options.a);
    const Frame b = frame_of(run_b.settings, options.b);
    if (a.pass != b.pass)
        throw UsageError("only one of the two runs has a shadow map, so its pass cannot be "
                         "compared.");
    if (!(a.settings.viewport == b.settings.viewport)) {
        throw UsageError("the two runs have pictures of different sizes, which cannot be "
                         "compared.");
    }
    const Cursor to = in_frame(session.cursor, a.pass);
    const Comparison comparison = compare_runs(a, b, to);
    if (!options.output.empty()) {
        write_difference(a, b, to, comparison.pixels.largest, options.output);
    }
    const RunTexts runs = run_texts(a, b);
    if (options.json) {
        print_comparison(a, runs, comparison, out);
    } else {
        print_text(a, runs, comparison, out);
    }
    return comparison.is_same() ? ExitCode::done : ExitCode::difference;
}

} // namespace rasterwalk
