#include "cli/diagnose_command.h"

#include <chrono>
#include <ostream>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "base/numbers.h"
#include "cli/json.h"
#include "cli/points.h"
#include "laboratory/diagnose.h"

namespace rasterwalk {

namespace {

/// A result that was compared with the reference.
struct Finding {
    Diagnosis diagnosis;
    std::string kind; ///< "picture" or "rows"
    std::string compared_with;
};

std::string size_text(int width, int height) {
    return fmt::format("{} x {}", width, height);
}

/// What is diagnosed: a file, or the standard input.
struct Result {
    std::string name; ///< for messages
    std::string bytes;
};

Finding diagnose_picture_file(const Result& result, const Session& session,
                              const std::vector<Bug>& bugs, double seconds, std::ostream& err,
                              ProgressLine& progress) {
    Image picture = parse_exact_image(result.bytes, result.name);
    const Settings& view = session.a.settings;
    const Settings reference = fitted_to(view, picture, session.scene->space);
    if (!(reference.viewport == view.viewport)) {
        err << "rasterwalk: the picture has " << size_text(picture.width, picture.height)
            << " pixels; the reference is drawn at that size";
        if (session.scene->space == SceneSpace::world)
            err << ", with a focal length of " << reference.camera.focal_length;
        err << ".\n";
    }
    DiagnosisWork work(std::move(picture), result.name, *session.scene, reference, bugs);
    const auto begin = std::chrono::steady_clock::now();
    while (!work.is_done()) {
        work.advance(frame_limit);
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        if (passed.count() > seconds) work.stop_searching();
        const PicturesDrawn drawn = work.pictures();
        if (drawn.all == 0) continue;
        progress.say(fmt::format("{}: {} of {} pictures",
                                 passed.count() > seconds ? "Looking at what was found"
                                                          : "Trying each mistake",
                                 drawn.done, drawn.all));
    }
    progress.clear();
    return {work.found(), "picture", "the picture of " + session.scene->name};
}

Finding diagnose_rows_file(const DiagnoseOptions& options, const Result& result,
                           const Session& session, const std::vector<Bug>& bugs) {
    std::vector<glm::ivec2> polygon;
    for (const std::string& text : options.polygon) {
        const ScreenVertex point = parse_point(text);
        polygon.emplace_back(point.column, point.row);
    }
    const std::vector<PrintedRow> rows = parse_printed_rows(result.bytes, result.name);
    Finding finding;
    finding.kind = "rows";
    finding.diagnosis = diagnose_rows(rows, polygon, *session.scene, session.a.settings, bugs,
                                      finding.compared_with);
    finding.compared_with.insert(0, "the row table of ");
    return finding;
}

/// For mistakes that come together, the possible names of each.
Json mistakes_to_json(const Candidate& candidate) {
    Json mistakes = Json::array();
    for (const Suspect& suspect : candidate.mistakes)
        mistakes.push_back(texts_to_json(suspect.ids));
    return mistakes;
}

Json to_json(const Finding& finding) {
    const Diagnosis& diagnosis = finding.diagnosis;
    Json candidates = Json::array();
    for (const Candidate& candidate : diagnosis.candidates) {
        std::vector<std::string> names;
        for (const Suspect& suspect : candidate.mistakes)
            names.insert(names.end(), suspect.names.begin(), suspect.names.end());
        candidates.push_back({{"different", candidate.different},
                              {"distance", candidate.distance},
                              {"explained", candidate.explained},
                              {"ids", texts_to_json(candidate.ids())},
                              {"likely", candidate.is_likely},
                              {"mistakes", mistakes_to_json(candidate)},
                              {"names", texts_to_json(names)},
                              {"remark", candidate.remark}});
    }
    return {{"candidates", std::move(candidates)},
            {"complete", diagnosis.is_complete},
            {"different", diagnosis.different},
            {"distance", diagnosis.distance},
            {"findings", texts_to_json(diagnosis.findings)},
            {"held_against", finding.compared_with},
            {"kind", finding.kind},
            {"place", diagnosis.place},
            {"rules", diagnosis.rules},
            {"verdict", diagnosis.verdict}};
}

void print_text(const Finding& finding, std::ostream& out) {
    const Diagnosis& diagnosis = finding.diagnosis;
    const bool is_picture = finding.kind == "picture";
    out << "Compared with " << finding.compared_with << (diagnosis.is_same() ? ": " : ".\n")
        << diagnosis.verdict << '\n';
    if (!diagnosis.rules.empty()) {
        const bool is_sure = diagnosis.is_same() || likely_candidate(diagnosis) != nullptr;
        out << (is_sure ? "Your program draws with " : "The nearest correct picture is drawn with ")
            << diagnosis.rules
            << (is_sure ? ", which is just as correct; the reference does the same.\n" : ".\n");
    }
    if (!diagnosis.is_same()) {
        out << counted(diagnosis.different, is_picture ? "pixel differs" : "row differs",
                       is_picture ? "pixels differ" : "rows differ")
            << (is_picture ? " from the correct picture." : " from the reference.");
        if (!diagnosis.place.empty()) out << ' ' << diagnosis.place;
        out << '\n';
    }
    for (const std::string& sentence : diagnosis.findings)
        out << sentence << '\n';
    if (!diagnosis.is_complete)
        out << "The search was stopped before everything had been tried; see --seconds.\n";
    if (diagnosis.candidates.empty()) return;
    out << "\nexplains  still differ  mistake\n";
    for (const Candidate& candidate : diagnosis.candidates) {
        out << fmt::format("{:>8}  {:>12}  ", explained_text(candidate.explained, 1),
                           candidate.different);
        for (std::size_t i = 0; i < candidate.mistakes.size(); ++i) {
            const Suspect& suspect = candidate.mistakes[i];
            if (i > 0) out << ", together with ";
            for (std::size_t k = 0; k < suspect.ids.size(); ++k)
                out << (k > 0 ? " or " : "") << suspect.ids[k] << ": " << suspect.names[k];
        }
        if (!candidate.remark.empty()) out << ", " << candidate.remark;
        out << '\n';
    }
}

} // namespace

ExitCode diagnose_command(const DiagnoseOptions& options, std::ostream& out, std::ostream& err,
                          ProgressLine& progress) {
    if (!(options.seconds > 0.0)) throw UsageError("--seconds takes a number greater than 0.");
    const Session session = open_view(options.view);
    const std::vector<Bug> bugs = read_bugs();
    const Result result{options.file == "-" ? standard_input_name : options.file,
                        read_input(options.file, largest_image_file)};
    const Finding finding =
        is_image(result.bytes)
            ? diagnose_picture_file(result, session, bugs, options.seconds, err, progress)
            : diagnose_rows_file(options, result, session, bugs);
    if (options.json) {
        print_json(to_json(finding), out);
    } else {
        print_text(finding, out);
    }
    return finding.diagnosis.is_same() ? ExitCode::done : ExitCode::difference;
}

} // namespace rasterwalk
