#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/image.h"
#include "laboratory/bug.h"
#include "laboratory/candidate.h"
#include "laboratory/diagnose.h"
#include "scene/scene.h"
#include "settings/settings.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

struct MarkdownPage; // ui/page/markdown.h

/// The three rooms of the bug laboratory.
enum class LabMode : std::uint8_t {
    bugs,   ///< the mistakes, to be turned on
    quiz,   ///< which of them is it?
    result, ///< a result from the student's own program, and what may be wrong with it
};

/// The student's picture, and the one it is compared with.
struct LabPictures {
    Image own;
    Image right;
    std::uint64_t number = 0;            ///< of both; grows with each diagnosis
    std::array<PictureTexture, 2> small; ///< as they are shown
};

/// What a result is compared with.
struct LabReference {
    bool is_set = false; ///< the settings at the time it is chosen; if not, the handout's picture
    std::shared_ptr<const Scene> scene;
    Settings settings;
};

/// A file of the student's, and what it is compared with.
struct LabSubject {
    std::size_t bytes = 0;   ///< a hash of the file's bytes
    bool is_picture = false; ///< if not, rows
    LabReference against;
    Settings reference;        ///< of `against`, at the size of the picture
    std::string compared_with; ///< "the picture of lab-room"
};

/// A picture that is being checked.
struct LabCheck {
    LabSubject subject; ///< its scene must outlive the work
    std::unique_ptr<DiagnosisWork> work;
    double seconds = 0.0;    ///< of work so far
    bool is_stopped = false; ///< the search has ended: what was found is examined
};

/// The result of checking a file, as it is shown.
struct LabAnswer {
    LabSubject subject;
    Diagnosis diagnosis;
};

/// What the bug laboratory keeps from one frame to the next.
struct LabLook {
    std::vector<Bug> bugs; ///< read when the laboratory is first opened
    std::string fault;     ///< why they could not be read
    bool is_read = false;
    std::string chosen; ///< id of the bug that is described
    std::string was_on; ///< id of the bug that was on when the list was last drawn; empty: none
    /// The bug, and the screen line, for which the list was last scrolled.
    std::string in_sight;
    float bottom = 0.0f;
    std::shared_ptr<MarkdownPage> page;
    LabMode mode = LabMode::bugs;
    int seed = 0;             ///< of the next quiz; 0: the program takes one
    bool wants_two = false;   ///< the next quiz hides two mistakes
    std::string result_path;  ///< of the student's own result, as typed
    std::string watched_path; ///< of the result last asked for: it is watched
    FileState watched;        ///< that file, when it was last checked
    LabReference reference;   ///< the one last requested
    int frames_to_result = 0; ///< it is diagnosed when this falls to 0 from 1; until then it waits
    std::string result_fault; ///< why the file in its current state could not be diagnosed
    bool is_given_up = false; ///< a check was given up after the current answer
    std::optional<LabCheck> check; ///< while it is running
    /// Of the watched file, perhaps an earlier state of it; stays until there is a new one.
    std::optional<LabAnswer> answer;
    std::shared_ptr<MarkdownPage> remedy; ///< what is said about the likely mistakes
    LabPictures pictures;                 ///< of a picture that was diagnosed
};

} // namespace rasterwalk
