#if coverage_scan_conversion || coverage_active_edges || (coverage_edge_functions && more_corners)
// A table of empty rows: all that the box of a polygon touches.
void EmptyRows(double top, double bottom, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels)
{
    int firstRow = int(floor(top / 256));
    int rows = int(floor(bottom / 256)) - firstRow + 1;
    leftPixels.resize(rows);
    rightPixels.resize(rows);
    for (int r = 0; r < rows; ++r)
    {
        leftPixels[r].x = INT_MAX;
        rightPixels[r].x = -INT_MAX;
        leftPixels[r].y = firstRow + r;
        rightPixels[r].y = firstRow + r;
    }
}
#endif
#if !stage_points && !stage_edges && !coverage_edge_functions
#if !coverage_scan_conversion && !coverage_active_edges
#if row_search_all_rows
// The place of a row of the picture in the table: every row is looked at.
int FindRow(int y, const vector<Pixel>& leftPixels)
{
    int row = -1;
    for (int r = 0; r < leftPixels.size(); ++r)
    {
        if (leftPixels[r].y == y)
            row = r;
    }
    return row;
}

#endif
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
#if row_start_row_short
    int rows = max(ymax - ymin, 1);
#else
    int rows = ymax - ymin + 1;
#endif
    leftPixels.resize(rows);
    rightPixels.resize(rows);
    for (int r = 0; r < rows; ++r)
    {
#if row_start_window
        leftPixels[r].x = SCREEN_WIDTH;
        rightPixels[r].x = 0;
#else
        leftPixels[r].x = INT_MAX;
        rightPixels[r].x = -INT_MAX;
#endif
        leftPixels[r].y = ymin + r;
        rightPixels[r].y = ymin + r;
    }
#if edge_samples_no_last_edge
    for (int i = 0; i < V - 1; ++i)
#else
    for (int i = 0; i < V; ++i)
#endif
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
#if edge_samples_without_last
        for (int k = 0; k < n - 1; ++k)
#else
        for (int k = 0; k < n; ++k)
#endif
        {
#if row_search_all_rows
            int row = FindRow(line[k].y, leftPixels); //@ sample k
#elif row_search_clamped
            int row = clamp(line[k].y - ymin, 0, rows - 1); //@ sample k
#else
            int row = line[k].y - ymin; //@ sample k
#endif
            if (row < 0 || row >= rows)
                continue;
#if row_search_clamped
            line[k].y = ymin + row;
#endif
            if (line[k].x < leftPixels[row].x)
#if row_search_column_only
                leftPixels[row].x = line[k].x;
#else
                leftPixels[row] = line[k];
#endif
            if (line[k].x > rightPixels[row].x)
#if row_search_column_only
                rightPixels[row].x = line[k].x;
#else
                rightPixels[row] = line[k];
#endif
        }
    }
}
#endif
#endif
