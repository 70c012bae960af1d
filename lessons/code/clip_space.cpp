#if projection_mixed
// What x and y are divided by: z in perspective, 1 in an orthographic one, or between.
float ClipW(float z)
{
    return (1 - orthographicMix) * z + orthographicMix;
}

#elif to_clip_space_mixed || depth_ndc || depth_reversed
// What x and y are divided by.
float ClipW(float z)
{
    return z;
}

#endif
#if depth_ndc
// The depth before it is divided: 0 at the near plane, and w at the far one.
float ClipZ(float z)
{
    return ClipW(zFar) * ((z - zNear) / (zFar - zNear));
}

#elif depth_reversed
// The depth before it is divided: w at the near plane, and 0 at the far one.
float ClipZ(float z)
{
    return ClipW(zNear) * ((zFar - z) / (zFar - zNear));
}

#endif
#if projection_mixed
// How far in front of the camera a place in clip space is.
float CameraDepth(vec4 clip)
{
#if depth_ndc
    return zNear + clip.z / ClipW(zFar) * (zFar - zNear);
#else
    return zFar - clip.z / ClipW(zNear) * (zFar - zNear);
#endif
}

#endif
#if transform_matrices && clip_space
// A place with its w, or a row of a matrix.
struct Vec4d
{
    double x;
    double y;
    double z;
    double w;
};

struct Matrix
{
    Vec4d row0;
    Vec4d row1;
    Vec4d row2;
    Vec4d row3;
};

double Dot(const Vec4d& row, const Vec4d& place)
{
    return (row.x * place.x + row.y * place.y) + (row.z * place.z + row.w * place.w);
}

// M p: each row of the matrix times the place.
Vec4d Product(const Matrix& M, const Vec4d& p)
{
    Vec4d product;
    product.x = Dot(M.row0, p);
    product.y = Dot(M.row1, p);
    product.z = Dot(M.row2, p);
    product.w = Dot(M.row3, p);
    return product;
}

// How far along an axis of the camera: after the translation by minus its position.
Vec4d AxisRow(vec3 axis)
{
    Vec4d row = {axis.x, axis.y, axis.z, 0};
#if !translation_bottom_row
    row.w = row.x * -cameraPos.x + row.y * -cameraPos.y + row.z * -cameraPos.z;
#endif
    return row;
}

// From the world to the camera.
Matrix ViewMatrix()
{
#if rotation_transposed
    mat3 axes = transpose(R);
#else
    mat3 axes = R;
#endif
    Matrix view;
    view.row0 = AxisRow(axes[0]); // right
    view.row1 = AxisRow(axes[1]); // down
    view.row2 = AxisRow(axes[2]); // forward
#if translation_bottom_row
    view.row3 = Vec4d{-cameraPos.x, -cameraPos.y, -cameraPos.z, 1};
#else
    view.row3 = Vec4d{0, 0, 0, 1};
#endif
    return view;
}

// From the camera to clip space: what is seen becomes a box, once it is divided by w.
Matrix ProjectionMatrix()
{
    double length = zFar - zNear;
    double wFar = zNear + length;
    double scale = focalLength;
#if projection_mixed
    double mix = orthographicMix;
    double depth = orthographicDepth;
    wFar = (1 - mix) * wFar + mix;
    scale = scale * ((1 - mix) * depth + mix) / depth;
#endif
    Matrix projection;
    projection.row0 = Vec4d{scale / (SCREEN_WIDTH / 2.0), 0, 0, 0};
    projection.row1 = Vec4d{0, scale / (SCREEN_HEIGHT / 2.0), 0, 0};
    projection.row2 = Vec4d{0, 0, wFar / length, -wFar * zNear / length};
#if projection_mixed
    projection.row3 = Vec4d{0, 0, 1 - mix, mix};
#else
    projection.row3 = Vec4d{0, 0, 1, 0}; // w = z
#endif
    return projection;
}

// From the world to clip space, by one matrix after the other.
vec4 ToClipSpace(vec3 position)
{
    Vec4d world = {position.x, position.y, position.z, 1};
    Vec4d camera = Product(ViewMatrix(), world);
    Vec4d clip = Product(ProjectionMatrix(), camera);
#if image_axes_mirrored
    double x = SCREEN_WIDTH / 2.0 * -clip.x;
    double y = SCREEN_HEIGHT / 2.0 * -clip.y;
#elif image_axes_exchanged
    double x = SCREEN_HEIGHT / 2.0 * clip.y;
    double y = SCREEN_WIDTH / 2.0 * clip.x;
#else
    double x = SCREEN_WIDTH / 2.0 * clip.x;
    double y = SCREEN_HEIGHT / 2.0 * clip.y;
#endif
#if depth_ndc
    return vec4(x, y, clip.z, clip.w);
#elif depth_reversed
    return vec4(x, y, clip.w - clip.z, clip.w);
#else
    return vec4(x, y, 1, clip.w); // divided by w, the 1 becomes 1/w
#endif
}
#elif clip_space
// From the world to clip space: x and y in pixels, the depth, and what all three are divided by.
vec4 ToClipSpace(vec3 position)
{
#if rotation_transposed
    vec3 pos = R * (position - cameraPos);
#elif camera_move_added
    vec3 pos = (position + cameraPos) * R;
#elif camera_move_rotated_first
    vec3 pos = position * R - cameraPos;
#else
    vec3 pos = (position - cameraPos) * R;
#endif
#if projection_mixed
    float scale = focalLength * ClipW(orthographicDepth) / orthographicDepth;
#else
    float scale = focalLength;
#endif
#if projection_mixed
    float w = ClipW(pos.z);
#elif divided_by_distance
    float w = pos.z > 0 ? length(pos) : -length(pos);
#else
    float w = pos.z;
#endif
#if depth_ndc || depth_reversed
    float depth = ClipZ(pos.z);
#else
    float depth = 1; // divided by w, it becomes 1/w
#endif
#if image_axes_mirrored
    return vec4(-scale * pos.x, -scale * pos.y, depth, w);
#elif image_axes_exchanged
    return vec4(scale * pos.y, scale * pos.x, depth, w);
#else
    return vec4(scale * pos.x, scale * pos.y, depth, w);
#endif
}
#endif

#if clip_space
// Where the camera sees a vertex: nothing is divided yet.
void VertexShader(Vertex& v)
{
    v.clip = ToClipSpace(v.position);
#if stage_vertex_light
    v.illumination = ReflectedLight(v.position, v.normal, v.reflectance);
#endif
}
#endif
