#if interpolation_mixed
#if stage_vertex_light || carried_pos3d || carried_color || scene_textures
// The weight of a vertex's values: a mix of 1 and referenceDepth / z.
float Weight(float zinv)
{
    return (1 - mixing) + mixing * (referenceDepth * zinv);
}

#endif
#endif
#if projection_mixed && asks_sight_ray
// The direction in which a point is seen: from the camera, or the camera's own if orthographic.
vec3 SightRay(vec3 position)
{
    return (1 - orthographicMix) * (position - cameraPos) + orthographicMix * R[2];
}

#endif
#if stage_vertex_light || stage_pixel_light || stage_flat
#if light_model_blinn_phong || normal_w_one || scene_surface_axes || scene_corners
// The same direction, with length 1; 0 has none.
vec3 Normalized(vec3 v)
{
    float size = sqrt(dot(v, v));
    if (size > 0)
        return v / size;
    return vec3(0, 0, 0);
}

#endif
#if (scene_normal_maps && normal_map_space_tangent) || scene_height_maps
// A direction of the world, measured along axes.
vec3 Along(const Axes& axes, vec3 direction)
{
    return vec3(dot(direction, axes.t), dot(direction, axes.b), dot(direction, axes.n));
}

#endif
// The light that a point of a surface reflects.
vec3 ReflectedLight(vec3 position, vec3 normal, vec3 reflectance)
{
#if normal_w_one && !scene_surface_axes
    normal = Normalized(normal - cameraPos); // moved like a point, as if its w were 1
#endif
#if light_sides_two && !scene_normal_maps
#if projection_mixed
    if (dot(normal, SightRay(position)) > 0)
#else
    if (dot(normal, position - cameraPos) > 0)
#endif
        normal = -1.0f * normal; // lit on the side that the camera sees
#endif
#if light_direction_from_light
    vec3 r = position - lightPos;
#else
    vec3 r = lightPos - position;
#endif
#if scene_normal_maps && normal_map_space_tangent
    r = Along(lightAxes, r);
#endif
#if light_direction_with_w
    float distance2 = dot(r, r) + 1; // of four numbers, the last of which is 1
#else
    float distance2 = dot(r, r);
#endif
    if (!(distance2 > 0))
    {
#if light_sum_reflectance_plus
        return reflectance;
#elif light_sum_reflectance_twice
        return reflectance * reflectance * indirectLightPowerPerArea;
#else
        return reflectance * indirectLightPowerPerArea;
#endif
    }
#if light_direction_not_normalized
    float cosine = max(0.0f, dot(r, normal));
#else
    float cosine = max(0.0f, dot(r, normal) / sqrt(distance2));
#endif
#if light_falloff_no_4pi
    float area = distance2;
#elif light_falloff_linear
    float area = sqrt(distance2);
#elif light_falloff_none
    float area = 1;
#elif light_falloff_cubed
    float area = 4 * 3.14159265f * distance2 * sqrt(distance2);
#elif light_falloff_pi_of_atan
    float area = 4 * (atan(1.0f) / 4) * distance2;
#elif light_falloff_pi_three
    float area = 4 * 3 * distance2;
#else
    float area = 4 * 3.14159265f * distance2;
#endif
#if scene_shadows
    float lit = 1;
    if (cosine > 0)
#if shadows_map
        lit = LitPart(position, cosine);
#elif scene_normal_maps && normal_map_space_tangent
        lit = LitPart(position, worldNormal);
#else
        lit = LitPart(position, normal);
#endif
    vec3 D = lightPower * lit * (cosine / area);
#else
    vec3 D = lightPower * (cosine / area);
#endif
#if light_model_blinn_phong
#if light_sum_reflectance_plus
    vec3 reflected = D + reflectance;
#elif light_sum_reflectance_twice
    vec3 reflected = reflectance * reflectance * (D + indirectLightPowerPerArea);
#else
    vec3 reflected = reflectance * (D + indirectLightPowerPerArea);
#endif
#if projection_mixed
    vec3 toEye = -SightRay(position);
#else
    vec3 toEye = cameraPos - position;
#endif
#if scene_normal_maps && normal_map_space_tangent
    toEye = Along(lightAxes, toEye);
#endif
    float eyeDistance2 = dot(toEye, toEye);
#if light_highlight_unasked
    if (!(eyeDistance2 > 0))
#else
    if (!(cosine > 0) || !(eyeDistance2 > 0))
#endif
        return reflected;
#if light_highlight_long_half
    vec3 halfway = r / sqrt(distance2) + toEye / sqrt(eyeDistance2);
#else
    vec3 halfway = Normalized(r / sqrt(distance2) + toEye / sqrt(eyeDistance2));
#endif
    float nDotH = max(0.0f, dot(normal, halfway));
#if scene_shadows
    return reflected + currentSpecular * (lightPower * lit * (pow(nDotH, currentExponent) / area));
#else
    return reflected + currentSpecular * (lightPower * (pow(nDotH, currentExponent) / area));
#endif
#else
#if light_sum_reflectance_plus
    return D + reflectance;
#elif light_sum_reflectance_twice
    return reflectance * reflectance * (D + indirectLightPowerPerArea);
#else
    return reflectance * (D + indirectLightPowerPerArea);
#endif
#endif
}
#endif
