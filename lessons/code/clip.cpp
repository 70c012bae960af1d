#if cuts_polygons
// A plane of the view: dot(plane, clip) is positive on its inner side, and 0 on the plane.
vec4 Plane(int p, float left, float right, float top, float bottom)
{
#if depth_ndc || depth_reversed
    float fromNear = (zFar - zNear) / ClipW(zFar);
    float fromFar = (zFar - zNear) / ClipW(zNear);
#endif
    if (p == 0)
#if depth_ndc
        return vec4(0, 0, fromNear, 0);
#elif depth_reversed
        return vec4(0, 0, -fromNear, fromNear);
#else
        return vec4(0, 0, -zNear, 1);
#endif
    if (p == 1)
#if depth_ndc
        return vec4(0, 0, -fromFar, fromFar);
#elif depth_reversed
        return vec4(0, 0, fromFar, 0);
#else
        return vec4(0, 0, zFar, -1);
#endif
    if (p == 2)
        return vec4(1, 0, 0, left);
    if (p == 3)
        return vec4(-1, 0, 0, right);
    if (p == 4)
        return vec4(0, 1, 0, top);
    return vec4(0, -1, 0, bottom);
}

// Plane p of the view, with the picture's sides moved outward by a margin in pixels.
vec4 ViewPlane(int p, float margin)
{
    int x = SCREEN_WIDTH / 2;
    int y = SCREEN_HEIGHT / 2;
    return Plane(p, x + margin, SCREEN_WIDTH - x + margin, y + margin, SCREEN_HEIGHT - y + margin);
}

#if reject_outcodes || reject_cheap
// Do all corners lie beyond the same plane?
bool LiesOutside(const vector<Vertex>& corners)
{
    for (int p = 0; p < 6; ++p)
    {
        vec4 plane = ViewPlane(p, 2); // rounding moves corners by up to two pixels
        int outside = 0;
        for (int i = 0; i < corners.size(); ++i)
        {
            if (dot(plane, corners[i].clip) < 0)
                ++outside;
        }
        if (outside == corners.size())
            return true;
    }
    return false;
}

#endif
#if clip_whole_only
// Leaves out a polygon that sticks out of the view.
void LeaveOutIfCut(vector<Vertex>& corners)
{
    int outside = 0;
    for (int p = 0; p < 6; ++p)
    {
        vec4 plane = ViewPlane(p, 0);
        for (int i = 0; i < corners.size(); ++i)
        {
            if (dot(plane, corners[i].clip) < 0)
                ++outside;
        }
    }
    if (outside > 0)
        corners.resize(0);
}

#elif clip_clamped
// Moves the corners behind the near plane onto it.
void MoveToNearPlane(vector<Vertex>& corners)
{
    for (int i = 0; i < corners.size(); ++i)
        corners[i].clip.w = max(corners[i].clip.w, zNear);
}

#elif !clip_nothing
// The point at a fraction t of the way from one corner to another.
Vertex Between(const Vertex& from, const Vertex& to, float t)
{
#if clip_uncut_varyings
    Vertex v = to; // only its place is cut
#else
    Vertex v = from;
#endif
    v.clip = from.clip + t * (to.clip - from.clip);
#if !clip_uncut_varyings
    v.position = from.position + (to.position - from.position) * t;
#if stage_vertex_light
    v.illumination = from.illumination + (to.illumination - from.illumination) * t;
#endif
#if carried_normal
    v.normal = from.normal + (to.normal - from.normal) * t;
#endif
#if carried_color
    v.reflectance = from.reflectance + (to.reflectance - from.reflectance) * t;
#endif
#if scene_textures
    v.texcoord = from.texcoord + (to.texcoord - from.texcoord) * t;
#endif
#endif
    return v;
}

// Where an edge meets a plane: always from its inner corner, so that neighbors get the same bits.
Vertex CutEdge(const Vertex& inside, const Vertex& outside, float dInside, float dOutside)
{
#if clip_wrong_t
    return Between(outside, inside, (zNear - outside.clip.w) / inside.clip.w);
#else
    return Between(inside, outside, dInside / (dInside - dOutside));
#endif
}

// What lies on the inner side of a plane.
void ClipByPlane(const vector<Vertex>& corners, vec4 plane, vector<Vertex>& kept)
{
    int V = corners.size();
    for (int i = 0; i < V; ++i)
    {
        Vertex a = corners[i]; //@ cut i
        Vertex b = corners[(i + 1) % V];
        float da = dot(plane, a.clip);
        float db = dot(plane, b.clip);
        if (da >= 0)
            kept.push_back(a);
        if (da >= 0 && db < 0)
            kept.push_back(CutEdge(a, b, da, db));
        if (da < 0 && db >= 0)
            kept.push_back(CutEdge(b, a, db, da));
    }
}

// Clips by one plane after another. Was anything cut off?
bool ClipByPlanes(vector<Vertex>& corners, int first, int last)
{
    bool isCut = false;
    for (int p = first; p <= last; ++p)
    {
#if clip_guard_band
        vec4 plane = Plane(p, 8192, 8192, 8192, 8192); //@ plane p
#else
        vec4 plane = ViewPlane(p, 0); //@ plane p
#endif
        int inside = 0;
        int outside = 0;
        for (int i = 0; i < corners.size(); ++i)
        {
            float d = dot(plane, corners[i].clip);
            if (d > 0)
                ++inside;
            if (d < 0)
                ++outside;
        }
        if (outside == 0)
            continue;
        isCut = true;
        vector<Vertex> kept;
        ClipByPlane(corners, plane, kept);
        corners = kept;
#if !clip_after_division && !clip_near_with_wrong_t && !clip_near_with_uncut_varyings
        if (inside == 0)
        {
            corners.resize(0); // it only touches the plane
            return true;
        }
#endif
    }
    return isCut;
}

#if clip_after_division
// First divides, then cuts by the sides of the picture.
void ClipOnScreen(vector<Vertex>& corners)
{
    vector<Vertex> screen = corners;
    for (int i = 0; i < screen.size(); ++i)
    {
        vec4 c = screen[i].clip;
        float zinv = 1 / c.w;
        screen[i].clip = vec4(c.x * zinv, c.y * zinv, zinv, 1);
        if (isinf(zinv) || isinf(c.x * zinv) || isinf(c.y * zinv))
            return;
    }
    if (!ClipByPlanes(screen, 2, 5))
        return;
    for (int i = 0; i < screen.size(); ++i)
    {
        vec4 c = screen[i].clip;
        float z = 1 / c.z;
        screen[i].clip = vec4(c.x * z, c.y * z, 1, z);
    }
    corners = screen;
}

#else
// What is left of a polygon in front of the near plane, or in the whole view.
void Clip(vector<Vertex>& corners)
{
#if clip_all || clip_guard_band
    ClipByPlanes(corners, 0, 5);
#elif clip_near || clip_near_with_wrong_t || clip_near_with_uncut_varyings
    ClipByPlanes(corners, 0, 0);
#endif
}

#endif
#endif
#endif
