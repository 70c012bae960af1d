#if interpolation_mixed && (stage_vertex_light || stage_pixel_light || scene_textures)
// What a vertex's values are multiplied by: something between 1 and 1/z.
float Weight(float zinv)
{
    return (1 - mixing) + mixing * (referenceDepth * zinv);
}

#endif
#if stage_vertex_light || stage_pixel_light || stage_flat
#if light_model_blinn_phong || (stage_pixel_light && scene_corners)
// The same direction, with length 1; 0 has none.
vec3 Normalized(vec3 v)
{
    float length = sqrt(dot(v, v));
    if (length > 0)
        return v / length;
    return vec3(0, 0, 0);
}

#endif
// The light that a point of a surface reflects.
vec3 ReflectedLight(vec3 position, vec3 normal, vec3 reflectance)
{
#if light_direction_from_light
    vec3 r = position - lightPos;
#else
    vec3 r = lightPos - position;
#endif
    float distance2 = dot(r, r);
    if (!(distance2 > 0))
        return reflectance * indirectLightPowerPerArea;
    float cosine = max(0.0f, dot(r, normal) / sqrt(distance2));
    float area = 4 * 3.14159265f * distance2;
    vec3 D = lightPower * (cosine / area);
#if light_model_blinn_phong
    vec3 R = reflectance * (D + indirectLightPowerPerArea);
    vec3 toEye = cameraPos - position;
    float eyeDistance2 = dot(toEye, toEye);
#if light_highlight_unasked
    if (!(eyeDistance2 > 0))
#else
    if (!(cosine > 0) || !(eyeDistance2 > 0))
#endif
        return R;
#if light_highlight_long_half
    vec3 halfway = r / sqrt(distance2) + toEye / sqrt(eyeDistance2);
#else
    vec3 halfway = Normalized(r / sqrt(distance2) + toEye / sqrt(eyeDistance2));
#endif
    float nDotH = max(0.0f, dot(normal, halfway));
    return R + currentSpecular * (lightPower * (pow(nDotH, currentExponent) / area));
#else
    return reflectance * (D + indirectLightPowerPerArea);
#endif
}
#endif
