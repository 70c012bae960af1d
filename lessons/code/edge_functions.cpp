#if coverage_edge_functions
// On which side of an edge a point lies, and how far: twice the area of the triangle they make.
double EdgeFunction(const Pixel& from, const Pixel& to, double px, double py)
{
    return (to.gridX - from.gridX) * (py - from.gridY) -
           (to.gridY - from.gridY) * (px - from.gridX);
}

#if !fill_rule_inclusive || more_corners
// Does an edge own the points on it?
bool OwnsPoints(const Pixel& from, const Pixel& to, double area)
{
#if fill_rule_exclusive && !more_corners
    return false;
#else
    double dx = to.gridX - from.gridX;
    double dy = to.gridY - from.gridY;
    if (area < 0)
    {
        dx = -dx; // the corners go round the other way
        dy = -dy;
    }
#if more_corners && !fill_rule_top_left
    if (from.isInner)
        return dy < 0 || (dy == 0 && dx > 0); // always one of its two triangles
#endif
#if fill_rule_exclusive
    return false;
#elif fill_rule_inclusive
    return true;
#else
#if fill_rule_left_only
    return dy < 0;
#else
    return dy < 0 || (dy == 0 && dx > 0);
#endif
#endif
#endif
}

#endif
// Is a point on the inner side of an edge?
bool IsInside(const Pixel& from, const Pixel& to, double e, double area)
{
    double inward = area < 0 ? -e : e;
#if fill_rule_inclusive && !more_corners
    return inward >= 0;
#else
    return inward > 0 || (inward == 0 && OwnsPoints(from, to, area));
#endif
}

#if box_walk_interval
// In which columns of a row an edge function is 0 or more: from each to the next it changes by the
// same step.
void FindColumns(const Pixel& from, const Pixel& to, double area, int y, int left, int& first,
                 int& last)
{
#if pixel_sample_corner
    double px = 256.0 * left;
    double py = 256.0 * y;
#else
    double px = 256.0 * left + 128;
    double py = 256.0 * y + 128;
#endif
    double e = EdgeFunction(from, to, px, py);
    double step = EdgeFunction(from, to, px + 256, py) - e;
    if (area < 0)
    {
        e = -e; // the corners go round the other way
        step = -step;
    }
    if (step > 0)
        first = max(first, left + int(min(ceil(-e / step), 65536.0)));
    if (step < 0)
        last = min(last, left + int(max(floor(e / -step), -65536.0)));
    if (area == 0 || (step == 0 && e < 0))
        last = first - 1; // in none
}

#endif
#if more_corners
// Does a triangle of the fan cover a point?
bool Covers(const Pixel& a, const Pixel& b, const Pixel& c, double area, double px, double py)
{
#if fill_rule_exclusive
    if (px == a.gridX && py == a.gridY)
        return false; // no triangle gets the corner that all share
#endif
    return area != 0 && IsInside(a, b, EdgeFunction(a, b, px, py), area) &&
           IsInside(b, c, EdgeFunction(b, c, px, py), area) &&
           IsInside(c, a, EdgeFunction(c, a, px, py), area);
}

#endif
#if rows_of_samples
// Does the triangle cover this sample of a pixel?
bool CoversSample(const vector<Pixel>& vertexPixels, int x, int y, int s)
{
    Pixel a = vertexPixels[0];
    Pixel b = vertexPixels[1];
    Pixel c = vertexPixels[2];
    double px = 256.0 * x + 128 + sampleX[s];
    double py = 256.0 * y + 128 + sampleY[s];
    double area = EdgeFunction(a, b, c.gridX, c.gridY);
    return area != 0 && IsInside(a, b, EdgeFunction(a, b, px, py), area) &&
           IsInside(b, c, EdgeFunction(b, c, px, py), area) &&
           IsInside(c, a, EdgeFunction(c, a, px, py), area);
}

