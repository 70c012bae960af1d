#if !stage_points && (line_bresenham || line_midpoint || line_dda)
// What a line carries besides its place: mixed of both ends.
void MixEnds(const Pixel& a, const Pixel& b, vector<Pixel>& result)
{
    int N = result.size();
    float steps = max(N - 1, 1);
    result[0] = a;
    for (int i = 1; i < N; ++i)
    {
        float t = i / steps;
        float s = 1 - t;
        result[i].zinv = a.zinv * s + b.zinv * t;
#if scene_textures
        result[i].texcoord = a.texcoord * s + b.texcoord * t;
#endif
#if stage_vertex_light
        result[i].illumination = a.illumination * s + b.illumination * t;
#endif
#if stage_pixel_light
        result[i].pos3d = a.pos3d * s + b.pos3d * t;
#endif
#if stage_pixel_light && scene_corners
        result[i].normal = a.normal * s + b.normal * t;
        result[i].color = a.color * s + b.color * t;
#endif
    }
}

int Sign(int value)
{
    if (value > 0)
        return 1;
    if (value < 0)
        return -1;
    return 0;
}

#if line_bresenham
// From one pixel to another, with whole numbers alone: d says on which side of the line the next
// pixel would lie.
void Bresenham(const Pixel& a, const Pixel& b, vector<Pixel>& result)
#elif line_midpoint
// From one pixel to another: d says on which side of the line the point between the two next pixels
// lies.
void Midpoint(const Pixel& a, const Pixel& b, vector<Pixel>& result)
#else
// From one pixel to another: one pixel along the longer axis, and a fraction along the shorter.
void DDA(const Pixel& a, const Pixel& b, vector<Pixel>& result)
#endif
{
    MixEnds(a, b, result);
    int dx = b.x - a.x;
    int dy = b.y - a.y;
#if line_bresenham && bresenham_rule_first_octant
    bool steep = false;
    int longer = dx;
    int shorter = dy;
    int right = 1;
    int down = 1;
#else
    bool steep = abs(dy) > abs(dx);
    int longer = max(abs(dx), abs(dy));
    int shorter = min(abs(dx), abs(dy));
    int right = Sign(dx);
    int down = Sign(dy);
#endif
    int x = a.x;
    int y = a.y;
#if line_bresenham
    int d = 2 * shorter - longer;
#elif line_midpoint
    double d = shorter - longer * 0.5;
#else
    float start = steep ? a.x : a.y;
    float end = steep ? b.x : b.y;
    float slope = (end - start) / max(longer, 1);
    float place = start;
#endif
    for (int i = 0; i < result.size(); ++i)
    {
#if line_dda
        if (steep)
            x = int(floor(double(place) + 0.5));
        else
            y = int(floor(double(place) + 0.5));
        result[i].x = x;
        result[i].y = y;
        if (steep)
            y += down;
        else
            x += right;
        place += slope;
#else
        result[i].x = x;
        result[i].y = y;
#if line_bresenham
        if (d < 0)
#else
        if (d <= 0)
#endif
        {
            if (steep)
                y += down;
            else
                x += right;
#if line_bresenham
            d += 2 * shorter;
#else
            d += shorter;
#endif
        }
        else
        {
            x += right;
            y += down;
#if line_bresenham
#if bresenham_rule_wrong_term
            d += -2 * longer;
#else
            d += 2 * (shorter - longer);
#endif
#else
            d += shorter - longer;
#endif
        }
#endif
    }
}
#endif
