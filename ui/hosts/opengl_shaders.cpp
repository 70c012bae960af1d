#include "ui/hosts/opengl_shaders.h"

#include <string>

namespace rasterwalk {

namespace {

/// What is carried from the vertices to the pixels, `in` or `out`.
std::string varyings(const std::string& way) {
    std::string text = "flat " + way + " int number;\n";
    for (const char* const varying :
         {"vec2 texture_place", "vec3 carried_colour", "vec3 carried_place", "vec3 carried_normal",
          "vec3 carried_specular", "float carried_exponent"})
        text += way + ' ' + varying + ";\n";
    return text;
}

/// R = reflectance (power max(n . l, 0) / (4 pi r^2) + indirect), and the highlight.
constexpr const char* light_text = R"(
uniform vec3 eye, lamp, power, indirect;
uniform bool has_highlights;

vec3 unit(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-30)); }

vec3 lit(vec3 place, vec3 normal, vec3 reflectance, vec3 specular, float exponent) {
    vec3 to_lamp = lamp - place;
    vec3 l = unit(to_lamp), n = unit(normal);
    float cosine = dot(n, l);
    float spread = 1.0 / (12.5663706 * max(dot(to_lamp, to_lamp), 1e-30));
    vec3 light = reflectance * (power * (max(cosine, 0.0) * spread) + indirect);
    if (!has_highlights || cosine <= 0.0) return light;
    float n_dot_h = clamp(dot(n, unit(l + unit(eye - place))), 1e-30, 1.0);
    return light + specular * power * (pow(n_dot_h, exponent) * spread);
}
)";

/// Corners in front of the near plane move to whole 256ths of a pixel, as in stages/snap.h.
constexpr const char* snap_text = R"(
uniform float near, focal_length, guard_band, subpixels;
uniform vec2 size, middle_pixel;

vec4 snapped_place(vec3 seen) {
    vec4 place = clip_place(seen);
    if (!(seen.z >= near)) return place;
    vec2 pixel = seen.xy * (1.0 / seen.z * focal_length) + middle_pixel;
    if (any(greaterThanEqual(abs(pixel), vec2(guard_band)))) return place;
    pixel = floor(pixel * subpixels + 0.5) / subpixels;
    return vec4((pixel * 2.0 / size - 1.0) * place.w, place.zw);
}
)";

constexpr const char* vertex_main = R"(
in vec3 place, lit_place, normal, reflectance, specular;
in vec2 texcoord;
in float exponent;
in int owner;
uniform mat3 axes; // of the camera, in the world

void main() {
    gl_Position = snapped_place((place - eye) * axes);
    number = owner;
    texture_place = texcoord;
    carried_place = place;
    carried_normal = normal;
    carried_specular = specular;
    carried_exponent = exponent;
    carried_colour = COLOUR_AT_VERTEX;
}
)";

/// Lookup as in stages/texture_lookup.h: the weights of OpenGL's own filter are rounded to 8 bits
/// by llvmpipe.
constexpr const char* texture_text = R"(
uniform sampler2D texels;
uniform bool is_painted, is_bilinear, is_clamped, is_mirrored;

float among_texels(float coordinate, int count) {
    float place = coordinate * float(count);
    return abs(place) < 1073741824.0 ? place : 0.0;
}

int wrapped(int texel, int count) {
    if (is_clamped) return clamp(texel, 0, count - 1);
    int period = is_mirrored ? 2 * count : count;
    // The rest of a negative number is undefined in GLSL.
    int rest = texel >= 0 ? texel % period : period - 1 - (-1 - texel) % period;
    return rest < count ? rest : period - 1 - rest;
}

vec3 texture_colour(vec2 texcoord) {
    if (!is_painted) return vec3(1.0);
    ivec2 size = textureSize(texels, 0);
    vec2 place = vec2(among_texels(texcoord.x, size.x), among_texels(texcoord.y, size.y));
    if (is_bilinear) place -= 0.5;
    vec2 before = floor(place), share = place - before;
    ivec2 first = ivec2(before);
    ivec2 p = ivec2(wrapped(first.x, size.x), wrapped(first.y, size.y));
    vec3 colour = texelFetch(texels, p, 0).rgb;
    if (!is_bilinear) return colour;
    ivec2 q = ivec2(wrapped(first.x + 1, size.x), wrapped(first.y + 1, size.y));
    return colour * ((1.0 - share.x) * (1.0 - share.y)) +
           texelFetch(texels, ivec2(q.x, p.y), 0).rgb * (share.x * (1.0 - share.y)) +
           texelFetch(texels, ivec2(p.x, q.y), 0).rgb * ((1.0 - share.x) * share.y) +
           texelFetch(texels, q, 0).rgb * (share.x * share.y);
}
)";

constexpr const char* fragment_main = R"(
uniform float near;
out vec4 colour;
out float inv_z;
out int triangle;

void main() {
    vec3 painted = texture_colour(texture_place);
    vec3 light = COLOUR_AT_PIXEL;
    // A byte is the whole part of 255 times the channel; OpenGL would round.
    colour = vec4(floor(clamp(light, 0.0, 1.0) * 255.0) / 255.0, 1.0);
    inv_z = gl_FragCoord.w;
    triangle = number;
    gl_FragDepth = gl_FragCoord.w * near;
}
)";

ShaderTexts texts(const char* at_vertex, const char* at_pixel) {
    return {shader_version + varyings("out") + light_text + clip_space_text + snap_text +
                replaced(vertex_main, "COLOUR_AT_VERTEX", at_vertex),
            shader_version + varyings("in") + light_text + texture_text +
                replaced(fragment_main, "COLOUR_AT_PIXEL", at_pixel)};
}

} // namespace

ShaderTexts opengl_shader_texts(fast::LightAt light_at) {
    switch (light_at) {
    case fast::LightAt::nowhere:
        break;
    case fast::LightAt::vertices:
        return texts("lit(lit_place, normal, reflectance, specular, exponent)",
                     "carried_colour * painted");
    case fast::LightAt::pixels:
        return texts("reflectance", "lit(carried_place, carried_normal, carried_colour * painted, "
                                    "carried_specular, carried_exponent)");
    }
    return texts("reflectance", "carried_colour * painted");
}

ShaderTexts opengl_line_texts() {
    return texts("vec3(1.0)", "carried_colour");
}

} // namespace rasterwalk
