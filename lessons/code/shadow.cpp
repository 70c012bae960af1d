#if scene_shadows && shadows_rays
// Does the segment from a point, along a direction to its end, hit a triangle?
bool Intersects(vec3 from, vec3 direction, const Triangle& triangle)
{
    vec3 e1 = triangle.v1 - triangle.v0;
    vec3 e2 = triangle.v2 - triangle.v0;
    vec3 across = cross(direction, e2);
    float determinant = dot(e1, across);
    if (!(determinant > 0 || determinant < 0))
        return false; // parallel to the triangle
    vec3 b = from - triangle.v0;
    float u = dot(b, across) / determinant;
    if (!(u >= 0 && u <= 1))
        return false;
    vec3 acrossEdge = cross(b, e1);
    float v = dot(direction, acrossEdge) / determinant;
    if (!(v >= 0 && u + v <= 1))
        return false;
    float t = dot(e2, acrossEdge) / determinant;
#if shadow_ray_past_lamp
    return t > 0;
#else
    return t > 0 && t < 1; // before the end of the segment
#endif
}

// The part of the lamp's light that arrives: all, unless a triangle is in the way.
float LitPart(vec3 position, vec3 normal)
{
    vec3 from = position + shadowOffset * normal;
    vec3 direction = lightPos - from;
    for (int i = 0; i < triangles.size(); ++i)
    {
        if (Intersects(from, direction, triangles[i]))
            return 0;
    }
    return 1;
}

#elif scene_shadows
// The face of the shadow map that looks in this direction.
int FaceToward(vec3 direction)
{
    vec3 size = abs(direction);
    if (size.x >= size.y && size.x >= size.z)
        return direction.x >= 0 ? 0 : 1;
    if (size.y >= size.z)
        return direction.y >= 0 ? 2 : 3;
    return direction.z >= 0 ? 4 : 5;
}

// The column or row of a place in a face.
int ShadowTexel(float place)
{
    return int(min(max(0.0f, floor(place)), shadowMapSize - 1.0f));
}

// Has the lamp seen nothing nearer than this in a texel?
bool IsLit(int face, int column, int row, float depth)
{
    int texel = (face * shadowMapSize + row) * shadowMapSize + column;
    return depth * shadowMap[texel] <= 1;
}

// The part of the lamp's light that arrives at a point, by what the lamp has seen.
float LitPart(vec3 position, float cosine)
{
    vec3 fromLamp = position - lightPos;
    int face = FaceToward(fromLamp);
    vec3 seen = fromLamp * shadowAxes[face];
    if (!(seen.z > 0))
        return 1;
    float focal = 0.5f * shadowMapSize;
    float zinv = 1 / seen.z;
    float x = focal * seen.x * zinv + shadowMapSize / 2;
    float y = focal * seen.y * zinv + shadowMapSize / 2;
#if !shadow_slope_bias_0
    float slant = clamp(cosine, 0.01f, 1.0f);
    float tangent = sqrt(1 - slant * slant) / slant;
    float texelSize = 2 * seen.z / shadowMapSize;
    float depth = seen.z - (shadowBias + slopeBias * texelSize * tangent);
#else
    float depth = seen.z - shadowBias;
#endif
#if shadow_filter_four
    int left = ShadowTexel(x - 0.5f);
    int right = ShadowTexel(x + 0.5f);
    int top = ShadowTexel(y - 0.5f);
    int bottom = ShadowTexel(y + 0.5f);
    int lit = 0;
    if (IsLit(face, left, top, depth))
        ++lit;
    if (IsLit(face, right, top, depth))
        ++lit;
    if (IsLit(face, left, bottom, depth))
        ++lit;
    if (IsLit(face, right, bottom, depth))
        ++lit;
    return lit / 4.0f;
#else
    if (IsLit(face, ShadowTexel(x), ShadowTexel(y), depth))
        return 1;
    return 0;
#endif
}

#endif
