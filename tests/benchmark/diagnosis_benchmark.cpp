#include "diagnosis_benchmark.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "laboratory/bug_rule.h"
#include "laboratory/diagnose.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"

namespace rasterwalk {

void print_diagnosis_times(const std::vector<std::string>& names) {
    const Scene scene = read_scene(lessons_folder() + "/" + std::string(usual_scene));
    const Settings reference = default_settings(scene);
    const std::vector<Bug> bugs = read_bugs();
    const auto picture_by = [&](const Settings& settings) {
        return view_image(draw_frame(prepare_frame(scene, settings)), View::colour);
    };
    double longest = 0.0;
    for (const Bug& bug : bugs) {
        if (!names.empty() && std::find(names.begin(), names.end(), bug.id) == names.end())
            continue;
        Settings wrong = correct_run(bug, reference);
        wrong.camera = reference.camera;
        const Image right = picture_by(wrong);
        apply_bug_rule(bug, wrong);
        if (differences_of(picture_by(wrong), right).pixels == 0) continue;
        const std::clock_t start = std::clock();
        const Diagnosis found = diagnose_picture(picture_by(wrong), scene, reference, bugs);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        const std::vector<std::string> ids =
            found.candidates.empty() ? std::vector<std::string>{} : found.candidates.front().ids();
        const bool is_named = std::find(ids.begin(), ids.end(), bug.id) != ids.end();
        std::printf("%-5s %5.1f s %s\n", bug.id.c_str(), seconds, is_named ? "named" : "");
        longest = std::max(longest, seconds);
    }
    std::printf("longest %.1f s\n", longest);
}

} // namespace rasterwalk
