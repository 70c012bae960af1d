#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "facts/facts.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "lessons/lesson_scores.h"
#include "lessons/lesson_search.h"
#include "lessons/progress.h"
#include "lessons/puzzle_desk.h"
#include "lessons/puzzle_judge.h"
#include "lessons/stage_note.h"
#include "text/markdown.h"
#include "ui/actions/kept_state.h"

namespace rasterwalk {

struct MarkdownPage; // ui/page/markdown.h

/// The student's answer to a prediction of the open lesson.
struct PredictionView {
    std::string typed;               ///< the number, as written in the field
    bool is_no_number = false;       ///< the field's content at the last answer
    std::optional<Judgement> judged; ///< of the last answer; none before the first
    std::string said;                ///< that answer, as repeated to the student
    std::shared_ptr<MarkdownPage> because;
    bool is_in_picture = false; ///< what the answer shows was set up since the step opened
    bool takes_keys = false;    ///< the field of a number has the keyboard from the next frame
    bool is_fresh = false;      ///< just answered: the verdict is scrolled to, and has the keyboard
    bool is_taken_up = false;   ///< a kept answer is shown; after that the student decides
};

/// A puzzle of the open lesson.
struct PuzzleView {
    PuzzleDesk desk;
    LessonPuzzle of; ///< whose pieces the desk has; without lines before they are laid out
    std::optional<PuzzleVerdict> verdict; ///< of the last run; none if a line was moved since
    bool is_fresh = false;                ///< it was just run: what is said is scrolled to
    int dragged = -1;                     ///< the piece that follows the pointer; -1: none
    int drag_depth = 1;                   ///< of that piece when it was taken
    bool drag_from_left = false;          ///< it was not used then
};

/// What is said about a task of the current step: Markdown.
struct TaskWords {
    std::string text;       ///< what the last try misses, or why it is solved; may be empty
    bool is_reason = false; ///< why it is solved
};

/// What a search over the lessons has found; searched again when one of the first two changes.
struct LessonSearch {
    std::string query;
    std::uint64_t number = 0; ///< of the lessons, see LessonList
    std::vector<SearchHit> hits;
};

/// What a strip shows of a step at a time: a few lines of its text, a question, or a task.
struct LessonCard {
    int part = 0;          ///< index in LessonStep::parts
    MarkdownDocument page; ///< as much as fits; for a question: of the reason for its answer
};

/// A place in a step's text.
struct LessonPlace {
    int part = 0;       ///< index in LessonStep::parts
    float share = 0.0f; ///< how far into that part, 0 to 1
};

/// What the strip of the lesson keeps from one frame to the next.
struct LessonStrip {
    std::vector<LessonCard> cards; ///< of the current step, in reading order; empty: not cut yet
    float cards_width = 0.0f;      ///< the width they were cut for, screen pixels
    float cards_text_size = 0.0f;  ///< the font size they were cut for, screen pixels
    float cards_height = 0.0f;     ///< the room for a table they were cut for, screen pixels
    bool is_recut = false;         ///< they must be cut again: their words have changed
    std::uint64_t cards_of = 0;    ///< number of the lessons when they were cut, see LessonList
    int card = 0;                  ///< the one shown
    LessonPlace place;             ///< where the card shown begins
    std::optional<LessonPlace> read_to; ///< where the cards continue once they are cut
    int scrolled_card = 0;              ///< the one the scroll position belongs to
    bool is_at_side = false;            ///< next to the canvas, and narrower than the window
    bool has_long_words = false; ///< the words of a step's parts have no room next to the buttons
    float height = 0.0f;         ///< of its text when last drawn, screen pixels
    float most_height = 0.0f;    ///< the most it can have in this window, screen pixels
    float figure_height = 0.0f;  ///< the most for a figure while it is drawn; 0: it is not
    /// The sentences that fit, and what they were found for.
    struct Fitting {
        std::string of;
        MarkdownDocument sentences;
        float width = 0.0f;     ///< screen pixels
        float text_size = 0.0f; ///< of the font, screen pixels
        int lines = 0;
    } fitting;
};

/// What can move the widget that a step points at out of sight without scrolling.
struct PointedPlace {
    std::string widget;                ///< that widget, or what must be clicked first
    int card = 0;                      ///< of the strip
    float strip = 0.0f;                ///< its height, screen pixels
    float width = 0.0f, height = 0.0f; ///< of the window, screen pixels
    float text_scale = 0.0f;           ///< screen pixels per design pixel

    friend bool operator==(const PointedPlace&, const PointedPlace&) = default;
};

/// What the lesson keeps from one frame to the next.
struct LessonView {
    StageNotes notes;
    LessonList lessons;
    Progress progress;
    Progress kept_progress; ///< as this window last read or wrote it
    KeptFile progress_file;
    LessonScores scores;
    FactCache facts;                                            ///< for the conditions of the tasks
    std::map<std::string, std::shared_ptr<MarkdownPage>> pages; ///< of the current step, by name
    std::map<std::string, PredictionView> predictions;          ///< of the lesson, by id
    std::map<std::string, PuzzleView> puzzles;                  ///< of the lesson, by id
    std::set<std::string> open_hints;                           ///< ids of tasks
    std::map<std::string, TaskWords> task_words;                ///< by task id
    std::string fresh;         ///< widget of words that have just appeared; empty: none
    int frames_to_fresh = 0;   ///< until they are scrolled into sight
    std::string shown;         ///< which page is shown; the scroll position belongs to it
    float scroll_share = 0.0f; ///< how far it is scrolled, 0 to 1
    unsigned place = 0;        ///< the window of ImGui that it is in
    std::optional<LessonPlace> place_to_show; ///< in the whole text: it is scrolled there
    /// Part of the column's text: an open question or task that is out of sight.
    std::optional<int> open_below;
    std::optional<float> known_scroll; ///< of the whole text; if it changes, the student scrolled
    bool wants_end = false;       ///< of the current step: its last card, the end of its whole text
    float pages_to_scroll = 0.0f; ///< requested by a key: 1 is a page forward
    bool has_more_above = false, has_more_below = false; ///< text that is scrolled away
    /// What the window showed whole in the previous frame, screen pixels from the text's beginning,
    /// and whether it had to leave out a line below.
    float shown_from = 0.0f, shown_to = 0.0f;
    bool is_cut_below = false;
    int frames_to_scroll = 0;          ///< in which it returns to that share, in another place
    std::string search;                ///< what the list of lessons is searched for
    LessonSearch found;                ///< the result of that search
    bool is_strip = false;             ///< above the canvas, for lack of room for a column
    bool drawer_is_open = false;       ///< if it is a strip: the whole text takes its place
    bool drawer_of_other_mode = false; ///< it is open when the lecture mode is left or entered
    LessonStrip strip;
    std::string meant;        ///< the widget that a link points at; empty: none
    std::string pointed_at;   ///< that one, or what must be clicked first: it is outlined
    bool is_pinned = false;   ///< it is kept in sight, and outlined without a pointer on the link
    std::string of_step;      ///< the widget that the step points at, until it is used; empty: none
    PointedPlace of_step_in;  ///< where that was brought into sight
    bool is_new = false;      ///< set by the click or key of this frame, which does not end it
    bool is_hovered = false;  ///< the pointer rests on such a link in this frame
    bool wants_frame = false; ///< pressed by key: what it points at gets the frame
    int frames_hidden = 0;    ///< since the widget pointed at was last on the screen
    int frame_of_answer = -1; ///< in which a kept answer was last judged
    int frame_of_waiting = -1; ///< in which another one was left for the next frame
};

} // namespace rasterwalk
