#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <imgui.h>

#include "ui/app/options_state.h"
#include "ui/widgets/widget_state.h"

namespace rasterwalk {

struct Ui;
enum class VectorName : std::uint8_t;

/// What a colour means; each meaning has one colour everywhere (Okabe and Ito's set, which the
/// colour-blind tell apart), in a tone that can be read on the theme's background. Only clipping
/// makes more than three edges: their colours lie as far from all others as they can.
enum class Meaning : std::uint8_t {
    edge_1,
    edge_2,
    edge_3,
    edge_4,
    edge_5,
    edge_6,
    edge_7,
    edge_8,
    edge_9,
    left_end,
    right_end,
    current,
    pass,
    fail,
};

/// The quiet colours of the interface.
struct Palette {
    ImVec4 ground; ///< behind everything
    ImVec4 bar;    ///< menu, transport
    ImVec4 card;   ///< boxes on the background
    ImVec4 canvas; ///< around the picture
    ImVec4 line;   ///< borders and rules
    ImVec4 button;
    ImVec4 button_hovered;
    ImVec4 accent; ///< the main action
    ImVec4 accent_text;
    ImVec4 text;
    ImVec4 dim; ///< text that may be overlooked; still 4.5 : 1
    ImVec4 link;
    ImVec4 row_lit; ///< a table's row that is pointed at or current
    ImVec4 chosen;  ///< behind the chosen one of several segments; quieter than the main action
    ImVec4 changed; ///< a setting that differs from the preset
};

const Palette& palette(Theme theme);

/// The colour of a meaning, for text and lines on the theme's background.
ImVec4 colour_of(Meaning meaning, Theme theme);

/// Edges with a separate colour: at most as many as six planes can make of a triangle.
inline constexpr int edge_colour_count = 9;

/// The meaning of an edge, from 0. Beyond edge_colour_count they repeat.
Meaning edge_meaning(int edge);

/// The meaning of a vector's colour, one for each letter. Nothing shows t and u at once, and u is
/// edge 0 of its triangle; so is l the lamp's.
Meaning vector_meaning(VectorName name);

/// The colour with a given opacity, as draw lists need it.
ImU32 packed(const ImVec4& colour, float opacity = 1.0f);

/// Are dark letters more readable than light ones on this background? The better of the two has a
/// contrast of at least 4.5 : 1.
bool has_dark_ink(const glm::vec<3, std::uint8_t>& ground);

/// Sets ImGui's colours and spacing for the theme and text scale.
void apply_style(const UiOptions& options);

/// Text sizes: the smallest and largest scale, and the step of A+ and A-.
inline constexpr float smallest_text_scale = 0.75f;
inline constexpr float largest_text_scale = 2.5f;
inline constexpr float text_scale_step = 0.125f;

} // namespace rasterwalk
