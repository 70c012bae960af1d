// One pixel of the picture.
void PutPixel(int x, int y, vec3 color)
{
#if bounds_excludes_zero
    if (x <= 0 || x >= SCREEN_WIDTH || y <= 0 || y >= SCREEN_HEIGHT)
#else
    if (x < 0 || x >= SCREEN_WIDTH || y < 0 || y >= SCREEN_HEIGHT)
#endif
        return;
#if rows_of_samples
    for (int s = 0; s < 4; ++s)
    {
        if (!writes[s])
            continue;
        int at = 4 * x + s;
#if scene_transparency
        if (currentAlpha < 1)
#if blend_swapped
            sampleColors[y][at] = color * (1 - currentAlpha) + sampleColors[y][at] * currentAlpha;
#else
            sampleColors[y][at] = color * currentAlpha + sampleColors[y][at] * (1 - currentAlpha);
#endif
        else
            sampleColors[y][at] = color;
#else
        sampleColors[y][at] = color;
#endif
    }
#elif scene_transparency
    if (currentAlpha < 1)
#if blend_swapped
        frame[y][x] = color * (1 - currentAlpha) + frame[y][x] * currentAlpha;
#else
        frame[y][x] = color * currentAlpha + frame[y][x] * (1 - currentAlpha);
#endif
    else
        frame[y][x] = color;
#else
    frame[y][x] = color;
#endif
}
