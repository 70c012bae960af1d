#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "picture/overlay.h"
#include "picture/view_image.h"
#include "pipeline/cursor.h"
#include "pipeline/framebuffer.h"
#include "pipeline/timeline.h"
#include "scene/reading.h"
#include "scene/scene.h"
#include "session/canvas_view.h"
#include "session/glossary.h"
#include "session/places.h"
#include "session/quiz_state.h"
#include "session/second_run.h"
#include "session/side_page.h"
#include "session/speed.h"
#include "session/tabs.h"
#include "session/undo.h"
#include "settings/preset.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Whether time is playing.
struct Play {
    bool running = false;
    bool has_just_begun = false; ///< no time has run since it was started
    Granularity granularity = Granularity::moment;
    Speed speed;
    double passed = 0.0; ///< part of the step at the cursor, 0 to 1

    friend bool operator==(const Play&, const Play&) = default;
};

/// The inputs of the results: what the student has set, and where they look.
struct SessionInputs : Choices, Place {
    friend bool operator==(const SessionInputs&, const SessionInputs&) = default;
};

/// Everything that the user, a lesson, a link or a test sets. Nothing in here is derived.
struct Session : SessionInputs {
    std::vector<Preset> presets;
    std::vector<Term> glossary;
    std::optional<RunPair> runs_before; ///< only for mirror_changes_to_b()
    CompareView compare_view = CompareView::run_a;
    float wipe = 0.5f;        ///< position of the divider, 0 left to 1 right
    std::optional<Quiz> quiz; ///< hides the settings while in progress
    Play play;
    CanvasView canvas;
    std::string tab = "rows"; ///< of the inspector, by name; see tabs.h
    TabGuide tab_guide;
    int jumps = 0; ///< grows with every go_to(); steps and scrubbing do not count
    UndoStack undo;
    PlaceHistory places;
    std::string lesson;               ///< id of the open lesson; empty: none
    int step = 0;                     ///< of the lesson; 0 is its opening
    std::string lesson_folder;        ///< folder of the lessons; empty: lessons_folder()
    SidePage page = SidePage::lesson; ///< next to the picture
    std::string notice;               ///< a sentence for the status line; may be empty
    std::string last_info; ///< the last notice that reported success; any other is a fault
};

/// Reports what was done. A notice set without this says what could not be done.
void show_info(Session& session, std::string sentence);

/// Does the notice say what could not be done?
bool is_fault(const Session& session);

/// A session on a scene file, with the presets of lessons_folder(). Throws Error.
Session open_session(const std::string& scene_path, const ReadingWatch& watch = {});

/// Replaces the scene: the settings of both runs keep their rules and take the scene's camera,
/// light and viewport; the cursor goes to the end, the selection is dropped. A quiz, which is about
/// the previous scene, is ended.
void set_scene(Session& session, Scene scene);

/// Puts a scene in place of the present one and leaves the settings unchanged.
void show_scene(Session& session, std::shared_ptr<const Scene> scene);

} // namespace rasterwalk
