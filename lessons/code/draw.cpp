// One polygon, from its vertices to its pixels.
void DrawPolygon(const vector<Vertex>& vertices)
{
    int V = vertices.size();
    vector<Pixel> vertexPixels(V);
    for (int i = 0; i < V; ++i)
        VertexShader(vertices[i], vertexPixels[i]); //@ vertex i
#if cull_face_normal
    if (dot(currentNormal, vertices[0].position - cameraPos) > 0) //@ cull 0
        return; // its back is turned to the camera
#endif
    for (int i = 0; i < V; ++i)
    {
        if (vertexPixels[i].zinv == 0)
            return;
    }
#if cull_screen_area
    vec3 a = vertexPixels[0].beforeDivision;
    vec3 b = vertexPixels[1].beforeDivision;
    vec3 c = vertexPixels[2].beforeDivision;
    if (dot(a, cross(b, c)) < 0) //@ cull 0
        return; // its corners go round the wrong way: its back is seen
#endif
#if stage_points
    for (int i = 0; i < V; ++i)
        PutPixel(vertexPixels[i].x, vertexPixels[i].y, vec3(1, 1, 1));
#elif stage_edges
    DrawPolygonEdges(vertexPixels);
#else
    vector<Pixel> leftPixels;
    vector<Pixel> rightPixels;
    ComputePolygonRows(vertexPixels, leftPixels, rightPixels);
#if stage_rows
    DrawRowEnds(leftPixels, rightPixels);
#else
#if coverage_edge_functions
    DrawPolygonRows(vertexPixels, leftPixels, rightPixels);
#else
    DrawPolygonRows(leftPixels, rightPixels);
#endif
#endif
#endif
}

#if stage_flat
bool AreSame(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

vec3 Mean(vec3 a, vec3 b, vec3 c)
{
    if (AreSame(a, b) && AreSame(a, c))
        return a; // without rounding
    return (a + b + c) / 3.0f;
}

#if scene_corners
// Out of the surface, at right angles to two of its edges.
vec3 FaceNormal(const Triangle& triangle)
{
    vec3 across = cross(triangle.v2 - triangle.v0, triangle.v1 - triangle.v0);
    float length = sqrt(dot(across, across));
    if (length > 0)
        return across / length;
    return vec3(0, 0, 0);
}

#endif
#endif
// Every triangle, in the order of the scene.
void Draw()
{
    for (int t = 0; t < triangles.size(); ++t)
    {
        vector<Vertex> vertices(3); //@ each triangle t
        vertices[0].position = triangles[t].v0;
        vertices[1].position = triangles[t].v1;
        vertices[2].position = triangles[t].v2;
#if stage_vertex_light || (stage_pixel_light && scene_corners)
#if scene_corners
        vertices[0].normal = triangles[t].normal0;
        vertices[1].normal = triangles[t].normal1;
        vertices[2].normal = triangles[t].normal2;
        vertices[0].reflectance = triangles[t].color0;
        vertices[1].reflectance = triangles[t].color1;
        vertices[2].reflectance = triangles[t].color2;
#else
        for (int i = 0; i < 3; ++i)
        {
            vertices[i].normal = triangles[t].normal;
            vertices[i].reflectance = triangles[t].color;
        }
#endif
#endif
#if scene_transparency
        currentAlpha = triangles[t].alpha;
#endif
#if scene_textures
        vertices[0].texcoord = triangles[t].texcoord0;
        vertices[1].texcoord = triangles[t].texcoord1;
        vertices[2].texcoord = triangles[t].texcoord2;
        currentTexture = triangles[t].texture;
#endif
#if light_model_blinn_phong && (stage_vertex_light || stage_pixel_light || stage_flat)
        currentSpecular = triangles[t].specular;
        currentExponent = triangles[t].exponent;
#endif
#if scene_corners && stage_pixel_light
        currentSmooth = triangles[t].smooth;
        currentBlended = triangles[t].blended;
        currentNormal = triangles[t].normal0;
        currentReflectance = triangles[t].color0;
#elif stage_pixel_light || cull_face_normal
        currentNormal = triangles[t].normal;
#endif
#if stage_flat
        vec3 middle = Mean(triangles[t].v0, triangles[t].v1, triangles[t].v2);
#if scene_corners
        vec3 normal = triangles[t].normal0;
        if (triangles[t].smooth)
            normal = FaceNormal(triangles[t]);
        vec3 color = Mean(triangles[t].color0, triangles[t].color1, triangles[t].color2);
        currentLight = ReflectedLight(middle, normal, color);
#else
        currentLight = ReflectedLight(middle, triangles[t].normal, triangles[t].color);
#endif
#elif stage_fill || stage_depth || stage_unlit || (stage_pixel_light && !scene_corners)
        currentReflectance = triangles[t].color;
#endif
        DrawPolygon(vertices);
    }
}

// An empty picture: black, and infinitely far away.
void Clear()
{
    for (int y = 0; y < SCREEN_HEIGHT; ++y)
    {
        for (int x = 0; x < SCREEN_WIDTH; ++x)
        {
            frame[y][x] = vec3(0, 0, 0);
#if !no_depth_test
#if depth_clear_0
            depthBuffer[y][x] = 0;
#else
            depthBuffer[y][x] = emptyDepth;
#endif
#endif
        }
    }
}
