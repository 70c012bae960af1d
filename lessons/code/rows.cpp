#if !stage_points && !stage_edges && !coverage_edge_functions
// Where each row of a polygon begins and ends.
void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                        vector<Pixel>& rightPixels)
{
    int V = vertexPixels.size();
    int ymin = vertexPixels[0].y;
    int ymax = vertexPixels[0].y;
    for (int i = 1; i < V; ++i)
    {
        ymin = min(ymin, vertexPixels[i].y);
        ymax = max(ymax, vertexPixels[i].y);
    }
    int rows = ymax - ymin + 1;
    leftPixels.resize(rows);
    rightPixels.resize(rows);
    for (int r = 0; r < rows; ++r)
    {
        leftPixels[r].x = INT_MAX;
        rightPixels[r].x = -INT_MAX;
        leftPixels[r].y = ymin + r;
        rightPixels[r].y = ymin + r;
    }
    for (int i = 0; i < V; ++i)
    {
        int j = (i + 1) % V; //@ edge i
        Pixel a = vertexPixels[i];
        Pixel b = vertexPixels[j];
#if edge_samples_rows
        int n = abs(a.y - b.y) + 1;
#elif edge_samples_shifted
        int n = max(max(abs(a.x - b.x + 1), abs(a.y - b.y + 1)), 1);
#elif line_bresenham && bresenham_rule_first_octant
        int n = max(b.x - a.x, 0) + 1;
#else
        int n = max(abs(a.x - b.x), abs(a.y - b.y)) + 1;
#endif
        vector<Pixel> line(n);
#if line_bresenham
        Bresenham(a, b, line);
#elif line_midpoint
        Midpoint(a, b, line);
#elif line_dda
        DDA(a, b, line);
#else
        Interpolate(a, b, line);
#endif
        for (int k = 0; k < n; ++k)
        {
            int row = line[k].y - ymin; //@ sample k
            if (row < 0 || row >= rows)
                continue;
            if (line[k].x < leftPixels[row].x)
                leftPixels[row] = line[k];
            if (line[k].x > rightPixels[row].x)
                rightPixels[row] = line[k];
        }
    }
}
#endif
