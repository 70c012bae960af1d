#pragma once

// The name of what the depth buffer holds. Every text that mentions it uses the name from here.

#include <string_view>

#include "settings/settings.h"

namespace rasterwalk {

/// The words for a kind of depth.
struct DepthWords {
    ClipDepth kind;
    std::string_view name;       ///< "1/z"
    std::string_view short_name; ///< for the head of a narrow column
    std::string_view ends;       ///< a sentence: what it is, and which of two is nearer
    std::string_view nearer;     ///< "larger": which of two is nearer
    std::string_view farther;    ///< "smaller"
};

/// The words for a kind of depth.
const DepthWords& depth_words(ClipDepth kind);

/// The words for what the depth buffer holds under these settings.
const DepthWords& depth_words(const Settings& settings, SceneSpace space);

} // namespace rasterwalk
