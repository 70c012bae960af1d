#include "settings/setting_table.h"

// The rows of the table. setting_value.cpp handles their values.

#include <array>
#include <optional>
#include <type_traits>
#include <utility>

namespace rasterwalk {

namespace {

/// 1/z of the nearest thing that a depth buffer can start with, and of the farthest.
constexpr float largest_depth_clear = 0x1p31f; // INT_MAX as a float
constexpr float largest_depth_epsilon = 10.0f;

/// Nearer to the camera the division by z leaves the range of floats.
constexpr float smallest_near = 1e-6f;
constexpr float smallest_view_side = 1e-6f; ///< of view_box

/// The value at the end of a path of members: at<&Settings::camera, &Camera::yaw>.
template <auto... path>
auto& at(Settings& s) {
    return (s.*....*path);
}

/// A choice among the words of the enum at the end of a path of members.
template <auto... path>
ChoiceSetting choice() {
    using Enum = std::remove_cvref_t<decltype(at<path...>(std::declval<Settings&>()))>;
    return {enum_words<Enum>, [](const Settings& s) { return static_cast<int>((s.*....*path)); },
            [](Settings& s, int index) { at<path...>(s) = static_cast<Enum>(index); }};
}

/// The steps of the strip: each sets a stage and a shading.
ChoiceSetting step_choice() {
    static const auto words = [] {
        std::array<std::string_view, stage_count> names;
        for (std::size_t i = 0; i < names.size(); ++i)
            names[i] = stage_list()[i].name;
        return names;
    }();
    return {words,
            [](const Settings& s) {
                return strip_place({s.stage, s.shading});
            },
            [](Settings& s, int index) {
                set_step(s, stage_list()[static_cast<std::size_t>(index)].step);
            }};
}

/// One rounding for vertices and lines.
ChoiceSetting rounding_choice() {
    return {enum_words<Rounding>,
            [](const Settings& s) {
                const std::optional<Rounding> rounding = common_rounding(s);
                return rounding ? static_cast<int>(*rounding) : no_word;
            },
            [](Settings& s, int index) { set_rounding(s, static_cast<Rounding>(index)); }};
}

/// The two ends of projection_mix; in between, it has no word.
ChoiceSetting projection_choice() {
    return {enum_words<ProjectionKind>,
            [](const Settings& s) {
                if (s.projection_mix == 0.0f) return static_cast<int>(ProjectionKind::perspective);
                return s.projection_mix == 1.0f ? static_cast<int>(ProjectionKind::orthographic)
                                                : no_word;
            },
            [](Settings& s, int index) { s.projection_mix = static_cast<float>(index); }};
}

// What a setting needs, to be of use.

bool is_in_world(const Scene& scene) {
    return scene.space == SceneSpace::world;
}
bool has_textures(const Scene& scene) {
    return !scene.textures.empty();
}
bool has_bumps(const Scene& scene) {
    return has_textures(scene) && has_normal_map(scene);
}
bool has_heights(const Scene& scene) {
    return has_textures(scene) && has_height_map(scene);
}
bool has_any_alpha(const Scene& scene) {
    return has_alpha(scene) || has_texture_alpha(scene);
}
bool has_depth_buffer(const Settings& s) {
    return hidden_rule(s) == Hidden::depth_buffer;
}
bool is_painted(const Settings& s) {
    return s.hidden == Hidden::painter;
}
bool has_bsp(const Settings& s) {
    return s.hidden == Hidden::bsp;
}
bool is_drawn_by_rays(const Settings& s) {
    return s.engine == Engine::rays;
}
bool is_interpolation_mixed(const Settings& s) {
    return s.interpolation == Interpolation::mixed;
}
bool has_highlights(const Settings& s) {
    return s.light.model == LightModel::blinn_phong;
}
bool blends_surfaces(const Settings& s) {
    return s.blend != Blend::off;
}
bool has_shadow_rays(const Settings& s) {
    return s.shadows == Shadows::rays;
}
bool has_shadow_map(const Settings& s) {
    return s.shadows == Shadows::map;
}

std::vector<Setting> make_table() {
    return {
        {"stage", "Drawn up to", "Stage", "How far along the pipeline the picture is drawn.",
         "All sections", "", step_choice()},
        {"shading", "Light computed", "Stage",
         "Where light is computed once all other stages are done: nowhere, once per triangle "
         "(flat), at the vertices (Gouraud) or at every pixel (Phong).",
         "Light per pixel", "", choice<&Settings::shading>(),
         SettingTies{.part_of = "stage", .words_moved_to = "depth_order"}},
        {"engine", "Picture drawn by", "Stage",
         "What draws the whole picture: the steps, which you can walk through; the fast engine, "
         "which has no steps and takes a fraction of the time; a ray through each pixel; or "
         "OpenGL. All but the steps test the centres of pixels. While you walk through time, the "
         "steps draw.",
         "All sections", "", choice<&Settings::engine>(),
         SettingTies{.needs_scene = is_in_world, .is_of_engine = true}},
        {"ray_boxes", "Boxes for rays", "Stage",
         "How triangles are sorted into boxes, so that a ray needs to be tested only against those "
         "in boxes that it meets: boxes in boxes, a bounding volume hierarchy; or one box, so that "
         "it is tested against every triangle. The picture is the same.",
         "Beyond the lab", "", choice<&Settings::ray_boxes>(),
         SettingTies{.needs_scene = is_in_world, .needs = is_drawn_by_rays, .is_of_engine = true}},
        {"mirrors", "Mirrors", "Stage",
         "Whether a surface with a highlight also mirrors what is around it: the ray goes on from "
         "there, and what it meets is added, times the specular share.",
         "Beyond the lab", "", choice<&Settings::mirrors>(),
         SettingTies{.needs_scene = is_in_world, .needs = is_drawn_by_rays, .is_of_engine = true}},
        {"tessellation", "Triangles cut into", "Stage",
         "How many parts each edge of the scene is cut into before anything else happens. n parts "
         "turn each triangle into n², and these are what is drawn and counted: triangles[t] of the "
         "scene becomes triangles[t n²] and the next ones, n² in all. The surfaces stay where "
         "they are, but there are more vertices at which light can be computed.",
         "Light per vertex", "parts",
         WholeSetting{at<&Settings::tessellation>, 1, largest_tessellation},
         SettingTies{.needs_scene = is_in_world}},
        {"rounding", "Rounding", "Rows and edges",
         "How a real coordinate becomes a whole pixel: int() cuts toward zero.", "Drawing edges",
         "", rounding_choice()},
        {"vertex_rounding", "Rounding of vertices", "Rows and edges",
         "How a projected vertex becomes a pixel: rounded while it is still counted from the "
         "middle of the picture; or (truncate_sum) moved to the middle first, int(f x/z + W/2).",
         "Drawing points", "", choice<&Settings::vertex_rounding>(),
         SettingTies{.part_of = "rounding"}},
        {"line_rounding", "Rounding of samples", "Rows and edges",
         "How a sample of an edge becomes a pixel. Used only if the line algorithm is interpolate; "
         "the others take the nearest pixel.",
         "Drawing edges", "", choice<&Settings::line_rounding>(),
         SettingTies{.part_of = "rounding"}},
        {"coverage", "Fill algorithm", "Rows and edges",
         "How the pixels of a triangle are found: by the row table that the samples of its edges "
         "fill, by edge functions that test the pixels of its box (Pineda), by scan conversion row "
         "by row, or by a list of active edges. The last three test the centres of pixels.",
         "Filled triangles", "", choice<&Settings::coverage>()},
        {"fill_rule", "Fill rule", "Rows and edges",
         "Which triangles draw a pixel whose centre lies exactly on an edge: all of them, none, or "
         "the one that has it as a top or left edge; or, by mistake, only the one that has it as a "
         "left edge. Used only if coverage is not rows.",
         "Filled triangles", "", choice<&Settings::fill_rule>()},
        {"snap", "Corners snapped to", "Rows and edges",
         "The grid that the corners of a triangle are moved to: the centres of whole pixels, 16ths "
         "of a pixel, or subpixel, which is 256ths. Used only if coverage is not rows.",
         "Filled triangles", "", choice<&Settings::snap>()},
        {"pixel_sample", "Pixels tested at", "Rows and edges",
         "The point at which a pixel is tested for coverage: its centre, or by mistake its upper "
         "left corner. Used only if coverage is not rows.",
         "Filled triangles", "", choice<&Settings::pixel_sample>()},
        {"samples", "Samples of a pixel", "Rows and edges",
         "At how many points of a pixel coverage and depth are tested: at its centre, or at four "
         "places, each with a colour and a depth of its own. The pixel shader runs once per "
         "fragment, at the centre, and when everything is drawn each pixel gets the mean of its "
         "samples (multisampling). Used from the Fill stage on, only if coverage is not rows: the "
         "row table holds whole columns, and there is nothing between them. Not used with "
         "hidden=warnock.",
         "Beyond the lab", "samples",
         WholeSetting{at<&Settings::samples>, 1, sample_count, sample_count - 1}},
        {"supersample", "Supersampling", "Rows and edges",
         "How many samples a pixel has along each of its sides, with the pixel shader run at each "
         "of them: with 2 the picture is drawn at twice its size and made smaller again. It goes "
         "before samples=4. Used in the same cases.",
         "Beyond the lab", "samples", WholeSetting{at<&Settings::supersample>, 1, 2}},
        {"sample_rule", "Sample rule", "Rows and edges",
         "How samples are tested and averaged: each by its own depth, with its colour clamped "
         "before the mean; or, by mistake, with only the mean clamped, or with the depth of the "
         "pixel's centre for all of them. Used only if pixels have several samples.",
         "Beyond the lab", "", choice<&Settings::sample_rule>()},
        {"box_walk", "Box pixels tested", "Rows and edges",
         "Which pixels of a triangle's bounding box the edge functions test: all of them, or in "
         "each row only the interval between the places where the edges cross it. The picture is "
         "the same. Used only if coverage is edge_functions.",
         "Beyond the lab", "", choice<&Settings::box_walk>()},
        {"weight_edge", "Corner weight from", "Rows and edges",
         "Which edge function gives the weight of a corner: that of the opposite edge, or by "
         "mistake that of the edge that starts at it. Used only if coverage is edge_functions.",
         "Filled triangles", "", choice<&Settings::weight_edge>()},
        {"line", "Line algorithm", "Rows and edges",
         "How the samples of an edge are found: by the lab's Interpolate, by Bresenham with "
         "integers, by the midpoint algorithm, or by the textbook DDA, which adds floats and "
         "rounds to the nearest pixel. Values along rows are always interpolated.",
         "Drawing edges", "", choice<&Settings::line>()},
        {"bresenham_rule", "Bresenham's steps", "Rows and edges",
         "Whether Bresenham's line is written correctly, only for the first of eight octants, or "
         "with a wrong term after a diagonal step. Used only if the line algorithm is bresenham.",
         "Drawing edges", "", choice<&Settings::bresenham_rule>()},
        {"line_walk", "Walking a line", "Rows and edges",
         "How the samples of a line are found: by adding up steps, by multiplying, without error, "
         "or by mistake with a step from an integer division, with a step divided by the number of "
         "samples, or along rows with a 1/z that falls where it should rise. Rows always use this; "
         "edges only if the line algorithm is interpolate.",
         "Drawing edges", "", choice<&Settings::line_walk>()},
        {"edge_samples", "Edge samples", "Rows and edges",
         "How many samples an edge has: one for each pixel of its longer axis, one in each row, or "
         "|a − b + 1| where |a − b| + 1 was meant; or all but the last, or none for the last edge. "
         "Used only if the line algorithm is interpolate.",
         "Filled triangles", "", choice<&Settings::edge_samples>()},
        {"row_start", "Row table begins with", "Rows and edges",
         "What the ends of a row are before its first sample: ±INT_MAX; or, by mistake, the "
         "picture's width on the left and 0 on the right, or ±INT_MAX in a table with one row too "
         "few.",
         "Filled triangles", "", choice<&Settings::row_start>()},
        {"row_search", "Finding a row", "Rows and edges",
         "How a sample finds its row in the table: by its number; or, by mistake, by searching "
         "every row, by going to the nearest row if it lies beyond the table, or by its number, "
         "but only the column of the sample goes into the row.",
         "Filled triangles", "", choice<&Settings::row_search>()},
        {"empty_rows", "Rows without samples", "Rows and edges",
         "What happens to a row that no sample reached: nothing, or it draws right − left + 1 "
         "fragments, which overflows (here it does so safely).",
         "Filled triangles", "", choice<&Settings::empty_rows>()},
        {"spans", "Fragments of a row", "Rows and edges",
         "Which fragments of a row are drawn: all, both ends included; or, by mistake, none in a "
         "row of one pixel, or all but the last.",
         "Filled triangles", "", choice<&Settings::spans>()},
        {"hidden", "Hidden surfaces", "Depth and interpolation",
         "How hidden surfaces are removed, from stage depth on: by the depth buffer; by the "
         "painter's algorithm, which draws the farthest triangles first; by a BSP tree, which "
         "cuts triangles along planes and draws the pieces from back to front; or by Warnock's "
         "algorithm, which divides the picture into squares until each is simple. The last three "
         "need no depth buffer. With painter and bsp, triangles[t] is the t-th of those drawn.",
         "Depth buffer", "", choice<&Settings::hidden>(), SettingTies{.needs_scene = is_in_world}},
        {"draw_order", "Drawing order", "Depth and interpolation",
         "The order in which triangles are drawn into the depth buffer, from stage depth on: the "
         "scene's, or sorted by the mean depth of their corners, the nearest or the farthest "
         "first. The depth test decides as before; but what is drawn later and hidden needs no "
         "colour. In a sorted order, triangles[t] is the t-th of those drawn. Used only if hidden "
         "is depth_buffer.",
         "Depth buffer", "", choice<&Settings::draw_order>(),
         SettingTies{.needs_scene = is_in_world, .needs = has_depth_buffer}},
        {"painter_rule", "Painter's order", "Depth and interpolation",
         "How the painter sorts: by the mean depth of the corners, the farthest first; or, by "
         "mistake, by the depth of the nearest corner, or the nearest first. Used only if hidden "
         "is painter.",
         "Depth buffer", "", choice<&Settings::painter_rule>(),
         SettingTies{.needs_scene = is_in_world, .needs = is_painted}},
        {"bsp_rule", "Side drawn first", "Depth and interpolation",
         "Which side of a plane is drawn first: the one on which the camera is not; or, by "
         "mistake, the one on which it is. Used only if hidden is bsp.",
         "Depth buffer", "", choice<&Settings::bsp_rule>(),
         SettingTies{.needs_scene = is_in_world, .needs = has_bsp}},
        {"depth_test", "Depth test", "Depth and interpolation",
         "What decides which fragment is nearer: 1/z (or whatever the depth buffer holds); z "
         "interpolated in a straight line; nothing; 1/z the wrong way round; 1/z with ≥ in "
         "place of >; or 1/z in a race of two threads for one buffer, the same in every run.",
         "Depth buffer", "", choice<&Settings::depth_test>(),
         SettingTies{.needs = has_depth_buffer}},
        {"depth_format", "Depth buffer holds", "Depth and interpolation",
         "What the depth buffer holds: 1/z; NDC z, 0 at the near plane and 1 at the far one; or "
         "NDC z reversed; each as a float, or rounded to 24 or 16 bits. Without perspective, 1/z "
         "does not change linearly, so reversed NDC z takes its place. This affects every depth "
         "test; without one it only changes what is stored.",
         "Depth buffer", "", choice<&Settings::depth_format>()},
        {"depth_clear", "Depth buffer begins at", "Depth and interpolation",
         "What the depth buffer starts with, measured from the value of the farthest depth: for "
         "1/z, 0 is infinitely far and 1 is one unit away; NDC z starts at 1 minus this.",
         "Depth buffer", "1/z or NDC z",
         NumberSetting{at<&Settings::depth_clear>, -largest_depth_clear, largest_depth_clear,
                       0.01f}},
        {"depth_epsilon", "Nearer by more than", "Depth and interpolation",
         "How much nearer than the stored depth a fragment must be, in 1/z or whatever the depth "
         "buffer holds. A fragment that is only just nearer counts as a tie, and the one drawn "
         "first stays. Only the correct depth test uses it.",
         "Depth buffer", "1/z or NDC z",
         NumberSetting{at<&Settings::depth_epsilon>, 0.0f, largest_depth_epsilon, 1e-6f}},
        {"depth_index", "Depth buffer index", "Depth and interpolation",
         "Which cell of the depth buffer belongs to a pixel: [y][x], or by mistake [x][y].",
         "Depth buffer", "", choice<&Settings::depth_index>()},
        {"depth_order", "Colour computed", "Depth and interpolation",
         "When a fragment's colour is computed: after the depth test, only if the fragment is "
         "drawn; or before it, always.",
         "Depth buffer", "", choice<&Settings::depth_order>()},
        {"interpolation", "Between the vertices", "Depth and interpolation",
         "How values between the vertices are found: divided by z at the vertices and by 1/z at "
         "the pixel (perspective); straight across the picture (affine); with weights in between "
         "(mixed); or, by mistake, multiplied by 1/z twice and divided by it once, or divided by "
         "1/z twice, or not at all, at the pixel.",
         "Light per pixel", "", choice<&Settings::interpolation>()},
        {"interpolation_mix", "Perspective m", "Depth and interpolation",
         "How much of perspective mixed interpolation takes into account. A vertex has the weight "
         "(1 − m) + m d/z, where d is the reference depth: all weights are equal at 0, which is "
         "affine, and go with 1/z at 1, which is perspective-correct.",
         "Light per pixel", "", NumberSetting{at<&Settings::interpolation_mix>, 0.0f, 1.0f, 0.005f},
         SettingTies{.needs = is_interpolation_mixed}},
        {"texture", "Textures", "Texture",
         "Whether surfaces show the textures that the scene gives them. Without one a surface has "
         "its own colour.",
         "Light per pixel", "", choice<&Settings::texture>(),
         SettingTies{.needs_scene = has_textures}},
        {"texture_filter", "Texture filter", "Texture",
         "Which texels (the pixels of a texture) colour a pixel: the one it falls in; the four "
         "around it; those four in a smaller copy of the texture that matches the size of the "
         "pixel (mipmap); or the four in each of the two copies nearest to that size (trilinear).",
         "Light per pixel", "", choice<&Settings::texture_filter>(),
         SettingTies{.needs_scene = has_textures}},
        {"texture_wrap", "Texture wrapping", "Texture",
         "What lies beyond the borders of a texture: the texture again, the texels of its border, "
         "or the texture with every second copy mirrored.",
         "Light per pixel", "", choice<&Settings::texture_wrap>(),
         SettingTies{.needs_scene = has_textures}},
        {"texture_alpha", "Texture alpha", "Texture",
         "What the alpha of a texture does: it cuts holes where it is below 1/2, as in leaves and "
         "fences; it blends each pixel over what was there; or it does nothing. Shadows are always "
         "those of the whole triangle.",
         "Beyond the lab", "", choice<&Settings::texture_alpha>(),
         SettingTies{.needs_scene = has_texture_alpha}},
        {"texel_rule", "Texel number", "Texture",
         "How a position in a texture becomes the number of a texel: correctly, or by mistake with "
         "v from the bottom, with the centres of texels at whole numbers, with a remainder that "
         "may be below 0 (only if texture_wrap is repeat), or with a mip level that depends on x "
         "alone (only if texture_filter uses levels).",
         "Light per pixel", "", choice<&Settings::texel_rule>(),
         SettingTies{.needs_scene = has_textures}},
        {"normal_map", "Normal maps", "Texture",
         "Whether normal maps bend the normals of the surfaces that have them. This needs light "
         "per pixel, because only then is a normal looked up at each one.",
         "Beyond the lab", "", choice<&Settings::normal_map>(),
         SettingTies{.needs_scene = has_bumps}},
        {"normal_map_rule", "Reading normal maps", "Texture",
         "How a colour of a normal map becomes a normal: correctly, as 2 c - 1 with green up; or "
         "by mistake with green down, with the same bitangent even where the texture is mirrored, "
         "or with the colour as it is.",
         "Beyond the lab", "", choice<&Settings::normal_map_rule>(),
         SettingTies{.needs_scene = has_bumps}},
        {"normal_map_space", "Bumps lit in", "Texture",
         "The space in which light meets the normal of a normal map: the world, into which "
         "the normal is transformed, or tangent space, into which the lamp and the eye are "
         "transformed. The picture is the same except for rounding.",
         "Beyond the lab", "", choice<&Settings::normal_map_space>(),
         SettingTies{.needs_scene = has_bumps}},
        {"parallax", "Parallax mapping", "Texture",
         "Whether height maps shift the texture toward the eye where a surface is high, and away "
         "from it where it is low: by h V.xy / V.z, which has no end at grazing angles, or "
         "limited, by h V.xy. This needs light per pixel, because only then does a pixel know "
         "where the eye is.",
         "Beyond the lab", "", choice<&Settings::parallax>(),
         SettingTies{.needs_scene = has_heights}},
        {"parallax_rule", "Parallax goes", "Texture",
         "Which way a height shifts the texture: correctly, toward the eye where the surface is "
         "high; or, by mistake, away from it.",
         "Beyond the lab", "", choice<&Settings::parallax_rule>(),
         SettingTies{.needs_scene = has_heights}},
        {"blend", "Half-transparent", "Depth and interpolation",
         "How a half-transparent surface is drawn: blended by its alpha over what the pixel shows "
         "(Porter-Duff's over); as if it were opaque; or, by mistake, with the two weights "
         "swapped.",
         "Beyond the lab", "", choice<&Settings::blend>(),
         SettingTies{.needs_scene = has_any_alpha}},
        {"surface.alpha", "Alpha of surfaces", "Depth and interpolation",
         "How opaque half-transparent surfaces are: above 0 up to 1 (opaque), the same for all of "
         "them; 0 takes each surface's own alpha.",
         "Beyond the lab", "", NumberSetting{at<&Settings::surface_alpha>, 0.0f, 1.0f, 0.005f},
         SettingTies{.needs_scene = has_alpha, .needs = blends_surfaces}},
        {"camera.position", "Camera position", "Camera",
         "Where the camera is: x right, y down, z forward.", "Moving the camera", "world units",
         VectorSetting{at<&Settings::camera, &Camera::position>, -largest_place, largest_place,
                       0.01f, false}},
        {"camera.yaw", "Turn (yaw)", "Camera", "How far the camera is turned about the y axis.",
         "Moving the camera", "radians",
         NumberSetting{at<&Settings::camera, &Camera::yaw>, -largest_yaw, largest_yaw, 0.005f}},
        {"camera.pitch", "Tilt (pitch)", "Camera",
         "How far the camera is turned about the x axis, after the yaw.", "Moving the camera",
         "radians",
         NumberSetting{at<&Settings::camera, &Camera::pitch>, -largest_pitch, largest_pitch,
                       0.005f}},
        {"camera.focal_length", "Focal length", "Camera",
         "Distance from the camera to the picture; doubling it makes everything twice as large.",
         "Drawing points", "pixels",
         NumberSetting{at<&Settings::camera, &Camera::focal_length>, smallest_focal_length,
                       largest_focal_length, 1.0f}},
        {"camera.aim", "Camera aimed by", "Camera",
         "What sets the direction in which the camera looks: turn and tilt, or a target point.",
         "Moving the camera", "", choice<&Settings::camera, &Camera::aim>()},
        {"camera.target", "Looks at", "Camera",
         "The point in the middle of the picture, if the camera is aimed at a target.",
         "Moving the camera", "world units",
         VectorSetting{at<&Settings::camera, &Camera::target>, -largest_place, largest_place, 0.01f,
                       false}},
        {"camera.up", "Up", "Camera",
         "The direction that points up in the picture, if the camera is aimed at a target.",
         "Moving the camera", "",
         VectorSetting{at<&Settings::camera, &Camera::up>, -largest_place, largest_place, 0.01f,
                       false}},
        {"rotation", "Rotation applied as", "Camera",
         "How the camera's rotation R is applied: v R, or by mistake R v.", "Moving the camera", "",
         choice<&Settings::rotation>()},
        {"camera_move", "Move to the camera", "Camera",
         "How the camera's position C is applied: subtracted before the rotation, (v − C) "
         "R; or by mistake added, (v + C) R, or subtracted after the rotation, v R − C. "
         "Used only if transform is lab.",
         "Moving the camera", "", choice<&Settings::camera_move>(),
         SettingTies{.needs_scene = is_in_world}},
        {"image_axes", "Picture axes", "Camera",
         "Which way the picture's axes run: x to the right and y down from its middle; or by "
         "mistake both reversed (a negative focal length), x and y swapped, or both from the upper "
         "left corner (without adding half the picture's size).",
         "Drawing points", "", choice<&Settings::image_axes>()},
        {"divided_by", "x and y divided by", "Camera",
         "What x and y are divided by, and whose reciprocal the depth buffer holds: z, how "
         "far a point is in front of the camera; or by mistake its distance from the "
         "camera. Used only in perspective and if transform is lab.",
         "Drawing points", "", choice<&Settings::divided_by>(),
         SettingTies{.needs_scene = is_in_world}},
        {"behind_mark", "Vertices behind camera", "Camera",
         "How a vertex on or behind the camera plane is marked: it has no pixel, or by mistake the "
         "column −1.",
         "Drawing points", "", choice<&Settings::behind_mark>()},
        {"outside_picture", "Outside the picture", "Camera",
         "What happens to vertices outside the picture: they stay there, or are moved to its "
         "border.",
         "Drawing points", "", choice<&Settings::outside_picture>()},
        {"transform", "World to clip space", "Spaces",
         "How a vertex gets from the world to clip space: by the lab's lines of code, or by one "
         "matrix per space.",
         "Moving the camera", "", choice<&Settings::transform>()},
        {"matrix_order", "Vectors are", "Spaces",
         "Which side of a matrix the vector is on where spaces are shown. The picture is the same.",
         "Moving the camera", "", choice<&Settings::matrix_order>()},
        {"translation", "Translation is", "Spaces",
         "Where the view matrix has its translation: in the last column, or by mistake in the "
         "bottom row, where it spoils w and moves nothing. Used only if transform is matrices.",
         "Moving the camera", "", choice<&Settings::translation>()},
        {"normal_w", "w of normals", "Spaces",
         "The w that a normal is given on its way to camera space for lighting: 0, as a "
         "direction, or by mistake 1, as a position, so that it is moved too.",
         "Illumination", "", choice<&Settings::normal_w>()},
        {"projection", "Projection", "Spaces",
         "Perspective divides by z; orthographic does not, so far things look as large as near "
         "ones.",
         "Drawing points", "", projection_choice()},
        {"projection_mix", "Orthographic mix", "Spaces",
         "0 is perspective, 1 is orthographic; between them w is (1 − mix) z + mix.",
         "Drawing points", "", NumberSetting{at<&Settings::projection_mix>, 0.0f, 1.0f, 0.005f},
         SettingTies{.part_of = "projection"}},
        {"orthographic_depth", "Reference depth d", "Spaces",
         "Orthographic projection divides x and y by this one depth instead of z, so things at "
         "this depth keep their size. 0 takes the depth of the world's origin.",
         "Drawing points", "world units",
         NumberSetting{at<&Settings::orthographic_depth>, 0.0f, largest_place, 0.01f}},
        {"near", "Near plane", "View volume",
         "How far in front of the camera the view begins; anything nearer is cut off.",
         "Drawing points", "world units",
         NumberSetting{at<&Settings::near>, smallest_near, largest_place, 0.01f}},
        {"far", "Far plane", "View volume",
         "How far in front of the camera the view ends; anything farther is cut off.",
         "Drawing points", "world units",
         NumberSetting{at<&Settings::far>, smallest_near, largest_place, 0.1f}},
        {"view_box", "Box at near: l, r, b, t", "View volume",
         "The window on the near plane, which fills the picture, in place of the focal length: "
         "left,right,bottom,top with y up, as glFrustum and glOrtho take them, or auto for the "
         "focal length. It may be off-centre. Used only if transform is matrices.",
         "Beyond the lab", "world units",
         BoxSetting{at<&Settings::view_box>, -largest_place, largest_place, smallest_view_side,
                    0.001f}},
        {"reject", "Rejected before clipping", "View volume",
         "Which triangles are found to lie entirely outside: none, or those whose vertices all lie "
         "beyond the same plane, as their outcodes show (Cohen-Sutherland). Cheap clipping does "
         "that too, and walks the others only as far as the picture reaches.",
         "Drawing points", "", choice<&Settings::reject>()},
        {"clip", "Clipped", "View volume",
         "What happens to triangles that reach outside the view: left out if a vertex lies behind "
         "the camera, cut by planes before the division (Sutherland-Hodgman), or nothing, so that "
         "anything behind the camera is drawn upside down. The last five are mistakes.",
         "Drawing points", "", choice<&Settings::clip>()},
        {"cull", "Culled", "View volume",
         "How triangles that face away from the camera are found and left out: by the normal of "
         "the surface, by the way their corners go round on the screen, by the normals of all "
         "vertices; or fragment by fragment, by the interpolated normal; or, by mistake, by the "
         "direction in which the camera looks, or by the lamp.",
         "Drawing points", "", choice<&Settings::cull>()},
        {"light.position", "Lamp position", "Light",
         "Where the lamp is: x right, y down, z into the picture.", "Illumination", "world units",
         VectorSetting{at<&Settings::light, &Light::position>, -largest_place, largest_place, 0.01f,
                       false}},
        {"light.power", "Lamp power", "Light",
         "Power of the lamp, which spreads over a sphere of 4 pi r^2.", "Illumination", "",
         VectorSetting{at<&Settings::light, &Light::power>, 0.0f, largest_power, 0.05f, true}},
        {"light.indirect", "Indirect light", "Light",
         "Light that comes from everywhere, the same at every point.", "Illumination", "",
         VectorSetting{at<&Settings::light, &Light::indirect>, 0.0f, largest_indirect, 0.005f,
                       true}},
        {"light.place", "Lamp is", "Light",
         "Where the lamp is: at its position, or at the camera, like a flashlight.", "Illumination",
         "", choice<&Settings::light, &Light::place>()},
        {"light.model", "Reflection model", "Light",
         "How a surface reflects light: the same in all directions (Lambert), or also with a "
         "highlight, if its material has one (Blinn-Phong).",
         "Illumination", "", choice<&Settings::light, &Light::model>()},
        {"light.exponent", "Highlight exponent", "Light",
         "How small and sharp highlights are: the power that n · h is raised to, above 0 the same "
         "for all materials; 0 takes each material's own exponent. Used only if light.model is "
         "blinn_phong.",
         "Illumination", "",
         NumberSetting{at<&Settings::light, &Light::exponent>, smallest_exponent, largest_exponent,
                       0.5f},
         SettingTies{.needs = has_highlights}},
        {"light.direction", "Light direction", "Light",
         "The vector that is compared with the normal: the one to the lamp, made unit length; or "
         "by mistake the one from the lamp, the one to the lamp at its full length, or the one to "
         "the lamp divided by a length that includes w = 1.",
         "Illumination", "", choice<&Settings::light_rules, &LightRules::direction>()},
        {"light.falloff", "Falloff", "Light",
         "What the power is divided by: 4 pi r^2, r^2, r, nothing, or by mistake 4 pi r^3, or 4 pi "
         "r^2 with a wrong pi.",
         "Illumination", "", choice<&Settings::light_rules, &LightRules::falloff>()},
        {"light.sum", "Light formula", "Light",
         "How the light is combined: reflectance times (D + N); or by mistake D plus "
         "reflectance, or reflectance times itself times (D + N).",
         "Illumination", "", choice<&Settings::light_rules, &LightRules::sum>()},
        {"light.renormalize", "Normals made unit length", "Light",
         "Whether an interpolated normal is made unit length again at the pixel. This matters only "
         "on surfaces whose corners have normals of their own.",
         "Light per pixel", "", choice<&Settings::light_rules, &LightRules::renormalize>()},
        {"light.highlight", "Highlight", "Light",
         "How the highlight is computed: correctly, or by mistake also on sides that face away "
         "from the lamp, or with a half vector that is not made unit length. Used only if "
         "light.model is blinn_phong.",
         "Illumination", "", choice<&Settings::light_rules, &LightRules::highlight>()},
        {"light.sides", "Lit sides", "Light",
         "How many sides of a surface are lit: the one its normal points to, or both. With both, a "
         "normal that points away from the eye is turned toward it before the light is computed, "
         "so the back of a surface is lit as its front would be.",
         "Beyond the lab", "", choice<&Settings::light_rules, &LightRules::sides>()},
        {"shadows", "Shadows", "Shadow",
         "How the program finds out whether something is between a point and the lamp: not at all, "
         "by a ray from the point to the lamp, or by a map of the depths that the lamp sees.",
         "Beyond the lab", "", choice<&Settings::shadows>(),
         SettingTies{.needs_scene = is_in_world}},
        {"shadow_offset", "Ray offset", "Shadow",
         "How far above its surface the ray to the lamp starts, along the normal. A point that "
         "rounding has moved below the surface would otherwise be in that surface's own shadow.",
         "Beyond the lab", "world units",
         NumberSetting{at<&Settings::shadow_rules, &ShadowRules::offset>, 0.0f, largest_place,
                       0.0005f},
         SettingTies{.needs_scene = is_in_world, .needs = has_shadow_rays}},
        {"shadow_ray", "Ray goes", "Shadow",
         "How far the ray goes: as far as the lamp, or by mistake beyond it, so that things behind "
         "the lamp cast shadows too.",
         "Beyond the lab", "", choice<&Settings::shadow_ray>(),
         SettingTies{.needs_scene = is_in_world, .needs = has_shadow_rays}},
        {"shadow_resolution", "Map size", "Shadow",
         "The number of texels along each side of the map's six faces.", "Beyond the lab", "texels",
         WholeSetting{at<&Settings::shadow_resolution>, smallest_shadow_resolution,
                      largest_shadow_resolution},
         SettingTies{.needs_scene = is_in_world, .needs = has_shadow_map}},
        {"shadow_bias", "Bias", "Shadow",
         "How far behind the depth in the map a point may lie and still be lit. With too little "
         "bias, surfaces shadow themselves in stripes; with too much, shadows come loose from "
         "whatever casts them.",
         "Beyond the lab", "world units",
         NumberSetting{at<&Settings::shadow_rules, &ShadowRules::bias>, 0.0f, largest_place,
                       0.0005f},
         SettingTies{.needs_scene = is_in_world, .needs = has_shadow_map}},
        {"shadow_slope_bias", "Slope bias", "Shadow",
         "Added to the bias: this many texels, times how steeply the surface slopes away from the "
         "lamp (the tangent of the angle between the light and the normal).",
         "Beyond the lab", "texels",
         NumberSetting{at<&Settings::shadow_rules, &ShadowRules::slope_bias>, 0.0f,
                       largest_slope_bias, 0.01f},
         SettingTies{.needs_scene = is_in_world, .needs = has_shadow_map}},
        {"shadow_filter", "Texels compared", "Shadow",
         "How many texels of the map a point is compared with: the one it falls in, or the four "
         "around it, so that the edge of a shadow has steps of a quarter (PCF).",
         "Beyond the lab", "", choice<&Settings::shadow_filter>(),
         SettingTies{.needs_scene = is_in_world, .needs = has_shadow_map}},
        {"viewport.size", "Picture size", "Picture", "Width and height of the picture.",
         "Drawing points", "pixels", SizeSetting{at<&Settings::viewport>, largest_viewport}},
        {"bounds", "In the picture", "Picture",
         "Which columns and rows count as inside the picture: those from 0 up, or by mistake only "
         "those above 0.",
         "Drawing points", "", choice<&Settings::bounds>()},
        {"encoding", "Bytes hold", "Picture",
         "How light becomes a byte: linearly, so that twice the light is twice the byte; by the "
         "sRGB curve, which a screen undoes, so that it sends out the light that was computed; or, "
         "by mistake where linear numbers are wanted, raised to the power of 1/2.2. Textures are "
         "not decoded; their bytes are always read as linear numbers.",
         "Beyond the lab", "", choice<&Settings::encoding>()},
        {"colour_over_one", "Channels above 1", "Picture",
         "What a channel above 1 is shown as: 1, or only its lowest 8 bits.", "Illumination", "",
         choice<&Settings::colour_over_one>()},
        {"channel_order", "Channel order", "Picture",
         "The order in which red, green and blue go to the screen: red first, or by mistake blue "
         "first, which swaps red and blue.",
         "Drawing points", "", choice<&Settings::channel_order>()},
    };
}

} // namespace

std::span<const Setting> setting_table() {
    static const std::vector<Setting> table = make_table();
    return table;
}

bool is_of_use(const Setting& setting, const Scene& scene) {
    return setting.ties.needs_scene == nullptr || setting.ties.needs_scene(scene);
}

bool is_of_use(const Setting& setting, const Scene& scene, const Settings& settings) {
    return is_of_use(setting, scene) &&
           (setting.ties.needs == nullptr || setting.ties.needs(settings));
}

const Setting* find_setting(std::string_view name) {
    for (const Setting& setting : setting_table()) {
        if (setting.name == name) return &setting;
    }
    return nullptr;
}

} // namespace rasterwalk
