#include "ui/actions/lab.h"

#include <algorithm>
#include <chrono>
#include <functional>

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

/// What a picture is compared with; says so if the size is not that of the scene.
std::string picture_words(const LabReference& against, Viewport size) {
    const std::string what =
        "the picture of " + against.scene->name +
        (against.is_set ? " with the current camera, light and stage" : " as the handout draws it");
    const Viewport usual = against.settings.viewport;
    if (size == usual) return what + ", " + size_words(usual) + " pixels like yours";
    return what + ", drawn at the size of yours: " + size_words(size) + " pixels instead of " +
           size_words(usual);
}

/// Keeps the two pictures shown side by side: the student's, and one of where it is wrong.
void keep_pictures(LabLook& lab, const DiagnosisWork& work) {
    LabPictures& pictures = lab.pictures;
    pictures.own = work.picture();
    pictures.right = work.right_picture();
    // Opacity is ignored: a picture that claims to be transparent is shown too.
    for (std::size_t i = 3; i < pictures.own.rgba.size(); i += 4)
        pictures.own.rgba[i] = 255;
    ++pictures.number;
}

} // namespace

std::shared_ptr<const Scene> usual_room(const Session& session) {
    Scene room = read_scene_file(lessons_folder() + "/" + std::string(usual_scene));
    return *session.scene == room ? session.scene : std::make_shared<const Scene>(std::move(room));
}

