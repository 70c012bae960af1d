#pragma once

#include <optional>
#include <string_view>

#include "explain/fragment_report.h"

namespace rasterwalk {

struct Ui;

// The parts of the fragment's panel; see fragment_panel.cpp. There must be a fragment.

/// The report on the fragment shown.
const FragmentReport& report_of(const Ui& ui);

/// Remembers which number is asked about, or goes to where it comes from.
void follow_source(Ui& ui, const std::optional<Source>& source);

/// The report's formulas of a section, a line for each.
void draw_fragment_section(Ui& ui, std::string_view section);

/// The table of all values that the fragment carries, affine and perspective-correct. Clicking one
/// asks about it.
void draw_fragment_values(Ui& ui);

/// Is the light of the vertices shown, as the lighting in force or as the alternative?
bool shows_vertex_light(const Ui& ui);

/// If there is a shadow map, its six faces in the order of their passes, with the texels that were
/// compared.
void draw_shadow_faces(Ui& ui, const ShadowTerms& shadow);

/// The light term by term, of the lighting in force or the alternative.
void draw_fragment_light(Ui& ui);

} // namespace rasterwalk
