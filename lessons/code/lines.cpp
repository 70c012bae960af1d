#if !stage_points && !coverage_edge_functions && (line_bresenham || line_midpoint || line_dda)
int Sign(int value)
{
    if (value > 0)
        return 1;
    if (value < 0)
        return -1;
    return 0;
}

#if line_bresenham
// From one pixel to another, in whole numbers: the sign of d says which of the two next pixels is
// nearer to the line.
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