// Which pixels have samples in the triangle: the first and the last one of each row.
#elif more_corners
// Which pixels have their centres in a triangle of the fan: they make the rows longer.
#else
// Which pixels have their centers in the triangle: the first and the last one of each row.
#endif
#if more_corners
void TestTriangle(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                  vector<Pixel>& rightPixels)
#else
void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                        vector<Pixel>& rightPixels)
#endif
{
    Pixel a = vertexPixels[0];
    Pixel b = vertexPixels[1];
    Pixel c = vertexPixels[2];
#if pixel_sample_corner
    int left = int(floor((min(min(a.gridX, b.gridX), c.gridX) + 128) / 256));
    int right = int(floor((max(max(a.gridX, b.gridX), c.gridX) + 128) / 256));
    int top = int(floor((min(min(a.gridY, b.gridY), c.gridY) + 128) / 256));
    int bottom = int(floor((max(max(a.gridY, b.gridY), c.gridY) + 128) / 256));
#else
    int left = int(floor(min(min(a.gridX, b.gridX), c.gridX) / 256));
    int right = int(floor(max(max(a.gridX, b.gridX), c.gridX) / 256));
    int top = int(floor(min(min(a.gridY, b.gridY), c.gridY) / 256));
    int bottom = int(floor(max(max(a.gridY, b.gridY), c.gridY) / 256));
#endif
    double area = EdgeFunction(a, b, c.gridX, c.gridY);
#if !more_corners
    int rows = bottom - top + 1;
    leftPixels.resize(rows);
    rightPixels.resize(rows);
    for (int r = 0; r < rows; ++r)
    {
        leftPixels[r].x = INT_MAX;
        rightPixels[r].x = -INT_MAX;
        leftPixels[r].y = top + r;
        rightPixels[r].y = top + r;
    }
#endif
#if stage_rows
    int firstRow = top;
    int lastRow = bottom;
    int firstColumn = left;
    int lastColumn = right;
#else
    int firstRow = max(top, 0);
    int lastRow = min(bottom, SCREEN_HEIGHT - 1);
    int firstColumn = max(left, 0);
    int lastColumn = min(right, SCREEN_WIDTH - 1);
#endif
    for (int y = firstRow; y <= lastRow; ++y)
    {
#if more_corners
        int r = y - leftPixels[0].y; //@ each pixelrow y
#else
        int r = y - top; //@ each boxrow y - top
#endif
#if box_walk_interval
        int first = firstColumn;
        int last = lastColumn;
        FindColumns(a, b, area, y, left, first, last);
        FindColumns(b, c, area, y, left, first, last);
        FindColumns(c, a, area, y, left, first, last);
        for (int x = first; x <= last; ++x)
#else
        for (int x = firstColumn; x <= lastColumn; ++x)
#endif
        {
#if rows_of_samples
            bool inside = false; //@ pixelcolumn x
            for (int s = 0; s < 4 && !inside; ++s) //@ pixelrow y
            {
                if (CoversSample(vertexPixels, x, y, s)) //@ test x - left
                    inside = true;
            }
#else
#if pixel_sample_corner
            double px = 256.0 * x; //@ pixelcolumn x
#else
            double px = 256.0 * x + 128; //@ pixelcolumn x
#endif
#if pixel_sample_corner && more_corners
            double py = 256.0 * y; //@ boxrow y - top
#elif more_corners
            double py = 256.0 * y + 128; //@ boxrow y - top
#elif pixel_sample_corner
            double py = 256.0 * y; //@ pixelrow y
#else
            double py = 256.0 * y + 128; //@ pixelrow y
#endif
#if more_corners
            bool inside = Covers(a, b, c, area, px, py); //@ test x - left
#else
            double e0 = EdgeFunction(a, b, px, py); //@ test x - left
            double e1 = EdgeFunction(b, c, px, py);
            double e2 = EdgeFunction(c, a, px, py);
            bool inside = area != 0 && IsInside(a, b, e0, area) && IsInside(b, c, e1, area) &&
                          IsInside(c, a, e2, area);
#endif
#endif
            if (inside && x < leftPixels[r].x)
                leftPixels[r].x = x;
            if (inside && x > rightPixels[r].x)
                rightPixels[r].x = x;
        }
    }
}

