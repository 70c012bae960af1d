#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/files.h"
#include "mine/check_lines.h"
#include "mine/source_lines.h"
#include "ui/inspector/lab_state.h"

namespace rasterwalk {

class ProgramCheck;    // mine/program_check.h
struct CheckedProgram; // mine/checked_program.h
struct MarkdownPage;   // ui/page/markdown.h

/// A file of a program, as it was when the program was last checked.
struct WatchedFile {
    std::string path;
    FileState state;
};

/// The source next to what was found, and what it was read for.
struct MineSource {
    ProgramPlace place;
    std::uint64_t of = 0; ///< number of the program, see MineLook
    SourceLines shown;
};

/// What the tab of the student's own program keeps from one frame to the next.
struct MineLook {
    std::string typed;                        ///< a path, in the field
    std::string path;                         ///< of the program last asked for; empty: none was
    std::chrono::milliseconds search{10'000}; ///< for what explains a wrong picture
    std::shared_ptr<ProgramCheck> check;      ///< null: none is running
    std::vector<std::shared_ptr<ProgramCheck>> stopped; ///< until their threads have noticed
    std::vector<WatchedFile> watched; ///< empty: nothing has been checked, so nothing is watched
    std::chrono::milliseconds look_pause{100};          ///< from one look at them to the next
    std::chrono::steady_clock::time_point next_look;    ///< at the watched files
    std::chrono::steady_clock::time_point next_listing; ///< for files that were missing
    bool was_edited = false;                            ///< a watched file, since the check began
    std::uint64_t number = 0;                           ///< grows whenever `last` becomes another
    std::shared_ptr<const CheckedProgram> last; ///< what is known of the program as it is now
    bool is_whole = false;                      ///< the check of `last` is done
    bool is_given_up = false;                   ///< or was stopped
    int checks = 0;                             ///< begun so far
    int last_of = 0;                            ///< of these, the one that `last` is of
    int compared = 0;                           ///< and the one whose picture is run B
    bool is_wanted = false;          ///< a check begins as soon as the stopped ones have noticed
    std::string checked_at;          ///< time of day when it began, "14:02:07"; empty: not said
    std::vector<CheckLine> lines;    ///< of `last`
    std::vector<CheckLine> before;   ///< as each line was after the last whole check
    std::vector<LineChange> changes; ///< since then
    std::string fault;               ///< why the program could not be checked; empty: it could
    std::string chosen;     ///< name of the line that the student chose; empty: the first wrong one
    std::string brought_up; ///< the line that the page was last scrolled to, see mine_panel.cpp
    std::size_t message = 0; ///< of the compiler, whose source is shown
    LabPictures pictures;
    std::uint64_t pictures_of = 0; ///< number of the program that they show
    MineSource source;
    ProgramPlace defined_at;              ///< of the function shown, line 0: not found
    std::uint64_t defined_in = 0;         ///< number of the program
    std::shared_ptr<MarkdownPage> remedy; ///< what is said about the likely mistakes
};

} // namespace rasterwalk
