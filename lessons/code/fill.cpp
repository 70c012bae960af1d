#if !stage_points && !stage_edges && !stage_rows
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
        if (leftPixels[r].x > rightPixels[r].x) //@ each row r
            continue; // no sample has reached it
        int n = rightPixels[r].x - leftPixels[r].x + 1;
#if coverage_edge_functions
        for (int k = 0; k < n; ++k)
        {
            Pixel p = WeightedPixel(vertexPixels, leftPixels[r].x + k, leftPixels[r].y);
            if (p.x < 0 || p.x >= SCREEN_WIDTH || p.y < 0 || p.y >= SCREEN_HEIGHT)
                continue;
#else
        vector<Pixel> row(n);
        Interpolate(leftPixels[r], rightPixels[r], row);
        for (int k = 0; k < n; ++k)
        {
            Pixel p = row[k];
            if (p.x < 0 || p.x >= SCREEN_WIDTH || p.y < 0 || p.y >= SCREEN_HEIGHT)
                continue;
#endif
#if no_depth_test
            PixelShader(p); //@ fragment k
#else
#if depth_test_reversed
            if (p.zinv < depthBuffer[p.y][p.x]) //@ fragment k
#elif depth_test_with_epsilon
            if (p.zinv > depthBuffer[p.y][p.x] + epsilon) //@ fragment k
#elif depth_test_or_equal
            if (p.zinv >= depthBuffer[p.y][p.x]) //@ fragment k
#else
            if (p.zinv > depthBuffer[p.y][p.x]) //@ fragment k
#endif
            {
                depthBuffer[p.y][p.x] = p.zinv;
                PixelShader(p);
            }
#endif
        }
    }
}
#endif
