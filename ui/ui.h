#pragma once

// The state of the whole interface: the state of its parts, each in its own folder.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/language.h"
#include "session/results.h"
#include "session/session.h"
#include "ui/actions/background_load_state.h"
#include "ui/actions/kept_state.h"
#include "ui/app/options_state.h"
#include "ui/bars/transport_state.h"
#include "ui/canvas/canvas_state.h"
#include "ui/hosts/host_state.h"
#include "ui/inspector/code_state.h"
#include "ui/inspector/inspector_state.h"
#include "ui/inspector/lab_state.h"
#include "ui/inspector/ladder_state.h"
#include "ui/inspector/mine_state.h"
#include "ui/lesson/lesson_state.h"
#include "ui/sheets/sheets_state.h"
#include "ui/start/start_state.h"
#include "ui/widgets/widget_state.h"

namespace rasterwalk {

struct ImageCache; // ui/widgets/pictures.h

/// A scene that comes with the program.
struct SceneEntry {
    std::filesystem::path file;
    std::string title; ///< its name, or the file's if the scene cannot be read
};

/// A language that the window can be in.
struct LanguageChoice {
    std::string code; ///< empty: English
    std::string name; ///< in the language itself
};

/// The interface: what the student sets (session), what follows from it (results), and the state of
/// the screen alone.
struct Ui {
    Session session;
    Results results;
    std::optional<SessionInputs> worked_out; ///< what the results belong to
    UiOptions options;
    UiOptions kept_options; ///< as this window last read or wrote them
    KeptFile options_file;
    std::vector<LanguageChoice> language_choices; ///< at least English, after the first frame
    Language language;                            ///< of the texts, read as the options ask for it
    std::string refused_language; ///< code that could not be read: English takes its place
    HostState host;
    Fonts fonts;
    bool style_is_stale = true; ///< theme or text size changed: style and fonts must be made again
    std::unordered_map<std::string, WidgetPlace> widgets; ///< drawn in this frame, by name
    Focus focus;
    std::shared_ptr<ImageCache> pictures; ///< shown in the lessons
    bool follow_cursor = false; ///< the cursor moved: tables scroll to what was just written
    std::vector<SceneEntry> scene_files; ///< of the Scene menu, read when it opens
    CanvasState canvas;
    CodeLook code;
    CompareLook compare;
    InspectorState inspector;
    LabLook lab;
    LadderLook ladder;
    MineLook mine;
    LessonView lesson;
    SheetsState sheets;
    StartPage start;
    TransportState transport;
    BackgroundLoad reading;
    int faults = 0; ///< exceptions that guarded() has caught
};

} // namespace rasterwalk
