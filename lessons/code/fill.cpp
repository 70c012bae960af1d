#if !stage_points && !stage_edges && !stage_rows && !hidden_warnock
#if depth_in_bits && !no_depth_test && !no_depth_test_in_buffer
// The depth as the buffer stores it, rounded to one of so many equal steps.
float InBuffer(float depth)
{
#if depth_in_16_bits
    int largest = 65535; // of 16 bits
#else
    int largest = 16777215; // of 24 bits
#endif
#if depth_ndc || depth_reversed
    double part = min(max(depth, 0.0f), 1.0f);
    return float(int(floor(part * largest + 0.5))) / largest;
#else
    double part = min(max(depth * zNear, 0.0f), 1.0f);
    return float(int(floor(part * largest + 0.5))) / largest / zNear;
#endif
}

#endif
#if row_fragments_with_falling_zinv
// 1/z of the pixels of a row, in equal steps.
void WalkZinv(const Pixel& left, const Pixel& right, vector<Pixel>& row)
{
    int n = row.size();
    float steps = max(n - 1, 1);
#if line_walk_zinv_falls
    float stepZinv = -(right.zinv - left.zinv) / steps;
#else
    float stepZinv = (right.zinv - left.zinv) / steps;
#endif
#if depth_ndc || depth_reversed
#if line_walk_zinv_falls
    float stepDepth = -(right.depth - left.depth) / steps;
#else
    float stepDepth = (right.depth - left.depth) / steps;
#endif
#endif
    for (int k = 1; k < n; ++k)
    {
        row[k].zinv = row[k - 1].zinv + stepZinv;
#if depth_ndc || depth_reversed
        row[k].depth = row[k - 1].depth + stepDepth;
#endif
    }
}

#endif
#if cull_fragment_normal
// Is the back of the surface seen at a pixel?
bool ShowsBack(const Pixel& p)
{
#if interpolation_affine || interpolation_undivided
    vec3 normal = p.normal;
    vec3 position = p.pos3d;
#elif interpolation_mixed
    vec3 normal = p.normal / Weight(p.zinv);
    vec3 position = p.pos3d / Weight(p.zinv);
#elif interpolation_divided_twice
    vec3 normal = p.normal / (p.zinv * p.zinv);
    vec3 position = p.pos3d / (p.zinv * p.zinv);
#else
    vec3 normal = p.normal / p.zinv;
    vec3 position = p.pos3d / p.zinv;
#endif
#if projection_mixed
    return dot(normal, SightRay(position)) > 0;
#else
    return dot(normal, position - cameraPos) > 0;
#endif
}

#endif
#if !rows_of_samples
// Every pixel of every row.
#if coverage_edge_functions
void DrawPolygonRows(const vector<Pixel>& vertexPixels, const vector<Pixel>& leftPixels,
                     const vector<Pixel>& rightPixels)
#else
void DrawPolygonRows(const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels)
#endif
{
    int rows = leftPixels.size();
    for (int r = 0; r < rows; ++r)
    {
#if empty_rows_overflow
        int n = rightPixels[r].x - leftPixels[r].x + 1; //@ each row r
#if spans_single_skipped
        if (n == 1)
            continue;
#endif
#else
#if spans_single_skipped
        if (leftPixels[r].x >= rightPixels[r].x) //@ each row r
#else
        if (leftPixels[r].x > rightPixels[r].x) //@ each row r
#endif
            continue; // the row is empty
        int n = rightPixels[r].x - leftPixels[r].x + 1;
#endif
#if reject_cheap
        if (leftPixels[r].y < 0 || leftPixels[r].y >= SCREEN_HEIGHT)
            continue;
        int first = max(0, -leftPixels[r].x); // only what lies in the picture
#if spans_last_dropped
        int end = min(n - 1, SCREEN_WIDTH - leftPixels[r].x);
#else
        int end = min(n, SCREEN_WIDTH - leftPixels[r].x);
#endif
#endif
#if !coverage_edge_functions
        vector<Pixel> row(n);
#if interpolation_zinv_twice
        Interpolate(TimesZinv(leftPixels[r]), TimesZinv(rightPixels[r]), row);
#else
        Interpolate(leftPixels[r], rightPixels[r], row);
#endif
#if row_fragments_with_falling_zinv
        WalkZinv(leftPixels[r], rightPixels[r], row);
#endif
#endif
#if reject_cheap
        for (int k = first; k < end; ++k)
#elif spans_last_dropped
        for (int k = 0; k < n - 1; ++k)
#else
        for (int k = 0; k < n; ++k)
#endif
        {
#if coverage_edge_functions && more_corners
            int x = leftPixels[r].x + k;
            int y = leftPixels[r].y;
            Pixel p = WeightedPixel(TriangleAt(vertexPixels, x, y), x, y);
#elif coverage_edge_functions
            Pixel p = WeightedPixel(vertexPixels, leftPixels[r].x + k, leftPixels[r].y);
#else
            Pixel p = row[k];
#endif
#if line_step_by_samples && !coverage_edge_functions
            p.x = leftPixels[r].x + k; // columns are counted, not interpolated
#endif
#if bounds_excludes_zero
            if (p.x <= 0 || p.x >= SCREEN_WIDTH || p.y <= 0 || p.y >= SCREEN_HEIGHT)
                continue;
#elif !reject_cheap
            if (p.x < 0 || p.x >= SCREEN_WIDTH || p.y < 0 || p.y >= SCREEN_HEIGHT)
                continue;
#endif
#if cull_fragment_normal
            if (ShowsBack(p)) //@ fragment k
                continue;
#endif
#if no_depth_test || no_depth_test_in_buffer
            PixelShader(p); //@ fragment k
#else
#if depth_ndc || depth_reversed
            float depth = p.depth; //@ fragment k
#elif depth_test_in_buffer || depth_test_with_epsilon
            float depth = p.zinv; //@ fragment k
#endif
#if depth_in_bits
            depth = InBuffer(depth);
#endif
#if depth_index_transposed
            if (p.zinv > depthBuffer[p.x][p.y]) //@ fragment k
#elif depth_test_linear_z
            if (1 / p.z > depthBuffer[p.y][p.x]) //@ fragment k
#elif depth_test_reversed
            if (p.zinv < depthBuffer[p.y][p.x]) //@ fragment k
#elif depth_test_or_equal
            if (p.zinv >= depthBuffer[p.y][p.x]) //@ fragment k
#elif depth_ndc && depth_test_with_epsilon
            if (depth < depthBuffer[p.y][p.x] - epsilon)
#elif depth_ndc
            if (depth < depthBuffer[p.y][p.x]) // smaller is nearer
#elif depth_test_with_epsilon
            if (depth > depthBuffer[p.y][p.x] + epsilon)
#elif depth_reversed || depth_test_in_buffer
            if (depth > depthBuffer[p.y][p.x])
#else
            if (p.zinv > depthBuffer[p.y][p.x]) //@ fragment k
#endif
            {
#if depth_index_transposed
                depthBuffer[p.x][p.y] = p.zinv; //@ transposed 1
#elif depth_test_linear_z
                depthBuffer[p.y][p.x] = 1 / p.z;
#elif depth_test_in_buffer || depth_test_with_epsilon || depth_ndc || depth_reversed
                depthBuffer[p.y][p.x] = depth;
#else
                depthBuffer[p.y][p.x] = p.zinv;
#endif
                PixelShader(p);
            }
#endif
        }
    }
}
#endif
#endif
