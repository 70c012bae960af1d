#if stage_rows
// The two ends of every row: yellow on the left, blue on the right.
void DrawRowEnds(const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels)
{
    int rows = leftPixels.size();
    for (int r = 0; r < rows; ++r)
    {
        int y = leftPixels[r].y;
#if bounds_excludes_zero
        if (leftPixels[r].x > rightPixels[r].x || y <= 0 || y >= SCREEN_HEIGHT)
#else
        if (leftPixels[r].x > rightPixels[r].x || y < 0 || y >= SCREEN_HEIGHT)
#endif
            continue;
        PutPixel(leftPixels[r].x, y, vec3(0.941f, 0.894f, 0.259f)); //@ row r
        PutPixel(rightPixels[r].x, y, vec3(0.0f, 0.447f, 0.698f));
    }
}
#endif
