#if rows_of_samples
// Is a sample nearer than what has been drawn there?
bool IsNearer(int x, int y, int s, float zinv)
{
#if no_depth_test
    return true;
#elif depth_test_reversed
    return zinv < sampleDepths[y][4 * x + s];
#elif depth_test_with_epsilon
    return zinv > sampleDepths[y][4 * x + s] + epsilon;
#elif depth_test_or_equal
    return zinv >= sampleDepths[y][4 * x + s];
#else
    return zinv > sampleDepths[y][4 * x + s];
#endif
}

// Draws the samples of a pixel that the triangle covers.
void DrawSamples(const vector<Pixel>& vertexPixels, int x, int y)
{
    Pixel middle = WeightedPixel(vertexPixels, x, y, 0, 0);
#if cull_fragment_normal && !square_grid
    if (ShowsBack(middle))
        return;
#endif
    bool any = false;
    for (int s = 0; s < 4; ++s)
    {
        writes[s] = false;
        if (!CoversSample(vertexPixels, x, y, s))
            continue;
        Pixel p = WeightedPixel(vertexPixels, x, y, sampleX[s], sampleY[s]);
#if cull_fragment_normal && square_grid
        if (ShowsBack(p))
            continue;
#endif
#if sample_rule_centre_depth
        float zinv = middle.zinv;
#else
        float zinv = p.zinv;
#endif
        if (!IsNearer(x, y, s, zinv))
            continue;
        sampleDepths[y][4 * x + s] = zinv;
        writes[s] = true;
        any = true;
#if square_grid
        PixelShader(p); // once for each sample
        writes[s] = false;
#endif
    }
#if !square_grid
    if (any)
        PixelShader(middle); // once, and its color goes to all these samples
#endif
}

// Every pixel of every row.
void DrawPolygonRows(const vector<Pixel>& vertexPixels, const vector<Pixel>& leftPixels,
                     const vector<Pixel>& rightPixels)
{
    int rows = leftPixels.size();
    for (int r = 0; r < rows; ++r)
    {
        int y = leftPixels[r].y; //@ each row r
#if bounds_excludes_zero
        if (y <= 0 || y >= SCREEN_HEIGHT)
#else
        if (y < 0 || y >= SCREEN_HEIGHT)
#endif
            continue;
        int left = leftPixels[r].x;
#if bounds_excludes_zero
        for (int x = max(left, 1); x <= min(rightPixels[r].x, SCREEN_WIDTH - 1); ++x)
#else
        for (int x = max(left, 0); x <= min(rightPixels[r].x, SCREEN_WIDTH - 1); ++x)
#endif
            DrawSamples(vertexPixels, x, y); //@ fragment x - left
    }
}

vec3 Clamped(vec3 color)
{
    return min(max(color, vec3(0, 0, 0)), vec3(1, 1, 1));
}

// Each pixel of a row gets the mean of its samples.
void ResolveRow(int y)
{
    for (int x = 0; x < SCREEN_WIDTH; ++x)
    {
        vec3 sum(0, 0, 0); //@ resolve x
        for (int s = 0; s < 4; ++s)
        {
#if sample_rule_late_clamp
            sum += sampleColors[y][4 * x + s];
#else
            sum += Clamped(sampleColors[y][4 * x + s]);
#endif
        }
#if sample_rule_late_clamp
        frame[y][x] = Clamped(sum / 4.0f);
#else
        frame[y][x] = sum / 4.0f;
#endif
    }
}

// Resolves the picture, once everything is drawn.
void Resolve()
{
    for (int y = 0; y < SCREEN_HEIGHT; ++y)
        ResolveRow(y); //@ each pictureline y
}
#endif
