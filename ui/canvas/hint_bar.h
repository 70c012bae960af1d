#pragma once

// What there is to say of the picture of a model, with the setting that shows more of it.

#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace rasterwalk {

struct Ui;

/// Hints that the student does not want to see any more.
struct HiddenHints {
    std::weak_ptr<const Scene> scene; ///< of which they were
    std::vector<std::string> acts;    ///< see SeenHint
};

/// A line above the picture with the first of the hints, a button that sets what it names, and one
/// that hides it; nothing where there is none, or where the settings are what is asked for.
void draw_hint_bar(Ui& ui);

} // namespace rasterwalk
