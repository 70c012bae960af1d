#include "lessons/stage_note.h"

#include <system_error>

#include "base/error.h"
#include "base/files.h"
#include "session/bench.h"
#include "session/content.h"

namespace rasterwalk {

namespace {

/// When the file was last written, and its size: together they tell whether it changed.
struct FileState {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;
};

FileState state_of(const std::string& path) {
    FileState state;
    std::error_code fault;
    const auto written = std::filesystem::last_write_time(path, fault);
    if (!fault) state.written = written;
    const std::uintmax_t size = std::filesystem::file_size(path, fault);
    if (!fault) state.size = size;
    return state;
}

} // namespace

std::string note_name(const Session& session) {
    if (session.scene && is_bench(*session.scene)) {
        return session.scene->examples.empty() ? "pixels" : "bench";
    }
    return std::string(stage_info(session.a.settings).name);
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
        const FileState now = state_of(found->second.note.path);
        if (now.written == found->second.written && now.size == found->second.size) {
            return found->second.note;
        }
    }
    Kept& kept = kept_[name];
    try {
        const std::string folder = lessons_folder();
        const FileState state = state_of(folder + "/stages/" + name + ".md");
        kept = {read_stage_note(folder, name), state.written, state.size};
    } catch (const Error& fault) {
        kept = {{{}, {}, fault.what()}, {}, 0};
    }
    return kept.note;
}

} // namespace rasterwalk
