#include "view/view_state.h"

#include <utility>

#include "base/error.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/setting_table.h"
#include "view/view_table.h"

namespace rasterwalk {

namespace {

/// Shows one state; collects faults, each with the line of its key.
class Showing {
  public:
    Showing(Session& session, const ViewState& state) : session_(session), state_(state) {}

    std::vector<Fault> show(const std::string& folder) {
        attempt("scene", [&] {
            const std::string wanted = state_.scene.value_or(std::string(usual_scene));
            set_scene(session_, read_scene_file(find_lesson_file(folder, wanted)));
        });
        if (session_.scene == nullptr) return std::move(faults_);
        session_.a.settings = default_settings(*session_.scene);
        for (const std::string& assignment : state_.set)
            attempt("set", [&] { set_from_text(session_.a.settings, assignment); });
        return show_on_scene();
    }

    std::vector<Fault> show_on_scene() {
        session_.play.running = false;
        session_.play.passed = 0.0;
        ++session_.jumps; // so that Back can leave the lesson's place
        for (const ViewField* field : view_table_drawn_first()) {
            if (field->show) attempt(field->key, [&] { field->show(state_, session_); });
        }
        return std::move(faults_);
    }

  private:
    template <class Action>
    void attempt(std::string_view key, Action action) {
        try {
            action();
        } catch (const Error& fault) {
            faults_.push_back({state_.line_of(key), fault.what()});
        }
    }

    Session& session_;
    const ViewState& state_;
    std::vector<Fault> faults_;
};

} // namespace

int ViewState::line_of(std::string_view key) const {
    const auto found = lines.find(key);
    return found != lines.end() ? found->second : line;
}

ViewState combined(const ViewState& base, const ViewState& over) {
    ViewState result = base;
    for (const ViewField& field : view_table())
        field.take(over, result);
    if (over.line != 0) result.line = over.line;
    for (const auto& [key, line] : over.lines)
        result.lines[key] = line;
    return result;
}

std::vector<Fault> show_state(Session& session, const ViewState& state, const std::string& folder) {
    return Showing(session, state).show(folder);
}

std::vector<Fault> show_on_scene(Session& session, const ViewState& state) {
    return Showing(session, state).show_on_scene();
}

ViewState state_of(const Session& session, const Scene& original) {
    ViewState state;
    for (const ViewField& field : view_table()) {
        if (field.read_session) field.read_session(session, original, state);
    }
    return state;
}

Scene scene_in_file(const Session& session) {
    const Scene& scene = *session.scene;
    if (scene.path.empty()) {
        throw UsageError("the scene " + scene.name + " was not read from a file.");
    }
    return is_bench(scene) ? read_scene_file(scene.path) : scene;
}

Settings settings_with(const Settings& settings, const std::vector<std::string>& assignments) {
    Settings result = settings;
    for (const std::string& assignment : assignments)
        set_from_text(result, assignment);
    return result;
}

} // namespace rasterwalk
