#if coverage_active_edges
// The edges of a polygon that are not level, each from its upper end down.
vector<Edge> SlopingEdges(const vector<Pixel>& vertexPixels)
{
    vector<Edge> edges;
    int V = vertexPixels.size();
    for (int i = 0; i < V; ++i)
    {
        Edge edge;
        edge.top = vertexPixels[i];
        edge.bottom = vertexPixels[(i + 1) % V];
        if (edge.top.gridY > edge.bottom.gridY)
        {
            edge.top = vertexPixels[(i + 1) % V];
            edge.bottom = vertexPixels[i];
        }
        if (edge.top.gridY < edge.bottom.gridY)
            edges.push_back(edge);
    }
    return edges;
}

// The first and the last pixel of a row between its active edges, those that cross it; false if
// there are none. An edge counts at its upper end, or at its lower end.
bool ActiveRow(const vector<Edge>& edges, int y, bool atUpperEnd, Pixel& left, Pixel& right)
{
    double py = 256.0 * y + 128;
    vector<Edge> active;
    for (int i = 0; i < edges.size(); ++i)
    {
        Edge edge = edges[i];
        bool isBelowTop = edge.top.gridY < py || (atUpperEnd && edge.top.gridY == py);
        bool isAboveEnd = py < edge.bottom.gridY || (!atUpperEnd && edge.bottom.gridY == py);
        if (isBelowTop && isAboveEnd)
            active.push_back(edge);
    }
#if more_corners
    // From left to right. Rounding can bend a polygon inward: four edges may cross a row then.
    for (int i = 1; i < active.size(); ++i)
    {
        for (int j = i; j > 0 && CrossingX(active[j], py) < CrossingX(active[j - 1], py); --j)
        {
            Edge edge = active[j];
            active[j] = active[j - 1];
            active[j - 1] = edge;
        }
    }
    bool found = false;
    for (int i = 1; i < active.size(); i += 2)
    {
        Pixel first;
        Pixel last;
        if (!RowBetween(active[i - 1], active[i], y, first, last))
            continue;
        if (!found)
            left = first;
        right = last;
        found = true;
    }
    return found;
#else
    if (active.size() < 2)
        return false;
    if (CrossingX(active[1], py) < CrossingX(active[0], py))
        return RowBetween(active[1], active[0], y, left, right);
    return RowBetween(active[0], active[1], y, left, right);
#endif
}

// Where each row of a triangle begins and ends.
void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                        vector<Pixel>& rightPixels)
{
#if more_corners
    EmptyPolygonRows(vertexPixels, leftPixels, rightPixels);
    int triangles = vertexPixels.size() - 2;
    if (!HaveArea(vertexPixels, 0, triangles))
        return;
#else
    Pixel a = vertexPixels[0];
    Pixel b = vertexPixels[1];
    Pixel c = vertexPixels[2];
    double top = min(min(a.gridY, b.gridY), c.gridY);
    double bottom = max(max(a.gridY, b.gridY), c.gridY);
    EmptyRows(top, bottom, leftPixels, rightPixels);
    double area =
        (b.gridX - a.gridX) * (c.gridY - a.gridY) - (b.gridY - a.gridY) * (c.gridX - a.gridX);
    if (area == 0)
        return;
#endif
    vector<Edge> edges = SlopingEdges(vertexPixels);
    int rows = leftPixels.size();
    for (int r = 0; r < rows; ++r)
    {
        int y = leftPixels[r].y;
        Pixel left;
        Pixel right;
#if fill_rule_top_left
        if (ActiveRow(edges, y, true, left, right))
        {
            leftPixels[r] = left;
            rightPixels[r] = right;
        }
#elif fill_rule_inclusive
        // A corner may lie on the row: it belongs to what is below it and to what is above it.
        if (ActiveRow(edges, y, true, left, right))
        {
            leftPixels[r] = left;
            rightPixels[r] = right;
        }
        if (ActiveRow(edges, y, false, left, right))
        {
            if (left.x < leftPixels[r].x)
                leftPixels[r] = left;
            if (right.x > rightPixels[r].x)
                rightPixels[r] = right;
        }
#else
        // A corner may lie on the row: it must lie between the edges below it and those above it.
        Pixel leftAbove;
        Pixel rightAbove;
        if (!ActiveRow(edges, y, true, left, right) ||
            !ActiveRow(edges, y, false, leftAbove, rightAbove))
            continue;
        if (left.x < leftAbove.x)
            left = leftAbove;
        if (right.x > rightAbove.x)
            right = rightAbove;
        if (left.x > right.x)
            continue;
        leftPixels[r] = left;
        rightPixels[r] = right;
#endif
    }
}
#endif
