#pragma once

// Everything that is known about a student's program: whether it compiles, what it draws, which of
// its functions do what the lab asks, and what is the likely mistake.

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/bug.h"
#include "mine/compile/compile.h"
#include "mine/compile/student_files.h"
#include "mine/functions/function_checks.h"
#include "mine/key_runs.h"
#include "mine/picture_check.h"
#include "mine/program_run.h"
#include "mine/put_sequence.h"
#include "scene/scene.h"

namespace rasterwalk {

/// A mistake that the evidence points to.
struct LikelyMistake {
    std::vector<std::string> bugs; ///< ids of the laboratory, each just as likely; empty: it is
                                   ///< none of them, or not known to be
    std::string sentence;          ///< what was found, where, and how large it is
    ProgramPlace place;            ///< line 0: not known
    bool is_not_called = false;    ///< a function that is written, but that no frame calls
};

/// What the pixels' order tells.
struct SequenceCheck {
    std::int64_t puts = 0; ///< theirs
    std::optional<SequenceParting> parting;
};

struct CheckedProgram {
    StudentFiles files;
    std::vector<std::string> defined; ///< names of the functions that its sources define
    Compiled compiled;
    std::optional<ProgramRun> run; ///< none: it does not compile
    KnownProgram known;            ///< camera, light and picture size
    std::vector<FunctionCheck> functions;
    std::optional<PictureCheck> picture;            ///< none: nothing was drawn
    std::optional<SequenceCheck> sequence;          ///< of a right picture
    std::vector<CompileMessage> sanitizer_messages; ///< why there was no sanitized run
    std::vector<KeyFault> key_faults;
    bool is_key_tested = false;
    std::vector<LikelyMistake> mistakes; ///< the one to fix first at the front

    bool compiles() const { return !compiled.program.empty(); }
    /// Nothing was found that is wrong. What is not written yet is not wrong.
    bool is_right() const;
    /// Its picture differs, and nothing else is wrong; but too little is known about the program to
    /// call that wrong.
    bool is_not_judged() const { return picture && !picture->is_judged && mistakes.empty(); }
};

/// What programs of the lab draw, and what their functions are asked.
struct LabScenes {
    Scene room;
    std::vector<BenchTriangle> bench; ///< the examples of the bench
};

/// Reads them from lessons_folder(). Throws Error.
LabScenes read_lab_scenes();

/// How a program is checked.
struct CheckProgramOptions {
    std::string compiler;                      ///< name or path; empty: the one that is found
    bool hold_keys = true;                     ///< also with sanitizers, and with its keys held
    std::chrono::milliseconds search{10'000};  ///< for what explains a wrong picture
    std::function<bool()> is_stopped;          ///< null: never
    std::function<void(std::string_view)> say; ///< what is being done; null: not needed
    /// What is known so far, each time that it is more; null: not needed.
    std::function<void(const CheckedProgram&)> report;
};

/// Compiles, runs and compares. Throws AccessError if there is no compiler, or if this system
/// cannot guard programs.
CheckedProgram check_program(const StudentFiles& files, const LabScenes& lab,
                             const std::vector<Bug>& bugs, const CheckProgramOptions& options);

/// The state of a function in words: "right", "not written yet", or "not found" if the picture
/// shows that the program has it, under a name that is not known here.
std::string_view state_words(const CheckedProgram& checked, const FunctionCheck& check);

/// What is said when nothing was found: only pictures of the first frame are compared.
inline constexpr std::string_view right_words =
    "Nothing wrong was found in the first frame, with the camera where it begins.";

/// Why a picture that differs is not called wrong, a sentence.
std::string_view not_judged_words(const CheckedProgram& checked);

/// What the evidence points to, what should be fixed first at the front. Called by check_program()
/// once the picture is compared, and at its end.
std::vector<LikelyMistake> likely_mistakes(const CheckedProgram& checked);

} // namespace rasterwalk
