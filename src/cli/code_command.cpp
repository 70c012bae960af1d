#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/text_parts.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "lab_code/code_walk.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/shown_pass.h"

namespace rasterwalk {

namespace {

/// A function that is being carried out, and where.
struct CodeSpot {
    std::string function, file;
    int line = 0; ///< of the file, with only the lines that the settings choose
    std::string text;
    bool is_mistake = false;
    std::vector<std::string> right; ///< lines in its place, or missing after it
    std::vector<CodeShown> variables;
};

CodeSpot spot_of(const LabCode& code, const CodeWalk& walk, const CodeCall& call) {
    const CodeMachine& machine = walk.machine();
    const FileLines file = file_around(walk.lines(), call.line);
    const ChosenLine& line = walk.lines()[static_cast<std::size_t>(call.line - 1)];
    std::vector<std::string> right;
    for (const std::string& usual : line.usual)
        right.emplace_back(trimmed(shown_words(usual)));
    return {machine.program().functions[static_cast<std::size_t>(call.function)].name,
            code.files[static_cast<std::size_t>(file.file)].name,
            call.line - file.first + 1,
            std::string(shown_words(line.text)),
            line.is_mistake,
            std::move(right),
            machine.variables(call)};
}

Json to_json(const CodeSpot& spot) {
    Json values = Json::object();
    for (const CodeShown& variable : spot.variables)
        values[variable.name] = variable.value;
    Json object{{"file", spot.file},
                {"function", spot.function},
                {"line", spot.line},
                {"text", trimmed(spot.text)}};
    if (spot.is_mistake)
        object["right"] = spot.right;
    else if (!spot.right.empty())
        object["missing"] = spot.right;
    object["values"] = std::move(values);
    return object;
}

void print_spots(const std::vector<CodeSpot>& spots, std::ostream& out) {
    for (const CodeSpot& spot : spots) {
        out << fmt::format("{} at {}:{}\n    {}\n", spot.function, spot.file, spot.line,
                           trimmed(spot.text));
        for (const std::string& right : spot.right)
            out << fmt::format("    {}: {}\n", spot.is_mistake ? "right" : "missing after it",
                               right);
        if (spot.is_mistake && spot.right.empty()) out << "    right: no such line\n";
    }
    if (spots.empty()) return;
    out << "\n";
    for (const CodeShown& variable : spots.front().variables)
        out << fmt::format("{} = {}\n", variable.name, variable.value);
}

} // namespace

void code_command(const CodeOptions& options, std::ostream& out) {
    const Session session = open_view(options.view);
    const Frame frame = shown_frame(session);
    const LabCode code = read_lab_code(lessons_folder() + "/code");
    CodeWalk walk;
    walk.take(code, frame, 1);
    if (!walk.missing().empty())
        throw UsageError(
            fmt::format("there is no code yet for this picture: \"{}\".", walk.missing()));
    const Timeline timeline(frame);
    const Cursor moment = timeline.at_or_after(in_frame(session.cursor, frame.pass));
    Framebuffer planes;
    clear(planes, frame);
    DrawWindow before;
    before.to = moment;
    draw(frame, before, planes);
    const CodePlace place = walk.seek({moment, options.lines}, planes);
    if (!walk.is_there())
        throw InputError(std::string(trimmed("the lab's code does not come to this moment. " +
                                             walk.machine().fault().sentence)));
    std::vector<CodeCall> calls = walk.machine().calls();
    std::reverse(calls.begin(), calls.end());
    std::vector<CodeSpot> spots;
    for (const CodeCall& call : calls)
        spots.push_back(spot_of(code, walk, call));
    if (!options.json) {
        out << moment_text(frame, place.cursor)
            << (place.lines > 0 ? ", " + counted(place.lines, "line", "lines") + " on"
                                : std::string())
            << ": " << (spots.empty() ? "every triangle is drawn." : "this line comes next.")
            << "\n";
        print_spots(spots, out);
        return;
    }
    Json answer{{"calls", Json::array()},
                {"cursor", moment_text(frame, place.cursor)},
                {"lines", place.lines}};
    for (const CodeSpot& spot : spots)
        answer["calls"].push_back(to_json(spot));
    print_json(answer, out);
}

} // namespace rasterwalk
