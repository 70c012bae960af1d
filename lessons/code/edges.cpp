#if stage_edges
// The edges of a polygon, sample by sample.
void DrawPolygonEdges(const vector<Pixel>& vertexPixels)
{
    int V = vertexPixels.size();
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
            PutPixel(line[k].x, line[k].y, vec3(1, 1, 1)); //@ sample k
    }
}
#endif
