#include "lessons/stage_note.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "lessons/lesson_run.h"
#include "session/bench.h"
#include "session/content.h"
#include "session/shown_pass.h"

namespace rasterwalk {

namespace {

/// The paragraph filled in; none if one of its numbers is missing.
std::optional<std::string> paragraph_about(std::string_view paragraph, const FactReader& fact) {
    if (paragraph.find('{') == std::string_view::npos) return std::string(paragraph);
    bool is_whole = true;
    try {
        std::string text = fill_in(paragraph, "", std::nullopt, [&](std::string_view name) {
            Value value = fact(name);
            is_whole = is_whole && is_there(value);
            return value;
        });
        return is_whole ? std::optional(std::move(text)) : std::nullopt;
    } catch (const UsageError&) {
        return std::string(paragraph);
    }
}

} // namespace

std::string note_name(const Session& session) {
    if (session.scene && is_bench(*session.scene)) {
        return session.scene->examples.empty() ? "pixels" : "bench";
    }
    if (shown_pass(session, session.a) < 0) return "shadow";
    const Settings& settings = session.a.settings;
    if (settings.stage == Stage::depth && hidden_rule(settings) != Hidden::depth_buffer)
        return "hidden";
    return std::string(stage_info(settings).name);
}

std::string note_about(std::string_view text, const FactReader& fact) {
    constexpr std::string_view gap = "\n\n";
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(gap), text.size());
        const std::string_view paragraph = text.substr(0, end);
        text.remove_prefix(std::min(end + gap.size(), text.size()));
        const std::string_view between = text.empty() ? std::string_view() : gap;
        if (const auto shown = paragraph_about(paragraph, fact))
            result.append(*shown).append(between);
    }
    return result;
}

StageNote read_stage_note(const std::string& folder, std::string_view name) {
    StageNote note;
    note.path = folder + "/stages/" + std::string(name) + ".md";
    try {
        note.text = read_file(note.path, largest_note);
    } catch (const Error& fault) {
        note.fault = fault.what();
    }
    return note;
}

const StageNote& StageNotes::find(const std::string& name) {
    const auto found = kept_.find(name);
    if (found != kept_.end()) {
        if (file_state(found->second.note.path) == found->second.state) return found->second.note;
    }
    Kept& kept = kept_[name];
    try {
        const std::string folder = lessons_folder();
        const FileState state = file_state(folder + "/stages/" + name + ".md");
        kept = {read_stage_note(folder, name), state};
    } catch (const Error& fault) {
        kept = {{{}, {}, fault.what()}, {}};
    }
    return kept.note;
}

} // namespace rasterwalk
