#if mip_levels && !stage_points && !stage_edges && !stage_rows
// The weight that texture coordinates have while they are interpolated.
float CarriedWeight(const Pixel& p)
{
#if interpolation_affine || interpolation_undivided
    return 1;
#elif interpolation_mixed
    return Weight(p.zinv);
#elif interpolation_divided_twice
    return p.zinv * p.zinv;
#else
    return p.zinv;
#endif
}

// A step over the screen from one vertex to another, in pixels.
double StepX(const Pixel& from, const Pixel& to)
{
#if coverage_edge_functions
    return to.gridX / 256 - from.gridX / 256;
#else
    return to.x - from.x;
#endif
}

double StepY(const Pixel& from, const Pixel& to)
{
#if coverage_edge_functions
    return to.gridY / 256 - from.gridY / 256;
#else
    return to.y - from.y;
#endif
}

// How the place in the texture changes from pixel to pixel.
void ComputeTextureSlope(const vector<Pixel>& vertexPixels)
{
    texcoordRight = vec2(0, 0);
    texcoordDown = vec2(0, 0);
    weightRight = 0;
    weightDown = 0;
    double largest = 0;
    for (int i = 2; i < vertexPixels.size(); ++i)
    {
        const Pixel& a = vertexPixels[0];
        const Pixel& b = vertexPixels[i - 1];
        const Pixel& c = vertexPixels[i];
        double abX = StepX(a, b);
        double abY = StepY(a, b);
        double acX = StepX(a, c);
        double acY = StepY(a, c);
        double area = abX * acY - abY * acX;
        if (!(abs(area) > largest))
            continue; // only the polygon's largest triangle counts: it is the most accurate
        largest = abs(area);
        double abU = double(b.texcoord.x) - a.texcoord.x;
        double acU = double(c.texcoord.x) - a.texcoord.x;
        double abV = double(b.texcoord.y) - a.texcoord.y;
        double acV = double(c.texcoord.y) - a.texcoord.y;
        double abWeight = double(CarriedWeight(b)) - CarriedWeight(a);
        double acWeight = double(CarriedWeight(c)) - CarriedWeight(a);
        texcoordRight = vec2((abU * acY - acU * abY) / area, (abV * acY - acV * abY) / area);
        texcoordDown = vec2((acU * abX - abU * acX) / area, (acV * abX - abV * acX) / area);
        weightRight = (abWeight * acY - acWeight * abY) / area;
        weightDown = (acWeight * abX - abWeight * acX) / area;
    }
}

// The length in texels of a step in texture coordinates.
float InTexels(const Texture& texture, vec2 step)
{
    float x = step.x * texture.width;
    float y = step.y * texture.height;
    return sqrt(x * x + y * y);
}

// The copy whose texels are about as large as the pixel; it may lie between two copies.
float TextureLevel(const Texture& texture, const Pixel& p)
{
    float weight = CarriedWeight(p);
    vec2 place = CarriedPlace(p);
    float right = InTexels(texture, (texcoordRight - place * weightRight) / weight);
#if texel_rule_level_along_x
    float longer = max(1.0f, right);
#else
    float down = InTexels(texture, (texcoordDown - place * weightDown) / weight);
    float longer = max(1.0f, max(right, down));
#endif
    return min(float(log2(double(longer))), float(texture.lastLevel));
}

#if texture_filter_mipmap
// The color of a texture: from the copy that suits best.
vec3 LevelColor(int texture, vec2 place, const Pixel& p)
{
    float level = TextureLevel(textures[texture], p);
    int nearest = max(int(ceil(level + 0.5f)) - 1, 0);
    return FourTexels(textures[texture + nearest], place.x, place.y, vec3(0, 0, 0), 1);
}
#elif texture_filter_trilinear
// The color of a texture: mixed from the two copies that suit best.
vec3 LevelColor(int texture, vec2 place, const Pixel& p)
{
    float level = TextureLevel(textures[texture], p);
    int first = int(level);
    float share = level - first;
    vec3 color = vec3(0, 0, 0);
    color = FourTexels(textures[texture + first], place.x, place.y, color, 1 - share);
    if (first < textures[texture].lastLevel)
        color = FourTexels(textures[texture + first + 1], place.x, place.y, color, share);
    return color;
}
#endif
#endif
