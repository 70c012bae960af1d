#if scene_textures && !stage_points && !stage_edges && !stage_rows
// The index of a texel in its row or column; the place may lie beyond the border.
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
#if texel_rule_remainder
    return rest;
#else
    return rest < 0 ? rest + count : rest;
#endif
#endif
}

// A texture coordinate, counted in texels.
float TexelCoordinate(float coordinate, int count)
{
    float place = coordinate * count;
#if texel_rule_whole_centres
    if (!(abs(place) < 1073741824.0f))
        return 0.5f; // too far out for int
    return place + 0.5f;
#else
    if (!(abs(place) < 1073741824.0f))
        return 0; // too far out for int
    return place;
#endif
}

vec3 Texel(const Texture& texture, int column, int row)
{
#if texel_rule_remainder
    int place = row * texture.width + column;
    if (place < 0 || place >= texture.width * texture.height)
        return vec3(0, 0, 0); // what lies there in memory belongs to something else
    return texels[texture.firstTexel + place];
#else
    return texels[texture.firstTexel + row * texture.width + column];
#endif
}

#if texture_filter_bilinear || mip_levels
// The color at a place: the four texels around it, weighted by how near they are.
#if mip_levels
vec3 FourTexels(const Texture& texture, float u, float v, vec3 color, float share)
#else
vec3 TextureColor(const Texture& texture, float u, float v)
#endif
{
    float x = TexelCoordinate(u, texture.width) - 0.5f;
#if texel_rule_upside_down
    float y = TexelCoordinate(1 - v, texture.height) - 0.5f;
#else
    float y = TexelCoordinate(v, texture.height) - 0.5f;
#endif
    float right = x - floor(x);
    float down = y - floor(y);
    int column0 = Wrap(int(floor(x)), texture.width);
    int column1 = Wrap(int(floor(x)) + 1, texture.width);
    int row0 = Wrap(int(floor(y)), texture.height);
    int row1 = Wrap(int(floor(y)) + 1, texture.height);
#if mip_levels
    color += Texel(texture, column0, row0) * ((1 - right) * (1 - down) * share);
    color += Texel(texture, column1, row0) * (right * (1 - down) * share);
    color += Texel(texture, column0, row1) * ((1 - right) * down * share);
    color += Texel(texture, column1, row1) * (right * down * share);
#else
    vec3 color(0, 0, 0);
    color += Texel(texture, column0, row0) * ((1 - right) * (1 - down));
    color += Texel(texture, column1, row0) * (right * (1 - down));
    color += Texel(texture, column0, row1) * ((1 - right) * down);
    color += Texel(texture, column1, row1) * (right * down);
#endif
    return color;
}
#else
// The color of a texture: that of the texel in which the place lies.
vec3 TextureColor(const Texture& texture, float u, float v)
{
    int column = Wrap(int(floor(TexelCoordinate(u, texture.width))), texture.width);
#if texel_rule_upside_down
    int row = Wrap(int(floor(TexelCoordinate(1 - v, texture.height))), texture.height);
#else
    int row = Wrap(int(floor(TexelCoordinate(v, texture.height))), texture.height);
#endif
    return Texel(texture, column, row);
}
#endif

// Where a pixel lies in the textures.
vec2 CarriedPlace(const Pixel& p)
{
#if interpolation_affine || interpolation_undivided
    return p.texcoord;
#elif interpolation_mixed
    return p.texcoord / Weight(p.zinv);
#elif interpolation_divided_twice
    return p.texcoord / (p.zinv * p.zinv);
#else
    return p.texcoord / p.zinv;
#endif
}
#endif
