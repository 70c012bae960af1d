#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "scene/mesh.h"
#include "scene/model.h"
#include "scene/model_source.h"
#include "scene/obj_report.h"
#include "scene/texture.h"

namespace rasterwalk {

/// What a surface is made of.
struct Material {
    glm::vec3 reflectance{1.0f}; ///< share of light reflected diffusely, red green blue, 0..1
    Shine shine{};
    float alpha = 1.0f; ///< 0 (clear) to 1 (opaque)

    friend bool operator==(const Material&, const Material&) = default;
};

/// A map of heights, and what its numbers mean.
struct HeightMap {
    int texture = -1; ///< index in Scene::textures; -1: none
    /// A texel h, 0 (black) to 1 (white), is h * scale + bias above the surface, world units.
    float scale = 0.05f, bias = -0.025f;

    friend bool operator==(const HeightMap&, const HeightMap&) = default;
};

/// A named group of consecutive triangles of the mesh ("tall block").
struct Part {
    std::string name;
    int first_triangle = 0;
    int triangle_count = 0;
    Model model{};       ///< how the scene file made it; no steps: given in world space
    int texture = -1;    ///< index in Scene::textures; -1: none
    float alpha = 1.0f;  ///< of all its triangles, 0 (clear) to 1 (opaque)
    int normal_map = -1; ///< index in Scene::textures; -1: none
    HeightMap height_map{};

    friend bool operator==(const Part&, const Part&) = default;
};

/// How the direction of the camera is given.
enum class CameraAim : std::uint8_t {
    angles,  ///< by yaw and pitch: the lab
    look_at, ///< by a point that it looks at, and a direction that is up
};

/// A pinhole camera; P_camera = (P_world - position) * R, row vectors (lab section "Moving the
/// camera").
struct Camera {
    glm::vec3 position{0.0f, 0.0f, -3.001f}; ///< world units
    float yaw = 0.0f;                        ///< radians about the y axis
    float pitch = 0.0f;                      ///< radians about the x axis, applied after yaw
    float focal_length = 500.0f;             ///< pixels
    CameraAim aim = CameraAim::angles;
    glm::vec3 target{0.0f};          ///< for look_at: a point in the middle of the picture
    glm::vec3 up{0.0f, -1.0f, 0.0f}; ///< for look_at: what points up in the picture, any length

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// How a surface reflects the light that falls on it.
enum class LightModel : std::uint8_t {
    lambert,     ///< the same in all directions: the lab
    blinn_phong, ///< plus a highlight, if the material has one
};

/// Where the lamp is.
enum class LampPlace : std::uint8_t {
    fixed,  ///< at its position
    camera, ///< where the camera is, like a flashlight on a helmet
};

/// One point light and one constant indirect light (lab section "Illumination").
struct Light {
    glm::vec3 position{0.0f, -0.5f, -0.7f}; ///< world units
    glm::vec3 power{1.1f};                  ///< red green blue; spreads over a sphere of 4 pi r^2
    glm::vec3 indirect{0.5f};               ///< red green blue, the same everywhere
    LightModel model = LightModel::lambert;
    LampPlace place = LampPlace::fixed;
    float exponent = 0.0f; ///< of all highlights; 0: each material's own

    friend bool operator==(const Light&, const Light&) = default;
};

/// Size of the picture in pixels.
struct Viewport {
    int width = 500;
    int height = 500;

    friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// The space in which a scene's positions are given.
enum class SceneSpace : std::uint8_t {
    world,  ///< to be projected by the camera
    pixels, ///< already columns and rows: the bench, where projection would only be in the way
};

/// A polygon of more than three corners. In the mesh it is a fan of triangles about its first
/// corner; its outline is corners 0 and 1 of the first triangle, and corner 2 of each.
struct ScenePolygon {
    int first_triangle = 0;
    int triangle_count = 0; ///< two less than its corners

    friend bool operator==(const ScenePolygon&, const ScenePolygon&) = default;
};

/// A further set of pixel-space triangles that a bench scene offers.
struct BenchExample {
    std::string name;
    std::string about; ///< one sentence: what it shows
    std::array<glm::vec3, 3> positions;

