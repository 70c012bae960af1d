#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
    result, ///< a result of the student's own, and what may be wrong with it
};

/// The student's picture, and the one that it is held against.
struct LabPictures {
    Image own;
    Image right;
    std::uint64_t number = 0;            ///< of both; grows with each diagnosis
    std::array<PictureTexture, 2> small; ///< as they are shown
};

/// What the bug laboratory keeps from one frame to the next.
struct LabLook {
    std::vector<Bug> bugs; ///< read when the laboratory is opened first
    std::string fault;     ///< why they could not be read
    bool is_read = false;
    std::string chosen; ///< id of the bug that is described
    std::string was_on; ///< id of the bug that was on when the list was last drawn; empty: none
    /// For which bug, and down to which screen line, the list was scrolled last.
    std::string in_sight;
    float bottom = 0.0f;
    std::shared_ptr<MarkdownPage> page;
    LabMode mode = LabMode::bugs;
    int seed = 0;                   ///< of the next quiz; 0: the program takes one
    bool wants_two = false;         ///< the next quiz hides two mistakes
    std::string result_path;        ///< of the student's own result, as it is typed
    std::string checked_path;       ///< of the result that was checked last
    bool holds_against_set = false; ///< a result: against what is set, else what the handout draws
    int frames_to_result = 0; ///< it is diagnosed when this falls to 0 from 1; until then it waits
    std::string result_fault; ///< why it could not be diagnosed
    std::unique_ptr<DiagnosisWork> work; ///< of a picture, as long as it goes on; null: none does
    std::string held_against;            ///< "the picture of lab-room"
    bool is_picture = false;             ///< what was held against it; else rows
    std::optional<Diagnosis> diagnosis;
    std::shared_ptr<MarkdownPage> remedy; ///< what is said of the likely mistake
    /// What a result was held against, so that a mistake is shown on the very same.
    std::shared_ptr<const Scene> compared_scene;
    Settings reference;
    LabPictures pictures; ///< of a picture that was diagnosed
};

} // namespace rasterwalk
