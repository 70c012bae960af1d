#pragma once

#include <optional>

#include "scene/scene.h"
#include "settings/choices.h"
#include "stages/depth_test.h"
#include "stages/normal_map.h"
#include "stages/parallax.h"
#include "stages/pixel_shader.h"
#include "stages/polygon_rows.h"
#include "stages/shadow.h"
#include "stages/stages.h"

namespace rasterwalk {

/// Every choice that changes the picture, or the work it takes. The defaults are the lab's rules
/// (preset `handout`); camera, light and viewport come from the scene.
struct Settings {
    Engine engine = Engine::steps; ///< for the whole picture; before its end, the steps draw
    TreeBoxes ray_boxes = TreeBoxes::nested; ///< for rays, and only for their number of tests
    Mirrors mirrors = Mirrors::off;          ///< for rays
    Stage stage = Stage::shade;
    Shading shading = Shading::phong; ///< of stage `shade`
    int tessellation = 1; ///< parts into which each edge of the scene is cut before all else
    VertexRounding vertex_rounding = VertexRounding::truncate;
    Coverage coverage = Coverage::rows;
    FillRule fill_rule = FillRule::inclusive;       ///< where coverage tests the centres of pixels
    Snap snap = Snap::pixel;                        ///< in the same case
    PixelSample pixel_sample = PixelSample::centre; ///< in the same case
    int samples = 1;     ///< of a pixel, 1 or 4, in the same case; see sampling_rule()
    int supersample = 1; ///< shaded samples along each side of a pixel, 1 or 2, in the same case
    SampleRule sample_rule = SampleRule::right;    ///< with several samples
    BoxWalk box_walk = BoxWalk::all;               ///< of edge functions
    WeightEdge weight_edge = WeightEdge::opposite; ///< of edge functions
    LineAlgorithm line = LineAlgorithm::interpolate;
    BresenhamRule bresenham_rule = BresenhamRule::right;
    Rounding line_rounding = Rounding::truncate; ///< of the samples of Interpolate along edges
    LineWalk line_walk = LineWalk::accumulate;
    EdgeSamples edge_samples = EdgeSamples::longest_axis;
    RowStart row_start = RowStart::extreme;
    RowSearch row_search = RowSearch::indexed;
    EmptyRows empty_rows = EmptyRows::skipped;
    Spans spans = Spans::inclusive;
    Bounds bounds = Bounds::inside;
    Hidden hidden = Hidden::depth_buffer;    ///< see hidden_rule()
    DrawOrder draw_order = DrawOrder::scene; ///< see draw_order_rule()
    PainterRule painter_rule = PainterRule::right;
    BspRule bsp_rule = BspRule::right;
    DepthTest depth_test = DepthTest::inverse_z; ///< of the depth buffer
    float depth_clear = 0.0f;   ///< what the depth buffer starts with, see depth_clear_rule()
    float depth_epsilon = 0.0f; ///< how much nearer is nearer, in the depth buffer's units
    DepthFormat depth_format = DepthFormat::inv_z;
    DepthIndex depth_index = DepthIndex::row_major;
    Interpolation interpolation = Interpolation::perspective;
    float interpolation_mix = 0.5f; ///< of interpolation=mixed, 0: affine, 1: perspective
    DepthOrder depth_order = DepthOrder::after_depth_test;
    TextureUse texture = TextureUse::on; ///< only where the scene has textures
    TextureFilter texture_filter = TextureFilter::nearest;
    TextureWrap texture_wrap = TextureWrap::repeat;
    TextureAlpha texture_alpha = TextureAlpha::cut_out; ///< only of textures that have alpha
    TexelRule texel_rule = TexelRule::right;
    NormalMapUse normal_map = NormalMapUse::on; ///< only where the scene has normal maps
    NormalMapRule normal_map_rule = NormalMapRule::right;
    NormalMapSpace normal_map_space = NormalMapSpace::world;
    Parallax parallax = Parallax::limited; ///< only where the scene has height maps
    ParallaxRule parallax_rule = ParallaxRule::right;
    Blend blend = Blend::over;  ///< only where the scene has something half transparent
    float surface_alpha = 0.0f; ///< of whatever is half transparent; 0: each surface's own
    Camera camera;
    Rotation rotation = Rotation::row_vector;
    CameraMove camera_move = CameraMove::subtracted; ///< only with the lab's lines of code
    ImageAxes image_axes = ImageAxes::right_way;
    DividedBy divided_by = DividedBy::z; ///< see divided_by_rule()
    Transform transform = Transform::lab;
    MatrixOrder matrix_order = MatrixOrder::row_vectors; ///< of what is shown; changes no picture
    Translation translation = Translation::last_column;  ///< only with matrices
    NormalW normal_w = NormalW::zero;                    ///< for the light
    float projection_mix = 0.0f;                         ///< 0: perspective, 1: orthographic
    float orthographic_depth = 0.0f; ///< where sizes stay the same; 0: at the world's origin
    float near = 0.1f, far = 100.0f; ///< the view volume's ends, in front of the camera
    std::optional<ViewBox> view_box; ///< window on the near plane; none: by the focal length
    Reject reject = Reject::none;
    Clip clip = Clip::leave_out;
    Cull cull = Cull::none;
    BehindMark behind_mark = BehindMark::none;
    OutsidePicture outside_picture = OutsidePicture::kept;
    Light light;
    LightRules light_rules;
    Shadows shadows = Shadows::off;
    ShadowRay shadow_ray = ShadowRay::to_lamp;
    ShadowFilter shadow_filter = ShadowFilter::nearest;
    int shadow_resolution = 512; ///< texels along each side of a face of the map
    ShadowRules shadow_rules;
    Encoding encoding = Encoding::linear;
    ColourOverOne colour_over_one = ColourOverOne::clamp;
    ChannelOrder channel_order = ChannelOrder::rgb;
    Viewport viewport;

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// The lab's rules with the scene's own camera, light, viewport and stage.
Settings default_settings(const Scene& scene);

/// The step of the strip that the settings are at.
const StageInfo& stage_info(const Settings& settings);
StripStep step_of(const Settings& settings);
void set_step(Settings& settings, const StripStep& step);

/// The rounding of vertices and of lines; none if they are rounded differently.
std::optional<Rounding> common_rounding(const Settings& settings);
void set_rounding(Settings& settings, Rounding rounding);

/// How the samples of edges become pixels: only Interpolate uses line_rounding; the other lines
/// take the nearest pixel.
Rounding sample_rounding(const Settings& settings);

/// The depth at which sizes are measured when the projection is not perspective.
float orthographic_depth_rule(const Settings& settings);

/// The window in force: none with the lab's lines of code, which only have a focal length, or in
/// pixels.
std::optional<ViewBox> view_box_rule(const Settings& settings, SceneSpace space);

/// The depth that clip space carries and the depth buffer holds. Without perspective, 1/z is not
/// linear on the screen, but z is, so reversed NDC z takes its place.
ClipDepth clip_depth_rule(const Settings& settings, SceneSpace space);

/// How the world is moved to the camera: always correctly with matrices.
CameraMove camera_move_rule(const Settings& settings);

/// What x and y are divided by: z with matrices, or if the projection is not perspective.
DividedBy divided_by_rule(const Settings& settings);

/// What the depth buffer holds, and how finely.
DepthRules depth_rules(const Settings& settings, SceneSpace space);

/// The value that the depth buffer starts with: nearer than the farthest depth by depth_clear, as
/// the buffer holds it.
float depth_clear_rule(const Settings& settings, SceneSpace space);

/// The weights that mixed interpolation carries values with.
MixedWeight mixed_weight_rule(const Settings& settings, SceneSpace space);

/// The alpha of a triangle, 0 (clear) to 1 (opaque): its surface's, or the setting's if it is half
/// transparent.
float alpha_rule(const Settings& settings, const Scene& scene, int triangle);

/// The lamp in force: a flashlight is where the camera is.
Light light_rule(const Settings& settings);

/// How much nearer a fragment must be to be drawn, in the depth buffer's units: only the correct
/// test uses it; for any other it is 0.
float depth_epsilon_rule(const Settings& settings);

/// The part of the settings that each stage of the pipeline needs.
VertexRules vertex_rules(const Settings& settings, SceneSpace space);
/// @param carried the varyings that are wanted; none if only positions matter
EdgeRules edge_rules(const Settings& settings, VaryingSet carried = VaryingSet::all());
PixelRules pixel_rules(const Settings& settings, SceneSpace space);

/// The coverage in force: before stage `rows` only the samples of edges are drawn, whatever the
/// setting says.
Coverage coverage_rule(const Settings& settings);

/// The sampling in force: only the centres with coverage=rows, before stage `fill`, and where the
/// picture is divided into squares. Supersampling includes the samples of multisampling.
Sampling sampling_rule(const Settings& settings);

/// The edge that a corner's weight is made from: always the opposite one where no edge functions
/// find the pixels, whatever the setting says.
WeightEdge weight_edge_rule(const Settings& settings);

/// The shading in force: none before stage `shade`, whatever the setting says.
Shading shading_rule(const Settings& settings);

/// What finds shadows: nothing where no light is computed, whatever the setting says.
Shadows shadow_rule(const Settings& settings, SceneSpace space);

/// Do normal maps have an effect? Only if light is computed at each pixel, which needs normals
/// there.
bool bends_normals(const Settings& settings);

/// Do height maps shift textures? Only if light is computed at each pixel, because only then does a
/// fragment know where it is in the world, and so in which direction the eye is.
bool shifts_textures(const Settings& settings);

/// How hidden surfaces are removed: not at all before stage `depth`, where the scene's order counts
/// as it does with a depth buffer.
Hidden hidden_rule(const Settings& settings);

/// In which order triangles are drawn: before stage `depth`, and where another order removes hidden
/// surfaces, the scene's.
DrawOrder draw_order_rule(const Settings& settings);

/// Are the scene's triangles drawn one after another as it lists them? Not if they are sorted or
/// divided, or if squares are drawn in their place.
bool follows_scene_order(const Settings& settings);

/// The depth test in force: none before stage `depth`, or if there is no depth buffer, whatever the
/// setting says.
DepthTest depth_rule(const Settings& settings);

} // namespace rasterwalk
