#if stage_points && clip_space
void DrawVertex(const Vertex& vertex)
{
    Vertex v = vertex;
    Pixel p;
    VertexShader(v);
    Project(v, p);
    if (p.zinv != 0)
        PutPixel(p.x, p.y, vec3(1, 1, 1));
}

#endif
// One polygon, from its vertices to its pixels.
void DrawPolygon(const vector<Vertex>& vertices)
{
#if clip_space
    vector<Vertex> corners = vertices;
    for (int i = 0; i < corners.size(); ++i)
        VertexShader(corners[i]); //@ vertex i
#if reject_outcodes || reject_cheap
    if (LiesOutside(corners))
        return;
#endif
#if !clip_nothing
#if clip_whole_only
    LeaveOutIfCut(corners);
#elif clip_clamped
    MoveToNearPlane(corners);
#elif clip_after_division
    ClipOnScreen(corners);
#else
    Clip(corners);
#endif
    if (corners.size() < 3)
        return; // nothing is left
#endif
#if cull_face_normal || cull_by_view_axis || cull_by_lamp || cull_vertex_normals || cull_screen_area
    if (IsBack(corners)) //@ cull 0
        return;
#endif
    int V = corners.size();
    vector<Pixel> vertexPixels(V);
    for (int i = 0; i < V; ++i)
        Project(corners[i], vertexPixels[i]);
#else
    int V = vertices.size();
    vector<Pixel> vertexPixels(V);
    for (int i = 0; i < V; ++i)
        VertexShader(vertices[i], vertexPixels[i]); //@ vertex i
#if cull_face_normal || cull_by_view_axis || cull_by_lamp || cull_vertex_normals
    if (IsBack(vertices)) //@ cull 0
        return;
#endif
#endif
    for (int i = 0; i < V; ++i)
    {
#if behind_mark_minus_one
        if (vertexPixels[i].x == -1)
#else
        if (vertexPixels[i].zinv == 0)
#endif
            return;
    }
#if cull_screen_area && !clip_space
    if (IsBack(vertexPixels)) //@ cull 0
        return;
#endif
#if stage_points && clip_space
    for (int i = 0; i < vertices.size(); ++i)
        DrawVertex(vertices[i]);
#elif stage_points
    for (int i = 0; i < V; ++i)
        PutPixel(vertexPixels[i].x, vertexPixels[i].y, vec3(1, 1, 1));
#elif stage_edges
    DrawPolygonEdges(vertexPixels);
#else
#if mip_levels && scene_textures && !stage_rows
    ComputeTextureSlope(vertexPixels);
#endif
    vector<Pixel> leftPixels;
    vector<Pixel> rightPixels;
    ComputePolygonRows(vertexPixels, leftPixels, rightPixels);
#if hidden_warnock
    KeepSurface(currentTriangle, leftPixels, rightPixels);
#elif stage_rows
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

#if scene_corners && (stage_flat || cull_face_normal || cull_by_lamp)
// Out of the surface, at right angles to two of its edges.
vec3 FaceNormal(const Triangle& triangle)
{
    vec3 across = cross(triangle.v2 - triangle.v0, triangle.v1 - triangle.v0);
    float size = sqrt(dot(across, across));
    if (size > 0)
        return across / size;
    return vec3(0, 0, 0);
}

#endif
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

#endif
// Every triangle, in the order of the list.
void Draw()
{
#if hidden_warnock
    surfaces.resize(0);
    surfaceRows.resize(0);
    surfacePixels.resize(0);
    squareCount = 0;
#endif
    for (int t = 0; t < triangles.size(); ++t)
    {
        vector<Vertex> vertices(3); //@ each triangle t
#if hidden_warnock
        currentTriangle = t;
#endif
        vertices[0].position = triangles[t].v0;
        vertices[1].position = triangles[t].v1;
        vertices[2].position = triangles[t].v2;
#if vertex_normals
#if scene_corners
        vertices[0].normal = triangles[t].normal0;
        vertices[1].normal = triangles[t].normal1;
        vertices[2].normal = triangles[t].normal2;
#else
        for (int i = 0; i < 3; ++i)
            vertices[i].normal = triangles[t].normal;
#endif
#endif
#if stage_vertex_light || carried_color
#if scene_corners
        vertices[0].reflectance = triangles[t].color0;
        vertices[1].reflectance = triangles[t].color1;
        vertices[2].reflectance = triangles[t].color2;
#else
        for (int i = 0; i < 3; ++i)
            vertices[i].reflectance = triangles[t].color;
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
#if scene_normal_maps
        currentNormalMap = triangles[t].normalMap;
#endif
#if scene_height_maps
        currentHeightMap = triangles[t].heightMap;
        currentHeightScale = triangles[t].heightScale;
        currentHeightBias = triangles[t].heightBias;
#endif
#if scene_surface_axes
        ComputeTextureDirections(triangles[t]);
#endif
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
#elif stage_pixel_light
        currentNormal = triangles[t].normal;
#endif
#if cull_face_normal || cull_by_view_axis || cull_by_lamp
#if scene_corners
        faceNormal = triangles[t].normal0;
#if !cull_by_view_axis
        if (triangles[t].smooth)
            faceNormal = FaceNormal(triangles[t]);
#endif
#else
        faceNormal = triangles[t].normal;
#endif
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
#if scene_corners
        currentReflectance = triangles[t].color0;
#else
        currentReflectance = triangles[t].color;
#endif
#if carried_color
        currentBlended = triangles[t].blended;
#endif
#endif
        DrawPolygon(vertices);
    }
#if hidden_warnock
    DrawSurfaces();
#elif rows_of_samples
    Resolve();
#endif
}

// Empties the picture and, if there is one, the depth buffer.
void Clear()
{
    for (int y = 0; y < SCREEN_HEIGHT; ++y)
    {
        for (int x = 0; x < SCREEN_WIDTH; ++x)
        {
            frame[y][x] = vec3(0, 0, 0);
#if rows_of_samples
            for (int s = 0; s < 4; ++s)
            {
                sampleColors[y][4 * x + s] = vec3(0, 0, 0);
#if depth_clear_0 || no_depth_test
                sampleDepths[y][4 * x + s] = 0;
#else
                sampleDepths[y][4 * x + s] = emptyDepth;
#endif
            }
#elif !no_depth_test && !no_depth_test_in_buffer
#if depth_clear_0 && !depth_ndc
            depthBuffer[y][x] = 0;
#else
            depthBuffer[y][x] = emptyDepth;
#endif
#endif
        }
    }
}
