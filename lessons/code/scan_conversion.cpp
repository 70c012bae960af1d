#if coverage_scan_conversion || coverage_active_edges
// An edge that is not level, from its upper end down.
struct Edge
{
    Pixel top;
    Pixel bottom;
};

// The first row or column of pixels whose centers lie at a place of the grid or beyond it.
int FirstFrom(double place)
{
    return int(ceil((place - 128) / 256));
}

// The last row or column of pixels whose centers lie at a place of the grid or before it.
int LastTo(double place)
{
    return int(floor((place - 128) / 256));
}

// Where an edge crosses a row of centers.
double CrossingX(const Edge& edge, double py)
{
    double height = edge.bottom.gridY - edge.top.gridY;
    double across = (edge.bottom.gridX - edge.top.gridX) * (py - edge.top.gridY);
    // Whole grid steps first, then the rest: exact up to the last division.
    double whole = floor(across / height);
    return edge.top.gridX + whole + (across - whole * height) / height;
}

// What an edge carries there.
Pixel CrossingValues(const Edge& edge, double py)
{
    float t = float(py - edge.top.gridY) / float(edge.bottom.gridY - edge.top.gridY);
    return Mix(edge.top, edge.bottom, t);
}

// The first and the last pixel of a row between two edges; false if it has none.
bool RowBetween(const Edge& leftEdge, const Edge& rightEdge, int y, Pixel& left, Pixel& right)
{
    double py = 256.0 * y + 128;
    double fromX = CrossingX(leftEdge, py);
    double toX = CrossingX(rightEdge, py);
#if fill_rule_exclusive
    int first = LastTo(fromX) + 1;
    int last = FirstFrom(toX) - 1;
#elif fill_rule_inclusive
    int first = FirstFrom(fromX);
    int last = LastTo(toX);
#else
    int first = FirstFrom(fromX); // a center on the left edge is inside, one on the right is not
    int last = FirstFrom(toX) - 1;
#endif
    if (first > last)
        return false;
    Pixel from = CrossingValues(leftEdge, py);
    Pixel to = CrossingValues(rightEdge, py);
    double width = toX - fromX;
    double tLeft = width > 0 ? (256.0 * first + 128 - fromX) / width : 0.0;
    double tRight = width > 0 ? (256.0 * last + 128 - fromX) / width : 0.0;
    left = Mix(from, to, float(tLeft));
    left.x = first;
    left.y = y;
    right = Mix(from, to, float(tRight));
    right.x = last;
    right.y = y;
    return true;
}
#endif
#if coverage_scan_conversion
// The rows of one half of a triangle: those between two of its edges.
void ConvertRows(const Edge& leftEdge, const Edge& rightEdge, int first, int last,
                 vector<Pixel>& leftPixels, vector<Pixel>& rightPixels)
{
    for (int y = first; y <= last; ++y)
    {
        Pixel left;
        Pixel right;
        if (!RowBetween(leftEdge, rightEdge, y, left, right))
            continue;
        int r = y - leftPixels[0].y;
#if more_corners
        if (left.x < leftPixels[r].x) // other triangles of the fan may have pixels there
            leftPixels[r] = left;
        if (right.x > rightPixels[r].x)
            rightPixels[r] = right;
#else
        leftPixels[r] = left;
        rightPixels[r] = right;
#endif
    }
}

Edge MakeEdge(const Pixel& top, const Pixel& bottom)
{
    Edge edge;
    edge.top = top;
    edge.bottom = bottom;
    return edge;
}

void Swap(Pixel& a, Pixel& b)
{
    Pixel c = a;
    a = b;
    b = c;
}

#if more_corners
// The rows of a triangle of the fan: its upper half, and then its lower half.
void ConvertTriangle(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                     vector<Pixel>& rightPixels)
#else
// Where each row of a triangle begins and ends: its upper half, and then its lower half.
void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels,
                        vector<Pixel>& rightPixels)
#endif
{
    Pixel top = vertexPixels[0];
    Pixel middle = vertexPixels[1];
    Pixel bottom = vertexPixels[2];
    if (middle.gridY < top.gridY)
        Swap(top, middle);
    if (bottom.gridY < middle.gridY)
        Swap(middle, bottom);
    if (middle.gridY < top.gridY)
        Swap(top, middle);
#if !more_corners
    EmptyRows(top.gridY, bottom.gridY, leftPixels, rightPixels);
#endif
    Edge whole = MakeEdge(top, bottom);
    Edge upper = MakeEdge(top, middle);
    Edge lower = MakeEdge(middle, bottom);
    double area = (middle.gridX - top.gridX) * (bottom.gridY - top.gridY) -
                  (middle.gridY - top.gridY) * (bottom.gridX - top.gridX);
    if (area == 0)
        return;
    if (top.gridY < middle.gridY)
    {
        int first = FirstFrom(top.gridY);
#if fill_rule_inclusive
        int last = FirstFrom(middle.gridY) - 1;
        if (middle.gridY == bottom.gridY)
            last = LastTo(middle.gridY);
#else
        int last = FirstFrom(middle.gridY) - 1;
#endif
        if (area > 0)
            ConvertRows(whole, upper, first, last, leftPixels, rightPixels);
        else
            ConvertRows(upper, whole, first, last, leftPixels, rightPixels);
    }
    if (middle.gridY < bottom.gridY)
    {
#if fill_rule_exclusive || fill_rule_left_only
        int first = top.gridY == middle.gridY ? LastTo(middle.gridY) + 1 : FirstFrom(middle.gridY);
#else
        int first = FirstFrom(middle.gridY);
#endif
        int last = LastTo(bottom.gridY);
        if (area > 0)
            ConvertRows(whole, lower, first, last, leftPixels, rightPixels);
        else
            ConvertRows(lower, whole, first, last, leftPixels, rightPixels);
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
        vector<Pixel> corners = FanTriangle(vertexPixels, t);
        ConvertTriangle(corners, leftPixels, rightPixels);
    }
}
#endif
#endif
