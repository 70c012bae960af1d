#include "cli/diagnose_command.h"

#include <ostream>

#include <fmt/format.h>

#include "base/files.h"
#include "base/image.h"
#include "base/numbers.h"
#include "cli/json.h"
#include "cli/points.h"
#include "laboratory/diagnose.h"

namespace rasterwalk {

namespace {

/// A result that was held against the reference.
struct Finding {
    Diagnosis diagnosis;
    std::string kind; ///< "picture" or "rows"
    std::string held_against;
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
                              const std::vector<Bug>& bugs, std::ostream& err,
                              ProgressLine& progress) {
    Image picture = parse_exact_image(result.bytes, result.name);
    const Settings& view = session.a.settings;
    const Settings reference = fitted_to(view, picture, session.scene->space);
    if (!(reference.viewport == view.viewport)) {
        err << "rasterwalk: the picture has " << size_text(picture.width, picture.height)
            << " pixels; the reference is drawn in that size, with a focal length of "
            << reference.camera.focal_length << ".\n";
    }
    DiagnosisWork work(std::move(picture), result.name, *session.scene, reference, bugs);
    while (!work.is_done()) {
        work.advance(frame_limit);
        const PicturesDrawn drawn = work.pictures();
        progress.say(fmt::format("Trying each mistake: {} of {} pictures", drawn.done, drawn.all));
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
                                      finding.held_against);
    finding.held_against.insert(0, "the row table of ");
    return finding;
}

Json to_json(const Finding& finding) {
    const Diagnosis& diagnosis = finding.diagnosis;
    Json candidates = Json::array();
    for (const Candidate& candidate : diagnosis.candidates) {
        candidates.push_back({{"different", candidate.different},
                              {"distance", candidate.distance},
                              {"explained", candidate.explained},
                              {"ids", texts_to_json(candidate.ids)},
                              {"names", texts_to_json(candidate.names)},
                              {"remark", candidate.remark}});
    }
    return {{"candidates", std::move(candidates)},
            {"different", diagnosis.different},
            {"distance", diagnosis.distance},
            {"held_against", finding.held_against},
            {"kind", finding.kind},
            {"place", diagnosis.place},
            {"verdict", diagnosis.verdict}};
}

void print_text(const Finding& finding, std::ostream& out) {
    const Diagnosis& diagnosis = finding.diagnosis;
    const bool is_picture = finding.kind == "picture";
    out << "Held against " << finding.held_against << ": " << diagnosis.verdict << '\n';
    if (diagnosis.is_same()) return;
    out << counted(diagnosis.different, is_picture ? "pixel" : "row",
                   is_picture ? "pixels" : "rows")
        << (diagnosis.different == 1 ? " differs" : " differ")
        << (is_picture ? " from the right picture" : " from the reference");
    const Candidate* const likely = likely_candidate(diagnosis);
    if (likely != nullptr && !likely->remark.empty()) out << ' ' << likely->remark;
    out << '.';
    if (!diagnosis.place.empty()) out << ' ' << diagnosis.place;
    out << '\n';
    if (diagnosis.candidates.empty()) return;
    out << "\nexplains  differ still  mistake\n";
    for (const Candidate& candidate : diagnosis.candidates) {
        out << fmt::format("{:>8}  {:>12}  ", explained_text(candidate.explained, 1),
                           candidate.different);
        for (std::size_t i = 0; i < candidate.ids.size(); ++i)
            out << (i > 0 ? " or " : "") << candidate.ids[i] << ": " << candidate.names[i];
        if (!candidate.remark.empty()) out << ", " << candidate.remark;
        out << '\n';
    }
}

} // namespace

ExitCode diagnose_command(const DiagnoseOptions& options, std::ostream& out, std::ostream& err,
                          ProgressLine& progress) {
    const Session session = open_view(options.view);
    const std::vector<Bug> bugs = read_bugs();
    const Result result{options.file == "-" ? standard_input_name : options.file,
                        read_input(options.file, largest_image_file)};
    const Finding finding = is_image(result.bytes)
                                ? diagnose_picture_file(result, session, bugs, err, progress)
                                : diagnose_rows_file(options, result, session, bugs);
    if (options.json) {
        print_json(to_json(finding), out);
    } else {
        print_text(finding, out);
    }
    return finding.diagnosis.is_same() ? ExitCode::done : ExitCode::difference;
}

} // namespace rasterwalk
