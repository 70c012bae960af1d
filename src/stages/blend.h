#pragma once

// Blending: a half-transparent fragment is laid over what its pixel shows.
//
// In:  the colour of a fragment, its alpha, and the colour that the pixel has.
// Out: the pixel's new colour.
// Picture: tinted glass in front of a wall. Of the light that reaches the eye the part alpha comes
//          from the glass and the rest, 1 - alpha, from the wall behind it.
//
//     new = alpha * fragment + (1 - alpha) * pixel
//
// Colours are not premultiplied: the fragment has its colour as if it were opaque. Light adds up in
// linear channels, as here, not in the encoded ones of an image file.
//
// The order counts: red glass over blue glass is a different colour from blue over red. So what is
// behind must be drawn first. The depth buffer does not help. A pane writes its depth like a wall,
// and hides anything behind it that is drawn later.
//
// The classic mistakes are the two shares the wrong way round, and triangles that share an edge and
// both draw it: at alpha 1/2 that edge is covered by 3/4.
//
// Source: T. Porter and T. Duff, "Compositing Digital Images", Computer Graphics 18(3), SIGGRAPH
// 1984: the operator over.

#include <glm/vec3.hpp>

namespace rasterwalk {

/// A fragment over what its pixel shows.
/// @param alpha of the fragment, 0 (clear) to 1 (opaque)
inline glm::vec3 blend_over(const glm::vec3& fragment, float alpha, const glm::vec3& pixel) {
    return fragment * alpha + pixel * (1.0f - alpha);
}

/// No blending: the fragment takes the place of what was there, as in the lab.
inline glm::vec3 blend_nothing(const glm::vec3& fragment, float, const glm::vec3&) {
    return fragment;
}

} // namespace rasterwalk
