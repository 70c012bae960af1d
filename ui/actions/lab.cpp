#include "ui/actions/lab.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "laboratory/diagnose.h"
#include "laboratory/quiz.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "session/second_run.h"
#include "ui/actions/actions.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"

namespace rasterwalk {

namespace {

std::string size_words(Viewport size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// What a picture is held against: another size than that of the scene is said.
/// @param drawn_by the settings of the reference, before it took the size of the picture
std::string picture_words(const LabLook& lab, const Settings& drawn_by) {
    const std::string what =
        "the picture of " + lab.compared_scene->name +
        (lab.holds_against_set ? " with the camera, light and stage that are set"
                               : " as the handout draws it");
    const Viewport usual = drawn_by.viewport, size = lab.reference.viewport;
    if (size == usual) return what + ", " + size_words(usual) + " pixels like yours";
    return what + ", drawn anew in the size of yours: " + size_words(size) + " pixels instead of " +
           size_words(usual);
}

/// Keeps what is shown side by side: the student's picture, and where it is not the right one.
void keep_pictures(LabLook& lab, const DiagnosisWork& work) {
    LabPictures& pictures = lab.pictures;
    pictures.own = work.picture();
    pictures.right = work.right_picture();
    // Opacity is not looked at: a picture that says it is transparent is shown, too.
    for (std::size_t i = 3; i < pictures.own.rgba.size(); i += 4)
        pictures.own.rgba[i] = 255;
    ++pictures.number;
}

/// Decides what a result is held against.
void choose_reference(Ui& ui) {
    LabLook& lab = ui.lab;
    const Session& session = ui.session;
    lab.compared_scene = session.scene;
    lab.reference = with_handout_rules(session.a.settings);
    if (lab.holds_against_set) return;
    // Of what a lesson has left behind nothing counts.
    Scene room = read_scene_file(lessons_folder() + "/" + std::string(usual_scene));
    if (!(*session.scene == room))
        lab.compared_scene = std::make_shared<const Scene>(std::move(room));
    lab.reference = default_settings(*lab.compared_scene);
}

void begin_picture(Ui& ui, const std::string& path) {
    LabLook& lab = ui.lab;
    Image picture = parse_exact_image(read_file(path, largest_image_file), path);
    const Settings usual = lab.reference;
    lab.reference = fitted_to(usual, picture, lab.compared_scene->space);
    lab.held_against = picture_words(lab, usual);
    lab.work = std::make_unique<DiagnosisWork>(std::move(picture), path, *lab.compared_scene,
                                               lab.reference, lab_bugs(ui));
}

void diagnose_rows_file(Ui& ui, const std::string& path) {
    LabLook& lab = ui.lab;
    const std::vector<PrintedRow> rows = parse_printed_rows(read_file(path), path);
    std::string about;
    lab.diagnosis =
        diagnose_rows(rows, {}, *lab.compared_scene, lab.reference, lab_bugs(ui), about);
    lab.held_against = "the row table of " + about;
}

} // namespace

const std::vector<Bug>& lab_bugs(Ui& ui) {
    LabLook& lab = ui.lab;
    if (!lab.is_read) {
        lab.is_read = true;
        try {
            lab.bugs = read_bugs();
        } catch (const Error& fault) {
            lab.fault = fault.what();
        }
        if (!lab.bugs.empty()) lab.chosen = lab.bugs.front().id;
    }
    return lab.bugs;
}

void turn_on(Ui& ui, const Bug& bug, bool on_its_scene) {
    if (refuses_settings(ui.session)) return;
    try {
        if (on_its_scene) {
            open_bug(bug, ui.session);
        } else {
            apply_bug(bug, ui.session);
        }
        ui.session.notice.clear();
        ui.lab.chosen = bug.id;
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
}

void show_candidate(Ui& ui, const Bug& bug, const Candidate& candidate) {
    Session& session = ui.session;
    if (refuses_settings(session)) return;
    end_comparison(session);
    const Run before = session.a;
    const std::shared_ptr<const Scene> before_scene = session.scene;
    const Settings& reference = ui.lab.reference;
    if (before_scene != ui.lab.compared_scene) show_scene(session, ui.lab.compared_scene);
    const bool is_drawn = candidate.recipe.has_value();
    show_bug(bug.id, is_drawn ? candidate.recipe->settings : wrong_run(bug, reference),
             is_drawn ? candidate.right.value_or(reference) : correct_run(bug, reference), session);
    session.replaced->before = before;
    if (session.scene != before_scene) session.replaced->before_scene = before_scene;
    session.notice.clear();
    ui.lab.chosen = bug.id;
}

void begin_quiz(Ui& ui) {
    LabLook& lab = ui.lab;
    // Any number will do: it only must not be the same each time.
    if (lab.seed == 0) lab.seed = 1000 + ImGui::GetFrameCount() * 37 % 9000;
    const auto seed = static_cast<std::uint32_t>(lab.seed);
    if (!start_quiz(ui.session, lab_bugs(ui), seed, lab.wants_two ? 2 : 1)) {
        ui.session.notice = "None of the mistakes shows in this scene: open the room.";
        return;
    }
    ui.session.notice.clear();
    lab.chosen.clear();
}

void finish_quiz(Ui& ui) {
    if (!ui.session.quiz) return;
    if (is_over(*ui.session.quiz)) {
        ui.options.score.rounds = std::min(ui.options.score.rounds + 1, largest_score);
        ui.options.score.points =
            std::min(ui.options.score.points + score(*ui.session.quiz), largest_score);
    }
    end_quiz(ui.session);
    ui.lab.seed = 0;
}

namespace {

void begin_check(Ui& ui, const std::string& path, bool against_set) {
    LabLook& lab = ui.lab;
    lab.holds_against_set = against_set;
    stop_diagnosis(ui);
    lab.mode = LabMode::result;
    open_tab(ui, "lab");
    lab.result_path = lab.checked_path = path;
    lab.diagnosis = std::nullopt;
    lab.result_fault.clear();
    // The frame before says that it may take a while.
    lab.frames_to_result = 2;
}

} // namespace

void diagnose_file(Ui& ui, const std::string& path) {
    begin_check(ui, path, false);
}

void hold_result_against(Ui& ui, bool what_is_set) {
    begin_check(ui, ui.lab.checked_path, what_is_set);
}

void carry_on_diagnosis(Ui& ui, const WorkLimit& limit) {
    LabLook& lab = ui.lab;
    const bool begins = lab.frames_to_result > 0 && --lab.frames_to_result == 0;
    if (!begins && lab.work == nullptr) return;
    try {
        if (begins) {
            const std::string path = lab.checked_path;
            // The answer takes the place of the question: in sight, and scrolled by keys.
            give_focus(ui, "lab.mode.result");
            refuse_endless_file(path);
            choose_reference(ui);
            lab.is_picture = is_image_file(path);
            lab.is_picture ? begin_picture(ui, path) : diagnose_rows_file(ui, path);
        } else {
            lab.work->advance(limit);
            if (!lab.work->is_done()) return;
            lab.diagnosis = lab.work->found();
            keep_pictures(lab, *lab.work);
            lab.work = nullptr;
        }
    } catch (const Error& fault) {
        lab.result_fault = fault.what();
        lab.work = nullptr;
    } catch (...) { // what had no room cannot go on
        lab.work = nullptr;
        throw;
    }
}

void stop_diagnosis(Ui& ui) {
    ui.lab.frames_to_result = 0;
    ui.lab.work = nullptr;
}

bool is_diagnosing(const Ui& ui) {
    return ui.lab.frames_to_result > 0 || ui.lab.work != nullptr;
}

} // namespace rasterwalk