#if more_corners
// The rows of a polygon that may have been cut: those of its triangles together.
void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                        vector<Pixel>& rightPixels)
{
    EmptyPolygonRows(vertexPixels, leftPixels, rightPixels);
    int triangles = vertexPixels.size() - 2;
    for (int t = 0; t < triangles; ++t)
    {
        vector<Pixel> corners = FanTriangle(vertexPixels, t); //@ fan t
        TestTriangle(corners, leftPixels, rightPixels);
    }
}

#if !stage_rows
// The triangle of the fan that a pixel belongs to: the first one that covers it. Rounding can bend
// a polygon inward; a pixel at such a dent belongs to the first one that has an area.
vector<Pixel> TriangleAt(const vector<Pixel>& vertexPixels, int x, int y)
{
    int triangles = vertexPixels.size() - 2;
    if (triangles == 1)
        return vertexPixels;
#if pixel_sample_corner
    double px = 256.0 * x;
    double py = 256.0 * y;
#else
    double px = 256.0 * x + 128;
    double py = 256.0 * y + 128;
#endif
    int firstWithArea = -1;
    for (int t = 0; t < triangles; ++t)
    {
        vector<Pixel> corners = FanTriangle(vertexPixels, t);
        Pixel a = corners[0];
        Pixel b = corners[1];
        Pixel c = corners[2];
        double area = EdgeFunction(a, b, c.gridX, c.gridY);
        if (Covers(a, b, c, area, px, py))
            return corners;
        if (area != 0 && firstWithArea < 0)
            firstWithArea = t;
    }
    return FanTriangle(vertexPixels, max(firstWithArea, 0));
}

#endif
#endif
#if (coverage_edge_functions || fragments_by_weights) && !stage_rows
// The values of a pixel: those of the corners, each with its weight.
#if rows_of_samples
Pixel WeightedPixel(const vector<Pixel>& vertexPixels, int x, int y, double right, double down)
#else
Pixel WeightedPixel(const vector<Pixel>& vertexPixels, int x, int y)
#endif
{
#if interpolation_zinv_twice
    Pixel a = TimesZinv(vertexPixels[0]);
    Pixel b = TimesZinv(vertexPixels[1]);
    Pixel c = TimesZinv(vertexPixels[2]);
#else
    Pixel a = vertexPixels[0];
    Pixel b = vertexPixels[1];
    Pixel c = vertexPixels[2];
#endif
#if rows_of_samples
    double px = 256.0 * x + 128 + right;
    double py = 256.0 * y + 128 + down;
#elif pixel_sample_corner
    double px = 256.0 * x;
    double py = 256.0 * y;
#else
    double px = 256.0 * x + 128;
    double py = 256.0 * y + 128;
#endif
    double area = EdgeFunction(a, b, c.gridX, c.gridY);
#if weight_edge_own
    float w0 = float(EdgeFunction(a, b, px, py)) / float(area);
    float w1 = float(EdgeFunction(b, c, px, py)) / float(area);
    float w2 = float(EdgeFunction(c, a, px, py)) / float(area);
#else
    float w0 = float(EdgeFunction(b, c, px, py)) / float(area);
    float w1 = float(EdgeFunction(c, a, px, py)) / float(area);
    float w2 = float(EdgeFunction(a, b, px, py)) / float(area);
#endif
    Pixel p;
    p.x = x;
    p.y = y;
    p.zinv = a.zinv * w0 + b.zinv * w1 + c.zinv * w2;
#if depth_ndc || depth_reversed
    p.depth = a.depth * w0 + b.depth * w1 + c.depth * w2;
#endif
#if depth_test_linear_z
    p.z = a.z * w0 + b.z * w1 + c.z * w2;
#endif
#if scene_textures
    p.texcoord = a.texcoord * w0 + b.texcoord * w1 + c.texcoord * w2;
#endif
#if stage_vertex_light
    p.illumination = a.illumination * w0 + b.illumination * w1 + c.illumination * w2;
#endif
#if carried_pos3d
    p.pos3d = a.pos3d * w0 + b.pos3d * w1 + c.pos3d * w2;
#endif
#if carried_normal
    p.normal = a.normal * w0 + b.normal * w1 + c.normal * w2;
#endif
#if carried_color
    p.color = a.color * w0 + b.color * w1 + c.color * w2;
#endif
    return p;
}
#endif
#endif
