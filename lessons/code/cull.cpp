#if cull_by_lamp && space_pixels
bool IsBack(const vector<Vertex>& corners)
{
    return false; // without a lamp there is no back
}
#elif cull_face_normal || cull_by_view_axis || cull_by_lamp
// Does the camera see the back of a polygon?
bool IsBack(const vector<Vertex>& corners)
{
#if cull_view_axis
    return dot(faceNormal, R[2]) > 0;
#elif cull_lamp
    return dot(faceNormal, corners[0].position - lightPos) > 0;
#elif projection_mixed
    return dot(faceNormal, SightRay(corners[0].position)) > 0;
#else
    return dot(faceNormal, corners[0].position - cameraPos) > 0;
#endif
}
#elif cull_vertex_normals
// Do the normals of all corners point away from the camera? Then its back is seen.
bool IsBack(const vector<Vertex>& corners)
{
    bool isBack = true;
    for (int i = 0; i < corners.size(); ++i)
#if projection_mixed
        isBack = isBack && dot(corners[i].normal, SightRay(corners[i].position)) > 0;
#else
        isBack = isBack && dot(corners[i].normal, corners[i].position - cameraPos) > 0;
#endif
    return isBack;
}
#elif cull_screen_area && clip_space
// Do the corners go round the wrong way on the screen? Then the back is seen.
bool IsBack(const vector<Vertex>& corners)
{
    for (int i = 0; i < corners.size(); ++i)
    {
        if (!(corners[i].clip.w > 0))
            return false; // behind the camera
    }
    float sum = 0;
    for (int i = 2; i < corners.size(); ++i)
    {
        vec4 a = corners[0].clip;
        vec4 b = corners[i - 1].clip;
        vec4 c = corners[i].clip;
        vec3 across = cross(vec3(b.x, b.y, b.w), vec3(c.x, c.y, c.w));
        sum += dot(vec3(a.x, a.y, a.w), across);
    }
    return sum < 0;
}
#elif cull_screen_area
// Do the corners go round the wrong way on the screen? Then the back is seen.
bool IsBack(const vector<Pixel>& vertexPixels)
{
    vec3 a = vertexPixels[0].beforeDivision;
    vec3 b = vertexPixels[1].beforeDivision;
    vec3 c = vertexPixels[2].beforeDivision;
#if clip_none || clip_after_division
    if (!(a.z > 0) || !(b.z > 0) || !(c.z > 0))
        return false; // behind the camera
#endif
    return dot(a, cross(b, c)) < 0;
}
#endif
