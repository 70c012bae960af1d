#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "session/ladder_run.h"

namespace rasterwalk {

struct Ui;

// The parts of the Speed tab; see speed_panel.cpp. The index of a rung is its place for rung_at().

/// "9.83 ms", "41.8 ms", "120 ms".
std::string milliseconds_text(double milliseconds);

/// Is a rung slower than the one before? What rounds to "× 1.0" is not.
/// @param ratio of the time before to its own
bool is_slower(double ratio);

/// How many times as fast: "× 2.5", or, if it is slower, "÷ 1.4".
/// @param ratio of the time before to its own
std::string gain_text(double ratio);

/// Whether a rung draws the same picture, in words.
struct PictureWords {
    std::string sign;               ///< ✓, ~ or ✗; empty: not known yet
    std::vector<std::string> forms; ///< the longest first
    bool is_wrong = false;
};
PictureWords picture_words(const LadderTimes& times, std::size_t index);

/// The scale of milliseconds above the bars. Nothing before there are times.
void draw_time_scale(Ui& ui, const LadderTimes& times);

/// A rung: its title, its time, and what it gained as a bar. A click explains it.
void draw_rung(Ui& ui, const LadderTimes& times, std::size_t index);

/// What all rungs gained together. Nothing before all are measured.
void draw_all_rungs(Ui& ui, const LadderTimes& times);

/// What the chosen rung changes, why that helps, and its times in all rounds.
void draw_rung_card(Ui& ui, const LadderTimes& times);

} // namespace rasterwalk
