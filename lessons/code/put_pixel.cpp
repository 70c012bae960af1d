// One pixel of the picture.
void PutPixel(int x, int y, vec3 color)
{
    if (x < 0 || x >= SCREEN_WIDTH || y < 0 || y >= SCREEN_HEIGHT)
        return;
#if scene_transparency
    if (currentAlpha < 1)
        frame[y][x] = color * currentAlpha + frame[y][x] * (1 - currentAlpha);
    else
        frame[y][x] = color;
#else
    frame[y][x] = color;
#endif
}
