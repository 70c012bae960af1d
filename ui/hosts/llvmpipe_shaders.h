#pragma once

#include "engines/workload.h"
#include "scene/scene.h"
#include "ui/hosts/opengl_program.h"

namespace rasterwalk {

/// What need not be computed at each pixel of a surface.
struct SurfaceFacts {
    bool is_flat = true;        ///< all corners of a triangle have one normal
    bool has_one_colour = true; ///< the whole scene has one reflectance
};

SurfaceFacts surface_facts(const Scene& scene);

/// The shaders of a workload.
///
/// They compute R = reflectance (power max(r^ . n^, 0) / (4 pi r^2) + indirect), as
/// stages/light.h does, in the cheapest way that the scene allows: on a flat triangle r . n is the
/// same everywhere, so it is computed at its corners; one colour is a uniform.
/// Attributes: 0 `position`, 1 `normal`, 2 `reflectance` unless there is one colour.
ShaderTexts shader_texts(Workload workload, const SurfaceFacts& facts);

} // namespace rasterwalk
