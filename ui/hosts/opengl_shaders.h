#pragma once

#include "engines/fast/fast_data.h"
#include "ui/hosts/opengl_program.h"

namespace rasterwalk {

/// The shaders that draw an OpenGlTask: attributes are the members of OpenGlCorner, outputs are
/// colour, 1/z and owner. Light is computed as in stages/light.h and stages/highlight.h, and bytes
/// are cut off as in stages/put_pixel.h. Corners are snapped as the fast engine does, and textures
/// are looked up texel by texel, so that pictures agree: OpenGL's own filter may round more.
ShaderTexts opengl_shader_texts(fast::LightAt light_at);

/// The shaders that draw it in white.
ShaderTexts opengl_line_texts();

} // namespace rasterwalk
