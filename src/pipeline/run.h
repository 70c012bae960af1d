#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "settings/settings.h"

namespace rasterwalk {

/// What draws a picture.
enum class Engine : std::uint8_t {
    steps, ///< this pipeline: every moment of it can be walked
};

/// The engines' words, indexed by Engine.
inline constexpr std::array<std::string_view, 1> engine_words{"steps"};
static_assert(engine_words.size() == static_cast<std::size_t>(Engine::steps) + 1);

/// One way to draw a scene: by which engine, and with which settings.
struct Run {
    Engine engine = Engine::steps;
    Settings settings;

    friend bool operator==(const Run&, const Run&) = default;
};

} // namespace rasterwalk
