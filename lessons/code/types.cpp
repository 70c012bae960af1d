// What a vertex, a pixel and a triangle are, and what every function may use.

struct Vertex
{
    vec3 position;
#if stage_vertex_light || (stage_pixel_light && scene_corners)
    vec3 normal;
    vec3 reflectance;
#endif
#if scene_textures
    vec2 texcoord;
#endif
};

struct Pixel
{
    int x;
    int y;
    float zinv; // 1/z; 0: not in front of the camera
#if coverage_edge_functions && !stage_points && !stage_edges
    double gridX; // where it lies on a grid of 256ths of a pixel
    double gridY;
#endif
#if scene_textures
    vec2 texcoord;
#endif
#if stage_vertex_light
    vec3 illumination;
#endif
#if stage_pixel_light
    vec3 pos3d;
#endif
#if stage_pixel_light && scene_corners
    vec3 normal;
    vec3 color;
#endif
#if cull_screen_area
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
};

vector<Texture> textures;
vector<vec3> texels; // of all textures
int currentTexture;

#endif

vector<Triangle> triangles;

const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;

#if !space_pixels
vec3 cameraPos(0, 0, -3.001f);
mat3 R;
float focalLength = 500;

#endif
#if stage_vertex_light || stage_pixel_light || stage_flat
vec3 lightPos(0, -0.5f, -0.7f);
vec3 lightPower(1.1f, 1.1f, 1.1f);
vec3 indirectLightPowerPerArea(0.5f, 0.5f, 0.5f);

#endif
#if interpolation_mixed
float mixing = 0.5f;
float referenceDepth = 3;

#endif
#if stage_pixel_light || cull_face_normal
vec3 currentNormal;
#endif
#if stage_pixel_light && scene_corners
bool currentSmooth;
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

#if !no_depth_test
#if depth_test_with_epsilon
float epsilon = 0;
#endif
#if !depth_clear_0
float emptyDepth = 0;
#endif
float depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];
#endif
vec3 frame[SCREEN_HEIGHT][SCREEN_WIDTH];
