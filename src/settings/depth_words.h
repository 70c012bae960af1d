#pragma once

// What the depth buffer holds, by name. Every text that says so takes the name from here.

#include <string_view>

#include "settings/settings.h"

namespace rasterwalk {

/// What is said about a depth.
struct DepthWords {
    ClipDepth kind;
    std::string_view name;       ///< "1/z"
    std::string_view short_name; ///< for the head of a narrow column
    std::string_view ends;       ///< what it is, and which of two is nearer; a sentence
    std::string_view nearer;     ///< "larger": what the nearer of two is
    std::string_view farther;    ///< "smaller"
};

/// The words of a kind of depth.
const DepthWords& depth_words(ClipDepth kind);

/// The words of what the depth buffer holds under these settings.
const DepthWords& depth_words(const Settings& settings, SceneSpace space);

} // namespace rasterwalk
