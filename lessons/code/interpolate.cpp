#if !stage_points && (!coverage_edge_functions || stage_edges)
// From one pixel to another, in equal steps.
void Interpolate(const Pixel& a, const Pixel& b, vector<Pixel>& result)
{
    int N = result.size();
    float steps = max(N - 1, 1);
    float stepX = (b.x - a.x) / steps;
    float stepY = (b.y - a.y) / steps;
    float stepZinv = (b.zinv - a.zinv) / steps;
#if scene_textures
    vec2 stepTexcoord = (b.texcoord - a.texcoord) / steps;
#endif
#if stage_vertex_light
    vec3 stepIllumination = (b.illumination - a.illumination) / steps;
#endif
#if stage_pixel_light
    vec3 stepPos3d = (b.pos3d - a.pos3d) / steps;
#endif
#if stage_pixel_light && scene_corners
    vec3 stepNormal = (b.normal - a.normal) / steps;
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
#if scene_textures
        current.texcoord = a.texcoord + stepTexcoord * float(i);
#endif
#if stage_vertex_light
        current.illumination = a.illumination + stepIllumination * float(i);
#endif
#if stage_pixel_light
        current.pos3d = a.pos3d + stepPos3d * float(i);
#endif
#if stage_pixel_light && scene_corners
        current.normal = a.normal + stepNormal * float(i);
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
#if scene_textures
        current.texcoord += stepTexcoord;
#endif
#if stage_vertex_light
        current.illumination += stepIllumination;
#endif
#if stage_pixel_light
        current.pos3d += stepPos3d;
#endif
#if stage_pixel_light && scene_corners
        current.normal += stepNormal;
        current.color += stepColor;
#endif
#endif
    }
}
#endif
