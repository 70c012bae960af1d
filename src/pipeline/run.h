#pragma once

#include "settings/settings.h"

namespace rasterwalk {

/// One way to draw a scene.
struct Run {
    Settings settings;

    friend bool operator==(const Run&, const Run&) = default;
};

} // namespace rasterwalk
