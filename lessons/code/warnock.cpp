#if hidden_warnock
// A row of a polygon, with all its pixels.
struct SurfaceRow
{
    int left;
    int end; // after its last column
    double depth; // 1/z at its left end
    double step; // from column to column
    int firstPixel; // in surfacePixels
};

// A polygon as the pixels that it covers.
struct Surface
{
    int triangle;
    int firstRow; // of the picture
    int firstEntry; // of the first row in surfaceRows
    int left; // the box around it
    int top;
    int right;
    int bottom;
};

struct Square
{
    int left;
    int top;
    int right;
    int bottom;
};

vector<Surface> surfaces;
vector<SurfaceRow> surfaceRows;
vector<Pixel> surfacePixels;
int squareCount = 0; // that have been looked at

// Keeps the rows of a polygon for later.
void KeepSurface(int triangle, const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels)
{
    Surface surface = {triangle, leftPixels[0].y, int(surfaceRows.size()), INT_MAX, INT_MAX, 0, 0};
    for (int r = 0; r < leftPixels.size(); ++r)
    {
        SurfaceRow row = {leftPixels[r].x, leftPixels[r].x, 0, 0, int(surfacePixels.size())};
        int n = 0;
        if (leftPixels[r].x <= rightPixels[r].x)
            n = rightPixels[r].x - leftPixels[r].x + 1;
        vector<Pixel> pixels(n);
        if (n > 0)
        {
            Interpolate(leftPixels[r], rightPixels[r], pixels);
            row.end = row.left + n;
            row.depth = leftPixels[r].zinv;
            row.step = (double(rightPixels[r].zinv) - leftPixels[r].zinv) / max(n - 1, 1);
        }
        for (int k = 0; k < n; ++k)
            surfacePixels.push_back(pixels[k]);
        surfaceRows.push_back(row);
        int y = leftPixels[r].y;
        if (n > 0 && y >= 0 && y < SCREEN_HEIGHT)
        {
            surface.left = min(surface.left, row.left);
            surface.right = max(surface.right, row.end);
            surface.top = min(surface.top, y);
            surface.bottom = max(surface.bottom, y + 1);
        }
    }
    surfaces.push_back(surface);
}

SurfaceRow RowOf(const Surface& surface, int y)
{
    return surfaceRows[surface.firstEntry + y - surface.firstRow];
}

// Does a polygon cover a pixel of a square?
bool Meets(const Surface& surface, const Square& square)
{
    if (surface.left >= square.right || surface.right <= square.left)
        return false;
    for (int y = max(surface.top, square.top); y < min(surface.bottom, square.bottom); ++y)
    {
        SurfaceRow row = RowOf(surface, y);
        if (max(row.left, square.left) < min(row.end, square.right))
            return true;
    }
    return false;
}

// Does it cover all of them?
bool Surrounds(const Surface& surface, const Square& square)
{
    if (surface.top > square.top || surface.bottom < square.bottom)
        return false;
    for (int y = square.top; y < square.bottom; ++y)
    {
        SurfaceRow row = RowOf(surface, y);
        if (row.left > square.left || row.end < square.right)
            return false;
    }
    return true;
}

double DepthAt(const SurfaceRow& row, int x)
{
    return row.depth + row.step * (double(x) - row.left);
}

bool IsNearerAt(const Surface& surface, const Surface& other, int x, int y)
{
    return DepthAt(RowOf(surface, y), x) > DepthAt(RowOf(other, y), x);
}

// Of the polygons that surround a square, the nearest one at its first pixel; -1: none surrounds
// it.
int NearestSurrounding(const vector<int>& met, const Square& square)
{
    int nearest = -1;
    for (int i = 0; i < met.size(); ++i)
    {
        if (!Surrounds(surfaces[met[i]], square))
            continue;
        if (nearest < 0 || IsNearerAt(surfaces[met[i]], surfaces[nearest], square.left, square.top))
            nearest = met[i];
    }
    return nearest;
}

// Is a polygon in front of another one everywhere in a square? The ends of each row decide.
bool IsInFront(int a, int b, const Square& square)
{
    for (int y = max(surfaces[b].top, square.top); y < min(surfaces[b].bottom, square.bottom); ++y)
    {
        SurfaceRow behind = RowOf(surfaces[b], y);
        int left = max(behind.left, square.left);
        int last = min(behind.end, square.right) - 1;
        if (left > last)
            continue;
        if (a < b && (IsNearerAt(surfaces[b], surfaces[a], left, y) ||
                      IsNearerAt(surfaces[b], surfaces[a], last, y)))
            return false;
        if (a > b && (!IsNearerAt(surfaces[a], surfaces[b], left, y) ||
                      !IsNearerAt(surfaces[a], surfaces[b], last, y)))
            return false;
    }
    return true;
}

// Draws a polygon, but only in a square.
void DrawInSquare(const Surface& surface, const Square& square)
{
    currentReflectance = triangles[surface.triangle].color;
    for (int y = max(surface.top, square.top); y < min(surface.bottom, square.bottom); ++y)
    {
        SurfaceRow row = RowOf(surface, y);
        for (int x = max(row.left, square.left); x < min(row.end, square.right); ++x)
            PixelShader(surfacePixels[row.firstPixel + x - row.left]);
    }
}

// Looks at a square: draws it if it is simple, or looks at each quarter of it.
void LookAt(const Square& square, const vector<int>& candidates)
{
    vector<int> met; //@ square squareCount
    ++squareCount;
    for (int i = 0; i < candidates.size(); ++i)
    {
        if (Meets(surfaces[candidates[i]], square))
            met.push_back(candidates[i]);
    }
    if (met.size() == 0)
        return;
    if (met.size() == 1)
    {
        DrawInSquare(surfaces[met[0]], square);
        return;
    }
    int width = square.right - square.left;
    int height = square.bottom - square.top;
    int nearest = NearestSurrounding(met, square);
    bool isSimple = nearest >= 0;
    for (int i = 0; isSimple && i < met.size() && width * height > 1; ++i)
        isSimple = met[i] == nearest || IsInFront(nearest, met[i], square);
    if (isSimple)
    {
        DrawInSquare(surfaces[nearest], square);
        return;
    }
    int x = square.left + width / 2;
    int y = square.top + height / 2;
    Square topLeft = {square.left, square.top, x, y};
    Square topRight = {x, square.top, square.right, y};
    Square bottomLeft = {square.left, y, x, square.bottom};
    Square bottomRight = {x, y, square.right, square.bottom};
    if (width > 1 && height > 1)
        LookAt(topLeft, met);
    if (height > 1)
        LookAt(topRight, met);
    if (width > 1)
        LookAt(bottomLeft, met);
    LookAt(bottomRight, met);
}

// When the rows of all polygons are known.
void DrawSurfaces()
{
    vector<int> all;
    Square picture = {0, 0, SCREEN_WIDTH, SCREEN_HEIGHT};
    for (int i = 0; i < surfaces.size(); ++i)
    {
        if (surfaces[i].left < surfaces[i].right)
            all.push_back(i);
    }
    LookAt(picture, all);
}
#endif
