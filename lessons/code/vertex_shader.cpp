// Where a vertex lies in the picture, and what it carries.
void VertexShader(const Vertex& v, Pixel& p)
{
#if space_pixels
    vec3 pos = v.position;
    p.zinv = 0;
    if (!(pos.z > 0))
        return;
    p.zinv = 1 / pos.z;
    p.x = int(pos.x);
    p.y = int(pos.y);
#else
#if rotation_transposed
    vec3 pos = R * (v.position - cameraPos);
#elif camera_move_added
    vec3 pos = (v.position + cameraPos) * R;
#elif camera_move_rotated_first
    vec3 pos = v.position * R - cameraPos;
#else
    vec3 pos = (v.position - cameraPos) * R;
#endif
    p.zinv = 0;
    if (!(pos.z > 0))
        return;
    p.zinv = 1 / pos.z;
#if cull_screen_area
    p.beforeDivision = vec3(focalLength * pos.x, focalLength * pos.y, pos.z);
#endif
    float x = focalLength * pos.x * p.zinv;
    float y = focalLength * pos.y * p.zinv;
    if (!(abs(x) <= 16384) || !(abs(y) <= 16384) || isinf(p.zinv))
    {
        p.zinv = 0; // too far out for floats to walk along its edges
        return;
    }
#if vertex_rounding_floor
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
#endif
#if coverage_edge_functions && !stage_points && !stage_edges
#if snap_subpixel && space_pixels
    p.gridX = floor(double(pos.x + 0.5f) * 256 + 0.5);
    p.gridY = floor(double(pos.y + 0.5f) * 256 + 0.5);
#elif snap_subpixel
    p.gridX = floor(double(x + SCREEN_WIDTH / 2) * 256 + 0.5);
    p.gridY = floor(double(y + SCREEN_HEIGHT / 2) * 256 + 0.5);
#elif snap_sixteenth && space_pixels
    p.gridX = floor(double(pos.x + 0.5f) * 16 + 0.5) * 16;
    p.gridY = floor(double(pos.y + 0.5f) * 16 + 0.5) * 16;
#elif snap_sixteenth
    p.gridX = floor(double(x + SCREEN_WIDTH / 2) * 16 + 0.5) * 16;
    p.gridY = floor(double(y + SCREEN_HEIGHT / 2) * 16 + 0.5) * 16;
#else
    p.gridX = 256.0 * p.x + 128; // the middle of its pixel
    p.gridY = 256.0 * p.y + 128;
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
#if stage_vertex_light
#if interpolation_affine
    p.illumination = ReflectedLight(v.position, v.normal, v.reflectance);
#elif interpolation_mixed
    p.illumination = ReflectedLight(v.position, v.normal, v.reflectance) * Weight(p.zinv);
#else
    p.illumination = ReflectedLight(v.position, v.normal, v.reflectance) * p.zinv;
#endif
#endif
#if stage_pixel_light
#if interpolation_affine
    p.pos3d = v.position;
#elif interpolation_mixed
    p.pos3d = v.position * Weight(p.zinv);
#else
    p.pos3d = v.position * p.zinv;
#endif
#if scene_corners
#if interpolation_affine
    p.normal = v.normal;
    p.color = v.reflectance;
#elif interpolation_mixed
    p.normal = v.normal * Weight(p.zinv);
    p.color = v.reflectance * Weight(p.zinv);
#else
    p.normal = v.normal * p.zinv;
    p.color = v.reflectance * p.zinv;
#endif
#endif
#endif
}
