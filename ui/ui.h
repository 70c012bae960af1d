#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <imgui.h>

#include "inspect/microscope.h"
#include "laboratory/bug.h"
#include "laboratory/candidate.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "lessons/lesson_search.h"
#include "lessons/progress.h"
#include "lessons/stage_note.h"
#include "session/results.h"
#include "session/session.h"

namespace rasterwalk {

/// Makes pictures known to the graphics system; the only thing that the interface asks of its host.
class TextureHost {
  public:
    virtual ~TextureHost() = default;
    /// Makes a texture of the picture, shown with hard pixel edges, or replaces `old` by it
    /// (null: a new one). The same size is replaced in place.
    virtual ImTextureID upload(ImTextureID old, const Image& image) = 0;
};

/// A widget that was drawn this frame, under the name by which tests and lessons find it.
struct WidgetPlace {
    ImVec2 top_left, bottom_right; ///< screen pixels, cut to what is visible
    bool visible = false;          ///< false: scrolled or clipped away
    bool is_whole = false;         ///< false: a part of it is cut off
    bool has_tooltip = false;
    std::string text; ///< the number that it shows, where it is one that can be clicked
};

/// Fonts in the sizes that the interface uses.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;
    ImFont* bold = nullptr;
    ImFont* italic = nullptr; ///< the text font where the slanted one is not installed
    ImFont* title = nullptr;
    ImFont* small = nullptr;
    std::string notice; ///< why the built-in font had to do; empty if it did not
};

enum class Theme : std::uint8_t { dark, light };

/// What the student has won in quizzes.
struct QuizScore {
    int rounds = 0;       ///< that were ended after they were over
    int points = 0;       ///< in all of them
    bool is_kept = false; ///< between two runs of the program

    friend bool operator==(const QuizScore&, const QuizScore&) = default;
};
inline constexpr int largest_score = 1'000'000;

/// How the window looks; what a student would expect to find again next time.
struct UiOptions {
    float wished_text_scale = 1.0f; ///< 1: 16 pixels
    float text_scale = 1.0f;        ///< in force: smaller than wished where the window is too small
    Theme theme = Theme::dark;
    float lesson_width = 0.0f; ///< columns, share of the window's width; 0: the layout decides
    float inspector_width = 0.0f;
    QuizScore score;
};

/// A file in which something is kept between two runs of the program.
struct KeptFile {
    std::string path;        ///< empty: nowhere
    double next_try = 0.0;   ///< not to be written before ImGui's clock says so, seconds
    bool is_failing = false; ///< it could not be written, and the student was told
};

/// Where the picture lies on the screen: screen = origin + scale * (column, row).
struct PicturePlace {
    ImVec2 origin{0, 0};
    float scale = 1.0f; ///< screen pixels a picture pixel
};

/// A picture that the graphics system knows.
struct PictureTexture {
    ImTextureID id = nullptr;
    std::uint64_t number = 0; ///< of the picture that it shows, see Results
    float scale = 0.0f;       ///< that it was resampled for; 1: as it is
    ImVec2 size{0, 0};        ///< in picture pixels
};

/// What the float microscope looks at.
struct MicroscopeView {
    int edge = 0;                    ///< of the triangle that the inspector shows
    std::optional<Cursor> picked_at; ///< where the cursor stood when the edge was picked by hand
    bool shows_x = false;            ///< x instead of y
    /// The triangle and edge for which x or y was last chosen; another edge chooses anew.
    std::pair<int, int> axis_chosen_for{-1, -1};
    EdgeMicroscope shown; ///< of that edge; worked out anew when another is shown
};

/// What only concerns the screen while two runs are compared.
struct CompareLook {
    PictureTexture picture;                 ///< shows run B
    PictureTexture difference;              ///< shows B minus A
    std::optional<PicturePlace> place_of_b; ///< of its picture, while both stand side by side
    float blink_seconds = 0.0f;             ///< since the blinking began; A comes first
    bool blink_is_held = false;
};

struct MarkdownPage; // ui/page/markdown.h

/// The three rooms of the bug laboratory.
enum class LabMode : std::uint8_t {
    bugs,   ///< the mistakes, to be turned on
    quiz,   ///< which of them is it?
    result, ///< a result of the student's own, and what may be wrong with it
};

/// What the bug laboratory keeps from one frame to the next.
struct LabLook {
    std::vector<Bug> bugs; ///< read when the laboratory is opened first
    std::string fault;     ///< why they could not be read
    bool is_read = false;
    std::string chosen; ///< id of the bug that is described
    /// For which bug, and down to which screen line, the list was scrolled last.
    std::string in_sight;
    float bottom = 0.0f;
    std::shared_ptr<MarkdownPage> page;
    LabMode mode = LabMode::bugs;
    int seed = 0;             ///< of the next quiz; 0: the program takes one
    bool wants_two = false;   ///< the next quiz hides two mistakes
    std::string result_path;  ///< of the student's own result
    int frames_to_result = 0; ///< it is diagnosed when this falls to 0 from 1; until then it waits
    std::string result_fault; ///< why it could not be diagnosed
    std::string held_against; ///< "the picture of lab-room"
    std::optional<Diagnosis> diagnosis;
};

/// What the row table has on show.
struct RowsPlace {
    int triangle = -1;
    std::optional<int> row; ///< that is selected
    int jumps = 0;          ///< Session::jumps: a lesson's step or a link may lead elsewhere

    friend bool operator==(const RowsPlace&, const RowsPlace&) = default;
};

