#if interpolation_zinv_twice && !stage_points && !stage_edges && !stage_rows
// What a pixel carries, times 1/z; but the vertices have done that already.
Pixel TimesZinv(Pixel p)
{
#if scene_textures
    p.texcoord *= p.zinv;
#endif
#if stage_vertex_light
    p.illumination *= p.zinv;
#endif
#if carried_pos3d
    p.pos3d *= p.zinv;
#endif
#if carried_normal
    p.normal *= p.zinv;
#endif
#if carried_color
    p.color *= p.zinv;
#endif
    return p;
}

#endif
#if !stage_points && !coverage_edge_functions
#if coverage_scan_conversion || coverage_active_edges || line_walk_exact || !line_interpolate
// The values between two pixels: t is 0 at the first and 1 at the second.
Pixel Mix(const Pixel& a, const Pixel& b, float t)
{
    float s = 1 - t;
    Pixel p;
    p.zinv = a.zinv * s + b.zinv * t;
#if depth_ndc || depth_reversed
    p.depth = a.depth * s + b.depth * t;
#endif
#if depth_test_linear_z
    p.z = a.z * s + b.z * t;
#endif
#if scene_textures
    p.texcoord = a.texcoord * s + b.texcoord * t;
#endif
#if stage_vertex_light
    p.illumination = a.illumination * s + b.illumination * t;
#endif
#if carried_pos3d
    p.pos3d = a.pos3d * s + b.pos3d * t;
#endif
#if carried_normal
    p.normal = a.normal * s + b.normal * t;
#endif
#if carried_color
    p.color = a.color * s + b.color * t;
#endif
    return p;
}

#endif
#if line_walk_exact || !line_interpolate
// The values along a line, mixed from those of its ends.
void MixEnds(const Pixel& a, const Pixel& b, vector<Pixel>& result)
{
    int N = result.size();
    float steps = max(N - 1, 1);
    result[0] = a;
    for (int i = 1; i < N; ++i)
        result[i] = Mix(a, b, i / steps);
}

#endif
#endif
#if !stage_points && !coverage_edge_functions
#if line_walk_exact
#if line_rounding_floor || line_rounding_round
int FloorDivide(int a, int b)
{
    if (a % b < 0)
        return a / b - 1;
    return a / b;
}

#endif
// A coordinate on a line after i of its steps.
int PlaceOnLine(int from, int to, int i, int steps)
{
    if (steps == 0)
        return from;
    int part = from * (steps - i) + to * i;
#if line_rounding_floor
    return FloorDivide(part, steps);
#elif line_rounding_round
    return FloorDivide(2 * part + steps, 2 * steps);
#else
    return part / steps;
#endif
}

// From one pixel to another, in whole numbers: without any rounding error.
void Interpolate(const Pixel& a, const Pixel& b, vector<Pixel>& result)
{
    MixEnds(a, b, result);
    int N = result.size();
    for (int i = 0; i < N; ++i)
    {
        result[i].x = PlaceOnLine(a.x, b.x, i, N - 1);
        result[i].y = PlaceOnLine(a.y, b.y, i, N - 1);
    }
}
#else
// From one pixel to another, in equal steps.
void Interpolate(const Pixel& a, const Pixel& b, vector<Pixel>& result)
{
    int N = result.size();
#if line_walk_short_step
    float steps = N;
#else
    float steps = max(N - 1, 1);
#endif
#if line_walk_integer_step
    float stepX = (b.x - a.x) / max(N - 1, 1); // int / int drops the fraction
    float stepY = (b.y - a.y) / max(N - 1, 1);
#else
    float stepX = (b.x - a.x) / steps;
    float stepY = (b.y - a.y) / steps;
#endif
    float stepZinv = (b.zinv - a.zinv) / steps;
#if depth_ndc || depth_reversed
    float stepDepth = (b.depth - a.depth) / steps;
#endif
#if depth_test_linear_z
    float stepZ = (b.z - a.z) / steps;
#endif
#if scene_textures
    vec2 stepTexcoord = (b.texcoord - a.texcoord) / steps;
#endif
#if stage_vertex_light
    vec3 stepIllumination = (b.illumination - a.illumination) / steps;
#endif
#if carried_pos3d
    vec3 stepPos3d = (b.pos3d - a.pos3d) / steps;
#endif
#if carried_normal
    vec3 stepNormal = (b.normal - a.normal) / steps;
#endif
#if carried_color
    vec3 stepColor = (b.color - a.color) / steps;
#endif
    float x = a.x;
    float y = a.y;
    Pixel current = a;
    for (int i = 0; i < N; ++i)
    {
#if line_walk_multiply
        x = a.x + stepX * i;
        y = a.y + stepY * i;
        current.zinv = a.zinv + stepZinv * i;
#if depth_ndc || depth_reversed
        current.depth = a.depth + stepDepth * i;
#endif
#if depth_test_linear_z
        current.z = a.z + stepZ * i;
#endif
#if scene_textures
        current.texcoord = a.texcoord + stepTexcoord * float(i);
#endif
#if stage_vertex_light
        current.illumination = a.illumination + stepIllumination * float(i);
#endif
#if carried_pos3d
        current.pos3d = a.pos3d + stepPos3d * float(i);
#endif
#if carried_normal
        current.normal = a.normal + stepNormal * float(i);
#endif
#if carried_color
        current.color = a.color + stepColor * float(i);
#endif
#endif
#if line_rounding_floor
        current.x = int(floor(x));
        current.y = int(floor(y));
#elif line_rounding_round
        current.x = int(floor(double(x) + 0.5));
        current.y = int(floor(double(y) + 0.5));
#else
        current.x = int(x);
        current.y = int(y);
#endif
        result[i] = current;
#if !line_walk_multiply
        x += stepX;
        y += stepY;
        current.zinv += stepZinv;
#if depth_ndc || depth_reversed
        current.depth += stepDepth;
#endif
#if depth_test_linear_z
        current.z += stepZ;
#endif
#if scene_textures
        current.texcoord += stepTexcoord;
#endif
#if stage_vertex_light
        current.illumination += stepIllumination;
#endif
#if carried_pos3d
        current.pos3d += stepPos3d;
#endif
#if carried_normal
        current.normal += stepNormal;
#endif
#if carried_color
        current.color += stepColor;
#endif
#endif
    }
}
#endif
#endif
