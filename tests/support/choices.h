#pragma once

// Settings under which tests compare texts with what is drawn: each value of each setting alone,
// and many together.

#include <string>
#include <vector>

#include "scene/scene.h"
#include "settings/settings.h"
#include "support/random.h"

namespace rasterwalk::test {

/// Settings, and which they are.
struct Choice {
    std::string name;
    Settings settings;
};

/// A scene of the lessons: "cylinder".
Scene lesson_scene(const std::string& name);

/// The scene's own settings in a picture of 60 pixels a side, up to stage `shade`, with one value
/// of one setting: every word of those that the scene can use, and of numbers the smallest and the
/// largest.
/// @param base one more assignment, which comes first: "shading=gouraud"
std::vector<Choice> single_choices(const Scene& scene, const std::string& base);

/// The same with several values at once, each a setting's own, by chance.
std::vector<Choice> mixed_choices(const Scene& scene, const std::string& base, int count,
                                  Random& random);

} // namespace rasterwalk::test
