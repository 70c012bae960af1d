#if scene_textures && !stage_points && !stage_edges && !stage_rows
// A color, painted with the texture of the triangle if it has one.
vec3 Painted(vec3 color, const Pixel& p)
{
    if (currentTexture < 0)
        return color;
    vec2 place = CarriedPlace(p);
#if scene_height_maps
    place += currentShift;
#endif
#if mip_levels
    return color * LevelColor(currentTexture, place, p);
#else
    return color * TextureColor(textures[currentTexture], place.x, place.y);
#endif
}

#endif
#if stage_vertex_light
// The color of a pixel: the light of its vertices.
void PixelShader(const Pixel& p)
{
#if interpolation_affine || interpolation_undivided
#if scene_textures
    PutPixel(p.x, p.y, Painted(p.illumination, p));
#else
    PutPixel(p.x, p.y, p.illumination);
#endif
#elif interpolation_mixed
#if scene_textures
    PutPixel(p.x, p.y, Painted(p.illumination / Weight(p.zinv), p));
#else
    PutPixel(p.x, p.y, p.illumination / Weight(p.zinv));
#endif
#elif interpolation_divided_twice
#if scene_textures
    PutPixel(p.x, p.y, Painted(p.illumination / (p.zinv * p.zinv), p));
#else
    PutPixel(p.x, p.y, p.illumination / (p.zinv * p.zinv));
#endif
#else
#if scene_textures
    PutPixel(p.x, p.y, Painted(p.illumination / p.zinv, p));
#else
    PutPixel(p.x, p.y, p.illumination / p.zinv);
#endif
#endif
}
#elif stage_pixel_light
// The color of a pixel: the light at its place in the world.
void PixelShader(const Pixel& p)
{
#if interpolation_affine || interpolation_undivided
    vec3 position = p.pos3d;
#elif interpolation_mixed
    vec3 position = p.pos3d / Weight(p.zinv);
#elif interpolation_divided_twice
    vec3 position = p.pos3d / (p.zinv * p.zinv);
#else
    vec3 position = p.pos3d / p.zinv;
#endif
#if scene_corners || scene_surface_axes
    vec3 normal = currentNormal;
    vec3 color = currentReflectance;
#if scene_corners
#if interpolation_affine || interpolation_undivided
    if (currentSmooth)
#if light_renormalize_off
        normal = p.normal;
#else
        normal = Normalized(p.normal);
#endif
    if (currentBlended)
        color = p.color;
#elif interpolation_mixed
    if (currentSmooth)
#if light_renormalize_off
        normal = p.normal / Weight(p.zinv);
#else
        normal = Normalized(p.normal / Weight(p.zinv));
#endif
    if (currentBlended)
        color = p.color / Weight(p.zinv);
#elif interpolation_divided_twice
    if (currentSmooth)
#if light_renormalize_off
        normal = p.normal / (p.zinv * p.zinv);
#else
        normal = Normalized(p.normal / (p.zinv * p.zinv));
#endif
    if (currentBlended)
        color = p.color / (p.zinv * p.zinv);
#else
    if (currentSmooth)
#if light_renormalize_off
        normal = p.normal / p.zinv;
#else
        normal = Normalized(p.normal / p.zinv);
#endif
    if (currentBlended)
        color = p.color / p.zinv;
#endif
#endif
#if normal_w_one && scene_surface_axes
    normal = Normalized(normal - cameraPos); // moved like a point, as if its w were 1
#endif
#if scene_height_maps
    currentShift = Parallax(position, normal, p);
#endif
#if scene_normal_maps && light_sides_two
    normal = BentNormalInView(position, normal, p);
#elif scene_normal_maps
    normal = BentNormal(normal, p);
#endif
#if scene_textures
    PutPixel(p.x, p.y, ReflectedLight(position, normal, Painted(color, p)));
#else
    PutPixel(p.x, p.y, ReflectedLight(position, normal, color));
#endif
#else
#if scene_textures
    vec3 color = Painted(currentReflectance, p);
    PutPixel(p.x, p.y, ReflectedLight(position, currentNormal, color));
#else
    PutPixel(p.x, p.y, ReflectedLight(position, currentNormal, currentReflectance));
#endif
#endif
}
#elif stage_flat
// The color of a pixel: the light in the middle of its triangle.
void PixelShader(const Pixel& p)
{
#if scene_textures
    PutPixel(p.x, p.y, Painted(currentLight, p));
#else
    PutPixel(p.x, p.y, currentLight);
#endif
}
#elif stage_fill || stage_depth || stage_unlit
// The color of a pixel: that of its triangle.
void PixelShader(const Pixel& p)
{
#if carried_color
    vec3 color = currentReflectance;
    if (currentBlended)
#if interpolation_affine || interpolation_undivided
        color = p.color;
#elif interpolation_mixed
        color = p.color / Weight(p.zinv);
#elif interpolation_divided_twice
        color = p.color / (p.zinv * p.zinv);
#else
        color = p.color / p.zinv;
#endif
#if scene_textures
    PutPixel(p.x, p.y, Painted(color, p));
#else
    PutPixel(p.x, p.y, color);
#endif
#elif scene_textures
    PutPixel(p.x, p.y, Painted(currentReflectance, p));
#else
    PutPixel(p.x, p.y, currentReflectance);
#endif
}
#endif
