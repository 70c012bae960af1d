// What a vertex, a pixel and a triangle are, and what every function may use.

struct Vertex
{
    vec3 position;
#if clip_space
    vec4 clip; // x, y and depth, not divided yet, and what they are divided by
#if stage_vertex_light
    vec3 illumination;
#endif
#endif
#if vertex_normals
    vec3 normal;
#endif
#if stage_vertex_light || carried_color
    vec3 reflectance;
#endif
#if scene_textures
    vec2 texcoord;
#endif
};

struct Pixel
{
#if behind_mark_minus_one
    int x; // -1: not in front of the camera
#else
    int x;
#endif
    int y;
#if behind_mark_minus_one
    float zinv; // 1/z
#elif clip_space
    float zinv; // 1/w; 0: not in front of the camera
#else
    float zinv; // 1/z; 0: not in front of the camera
#endif
#if depth_ndc
    float depth; // 0 at the near plane, 1 at the far one
#elif depth_reversed
    float depth; // 1 at the near plane, 0 at the far one
#endif
#if depth_test_linear_z
    float z;
#endif
#if coverage_edge_functions || coverage_scan_conversion || coverage_active_edges
    double gridX; // where it lies on a grid of 256ths of a pixel
    double gridY;
#if more_corners && coverage_edge_functions && !fill_rule_top_left
    bool isInner; // the edge from here to the next corner lies within the polygon
#endif
#endif
#if scene_textures
    vec2 texcoord;
#endif
#if stage_vertex_light
    vec3 illumination;
#endif
#if carried_pos3d
    vec3 pos3d;
#endif
#if carried_normal
    vec3 normal;
#endif
#if carried_color
    vec3 color;
#endif
#if cull_screen_area && !clip_space
    vec3 beforeDivision; // x and y times the focal length, and z
#endif
};

struct Triangle
{
    vec3 v0;
    vec3 v1;
    vec3 v2;
#if scene_corners
    vec3 normal0;
    vec3 normal1;
    vec3 normal2;
    vec3 color0;
    vec3 color1;
    vec3 color2;
    bool smooth; // its normals differ
    bool blended; // its colors differ
#else
    vec3 normal;
    vec3 color;
#endif
#if light_model_blinn_phong
    vec3 specular;
    float exponent;
#endif
#if scene_textures
    vec2 texcoord0;
    vec2 texcoord1;
    vec2 texcoord2;
    int texture; // -1: none
#if scene_normal_maps
    int normalMap; // of the textures; -1: none
#endif
#if scene_height_maps
    int heightMap; // of the textures; -1: none
    float heightScale; // how much higher white is than black
    float heightBias; // how high black is
#endif
#endif
#if scene_transparency
    float alpha; // 0 clear, 1 opaque
#endif
};

#if scene_transparency
float currentAlpha;

#endif

#if scene_textures
struct Texture
{
    int width;
    int height;
    int firstTexel; // row by row from there on
#if mip_levels
    int lastLevel; // so many smaller copies follow it in the list
#endif
};

vector<Texture> textures;
vector<vec3> texels; // of all textures
int currentTexture;
#if scene_normal_maps
int currentNormalMap;
#endif
#if scene_height_maps
int currentHeightMap;
float currentHeightScale;
float currentHeightBias;
vec2 currentShift; // of the place in the textures
#endif
#if mip_levels && !stage_points && !stage_edges && !stage_rows

// How much the values change from a pixel to the next one on its right, and below it: the same
// everywhere in a polygon.
vec2 texcoordRight;
vec2 texcoordDown;
float weightRight;
float weightDown;
#endif

#endif
#if scene_surface_axes
vec3 currentAlongU; // the step in the world for which u grows by 1
vec3 currentAlongV;

// The axes of a surface, along which its maps are read.
struct Axes
{
    vec3 t; // where u grows
    vec3 b; // where v gets smaller: up in the texture
    vec3 n; // out of the surface
};

#if scene_normal_maps && normal_map_space_tangent
Axes lightAxes; // along which the light is worked out
#if scene_shadows && shadows_rays
vec3 worldNormal; // the bent normal, along the axes of the world
#endif

#endif
#endif

vector<Triangle> triangles;

const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;

#if camera_known
vec3 cameraPos(0, 0, -3.001f);
mat3 R;
#endif
#if !space_pixels
float focalLength = 500;

#endif
#if clip_space || depth_test_in_buffer || depth_ndc || depth_reversed
float zNear = 0.1f; // what is seen lies between these two planes
float zFar = 100;
#if projection_mixed
float orthographicMix = 1; // 0: perspective
float orthographicDepth = 3; // where both show the same size
#endif

#endif
#if stage_vertex_light || stage_pixel_light || stage_flat || (cull_by_lamp && !space_pixels)
vec3 lightPos(0, -0.5f, -0.7f);
vec3 lightPower(1.1f, 1.1f, 1.1f);
vec3 indirectLightPowerPerArea(0.5f, 0.5f, 0.5f);

#endif
#if scene_shadows && shadows_map
int shadowMapSize = 512; // texels along each side of one of its six faces
mat3 shadowAxes[6]; // columns: right, down and forward of a face
vector<float> shadowMap; // 1/z of what the lamp sees, face by face and row by row; 0: nothing
float shadowBias = 0.05f;
#if !shadow_slope_bias_0
float slopeBias = 0;
#endif
#elif scene_shadows
float shadowOffset = 0.001f;
#endif
#if interpolation_mixed
float mixing = 0.5f;
float referenceDepth = 3;

#endif
#if stage_pixel_light
vec3 currentNormal;
#endif
#if cull_face_normal || cull_by_view_axis || cull_by_lamp
vec3 faceNormal;
#endif
#if carried_color && stage_pixel_light
bool currentSmooth;
#endif
#if carried_color
bool currentBlended;
#endif
#if stage_flat
vec3 currentLight;
#elif !stage_points && !stage_edges && !stage_rows && !stage_vertex_light
vec3 currentReflectance;
#endif
#if light_model_blinn_phong && (stage_vertex_light || stage_pixel_light || stage_flat)
vec3 currentSpecular;
float currentExponent;
#endif

#if hidden_warnock
int currentTriangle;

#endif
#if rows_of_samples
// Where the four samples of a pixel are, in 256ths of a pixel from its center.
#if square_grid
vector<double> sampleX{-64, 64, -64, 64};
vector<double> sampleY{-64, -64, 64, 64};
#else
vector<double> sampleX{-32, 96, -96, 32};
vector<double> sampleY{-96, -32, 32, 96};
#endif
vec3 sampleColors[SCREEN_HEIGHT][4 * SCREEN_WIDTH];
float sampleDepths[SCREEN_HEIGHT][4 * SCREEN_WIDTH];
vector<bool> writes(4); // which samples of the current pixel get its color
#endif
#if !no_depth_test && !no_depth_test_in_buffer
#if depth_test_with_epsilon
float epsilon = 0;
#endif
#if !depth_clear_0 || depth_ndc
float emptyDepth = 0;
#endif
#if !rows_of_samples
float depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];
#endif
#endif
vec3 frame[SCREEN_HEIGHT][SCREEN_WIDTH];
