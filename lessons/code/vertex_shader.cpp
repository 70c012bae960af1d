#if clip_space
// Where a vertex lies in the picture, and what it carries: the division by w.
void Project(const Vertex& v, Pixel& p)
#else
// Where a vertex lies in the picture, and what it carries.
void VertexShader(const Vertex& v, Pixel& p)
#endif
{
#if clip_space
    float w = v.clip.w;
#if behind_mark_minus_one
    p.x = -1; // behind the camera
#else
    p.zinv = 0;
#endif
#if clip_none || clip_after_division
    if (w == 0)
#elif projection_mixed && !has_positive_w
    if (!(w > 0) || !(CameraDepth(v.clip) > 0))
#else
    if (!(w > 0))
#endif
        return;
    p.zinv = 1 / w;
#if depth_ndc || depth_reversed
    p.depth = v.clip.z * p.zinv;
#endif
    float x = v.clip.x * p.zinv;
    float y = v.clip.y * p.zinv;
#else
#if space_pixels
    vec3 pos = v.position;
#elif rotation_transposed
    vec3 pos = R * (v.position - cameraPos);
#elif camera_move_added
    vec3 pos = (v.position + cameraPos) * R;
#elif camera_move_rotated_first
    vec3 pos = v.position * R - cameraPos;
#else
    vec3 pos = (v.position - cameraPos) * R;
#endif
#if behind_mark_minus_one
    p.x = -1; // behind the camera
#else
    p.zinv = 0;
#endif
#if clip_none || clip_after_division
    if (pos.z == 0)
#else
    if (!(pos.z > 0))
#endif
        return;
#if divided_by_distance && !space_pixels
    p.zinv = 1 / length(pos);
#else
    p.zinv = 1 / pos.z;
#endif
#if depth_ndc || depth_reversed
    p.depth = ClipZ(pos.z) * p.zinv;
#endif
#if space_pixels
    float x = pos.x;
    float y = pos.y;
#elif image_axes_mirrored
    float x = -focalLength * pos.x * p.zinv;
    float y = -focalLength * pos.y * p.zinv;
#elif image_axes_exchanged
    float x = focalLength * pos.y * p.zinv;
    float y = focalLength * pos.x * p.zinv;
#else
    float x = focalLength * pos.x * p.zinv;
    float y = focalLength * pos.y * p.zinv;
#endif
#if cull_screen_area
#if space_pixels
    p.beforeDivision = vec3(x, y, 1);
#elif image_axes_mirrored
    p.beforeDivision = vec3(-focalLength * pos.x, -focalLength * pos.y, pos.z);
#elif image_axes_exchanged
    p.beforeDivision = vec3(focalLength * pos.y, focalLength * pos.x, pos.z);
#else
    p.beforeDivision = vec3(focalLength * pos.x, focalLength * pos.y, pos.z);
#endif
#if divided_by_distance && !space_pixels
    p.beforeDivision.z = length(pos);
#endif
#endif
#endif
    if (!(abs(x) <= 16384) || !(abs(y) <= 16384) || isinf(p.zinv))
    {
#if behind_mark_minus_one
        p.x = -1; // too far out for floats to walk along its edges
#else
        p.zinv = 0; // too far out for floats to walk along its edges
#endif
        return;
    }
#if image_axes_uncentred || space_pixels
#if vertex_rounding_floor
    p.x = int(floor(x));
    p.y = int(floor(y));
#elif vertex_rounding_round
    p.x = int(floor(double(x) + 0.5));
    p.y = int(floor(double(y) + 0.5));
#else
    p.x = int(x);
    p.y = int(y);
#endif
#elif vertex_rounding_floor
    p.x = int(floor(x)) + SCREEN_WIDTH / 2;
    p.y = int(floor(y)) + SCREEN_HEIGHT / 2;
#elif vertex_rounding_round
    p.x = int(floor(double(x) + 0.5)) + SCREEN_WIDTH / 2;
    p.y = int(floor(double(y) + 0.5)) + SCREEN_HEIGHT / 2;
#elif vertex_rounding_truncate_sum
    p.x = int(x + SCREEN_WIDTH / 2);
    p.y = int(y + SCREEN_HEIGHT / 2);
#else
    p.x = int(x) + SCREEN_WIDTH / 2;
    p.y = int(y) + SCREEN_HEIGHT / 2;
#endif
#if outside_picture_clamped
    p.x = clamp(p.x, 0, SCREEN_WIDTH - 1); // outside the picture: moved to its border
    p.y = clamp(p.y, 0, SCREEN_HEIGHT - 1);
#endif
#if coverage_edge_functions || coverage_scan_conversion || coverage_active_edges
#if snap_subpixel || snap_sixteenth
#if space_pixels
    float placeX = x + 0.5f;
    float placeY = y + 0.5f;
#elif image_axes_uncentred
    float placeX = x;
    float placeY = y;
#else
    float placeX = x + SCREEN_WIDTH / 2;
    float placeY = y + SCREEN_HEIGHT / 2;
#endif
#if outside_picture_clamped
    placeX = clamp(placeX, 0.5f, SCREEN_WIDTH - 0.5f);
    placeY = clamp(placeY, 0.5f, SCREEN_HEIGHT - 0.5f);
#endif
#endif
#if snap_subpixel
    p.gridX = floor(double(placeX) * 256 + 0.5);
    p.gridY = floor(double(placeY) * 256 + 0.5);
#elif snap_sixteenth
    p.gridX = floor(double(placeX) * 16 + 0.5) * 16;
    p.gridY = floor(double(placeY) * 16 + 0.5) * 16;
#else
    p.gridX = 256.0 * p.x + 128; // the center of its pixel
    p.gridY = 256.0 * p.y + 128;
#endif
#if pixel_sample_corner && !coverage_edge_functions
    p.gridX += 128; // as if the pixel's corner were its center
    p.gridY += 128;
#endif
#endif
#if depth_test_linear_z
#if clip_space && projection_mixed
    p.z = CameraDepth(v.clip);
#elif clip_space
    p.z = v.clip.w;
#elif divided_by_distance && !space_pixels
    p.z = length(pos);
#else
    p.z = pos.z;
#endif
#endif
#if scene_textures
#if interpolation_affine
    p.texcoord = v.texcoord;
#elif interpolation_mixed
    p.texcoord = v.texcoord * Weight(p.zinv);
#else
    p.texcoord = v.texcoord * p.zinv;
#endif
#endif
#if stage_vertex_light && clip_space
#if interpolation_affine
    p.illumination = v.illumination;
#elif interpolation_mixed
    p.illumination = v.illumination * Weight(p.zinv);
#else
    p.illumination = v.illumination * p.zinv;
#endif
#elif stage_vertex_light
#if interpolation_affine
    p.illumination = ReflectedLight(v.position, v.normal, v.reflectance);
#elif interpolation_mixed
    p.illumination = ReflectedLight(v.position, v.normal, v.reflectance) * Weight(p.zinv);
#else
    p.illumination = ReflectedLight(v.position, v.normal, v.reflectance) * p.zinv;
#endif
#endif
#if carried_pos3d
#if interpolation_affine
    p.pos3d = v.position;
#elif interpolation_mixed
    p.pos3d = v.position * Weight(p.zinv);
#else
    p.pos3d = v.position * p.zinv;
#endif
#endif
#if carried_normal
#if interpolation_affine
    p.normal = v.normal;
#elif interpolation_mixed
    p.normal = v.normal * Weight(p.zinv);
#else
    p.normal = v.normal * p.zinv;
#endif
#endif
#if carried_color
#if interpolation_affine
    p.color = v.reflectance;
#elif interpolation_mixed
    p.color = v.reflectance * Weight(p.zinv);
#else
    p.color = v.reflectance * p.zinv;
#endif
#endif
}
