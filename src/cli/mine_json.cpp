#include "cli/mine_json.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/base64.h"
#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "base/quoted.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

/// The largest file that is merged, bytes: room for a course with all its pictures.
constexpr std::size_t largest_table = std::size_t{1} << 30;

double seconds_of(std::chrono::milliseconds time) {
    return static_cast<double>(time.count()) / 1000.0;
}

void add_place(Json& object, const ProgramPlace& place) {
    if (place.line == 0) return;
    object["file"] = place.file;
    object["function"] = place.function;
    object["line"] = place.line;
}

Json to_json(const CompileMessage& message) {
    return {{"cause", message.cause}, {"column", message.column}, {"error", message.is_error},
            {"file", message.file},   {"line", message.line},     {"text", message.text}};
}

Json to_json(const ProgramFault& fault) {
    Json object{{"hang", fault.is_hang}, {"sentence", fault.sentence}};
    add_place(object, fault.place);
    return object;
}

Json to_json(const ProgramRun& run) {
    Json faults = Json::array(), refused = Json::array(), calls = Json::object();
    for (const ProgramFault& fault : run.faults)
        faults.push_back(to_json(fault));
    for (const RefusedCall& call : run.refused) {
        refused.push_back({{"count", call.count}, {"what", call.what}});
        add_place(refused.back(), call.place);
    }
    for (const FunctionCalls& function : run.calls)
        calls[function.function] = function.count;
    return {{"calls", std::move(calls)},
            {"faults", std::move(faults)},
            {"files_guarded", run.has_landlock},
            {"frames", run.recording.progress.frames},
            {"height", run.recording.window.height},
            {"output", run.output},
            {"puts", run.recording.progress.puts},
            {"puts_outside", run.recording.progress.outside},
            {"refused", std::move(refused)},
            {"seconds", seconds_of(run.time)},
            {"width", run.recording.window.width}};
}

Json to_json(const CheckedProgram& checked, const FunctionCheck& check) {
    Json rules = Json::object();
    for (const auto& [name, value] : check.rules)
        rules[name] = value;
    return {{"asked", check.asked},
            {"bugs", texts_to_json(check.bugs)},
            {"causes", texts_to_json(check.causes)},
            {"fed", check.fed},
            {"first", check.first},
            {"name", check.function},
            {"notes", texts_to_json(check.notes)},
            {"right", check.right},
            {"rule", check.rule},
            {"rules", std::move(rules)},
            {"state", state_words(checked, check)},
            {"together", texts_to_json(check.together)}};
}

std::string picture_data(const Image& image) {
    return "data:image/png;base64," + base64(png_bytes(image));
}

Json to_json(const PictureCheck& picture) {
    Json object{{"different", picture.different},
                {"findings", texts_to_json(picture.diagnosis.findings)},
                {"judged", picture.is_judged},
                {"pixels", picture.pixels},
                {"place", picture.diagnosis.place},
                {"right", picture.is_right},
                {"rules", picture.diagnosis.rules},
                {"stage", stage_info(picture.reference).name},
                {"verdict", picture.diagnosis.verdict}};
    if (picture.first) object["first"] = {picture.first->x, picture.first->y};
    object["theirs"] = picture_data(picture.theirs);
    if (!picture.is_right) object["ours"] = picture_data(picture.right);
    return object;
}

Json to_json(const SequenceCheck& sequence) {
    Json object{{"puts", sequence.puts}, {"same", !sequence.parting.has_value()}};
    if (!sequence.parting) return object;
    object["index"] = sequence.parting->index;
    if (const auto& theirs = sequence.parting->theirs) object["theirs"] = {theirs->x, theirs->y};
    if (const auto& ours = sequence.parting->ours) {
        object["moment"] = to_text(ours->cursor);
        object["ours"] = {ours->pixel.x, ours->pixel.y};
    }
    return object;
}

