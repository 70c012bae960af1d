#include "settings/choose_stages.h"

#include "settings/stage_functions.h"

namespace rasterwalk {

namespace {

Stages chosen_stages(const Settings& settings, const Scene* scene) {
    Stages stages;
    for (const StageFunction& row : stage_functions()) {
        if (is_chosen(row, settings, scene)) row.does.put(stages, settings, scene);
    }
    return stages;
}

} // namespace

Stages choose_stages(const Settings& settings) {
    return chosen_stages(settings, nullptr);
}

Stages choose_stages(const Settings& settings, const Scene& scene) {
    return chosen_stages(settings, &scene);
}

} // namespace rasterwalk