/// What is asked about in the Vertices, Fragment and Graph tabs.
struct InspectView {
    std::string vertex_number = "pixel.column"; ///< id of a formula, see vertex_report.h
    std::string fragment_number = "zinv";       ///< id of a formula, see fragment_report.h
    bool shows_other_light = false;             ///< per vertex where it is per pixel, and back
    std::string graph_quantity = "z";           ///< id of a quantity, see carried_row.h
};

struct MarkdownPage; // ui/page/markdown.h
struct PictureShelf; // ui/widgets/pictures.h

/// What the student answered to a prediction of the lesson that is open.
struct PredictionView {
    std::string typed;               ///< the number, as it stands in the field
    bool is_no_number = false;       ///< what stood there when it was answered
    std::optional<Judgement> judged; ///< of the answer given last; none before the first
    std::string said;                ///< that answer, as it is told back
    std::shared_ptr<MarkdownPage> because;
};

/// What a search over the lessons has found; searched again when one of the first two changes.
struct LessonSearch {
    std::string query;
    std::uint64_t number = 0; ///< of the lessons, see LessonList
    std::vector<SearchHit> hits;
};

/// What the lesson column keeps from one frame to the next.
struct LessonView {
    StageNotes notes;
    LessonList lessons;
    Progress progress;
    Progress kept_progress; ///< as this window last read or wrote it
    KeptFile progress_file;
    FactCache facts; ///< that the conditions of the tasks ask for
    std::map<std::string, std::shared_ptr<MarkdownPage>> pages; ///< of the step on show, by name
    std::map<std::string, PredictionView> predictions;          ///< of the lesson, by id
    std::set<std::string> open_hints;                           ///< ids of tasks
    std::string shown;             ///< which page is on show; the scroll position belongs to it
    std::string search;            ///< what the list of lessons is searched for
    LessonSearch found;            ///< what it has found
    bool shows_list = false;       ///< the list of lessons instead of a lesson
    bool shows_stage = false;      ///< the page about the stage instead of the lesson
    bool covers_inspector = false; ///< where the lesson is a tab of the inspector: it is in front
    std::string pointed_at;        ///< widget that a link points at: it is outlined; empty: none
    bool is_held = false;          ///< it stays outlined after the pointer has left the link
    bool is_hovered = false;       ///< the pointer rests on such a link in this frame
    int frames_unseen = 0;         ///< since the widget pointed at was last on the screen
};

/// A file or folder that the sheet for files lists.
struct FileEntry {
    std::string name;
    bool is_folder = false;
};

/// The sheet on which a file is opened or a view is saved.
struct FileSheet {
    enum class Kind : std::uint8_t { closed, open, save };
    Kind kind = Kind::closed;
    std::string path;   ///< as it stands in the field
    std::string folder; ///< that is listed; kept for the next time
    std::vector<FileEntry> entries;
    std::size_t left_out = 0; ///< files that are not listed because there are too many
    std::string fault;        ///< why it was not opened or saved
    std::string asked;        ///< file that is there already: may it be replaced? empty: not asked
    bool wants_focus = false; ///< the field takes the keyboard in the next frame
};

/// What of the session a frame depends on.
struct Asked {
    std::shared_ptr<const Scene> scene;
    Run a;
    std::optional<Run> b;
    Cursor cursor;
    Selection selection;
    View view;
    OverlaySet overlays;
    std::optional<DepthRange> depth_range;

    friend bool operator==(const Asked&, const Asked&) = default;
};

/// The interface: what the student sets (session), what follows from it (results), and what only
/// concerns the screen.
struct Ui {
    Session session;
    Results results;
    std::optional<Asked> worked_out; ///< what the results belong to
    UiOptions options;
    UiOptions kept_options; ///< as this window last read or wrote them
    KeptFile options_file;
    MicroscopeView microscope;
    InspectView inspect;
    LessonView lesson;
    Fonts fonts;
    TextureHost* textures = nullptr;
    std::shared_ptr<PictureShelf> pictures; ///< that the lessons show
    CompareLook compare;
    LabLook lab;
    FileSheet files;
    PictureTexture picture;      ///< shows Results::picture
    PictureTexture overlay;      ///< shows Results::overlay
    bool page_is_low = false;    ///< the inspector's page has few lines: panels are brief
    bool page_is_narrow = false; ///< and few letters a line
    bool shows_legend = true;    ///< of the overlays; or else only their swatches
    float depth_grip = 0.0f;     ///< from a handle of the depth view that is held to the pointer
    std::unordered_map<std::string, WidgetPlace> widgets; ///< drawn in this frame, by name
    PicturePlace picture_place;                           ///< in this frame
    std::string setting_search;              ///< what the settings panel is filtered by
    std::optional<glm::ivec2> hovered_pixel; ///< of the picture, under the pointer
    std::optional<int> hovered_row;          ///< row of the picture pointed at in the row table
    bool shows_end_values = false;           ///< further columns in the row table
    bool scroll_to_row = false;              ///< the row table brings a row into view
    RowsPlace rows_place;                    ///< for which it did so last
    bool follow_cursor = false;  ///< the cursor moved: tables scroll to what was just written
    int dragged_vertex = -1;     ///< of the bench triangle; -1: none
    bool shows_glossary = false; ///< the glossary is open
    std::vector<std::filesystem::path> scene_files; ///< of the Scene menu, read when it opens
    std::string glossary_search;                    ///< what the glossary is filtered by
    bool shows_keys = false;                        ///< the sheet of keys is open
    bool style_is_stale = true; ///< theme or text size changed: style and fonts are to be made anew
    bool fonts_changed = false; ///< the host makes the font texture anew and sets this back
    bool wants_quit = false;
    bool wants_picture = false; ///< F12: the host saves a picture of the window
};

} // namespace rasterwalk
