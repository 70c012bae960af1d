#if coverage_edge_functions && !stage_points && !stage_edges
// On which side of an edge a point lies, and how far: twice the area of the triangle they make.
double EdgeFunction(const Pixel& from, const Pixel& to, double px, double py)
{
    return (to.gridX - from.gridX) * (py - from.gridY) -
           (to.gridY - from.gridY) * (px - from.gridX);
}

#if !fill_rule_inclusive
// Does an edge own the points on it?
bool OwnsPoints(const Pixel& from, const Pixel& to, double area)
{
#if fill_rule_exclusive
    return false;
#else
    double dx = to.gridX - from.gridX;
    double dy = to.gridY - from.gridY;
    if (area < 0)
    {
        dx = -dx; // the corners go round the other way
        dy = -dy;
    }
#if fill_rule_left_only
    return dy < 0;
#elif fill_rule_top_left
    return dy < 0 || (dy == 0 && dx > 0);
#endif
#endif
}

#endif
// Is a point on the inner side of an edge?
bool IsInside(const Pixel& from, const Pixel& to, double e, double area)
{
    double inward = area < 0 ? -e : e;
#if fill_rule_inclusive
    return inward >= 0;
#else
    return inward > 0 || (inward == 0 && OwnsPoints(from, to, area));
#endif
}

// Which pixels have their centres in the triangle: the first and the last one of each row.
void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                        vector<Pixel>& rightPixels)
{
    Pixel a = vertexPixels[0];
    Pixel b = vertexPixels[1];
    Pixel c = vertexPixels[2];
    int left = int(floor(min(min(a.gridX, b.gridX), c.gridX) / 256));
    int right = int(floor(max(max(a.gridX, b.gridX), c.gridX) / 256));
    int top = int(floor(min(min(a.gridY, b.gridY), c.gridY) / 256));
    int bottom = int(floor(max(max(a.gridY, b.gridY), c.gridY) / 256));
    double area = EdgeFunction(a, b, c.gridX, c.gridY);
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
        int r = y - top; //@ boxrow y - top
        for (int x = firstColumn; x <= lastColumn; ++x)
        {
            double px = 256.0 * x + 128; //@ pixelcolumn x
            double py = 256.0 * y + 128; //@ pixelrow y
            double e0 = EdgeFunction(a, b, px, py); //@ test x - left
            double e1 = EdgeFunction(b, c, px, py);
            double e2 = EdgeFunction(c, a, px, py);
            bool inside = area != 0 && IsInside(a, b, e0, area) && IsInside(b, c, e1, area) &&
                          IsInside(c, a, e2, area);
            if (inside && x < leftPixels[r].x)
                leftPixels[r].x = x;
            if (inside && x > rightPixels[r].x)
                rightPixels[r].x = x;
        }
    }
}

#if !stage_rows
// The values of a pixel: those of the corners, each with its weight.
Pixel WeightedPixel(const vector<Pixel>& vertexPixels, int x, int y)
{
    Pixel a = vertexPixels[0];
    Pixel b = vertexPixels[1];
    Pixel c = vertexPixels[2];
    double px = 256.0 * x + 128;
    double py = 256.0 * y + 128;
    double area = EdgeFunction(a, b, c.gridX, c.gridY);
    float w0 = float(EdgeFunction(b, c, px, py)) / float(area);
    float w1 = float(EdgeFunction(c, a, px, py)) / float(area);
    float w2 = float(EdgeFunction(a, b, px, py)) / float(area);
    Pixel p;
    p.x = x;
    p.y = y;
    p.zinv = a.zinv * w0 + b.zinv * w1 + c.zinv * w2;
#if scene_textures
    p.texcoord = a.texcoord * w0 + b.texcoord * w1 + c.texcoord * w2;
#endif
#if stage_vertex_light
    p.illumination = a.illumination * w0 + b.illumination * w1 + c.illumination * w2;
#endif
#if stage_pixel_light
    p.pos3d = a.pos3d * w0 + b.pos3d * w1 + c.pos3d * w2;
#endif
#if stage_pixel_light && scene_corners
    p.normal = a.normal * w0 + b.normal * w1 + c.normal * w2;
    p.color = a.color * w0 + b.color * w1 + c.color * w2;
#endif
    return p;
}
#endif
#endif
