#include "cli/ladder_command.h"

#include <algorithm>
#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "base/numbers.h"
#include "cli/interrupt.h"
#include "cli/json.h"
#include "cli/machine.h"
#include "cli/whole_number.h"
#include "engines/kept_memory.h"
#include "engines/ladder/ladder.h"
#include "engines/ladder/race.h"
#include "engines/measure.h"

namespace rasterwalk {

namespace {

constexpr int most_races = 1000;

void check_rung(const std::string& name) {
    if (name.empty() || find_rung(name) != nullptr) return;
    std::vector<std::string_view> names;
    for (std::size_t place = 0; place < rung_count(); ++place)
        names.push_back(rung_at(place).name);
    throw UsageError(no_such_name("rung", name, names));
}

/// A rung as it was measured.
struct LadderRow {
    const Rung* rung;
    const RungTime* time;
    double before = 0.0; ///< median of the rung that it is compared with; 0: none
    double first = 0.0;  ///< of the lab's loop
};

std::vector<LadderRow> rows_of(const std::vector<RungTime>& times) {
    std::vector<LadderRow> rows;
    for (std::size_t place = 0; place < rung_count(); ++place) {
        const std::size_t before = rung_before(place);
        rows.push_back({&rung_at(place), &times[place],
                        before == place ? 0.0 : times[before].median, times[0].median});
    }
    return rows;
}

bool is_drawn(const LadderRow& row) {
    return row.time->from_previous.pixels > 0;
}

bool is_timed(const LadderRow& row) {
    return !row.time->milliseconds.empty();
}

/// Does it draw something else than it should?
bool draws_wrongly(const LadderRow& row) {
    if (row.rung->has_other_edges || row.rung->is_random) return false;
    // The fast engine works out centres on an edge in another way.
    const bool is_last = row.rung == &ladder().back();
    return is_last ? !do_agree(row.time->from_previous) : row.time->from_previous.different > 0;
}

std::string_view time_word(const Rung& rung) {
    return rung.threads == 1 ? "processor" : "wall";
}

Json ratio_to_json(double of, double by) {
    return of > 0.0 && by > 0.0 ? Json(of / by) : Json();
}

Json to_json(const LadderRow& row) {
    const PictureDifference& difference = row.time->from_previous;
    return {{"against", row.rung->against.empty() ? Json() : Json(row.rung->against)},
            {"differ", is_drawn(row) ? Json(difference.different) : Json()},
            {"gain", ratio_to_json(row.before, row.time->median)},
            {"gain_in_all", ratio_to_json(row.first, row.time->median)},
            {"largest", is_drawn(row) ? Json(difference.largest) : Json()},
            {"median", is_timed(row) ? Json(row.time->median) : Json()},
            {"milliseconds", row.time->milliseconds},
            {"name", row.rung->name},
            {"threads", row.rung->threads == 1 ? 1 : ladder_threads()},
            {"time", time_word(*row.rung)},
            {"title", row.rung->title}};
}

std::string ratio_text(double of, double by) {
    return of > 0.0 && by > 0.0 ? decimals(of / by, 2) : std::string();
}

std::string remark(const LadderRow& row) {
    const PictureDifference& difference = row.time->from_previous;
    if (!is_drawn(row) || row.rung == &ladder().front()) return {};
    if (difference.different == 0) return "same picture";
    if (row.rung->has_other_edges)
        return "other edges, light of the centre: " + difference_text(difference);
    if (row.rung->is_random) return "in this run: " + difference_text(difference);
    return difference_text(difference);
}

void print_rows(const std::vector<LadderRow>& rows, const std::string& only, std::ostream& out) {
    out << fmt::format("{:<24}{:>12}{:>8}{:>8}\n", "rung", "ms/picture", "gain", "in all");
    for (const LadderRow& row : rows) {
        if (!only.empty() && row.rung->name != only) continue;
        if (row.rung == &wrong_turnings().front())
            out << "wrong turnings, each against the rung that it changes\n";
        std::string line =
            fmt::format("{:<24}{:>12}{:>8}{:>8}  {}", row.rung->name,
                        is_timed(row) ? decimals(row.time->median, 3) : std::string(),
                        ratio_text(row.before, row.time->median),
                        ratio_text(row.first, row.time->median), remark(row));
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << '\n';
    }
}

ExitCode run_race(const LadderOptions& options, std::ostream& out, const Interrupt& interrupt) {
    const int runs = whole_number("--race", options.race, 1, most_races);
    if (options.view != ViewOptions{} || !options.rounds.empty() || !options.rung.empty())
        throw UsageError("--race draws a scene of its own, so of the other options only --json "
                         "can be given with it.");
    const Scene scene = race_scene();
    const Settings settings = race_settings(scene);
    const std::vector<std::int64_t> wrong =
        race_pictures(scene, settings, runs, [&] { return interrupt.was_interrupted(); });
    if (options.json) {
        print_json({{"machine", machine_to_json()},
                    {"pixels", settings.viewport.width * settings.viewport.height},
                    {"threads", ladder_threads()},
                    {"wrong", wrong}},
                   out);
    } else if (ladder_threads() == 1) {
        out << "There are no threads here, so nothing races.\n";
    } else {
        out << "Two threads, one depth buffer: wrong pixels in each run\n";
        for (const std::int64_t pixels : wrong)
            out << pixels << '\n';
    }
    return interrupt.was_interrupted() ? ExitCode::interrupted : ExitCode::done;
}

} // namespace

std::string ladder_footer() {
    std::string text = "The rungs:";
    for (const Rung& rung : ladder())
        text += fmt::format("\n  {:<24}{}", rung.name, rung.title);
    text += "\nWrong turnings:";
    for (const Rung& rung : wrong_turnings())
        text += fmt::format("\n  {:<24}{}, compared with {}", rung.name, rung.title, rung.against);
    text +=
        "\nAll of them take turns. The output gives the median time per picture (processor "
        "time with one"
        "\nthread, wall time with two), how many times as fast that is as the rung before and "
        "as the first,"
        "\nand how many pixels differ from the rung before by more than 1/255. The exit code is "
        "1 if a rung"
        "\ndraws something wrong, and 130 after Ctrl+C, which prints what has been measured.";
    return text;
}

ExitCode ladder_command(const LadderOptions& options, std::ostream& out, ProgressLine& progress) {
    check_rung(options.rung);
    const Interrupt interrupt;
    if (!options.race.empty()) return run_race(options, out, interrupt);
    const int rounds = options.rounds.empty()
                           ? usual_ladder_rounds
                           : whole_number("--rounds", options.rounds, 1, most_rounds);
    const Session session = open_view(options.view);
    keep_freed_memory();
    LadderWork work;
    work.begin(session.scene, session.a.settings, rounds);
    while (!work.is_done() && !interrupt.was_interrupted()) {
        progress.say(fmt::format("{} of {} rounds", work.rounds_done(), rounds));
        work.advance();
    }
    progress.clear();
    const std::vector<LadderRow> rows = rows_of(work.times());
    const Viewport size = session.a.settings.viewport;
    if (options.json) {
        Json list = Json::array();
        for (const LadderRow& row : rows) {
            if (options.rung.empty() || row.rung->name == options.rung)
                list.push_back(to_json(row));
        }
        print_json({{"machine", machine_to_json()},
                    {"rounds", work.rounds_done()},
                    {"rungs", std::move(list)},
                    {"scene", session.scene->name},
                    {"size", fmt::format("{}x{}", size.width, size.height)}},
                   out);
    } else {
        out << fmt::format("{}\n{}, {}x{}, {}\n", machine_text(), session.scene->name, size.width,
                           size.height, counted(work.rounds_done(), "round", "rounds"));
        print_rows(rows, options.rung, out);
        if (const Rung* const rung = find_rung(options.rung); rung != nullptr)
            out << fmt::format("{}\n{}\nsrc/engines/ladder/{}\n", rung->change, rung->why,
                               rung->file);
    }
    if (interrupt.was_interrupted()) return ExitCode::interrupted;
    return std::any_of(rows.begin(), rows.end(), draws_wrongly) ? ExitCode::difference
                                                                : ExitCode::done;
}

} // namespace rasterwalk
