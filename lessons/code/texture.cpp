#if scene_textures && !stage_points && !stage_edges && !stage_rows
// The number of a texel in its line, for a place that may lie beyond the border.
int Wrap(int texel, int count)
{
#if texture_wrap_clamp
    return clamp(texel, 0, count - 1);
#elif texture_wrap_mirror
    int rest = texel % (2 * count);
    if (rest < 0)
        rest += 2 * count;
    if (rest < count)
        return rest;
    return 2 * count - 1 - rest;
#else
    int rest = texel % count;
    if (rest < 0)
        rest += count;
    return rest;
#endif
}

// A texture coordinate, counted in texels.
float AmongTexels(float coordinate, int count)
{
    float place = coordinate * count;
    if (!(abs(place) < 1073741824.0f))
        return 0; // too far out for int
    return place;
}

vec3 Texel(const Texture& texture, int column, int row)
{
    return texels[texture.firstTexel + row * texture.width + column];
}

#if texture_filter_bilinear
// The color of a texture: the four texels around the place, each the more the nearer it is.
vec3 TextureColor(const Texture& texture, float u, float v)
{
    float x = AmongTexels(u, texture.width) - 0.5f;
    float y = AmongTexels(v, texture.height) - 0.5f;
    float right = x - floor(x);
    float down = y - floor(y);
    int column0 = Wrap(int(floor(x)), texture.width);
    int column1 = Wrap(int(floor(x)) + 1, texture.width);
    int row0 = Wrap(int(floor(y)), texture.height);
    int row1 = Wrap(int(floor(y)) + 1, texture.height);
    vec3 color(0, 0, 0);
    color += Texel(texture, column0, row0) * ((1 - right) * (1 - down));
    color += Texel(texture, column1, row0) * (right * (1 - down));
    color += Texel(texture, column0, row1) * ((1 - right) * down);
    color += Texel(texture, column1, row1) * (right * down);
    return color;
}
#else
// The color of a texture: that of the texel in which the place lies.
vec3 TextureColor(const Texture& texture, float u, float v)
{
    int column = Wrap(int(floor(AmongTexels(u, texture.width))), texture.width);
    int row = Wrap(int(floor(AmongTexels(v, texture.height))), texture.height);
    return Texel(texture, column, row);
}
#endif

// A color, painted with the texture of the triangle if it has one.
vec3 Painted(vec3 color, const Pixel& p)
{
    if (currentTexture < 0)
        return color;
#if interpolation_affine
    vec2 place = p.texcoord;
#elif interpolation_mixed
    vec2 place = p.texcoord / Weight(p.zinv);
#else
    vec2 place = p.texcoord / p.zinv;
#endif
    return color * TextureColor(textures[currentTexture], place.x, place.y);
}
#endif
