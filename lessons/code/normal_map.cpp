#if scene_surface_axes
// The steps in the world for which u, or v, grows by 1.
void ComputeTextureDirections(const Triangle& triangle)
{
    vec3 e1 = triangle.v1 - triangle.v0;
    vec3 e2 = triangle.v2 - triangle.v0;
    vec2 uv1 = triangle.texcoord1 - triangle.texcoord0;
    vec2 uv2 = triangle.texcoord2 - triangle.texcoord0;
    float area = uv1.x * uv2.y - uv2.x * uv1.y;
    currentAlongU = vec3(0, 0, 0);
    currentAlongV = vec3(0, 0, 0);
    if (area == 0)
        return;
    currentAlongU = (e1 * uv2.y - e2 * uv1.y) / area;
    currentAlongV = (e2 * uv1.x - e1 * uv2.x) / area;
}

// The axes of the surface where it has this normal.
Axes SurfaceAxes(vec3 n)
{
    Axes axes;
    axes.n = n;
    axes.t = Normalized(currentAlongU - n * dot(n, currentAlongU));
    vec3 b = cross(n, axes.t);
#if normal_map_rule_mirror_missed
    axes.b = b;
#else
    axes.b = dot(b, currentAlongV) > 0 ? -b : b; // up, even if the texture is mirrored
#endif
    return axes;
}

#if scene_height_maps
// How far the place in the textures is shifted, because the surface there is higher or lower.
vec2 Parallax(vec3 position, vec3 normal, const Pixel& p)
{
    if (currentHeightMap < 0)
        return vec2(0, 0);
    Axes axes = SurfaceAxes(normal);
    if (dot(axes.b, axes.b) == 0)
        return vec2(0, 0);
    vec2 place = CarriedPlace(p);
#if mip_levels
    vec3 color = LevelColor(currentHeightMap, place, p);
#else
    vec3 color = TextureColor(textures[currentHeightMap], place.x, place.y);
#endif
    float height = color.x * currentHeightScale + currentHeightBias;
#if projection_mixed
    vec3 toEye = -SightRay(position);
#else
    vec3 toEye = cameraPos - position;
#endif
    vec3 V = Along(axes, toEye / length(toEye));
#if parallax_divided
    vec2 step = height * vec2(V.x, V.y) / V.z;
#else
    float side = V.z < 0 ? -1 : 1;
    vec2 step = height * side * vec2(V.x, V.y);
#endif
    // The same step, in the texture.
    float v = step.y / dot(currentAlongV, axes.b);
    float u = (step.x - v * dot(currentAlongV, axes.t)) / dot(currentAlongU, axes.t);
#if parallax_rule_subtracted
    return -vec2(u, v);
#else
    return vec2(u, v);
#endif
}

#endif
#if scene_normal_maps
// The arrow that a color of a normal map stands for.
vec3 DecodeNormal(vec3 color)
{
#if normal_map_rule_undecoded
    return color;
#elif normal_map_rule_green_turned
    return (2.0f * color - 1.0f) * vec3(1, -1, 1);
#else
    return 2.0f * color - 1.0f;
#endif
}

#if !normal_map_space_tangent || (scene_shadows && shadows_rays)
// The arrow of the map as a normal in the world.
vec3 InWorld(vec3 a, const Axes& axes)
{
    return Normalized(a.x * axes.t + a.y * axes.b + a.z * axes.n);
}

#endif
#if normal_map_space_tangent
// The light is worked out in the world, where the surface has this normal.
void LightInWorld(vec3 normal)
{
    lightAxes.t = vec3(1, 0, 0);
    lightAxes.b = vec3(0, 1, 0);
    lightAxes.n = vec3(0, 0, 1);
#if scene_shadows && shadows_rays
    worldNormal = normal;
#endif
}

// The light is worked out along axes of the surface, where the normal is the arrow itself.
vec3 LightAlong(const Axes& axes, vec3 a)
{
    // Only axes of length 1 and at right angles leave the angles of light as they are.
    float lean = dot(axes.t, axes.n);
    float width = length(axes.b);
    vec3 upright = axes.n - axes.t * lean;
    float height = length(upright);
    lightAxes.t = axes.t;
    lightAxes.b = axes.b / width;
    lightAxes.n = upright / height;
#if scene_shadows && shadows_rays
    worldNormal = InWorld(a, axes);
#endif
    return Normalized(vec3(a.x + a.z * lean, a.y * width, a.z * height));
}

#endif
// The normal, bent by the normal map of the triangle if it has one.
vec3 BentNormal(vec3 normal, const Pixel& p)
{
#if normal_map_space_tangent
    LightInWorld(normal);
#endif
    if (currentNormalMap < 0)
        return normal;
    vec2 place = CarriedPlace(p);
#if scene_height_maps
    place += currentShift;
#endif
#if mip_levels
    vec3 a = DecodeNormal(LevelColor(currentNormalMap, place, p));
#else
    vec3 a = DecodeNormal(TextureColor(textures[currentNormalMap], place.x, place.y));
#endif
    Axes axes = SurfaceAxes(normal);
    if (dot(axes.b, axes.b) == 0 || dot(a, a) == 0)
        return normal;
#if normal_map_space_tangent
    return LightAlong(axes, a);
#else
    return InWorld(a, axes);
#endif
}

#if light_sides_two
// The bent normal on the side that the camera sees: from behind, a bump is a dent.
vec3 BentNormalInView(vec3 position, vec3 normal, const Pixel& p)
{
    vec3 bent = BentNormal(normal, p);
#if projection_mixed
    if (!(dot(normal, SightRay(position)) > 0))
#else
    if (!(dot(normal, position - cameraPos) > 0))
#endif
        return bent;
#if normal_map_space_tangent && scene_shadows && shadows_rays
    worldNormal = -worldNormal;
#endif
    return -bent;
}
#endif
#endif
#endif