Json to_json(const LikelyMistake& mistake, const std::vector<Bug>& bugs) {
    std::vector<std::string> names, lessons;
    for (const std::string& id : mistake.bugs)
        if (const Bug* bug = bug_of_id(bugs, id)) {
            names.push_back(bug->name);
            lessons.push_back(bug->lesson);
        }
    Json object{{"bugs", texts_to_json(mistake.bugs)},
                {"lessons", texts_to_json(lessons)},
                {"names", texts_to_json(names)},
                {"sentence", mistake.sentence}};
    add_place(object, mistake.place);
    return object;
}

} // namespace

Json to_json(const CheckedProgram& checked, const std::vector<Bug>& bugs) {
    Json messages = Json::array(), functions = Json::array(), keys = Json::array(),
         mistakes = Json::array();
    for (const CompileMessage& message : checked.compiled.messages)
        messages.push_back(to_json(message));
    for (const FunctionCheck& check : checked.functions)
        functions.push_back(to_json(checked, check));
    for (const KeyFault& fault : checked.key_faults) {
        keys.push_back(to_json(fault.fault));
        keys.back()["frame"] = fault.frame;
        keys.back()["key"] = fault.key.name;
    }
    for (const LikelyMistake& mistake : checked.mistakes)
        mistakes.push_back(to_json(mistake, bugs));
    Json object{{"compiler", checked.compiled.compiler},
                {"compiles", checked.compiles()},
                {"compile_seconds", seconds_of(checked.compiled.time)},
                {"folder", checked.files.folder},
                {"functions", std::move(functions)},
                {"judged", !checked.is_not_judged()},
                {"keys", std::move(keys)},
                {"keys_tested", checked.is_key_tested},
                {"main", checked.files.main},
                {"messages", std::move(messages)},
                {"mistakes", std::move(mistakes)},
                {"name", checked.files.name},
                {"right", checked.is_right()}};
    if (checked.run) object["run"] = to_json(*checked.run);
    if (checked.picture) object["picture"] = to_json(*checked.picture);
    if (checked.sequence) object["sequence"] = to_json(*checked.sequence);
    return object;
}

Json row_not_checked(const StudentFiles& files, const std::string& fault) {
    const Json none = Json::array();
    return {{"compiles", false},  {"fault", fault},   {"folder", files.folder},
            {"functions", none},  {"judged", false},  {"keys", none},
            {"main", ""},         {"messages", none}, {"mistakes", none},
            {"name", files.name}, {"right", false}};
}

bool is_set(const Json& object, const char* key) {
    if (!object.is_object()) return false;
    const auto found = object.find(key);
    return found != object.end() && found->is_boolean() && found->get<bool>();
}

std::string text_of(const Json& object, const char* key) {
    if (!object.is_object()) return {};
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<std::string> texts_of(const Json& object, const char* key) {
    std::vector<std::string> texts;
    if (!object.is_object() || !object.contains(key)) return texts;
    for (const Json& one : object[key])
        if (one.is_string()) texts.push_back(one.get<std::string>());
    return texts;
}

std::string fault_of(const Json& program) {
    return text_of(program, "fault");
}

std::string_view verdict_words(const Json& program) {
    if (!fault_of(program).empty()) return "not checked";
    if (is_set(program, "right")) return "right";
    return is_set(program, "judged") ? "differs" : "not judged";
}

Json merged_tables(const std::vector<std::string>& paths) {
    Json merged = Json::array();
    for (const std::string& path : paths) {
        const Json table = Json::parse(read_file(path, largest_table), nullptr, false);
        const auto is_program = [](const Json& one) {
            return one.is_object() && one.contains("name") && one["name"].is_string() &&
                   one.contains("mistakes");
        };
        if (is_program(table)) {
            merged.push_back(table);
        } else if (table.is_array() && std::all_of(table.begin(), table.end(), is_program)) {
            merged.insert(merged.end(), table.begin(), table.end());
        } else {
            throw InputError(fmt::format(
                "{} is no table that `rasterwalk mine --json` has printed.", in_quotes(path)));
        }
    }
    std::stable_sort(merged.begin(), merged.end(), [](const Json& a, const Json& b) {
        return a["name"].get<std::string>() < b["name"].get<std::string>();
    });
    return merged;
}

} // namespace rasterwalk
