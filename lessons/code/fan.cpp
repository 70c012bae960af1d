#if more_corners && !stage_points && !stage_edges
#if coverage_edge_functions || coverage_scan_conversion || coverage_active_edges
// A table of empty rows for all corners of a polygon.
void EmptyPolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                      vector<Pixel>& rightPixels)
{
    double top = vertexPixels[0].gridY;
    double bottom = vertexPixels[0].gridY;
    for (int i = 1; i < vertexPixels.size(); ++i)
    {
        top = min(top, vertexPixels[i].gridY);
        bottom = max(bottom, vertexPixels[i].gridY);
    }
#if coverage_edge_functions && pixel_sample_corner
    EmptyRows(top + 128, bottom + 128, leftPixels, rightPixels);
#else
    EmptyRows(top, bottom, leftPixels, rightPixels);
#endif
}

#endif
#if (coverage_edge_functions && !fill_rule_top_left) || coverage_active_edges
// Does any of these triangles of the fan have an area?
bool HaveArea(const vector<Pixel>& vertexPixels, int first, int end)
{
    Pixel a = vertexPixels[0];
    for (int t = first; t < end; ++t)
    {
        Pixel b = vertexPixels[t + 1];
        Pixel c = vertexPixels[t + 2];
        if ((b.gridX - a.gridX) * (c.gridY - a.gridY) != (b.gridY - a.gridY) * (c.gridX - a.gridX))
            return true;
    }
    return false;
}

#endif
#if coverage_edge_functions || coverage_scan_conversion
// A polygon that is cut can have more than three corners. It is drawn as triangles, which lie like
// those of a fan: each has the first corner, and two neighbors.
vector<Pixel> FanTriangle(const vector<Pixel>& vertexPixels, int t)
{
    vector<Pixel> corners(3);
    corners[0] = vertexPixels[0];
    corners[1] = vertexPixels[t + 1];
    corners[2] = vertexPixels[t + 2];
#if coverage_edge_functions && !fill_rule_top_left
    int triangles = vertexPixels.size() - 2;
    corners[0].isInner = HaveArea(vertexPixels, 0, t);
    corners[1].isInner = false;
    corners[2].isInner = HaveArea(vertexPixels, t + 1, triangles);
#endif
    return corners;
}
#endif
#endif
