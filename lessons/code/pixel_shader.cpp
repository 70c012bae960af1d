#if stage_vertex_light
// The colour of a pixel: the light of its vertices.
void PixelShader(const Pixel& p)
{
#if interpolation_affine
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
#else
#if scene_textures
    PutPixel(p.x, p.y, Painted(p.illumination / p.zinv, p));
#else
    PutPixel(p.x, p.y, p.illumination / p.zinv);
#endif
#endif
}
#elif stage_pixel_light
// The colour of a pixel: the light at its place in the world.
void PixelShader(const Pixel& p)
{
#if interpolation_affine
    vec3 position = p.pos3d;
#elif interpolation_mixed
    vec3 position = p.pos3d / Weight(p.zinv);
#else
    vec3 position = p.pos3d / p.zinv;
#endif
#if scene_corners
    vec3 normal = currentNormal;
    vec3 color = currentReflectance;
#if interpolation_affine
    if (currentSmooth)
        normal = Normalized(p.normal);
    if (currentBlended)
        color = p.color;
#elif interpolation_mixed
    if (currentSmooth)
        normal = Normalized(p.normal / Weight(p.zinv));
    if (currentBlended)
        color = p.color / Weight(p.zinv);
#else
    if (currentSmooth)
        normal = Normalized(p.normal / p.zinv);
    if (currentBlended)
        color = p.color / p.zinv;
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
// The colour of a pixel: the light in the middle of its triangle.
void PixelShader(const Pixel& p)
{
#if scene_textures
    PutPixel(p.x, p.y, Painted(currentLight, p));
#else
    PutPixel(p.x, p.y, currentLight);
#endif
}
#elif stage_fill || stage_depth || stage_unlit
// The colour of a pixel: that of its triangle.
void PixelShader(const Pixel& p)
{
#if scene_textures
    PutPixel(p.x, p.y, Painted(currentReflectance, p));
#else
    PutPixel(p.x, p.y, currentReflectance);
#endif
}
#endif
