#pragma once

// Samples: several points of a pixel instead of its centre, for smooth edges.
//
// In:  a polygon on the screen; later the colours of a pixel's samples.
// Out: which of the samples the polygon covers; and from their colours the pixel's.
// Picture: a pixel is a small window. One look through its middle sees the wall or the sky, and
//          edges become stairs. Four looks see three parts of wall and one of sky.
//
// Multisampling tests coverage and depth at each of the four samples, and stores a colour and a
// depth for each. The pixel shader runs only once per fragment, at the pixel's centre, and its
// colour goes to all samples that are covered and pass. So edges become smooth, also those where
// surfaces cross, and whatever the shader computes within a surface stays as it was. Supersampling
// runs the shader at each sample: four times the work, and textures and highlights become smooth as
// well. It is the picture at twice the size, made smaller.
//
// Multisampling places its samples on a rotated grid, on which no two have the same column or row:
// an edge that is nearly level or upright has four steps in a pixel, where a square grid has two.
//
// At the end each pixel is resolved: it gets the mean of its samples. Each is clamped to what the
// screen can show first. A highlight of 5 on one sample would otherwise outweigh three dark ones:
// the mean is above 1, the pixel as white as its neighbour, and the edge as jagged as before.
//
// The centre of a pixel may lie outside a polygon that covers one of its samples. What the fragment
// carries to the shader is then extrapolated beyond the edge: a colour can fall below 0, a position
// lie off the wall, a place in a texture beyond its border. Hardware offers centroid sampling as a
// cure. The other classic mistakes are to clamp only the mean, and to test all samples with one
// depth: then the edges where surfaces cross stay jagged.
//
// Source: K. Akeley, "RealityEngine Graphics", SIGGRAPH 1993: samples, one colour per fragment, and
// the resolve. Supersampling: F. C. Crow, "The Aliasing Problem in Computer-Generated Shaded
// Images", Communications of the ACM 20(11), 1977. The rotated grid: Microsoft, Direct3D 11.3
// Functional Specification, section 19.2.4, standard sample pattern of four samples.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "stages/edge_functions.h"
#include "stages/fragment.h"
#include "stages/polygon_rows.h"
#include "stages/put_pixel.h"
#include "stages/sample_list.h"
#include "stages/snap.h"

namespace rasterwalk {

/// In the slot sample_place: where a sample of a pixel is, from the pixel's centre, on a rotated
/// grid: (-1, -3), (3, -1), (-3, 1) and (1, 3) eighths of a pixel.
/// @param sample 0 to sample_count - 1
GridPoint rotated_grid(int sample);

/// In the slot sample_place: on a square grid, a quarter of a pixel from the centre along each
/// axis, row by row: the centres of the pixels of a picture twice as large.
GridPoint square_grid(int sample);

/// The slot fragment_at_sample: what is tested for depth at a sample is the fragment's value there.
/// @param at_centre the fragment as it is shaded
/// @param at_sample the same polygon's depth, 1/w and z at the sample
inline const Fragment& own_fragment(const Fragment&, const Fragment& at_sample) {
    return at_sample;
}

/// The slot resolve: the mean of the samples, each of them clamped to 0..1 first.
/// @param colours of the samples, not clamped
glm::vec3 mean_of_clamped(const SampleColours& colours);

/// The slot compute_polygon_rows for pixels with samples: from the first to the last pixel of each
/// row that has a sample inside, and in PolygonRows::samples which samples those are. Between them
/// there can be pixels without any, in a thin polygon that is nearly level. The samples are found
/// one at a time, each as if it were its pixel's centre.
/// @param find_rows the coverage, which must heed EdgeRules::sample
void find_sample_rows(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                      PolygonRows& rows, SampleSink* sink,
                      decltype(&rows_by_edge_functions) find_rows);

/// The same with a coverage of its own.
template <auto find_rows>
void rows_of_samples(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                     PolygonRows& rows, SampleSink* sink) {
    find_sample_rows(vertices, rules, stages, rows, sink, find_rows);
}

/// Which samples of a pixel the polygon covers.
/// @param index  of the row in the table, 0 <= index < rows.size()
/// @param column of the picture
SampleMask covered_samples(const PolygonRows& rows, int index, int column);

/// Do the pixels of these stages have samples?
bool has_samples(const Stages& stages);

} // namespace rasterwalk
