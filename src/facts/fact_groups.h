#pragma once

// The groups of the table of facts, one for each subject.

#include <vector>

#include "facts/fact_values.h"
#include "facts/facts.h"

namespace rasterwalk {

// In frame_facts.cpp:
/// The moment: what comes next.
void add_cursor_facts(std::vector<Fact>& table);
/// The results of edge functions for the pixel that comes next.
void add_test_facts(std::vector<Fact>& table);
/// What is selected, and what is shown.
void add_session_facts(std::vector<Fact>& table);
/// The whole frame in numbers.
void add_frame_facts(std::vector<Fact>& table);
/// The contents of the open model file.
void add_model_facts(std::vector<Fact>& table);

// In triangle_facts.cpp, for the triangle shown:
/// Where it is, and which side it shows.
void add_side_facts(std::vector<Fact>& table);
/// What clipping and culling do to it.
void add_clip_facts(std::vector<Fact>& table);
/// The polygon of the scene that it belongs to.
void add_outline_facts(std::vector<Fact>& table);
/// The edge that it shares with a neighbour.
void add_shared_edge_facts(std::vector<Fact>& table);
/// Its selected vertex.
void add_vertex_facts(std::vector<Fact>& table);

// In light_facts.cpp:
/// The light of the picked pixel, term by term.
void add_light_facts(std::vector<Fact>& table);

// In shadow_facts.cpp:
/// What is in shadow: the picked pixel, the part shown, the whole picture.
void add_shadow_facts(std::vector<Fact>& table);

// In fragment_facts.cpp:
/// The picked pixel.
void add_pixel_facts(std::vector<Fact>& table);
/// The row table of the triangle shown.
void add_table_facts(std::vector<Fact>& table);

// In compare_facts.cpp:
/// Two runs, and how they differ.
void add_compare_facts(std::vector<Fact>& table);

/// The most corners of a triangle after all planes, each of which can add one.
inline constexpr int most_polygon_corners = triangle_corners + static_cast<int>(clip_plane_count);

/// Ndc z of a depth in front of run A's camera; none in a scene in pixels.
Value z_ndc(const Facts& facts, float z);

} // namespace rasterwalk
