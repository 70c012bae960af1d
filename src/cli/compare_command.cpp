#include "cli/compare_command.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <string_view>

#include <fmt/format.h>

#include "base/numbers.h"
#include "cli/json.h"
#include "compare/compare.h"
#include "engines/engine_picture.h"
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
};

RunTexts run_texts(const Settings& a, const Settings& b) {
    RunTexts texts;
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

void print_comparison(const Frame& frame, const RunTexts& runs, const Comparison& comparison,
                      std::ostream& out) {
    const DivergenceList& list = comparison.divergences;
    const auto &first = list.first, &larger = list.first_beyond_rounding;
    Json groups = Json::array();
    for (const DivergenceGroup& group : list.groups)
        groups.push_back(to_json(frame, group));
    Json object{{"a", texts_to_json(runs.a)}, {"b", texts_to_json(runs.b)}};
    if (first) object["cause"] = first->text;
    if (larger) object["cause_beyond_rounding"] = larger->text;
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
        << "different_pixels    " << pixels.different << " of " << pixels.pixels << '\n'
        << "shown_pixels        " << pixels.shown << '\n'
        << "largest_difference  " << significant(static_cast<double>(pixels.largest), 6) << '\n'
        << "mean_difference     " << significant(pixels.mean, 6) << '\n'
        << "different_rows      " << comparison.different_rows << '\n'
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
    const RunTexts runs = run_texts(a.settings, b.settings);
    if (options.json) {
        print_comparison(a, runs, comparison, out);
    } else {
        print_text(a, runs, comparison, out);
    }
    return comparison.is_same() ? ExitCode::done : ExitCode::difference;
}

} // namespace rasterwalk