namespace {

/// What a result is compared with now.
LabReference chosen_reference(const Session& session, bool what_is_set) {
    LabReference reference{what_is_set, session.scene, with_handout_rules(session.a.settings)};
    if (what_is_set) return reference;
    reference.scene = usual_room(session); // nothing left behind by a lesson counts
    reference.settings = default_settings(*reference.scene);
    return reference;
}

/// Is this what is being checked, or what was answered?
bool is_known(const LabLook& lab, const LabSubject& subject) {
    const LabSubject* const last = lab.check    ? &lab.check->subject
                                   : lab.answer ? &lab.answer->subject
                                                : nullptr;
    return last != nullptr && last->bytes == subject.bytes &&
           last->against.is_set == subject.against.is_set;
}

/// Reads the watched file, and begins to check it; rows are answered immediately. Throws Error; any
/// check in progress then goes on.
/// @param again the file may be unchanged: then nothing is begun
void begin_check(Ui& ui, bool again) {
    LabLook& lab = ui.lab;
    const std::string& path = lab.watched_path;
    refuse_endless_file(path);
    LabSubject subject;
    subject.is_picture = is_image_file(path);
    const std::string bytes =
        subject.is_picture ? read_file(path, largest_image_file) : read_file(path);
    subject.bytes = std::hash<std::string>()(bytes);
    subject.against = lab.reference;
    subject.reference = lab.reference.settings;
    lab.is_given_up = false;
    if (again && is_known(lab, subject)) return;
    const Scene& scene = *subject.against.scene;
    if (subject.is_picture) {
        Image picture = parse_exact_image(bytes, path);
        subject.reference = fitted_to(subject.reference, picture, scene.space);
        subject.compared_with = picture_words(subject.against, subject.reference.viewport);
        auto work = std::make_unique<DiagnosisWork>(std::move(picture), path, scene,
                                                    subject.reference, lab_bugs(ui));
        lab.check = std::nullopt; // the old work goes before its scene
        lab.check.emplace(LabCheck{std::move(subject), std::move(work)});
    } else {
        const std::vector<PrintedRow> rows = parse_printed_rows(bytes, path);
        std::string about;
        Diagnosis found = diagnose_rows(rows, {}, scene, subject.reference, lab_bugs(ui), about);
        subject.compared_with = "the row table of " + about;
        lab.check = std::nullopt;
        lab.answer.emplace(LabAnswer{std::move(subject), std::move(found)});
    }
}

void poll_check(LabLook& lab, const WorkLimit& limit) {
    LabCheck& check = *lab.check;
    const auto begin = std::chrono::steady_clock::now();
    check.work->advance(limit);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    check.seconds += passed.count();
    if (check.work->is_done()) {
        keep_pictures(lab, *check.work);
        lab.answer.emplace(LabAnswer{check.subject, check.work->found()});
        lab.check = std::nullopt;
    } else if (check.seconds > longest_search && !check.is_stopped) {
        check.is_stopped = true;
        check.work->stop_searching();
    }
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
    const std::shared_ptr<const Scene> scene = ui.lab.answer->subject.against.scene;
    const Settings& reference = ui.lab.answer->subject.reference;
    if (before_scene != scene) show_scene(session, scene);
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
    // Any number will do, as long as it is not the same each time.
    if (lab.seed == 0) lab.seed = 1000 + ImGui::GetFrameCount() * 37 % 9000;
    const auto seed = static_cast<std::uint32_t>(lab.seed);
    if (!start_quiz(ui.session, lab_bugs(ui), seed, lab.wants_two ? 2 : 1)) {
        ui.session.notice = "None of the mistakes shows in this scene. Open the room instead.";
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

/// Asks for the file to be checked, after a frame that says that it may take a while.
void request_check(Ui& ui, const std::string& path, bool against_set) {
    LabLook& lab = ui.lab;
    give_up_diagnosis(ui);
    if (path != lab.watched_path) lab.answer = std::nullopt;
    lab.mode = LabMode::result;
    open_tab(ui, "lab");
    lab.result_path = lab.watched_path = path;
    lab.reference.is_set = against_set;
    lab.result_fault.clear();
    lab.frames_to_result = 2;
}

} // namespace

void diagnose_file(Ui& ui, const std::string& path) {
    request_check(ui, path, false);
}

void compare_result_with(Ui& ui, bool what_is_set) {
    request_check(ui, ui.lab.watched_path, what_is_set);
}

void poll_diagnosis(Ui& ui, const WorkLimit& limit) {
    LabLook& lab = ui.lab;
    const bool begins = lab.frames_to_result > 0 && --lab.frames_to_result == 0;
    const bool reads = begins || result_was_edited(ui);
    if (!reads && !lab.check) return;
    try {
        if (reads) {
            lab.result_fault.clear();
            lab.watched = file_state(lab.watched_path);
            // The answer takes the place of the question: in sight, and scrolled by the keys.
            if (begins) give_focus(ui, "lab.mode.result");
            if (begins || lab.reference.scene == nullptr)
                lab.reference = chosen_reference(ui.session, lab.reference.is_set);
            begin_check(ui, !begins);
        } else {
            poll_check(lab, limit);
        }
    } catch (const Error& fault) {
        lab.result_fault = fault.what();
        // If a file cannot be read now, what was read before can still be answered.
        if (!reads) lab.check = std::nullopt;
    } catch (...) { // what had no room cannot go on
        lab.check = std::nullopt;
        throw;
    }
}

void stop_diagnosis(Ui& ui) {
    LabLook& lab = ui.lab;
    if (!lab.check || lab.check->is_stopped) {
        give_up_diagnosis(ui);
        return;
    }
    lab.check->is_stopped = true;
    lab.check->work->stop_searching();
}

void give_up_diagnosis(Ui& ui) {
    LabLook& lab = ui.lab;
    lab.is_given_up = lab.answer && is_diagnosing(ui);
    lab.frames_to_result = 0;
    lab.check = std::nullopt;
    // When the file changes, it is compared with the same reference as before.
    if (lab.answer) lab.reference = lab.answer->subject.against;
}

bool result_was_edited(const Ui& ui) {
    const LabLook& lab = ui.lab;
    const bool is_shown = ui.session.tab == "lab" && lab.mode == LabMode::result;
    return is_shown && !lab.watched_path.empty() && lab.frames_to_result == 0 &&
           file_state(lab.watched_path) != lab.watched;
}

bool is_diagnosing(const Ui& ui) {
    return ui.lab.frames_to_result > 0 || ui.lab.check.has_value();
}

} // namespace rasterwalk