    friend bool operator==(const BenchExample&, const BenchExample&) = default;
};

/// A triangle of a list made for drawing: which triangle of the scene it is, or is a piece of.
struct TriangleSource {
    int triangle = 0;
    bool is_cut = false; ///< it is a piece
    /// Corner i is the sum of the triangle's corners, each times its number in weights[i].
    std::array<glm::vec3, triangle_corners> weights{
        glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f)};

    friend bool operator==(const TriangleSource&, const TriangleSource&) = default;
};

/// What is drawn, and the view it opens with.
struct Scene {
    std::string name;
    std::string path; ///< the file it came from; empty for a scene made in memory
    SceneSpace space = SceneSpace::world;
    Mesh mesh;
    /// Of a scene made for drawing, in another order: a source for each triangle. Parts and
    /// polygons count the sources' triangles. Empty: every triangle is its own.
    std::vector<TriangleSource> sources;
    std::vector<Part> parts; ///< one after another: every triangle belongs to one of them
    std::vector<SharedTexture> textures; ///< each once, however many parts show it
    std::string
        applied_texture; ///< file of an image that was laid on it, see with_texture(); empty: none
    std::vector<ScenePolygon> polygons; ///< in drawing order; only in a scene in pixels
    std::vector<BenchExample> examples;
    Camera camera;
    Light light;
    Viewport viewport;
    std::string stage;                     ///< name of the stage the scene asks for; empty: any
    std::optional<ObjReport> model_report; ///< of a scene that was read from a model file
    SharedModelSource model_source;        ///< of such a scene; null for others

    int triangle_count() const { return mesh.triangle_count(); }
    /// A corner of a triangle: 0, 1 or 2.
    const Vertex& corner(int triangle, int i) const { return mesh.corner(triangle, i); }

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// normalize(cross(v2 - v0, v1 - v0)): out of the blocks and into the room; zero for a triangle
/// without area.
glm::vec3 face_normal(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2);

/// All corners of a triangle, in order.
std::array<Vertex, triangle_corners> corners_of(const Scene& scene, int triangle);

/// The triangle of the scene that a drawn one is, or is a piece of.
inline int scene_triangle(const Scene& scene, int triangle) {
    return scene.sources.empty() ? triangle
                                 : scene.sources[static_cast<std::size_t>(triangle)].triangle;
}

/// The part that a triangle belongs to, as an index of Scene::parts; -1 for a scene without parts.
int part_of(const Scene& scene, int triangle);

/// The texture that a triangle shows; null if it shows none.
const Texture* texture_of(const Scene& scene, int triangle);

/// The normal map that bends the normals of a triangle; null if it has none.
const Texture* normal_map_of(const Scene& scene, int triangle);

/// Does any part of the scene show a texture? Normal maps are textures too, but are not shown.
bool has_texture(const Scene& scene);

/// Has any part of the scene a normal map?
bool has_normal_map(const Scene& scene);

/// The height map that shifts the texture of a triangle; null if it has none.
const HeightMap* height_map_of(const Scene& scene, int triangle);

/// Has any part of the scene a height map?
bool has_height_map(const Scene& scene);

/// The alpha of a triangle, 0 (clear) to 1 (opaque).
float alpha_of(const Scene& scene, int triangle);

/// Is anything in the scene half transparent?
bool has_alpha(const Scene& scene);

/// Has any part of the scene a texture with texels that are not quite opaque?
bool has_texture_alpha(const Scene& scene);

/// The name of the part that a triangle belongs to.
const std::string& part_name(const Scene& scene, int triangle);

/// What a drawn triangle is of: the name of its part and, in a list made for drawing, the triangle
/// of the scene: "floor", "floor, the scene's [3]", "floor, a piece of [3]".
std::string part_words(const Scene& scene, int triangle);

/// The smallest box, along the world's axes, around everything a scene draws.
struct SceneBox {
    glm::dvec3 low{-1.0}, high{1.0};

    glm::dvec3 middle() const { return 0.5 * (low + high); }
    /// Radius of the ball around it; never 0.
    double radius() const;
};

/// Around all vertices that are finite; a scene without any gets the box from -1 to 1.
SceneBox box_of(const Scene& scene);

} // namespace rasterwalk
