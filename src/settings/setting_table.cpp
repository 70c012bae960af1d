#include "settings/setting_table.h"

// The rows of the table. What becomes of their values is in setting_value.cpp.

#include <array>
#include <optional>
#include <type_traits>
#include <utility>

namespace rasterwalk {

namespace {

/// 1/z of the nearest thing that a depth buffer may be made to start with, and of the farthest.
constexpr float largest_depth_clear = 0x1p31f; // INT_MAX as a float
constexpr float largest_depth_epsilon = 10.0f;

/// Nearer to the camera the division by z leaves the range of floats.
constexpr float smallest_near = 1e-6f;
constexpr float smallest_view_side = 1e-6f; ///< of view_box

/// A choice among the words of an enum, which is one member of Settings.
template <auto member>
ChoiceSetting choice() {
    using Enum = std::remove_cvref_t<decltype(std::declval<Settings>().*member)>;
    static_assert(words_match<Enum>);
    return {enum_words<Enum>, [](const Settings& s) { return static_cast<int>(s.*member); },
            [](Settings& s, int index) { s.*member = static_cast<Enum>(index); }};
}

/// The same for a member of the rules of light.
template <auto member>
ChoiceSetting light_choice() {
    using Enum = std::remove_cvref_t<decltype(std::declval<LightRules>().*member)>;
    static_assert(words_match<Enum>);
    return {enum_words<Enum>,
            [](const Settings& s) { return static_cast<int>(s.light_rules.*member); },
            [](Settings& s, int index) { s.light_rules.*member = static_cast<Enum>(index); }};
}

/// The same for a member of the lamp.
template <auto member>
ChoiceSetting lamp_choice() {
    using Enum = std::remove_cvref_t<decltype(std::declval<Light>().*member)>;
    static_assert(words_match<Enum>);
    return {enum_words<Enum>, [](const Settings& s) { return static_cast<int>(s.light.*member); },
            [](Settings& s, int index) { s.light.*member = static_cast<Enum>(index); }};
}

/// The steps of the strip: each says a stage and a shading.
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

/// The two ends of projection_mix; between them it has no word.
ChoiceSetting projection_choice() {
    return {enum_words<ProjectionKind>,
            [](const Settings& s) {
                if (s.projection_mix == 0.0f) return static_cast<int>(ProjectionKind::perspective);
                return s.projection_mix == 1.0f ? static_cast<int>(ProjectionKind::orthographic)
                                                : no_word;
            },
            [](Settings& s, int index) { s.projection_mix = static_cast<float>(index); }};
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
         "Where light is computed once all other stages are done: nowhere, once a triangle "
         "(flat), at the vertices (Gouraud) or at every pixel (Phong).",
         "Light per pixel", "", choice<&Settings::shading>(), "stage", "depth_order"},
        {.name = "engine",
         .title = "Picture drawn by",
         .group = "Stage",
         .help = "What draws the whole picture: the steps, which you can walk through, or the fast "
                 "engine, which has none and takes a fraction of the time. It asks the centres of "
                 "pixels; where you walk through time the steps draw.",
         .section = "All sections",
         .unit = "",
         .kind = choice<&Settings::engine>(),
         .needs_world = true},
        {"tessellation",
         "Triangles cut into",
         "Stage",
         "Into how many parts each edge of the scene is cut before all else: n makes n² triangles "
         "of each. They are what is drawn and counted: triangles[t] of the scene becomes "
         "triangles[t n²] and those behind it, n² in all. The surfaces stay where they are; there "
         "are more vertices for light to be worked out at.",
         "Light per vertex",
         "parts",
         WholeSetting{[](Settings& s) -> int& { return s.tessellation; }, 1, largest_tessellation},
         {},
         {},
         false,
         true},
        {"rounding", "Rounding", "Rows and edges",
         "How a real coordinate becomes a whole pixel: int() cuts toward zero.", "Drawing edges",
         "", rounding_choice()},
        {"vertex_rounding", "Rounding of vertices", "Rows and edges",
         "How a projected vertex becomes a pixel: made whole as it is counted from the middle of "
         "the picture; or, truncate_sum, moved to the middle first, int(f x/z + W/2).",
         "Drawing points", "", choice<&Settings::vertex_rounding>(), "rounding"},
        {"line_rounding", "Rounding of samples", "Rows and edges",
         "How a sample of an edge becomes a pixel. Only where the line algorithm is interpolate: "
         "the others take the nearest pixel.",
         "Drawing edges", "", choice<&Settings::line_rounding>(), "rounding"},
        {"coverage", "Fill algorithm", "Rows and edges",
         "How the pixels of a triangle are found: by the row table that the samples of its edges "
         "fill, by edge functions that ask the pixels of its box, by scan conversion row by row, "
         "or by a list of active edges. The last three ask the centres of pixels.",
         "Filled triangles", "", choice<&Settings::coverage>()},
        {"fill_rule", "Fill rule", "Rows and edges",
         "Who draws a pixel whose centre lies exactly on an edge: every triangle there, none, or "
         "the one of which it is a top or a left edge; or, by mistake, a left edge only. Only "
         "where coverage is not rows.",
         "Filled triangles", "", choice<&Settings::fill_rule>()},
        {"snap", "Corners stand on", "Rows and edges",
         "The grid on which the corners of a triangle stand: centres of whole pixels, 16ths of a "
         "pixel, or subpixel, which is 256ths. Only where coverage is not rows.",
         "Filled triangles", "", choice<&Settings::snap>()},
        {"pixel_sample", "Pixels tested at", "Rows and edges",
         "Where a pixel is tested whether it is covered: at its centre, or by mistake at its upper "
         "left corner. Only where coverage is not rows.",
         "Filled triangles", "", choice<&Settings::pixel_sample>()},
        {"box_walk", "Pixels of a box tested", "Rows and edges",
         "Which pixels of a triangle's bounding box edge functions test: all of them, or in each "
         "row only the interval between the places where the edges cross it. The picture is the "
         "same. Only where coverage is edge_functions.",
         "Beyond the lab", "", choice<&Settings::box_walk>()},
        {"weight_edge", "Weight of a corner from", "Rows and edges",
         "Which edge function gives the weight of a corner: that of the opposite edge, or by "
         "mistake that of the edge that begins at it. Only where coverage is edge_functions.",
         "Filled triangles", "", choice<&Settings::weight_edge>()},
        {"line", "Line algorithm", "Rows and edges",
         "How the samples of an edge are found: by Interpolate, by Bresenham's whole numbers, by "
         "the midpoint, or by a float that is rounded to the nearest (DDA). Values along rows are "
         "always interpolated.",
         "Drawing edges", "", choice<&Settings::line>()},
        {"bresenham_rule", "Bresenham's steps", "Rows and edges",
         "How Bresenham's line is written: right, only for the first of eight octants, or with a "
         "wrong term behind a diagonal step. Only where the line algorithm is bresenham.",
         "Drawing edges", "", choice<&Settings::bresenham_rule>()},
        {"line_walk", "Walking a line", "Rows and edges",
         "How the samples of a line are found: by adding up steps, by multiplying, without error, "
         "or by mistake with a step that was divided as int by int, with one divided by the number "
         "of samples, or along rows with a 1/z that falls where it should rise. Edges do so only "
         "where the line algorithm is interpolate, rows always.",
         "Drawing edges", "", choice<&Settings::line_walk>()},
        {"edge_samples", "Samples of an edge", "Rows and edges",
         "How many samples an edge has: as many as its longer axis, one in each row, or "
         "|a − b + 1| where |a − b| + 1 was meant; or all but the last, or none for the last edge. "
         "Only where the line algorithm is interpolate.",
         "Filled triangles", "", choice<&Settings::edge_samples>()},
        {"row_start", "Row table begins with", "Rows and edges",
         "Where the ends of a row stand before its first sample: at ±INT_MAX, or left at the "
         "picture's width and right at 0. Or the table has one row too few, by mistake.",
         "Filled triangles", "", choice<&Settings::row_start>()},
        {"row_search", "Finding a row", "Rows and edges",
         "How a sample finds its row in the table: by its number, or by asking every row. By "
         "mistake a sample beyond the table goes to the nearest row, or a row takes only the "
         "column of a sample.",
         "Filled triangles", "", choice<&Settings::row_search>()},
        {"empty_rows", "Rows without samples", "Rows and edges",
         "What becomes of a row that no sample reached: nothing, or right − left + 1 fragments, "
         "which overflows; carried out under guard.",
         "Filled triangles", "", choice<&Settings::empty_rows>()},
        {"spans", "Fragments of a row", "Rows and edges",
         "Which fragments of a row are drawn: both ends too, none in a row of one pixel, or all "
         "but the last.",
         "Filled triangles", "", choice<&Settings::spans>()},
        {"depth_test", "Depth test", "Depth and interpolation",
         "What decides which fragment is nearer: 1/z, or what else the depth buffer holds; z "
         "interpolated in a straight line; nothing; the same as first, the wrong way round; or "
         "with ≥ in place of >.",
         "Depth buffer", "", choice<&Settings::depth_test>()},
        {"depth_format", "Depth buffer holds", "Depth and interpolation",
         "What the depth buffer holds: 1/z; ndc z, 0 at the near plane and 1 at the far one; or "
         "that reversed; each as a float, or rounded to 24 or 16 bits. Without perspective 1/z is "
         "no straight line, and the reversed form takes its place. It acts with every depth test; "
         "with none it only changes what is stored.",
         "Depth buffer", "", choice<&Settings::depth_format>()},
        {"depth_clear", "Depth buffer begins at", "Depth and interpolation",
         "What the depth buffer starts with, above the value of what is farthest: in 1/z 0 is "
         "infinitely far and 1 is one unit away; ndc z begins at 1 less this.",
         "Depth buffer", "1/z or ndc z",
         NumberSetting{[](Settings& s) -> float& { return s.depth_clear; }, -largest_depth_clear,
                       largest_depth_clear, 0.01f}},
        {"depth_epsilon", "Nearer by more than", "Depth and interpolation",
         "How much nearer than what is stored a fragment must be, in 1/z or what else the depth "
         "buffer holds. What is hardly nearer counts as equally near, and the one drawn first "
         "stays. Only the correct depth test asks for it.",
         "Depth buffer", "1/z or ndc z",
         NumberSetting{[](Settings& s) -> float& { return s.depth_epsilon; }, 0.0f,
                       largest_depth_epsilon, 1e-6f}},
        {"depth_index", "Depth buffer index", "Depth and interpolation",
         "Which cell of the depth buffer belongs to a pixel: [y][x], or by mistake [x][y].",
         "Depth buffer", "", choice<&Settings::depth_index>()},
        {"depth_order", "Colour worked out", "Depth and interpolation",
         "When a fragment's colour is worked out: only if it is drawn, or always.", "Depth buffer",
         "", choice<&Settings::depth_order>()},
        {"interpolation", "Between the vertices", "Depth and interpolation",
         "How values between the vertices are found: divided by z on the way, straight across the "
         "picture, divided by z twice and multiplied once, or divided by z and at the pixel by 1/z "
         "never or twice.",
         "Light per pixel", "", choice<&Settings::interpolation>()},
        {"texture",
         "Textures",
         "Texture",
         "Whether surfaces show the textures that the scene gives them. Without one a surface has "
         "its own colour.",
         "Light per pixel",
         "",
         choice<&Settings::texture>(),
         {},
         {},
         true},
        {"texture_filter",
         "Texture filter",
         "Texture",
         "Which texels, the pixels of a texture, colour a pixel: the one in which it lies; the "
         "four around it; those four in a smaller copy of the texture that suits the size of the "
         "pixel (mipmap); or those of the two copies nearest to that size (trilinear).",
         "Light per pixel",
         "",
         choice<&Settings::texture_filter>(),
         {},
         {},
         true},
        {"texture_wrap",
         "Texture wrapping",
         "Texture",
         "What lies beyond the borders of a texture: the texture again, the texels of its border, "
         "or the texture mirrored every second time.",
         "Light per pixel",
         "",
         choice<&Settings::texture_wrap>(),
         {},
         {},
         true},
        {"texture_alpha",
         "Alpha of textures",
         "Texture",
         "What the alpha of a texture does: it cuts holes where it is below 1/2, as in leaves and "
         "fences; it blends each pixel over what was there; or nothing. Shadows are those of the "
         "whole triangle.",
         "Beyond the lab",
         "",
         choice<&Settings::texture_alpha>(),
         {},
         {},
         true,
         false,
         false,
         false,
         nullptr,
         true},
        {"texel_rule",
         "Number of a texel",
         "Texture",
         "How a place in a texture becomes the number of a texel: rightly, or by mistake with v "
         "from the bottom, with the centres of texels at whole numbers, with a remainder that may "
         "be below 0 (only where texture_wrap is repeat), or with a mip level that looks along x "
         "alone (only where texture_filter has levels).",
         "Light per pixel",
         "",
         choice<&Settings::texel_rule>(),
         {},
         {},
         true},
        {"normal_map",
         "Normal maps",
         "Texture",
         "Whether normal maps bend the normals of the surfaces that have them. Only light that is "
         "worked out at each pixel has normals there.",
         "Beyond the lab",
         "",
         choice<&Settings::normal_map>(),
         {},
         {},
         true,
         false,
         false,
         true},
        {"normal_map_rule",
         "Reading normal maps",
         "Texture",
         "How a colour of a normal map becomes a normal: rightly, as 2 c - 1 with green up; or by "
         "mistake with green down, with the same side also where a texture is mirrored, or with "
         "the colour as it is.",
         "Beyond the lab",
         "",
         choice<&Settings::normal_map_rule>(),
         {},
         {},
         true,
         false,
         false,
         true},
        {.name = "normal_map_space",
         .title = "Bumps lit in",
         .group = "Texture",
         .help = "Where light meets the normal of a normal map: in the world, to which the normal "
                 "is taken, or in tangent space, to which the lamp and the eye are taken. The "
                 "picture is the same but for rounding.",
         .section = "Beyond the lab",
         .unit = "",
         .kind = choice<&Settings::normal_map_space>(),
         .needs_texture = true,
         .needs_normal_map = true},
        {"blend",
         "Half transparent",
         "Depth and interpolation",
         "How what is half transparent is drawn: over what its pixel shows, by its alpha; as if it "
         "were opaque; or, by mistake, with the two shares the wrong way round.",
         "Beyond the lab",
         "",
         choice<&Settings::blend>(),
         {},
         {},
         false,
         false,
         true},
        {"camera.position", "Camera position", "Camera",
         "Where the camera stands: x right, y down, z forward.", "Moving the camera", "world units",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.camera.position; }, -largest_place,
                       largest_place, 0.01f, false}},
        {"camera.yaw", "Turn (yaw)", "Camera", "Turn of the camera about the y axis.",
         "Moving the camera", "radians",
         NumberSetting{[](Settings& s) -> float& { return s.camera.yaw; }, -largest_yaw,
                       largest_yaw, 0.005f}},
        {"camera.pitch", "Tilt (pitch)", "Camera",
         "Turn of the camera about the x axis, after the yaw.", "Moving the camera", "radians",
         NumberSetting{[](Settings& s) -> float& { return s.camera.pitch; }, -largest_pitch,
                       largest_pitch, 0.005f}},
        {"camera.focal_length", "Focal length", "Camera",
         "Distance from the camera to the picture; twice as long shows everything twice as large.",
         "Drawing points", "pixels",
         NumberSetting{[](Settings& s) -> float& { return s.camera.focal_length; },
                       smallest_focal_length, largest_focal_length, 1.0f}},
        {"camera.aim", "Camera aimed by", "Camera",
         "What sets the direction in which the camera looks: turn and tilt, or a target, which is "
         "the point that it looks at.",
         "Moving the camera", "",
         ChoiceSetting{
             enum_words<CameraAim>,
             [](const Settings& s) { return static_cast<int>(s.camera.aim); },
             [](Settings& s, int index) { s.camera.aim = static_cast<CameraAim>(index); }}},
        {"camera.target", "Looks at", "Camera",
         "The point in the middle of the picture, if the camera looks at one.", "Moving the camera",
         "world units",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.camera.target; }, -largest_place,
                       largest_place, 0.01f, false}},
        {"camera.up", "Up", "Camera",
         "The direction that points up in the picture, if the camera looks at a point.",
         "Moving the camera", "",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.camera.up; }, -largest_place,
                       largest_place, 0.01f, false}},
        {"rotation", "Rotation applied as", "Camera",
         "How the camera's rotation R is applied: v R, or by mistake R v.", "Moving the camera", "",
         choice<&Settings::rotation>()},
        {.name = "camera_move",
         .title = "Move to the camera",
         .group = "Camera",
         .help = "How the camera's position C is applied: subtracted before the rotation, (v − C) "
                 "R; or by mistake added, (v + C) R, or subtracted after the rotation, v R − C. "
                 "Only where the lab's lines do the work.",
         .section = "Moving the camera",
         .unit = "",
         .kind = choice<&Settings::camera_move>(),
         .needs_world = true},
        {"image_axes", "Picture axes", "Camera",
         "How the axes of the picture lie: x to the right and y down from its middle; or by "
         "mistake turned by half a turn, with a negative focal length, with x and y exchanged, or "
         "counted from the upper left corner, without half of the picture's size.",
         "Drawing points", "", choice<&Settings::image_axes>()},
        {.name = "divided_by",
         .title = "x and y divided by",
         .group = "Camera",
         .help = "What x and y are divided by, and what the depth buffer holds one over: z, how "
                 "far a point is in front of the camera; or by mistake its distance from the "
                 "camera. Only in perspective, where the lab's lines do the work.",
         .section = "Drawing points",
         .unit = "",
         .kind = choice<&Settings::divided_by>(),
         .needs_world = true},
        {"behind_mark", "Mark behind the camera", "Camera",
         "How a vertex on or behind the camera plane is marked: it has no pixel, or by mistake the "
         "column −1.",
         "Drawing points", "", choice<&Settings::behind_mark>()},
        {"outside_picture", "Beside the picture", "Camera",
         "What becomes of vertices beside the picture: they stay there, or are moved to its "
         "border.",
         "Drawing points", "", choice<&Settings::outside_picture>()},
        {"transform", "World to clip space", "Spaces",
         "How a vertex comes from the world to clip space: by the lab's lines, or by a matrix for "
         "each space.",
         "Moving the camera", "", choice<&Settings::transform>()},
        {"matrix_order", "Vectors are", "Spaces",
         "On which side of a matrix the vector stands where spaces are shown. The picture is the "
         "same.",
         "Moving the camera", "", choice<&Settings::matrix_order>()},
        {"translation", "Translation stands", "Spaces",
         "Where the view matrix has the translation: in the last column, or by mistake in the "
         "bottom row, where it spoils w and moves nothing. Only where a matrix for each space does "
         "the work.",
         "Moving the camera", "", choice<&Settings::translation>()},
        {"normal_w", "w of a normal", "Spaces",
         "With which w a normal is taken to the camera before the light: 0, as a direction, or by "
         "mistake 1, as a place, so that it is moved too.",
         "Illumination", "", choice<&Settings::normal_w>()},
        {"projection", "Projection", "Spaces",
         "Perspective divides by z; orthographic does not, so that what is far is as large as what "
         "is near.",
         "Drawing points", "", projection_choice()},
        {"projection_mix", "Way to orthographic", "Spaces",
         "0 is perspective, 1 is orthographic; between them w is (1 − mix) z + mix.",
         "Drawing points", "",
         NumberSetting{[](Settings& s) -> float& { return s.projection_mix; }, 0.0f, 1.0f, 0.005f},
         "projection"},
        {"orthographic_depth", "Reference depth d", "Spaces",
         "Orthographic projection divides x and y by this one depth, not by z: what stands there "
         "keeps its size. 0 takes the depth of the world's origin.",
         "Drawing points", "world units",
         NumberSetting{[](Settings& s) -> float& { return s.orthographic_depth; }, 0.0f,
                       largest_place, 0.01f}},
        {"near", "Near plane", "View volume",
         "How far in front of the camera the view begins; what is nearer is cut off.",
         "Drawing points", "world units",
         NumberSetting{[](Settings& s) -> float& { return s.near; }, smallest_near, largest_place,
                       0.01f}},
        {"far", "Far plane", "View volume",
         "How far in front of the camera the view ends; what is farther is cut off.",
         "Drawing points", "world units",
         NumberSetting{[](Settings& s) -> float& { return s.far; }, smallest_near, largest_place,
                       0.1f}},
        {"view_box", "Box at near: l, r, b, t", "View volume",
         "The window on the near plane, which fills the picture, in place of the focal length: "
         "left,right,bottom,top with y up, as glFrustum and glOrtho take them, or auto for the "
         "focal length. It may be off-centre. Only where a matrix for each space does the work.",
         "Beyond the lab", "world units",
         BoxSetting{[](Settings& s) -> std::optional<ViewBox>& { return s.view_box; },
                    -largest_place, largest_place, smallest_view_side, 0.001f}},
        {"reject", "Rejected before clipping", "View volume",
         "Which triangles are found to lie outside as a whole: none, or those whose vertices all "
         "lie beyond the same plane. Cheap clipping does that too, and walks the others only as "
         "far as the picture reaches.",
         "Drawing points", "", choice<&Settings::reject>()},
        {"clip", "Clipped", "View volume",
         "What becomes of triangles that reach out of the view: left out if a vertex lies behind "
         "the camera, cut by planes before the division, or nothing, so that what is behind is "
         "drawn upside down. The last five are mistakes.",
         "Drawing points", "", choice<&Settings::clip>()},
        {"cull", "Backs left out", "View volume",
         "How triangles are found that show their back to the camera, and left out: by the normal "
         "of the surface, by the way their corners go round on the screen, by the normals of all "
         "vertices; or fragment by fragment, by the interpolated normal; or, by mistake, by the "
         "direction in which the camera looks, or by the lamp.",
         "Drawing points", "", choice<&Settings::cull>()},
        {"light.position", "Lamp position", "Light",
         "Where the lamp is: x right, y down, z into the picture.", "Illumination", "world units",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.light.position; }, -largest_place,
                       largest_place, 0.01f, false}},
        {"light.power", "Lamp power", "Light",
         "Power of the lamp, which spreads over a sphere of 4 pi r^2.", "Illumination", "",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.light.power; }, 0.0f, largest_power,
                       0.05f, true}},
        {"light.indirect", "Indirect light", "Light",
         "Light that comes from everywhere, the same at every point.", "Illumination", "",
         VectorSetting{[](Settings& s) -> glm::vec3& { return s.light.indirect; }, 0.0f,
                       largest_indirect, 0.005f, true}},
        {"light.place", "Lamp stands", "Light",
         "Where the lamp stands: at its position, or where the camera is, like a flashlight.",
         "Illumination", "", lamp_choice<&Light::place>()},
        {"light.model", "Reflection model", "Light",
         "How a surface reflects light: the same in all directions (Lambert), or also with a "
         "highlight, if its material has one (Blinn-Phong).",
         "Illumination", "", lamp_choice<&Light::model>()},
        {"light.direction", "Direction of the light", "Light",
         "The vector whose slant counts: to the lamp at unit length; or by mistake from the lamp, "
         "as long as the way, or with w = 1 in its length.",
         "Illumination", "", light_choice<&LightRules::direction>()},
        {"light.falloff", "Falloff", "Light",
         "Over what the power is spread: 4 pi r^2, r^2, r, nothing, or by mistake 4 pi r^3, or "
         "4 pi r^2 with a wrong pi.",
         "Illumination", "", light_choice<&LightRules::falloff>()},
        {"light.sum", "Sum of the light", "Light",
         "How the light is put together: reflectance times (D + N); or by mistake D plus "
         "reflectance, or reflectance times itself times (D + N).",
         "Illumination", "", light_choice<&LightRules::sum>()},
        {"light.renormalize", "Normals made unit length", "Light",
         "Whether a normal that was interpolated is made unit length again at the pixel. Only on "
         "surfaces whose corners have normals of their own.",
         "Light per pixel", "", light_choice<&LightRules::renormalize>()},
        {"light.highlight", "Highlight", "Light",
         "How the highlight is worked out: rightly, or by mistake on backs too, or with a half "
         "vector that is not made unit length. Only where light.model is blinn_phong.",
         "Illumination", "", light_choice<&LightRules::highlight>()},
        {"light.sides", "Lit sides", "Light",
         "How many sides of a surface are lit: the one to which its normal points, or both. With "
         "both, a normal that points away from the eye is turned toward it before the light is "
         "computed, so the back of a surface is lit as its front would be.",
         "Beyond the lab", "", light_choice<&LightRules::sides>()},
        {"shadows",
         "Shadows",
         "Shadow",
         "How it is found out whether something stands between a point and the lamp: not at all, "
         "by a ray from the point to the lamp, or by a map of the depths that the lamp sees.",
         "Beyond the lab",
         "",
         choice<&Settings::shadows>(),
         {},
         {},
         false,
         true},
        {"shadow_offset",
         "Ray begins above",
         "Shadow",
         "How far above its surface the ray to the lamp begins, along the normal. A point that "
         "floats have moved below the surface would else lie in the shadow of that surface.",
         "Beyond the lab",
         "world units",
         NumberSetting{[](Settings& s) -> float& { return s.shadow_rules.offset; }, 0.0f,
                       largest_place, 0.0005f},
         {},
         {},
         false,
         true,
         false,
         false,
         has_shadow_rays},
        {"shadow_ray",
         "Ray goes on",
         "Shadow",
         "How far the ray goes: as far as the lamp, or by mistake on and on, so that what stands "
         "behind the lamp casts a shadow too.",
         "Beyond the lab",
         "",
         choice<&Settings::shadow_ray>(),
         {},
         {},
         false,
         true,
         false,
         false,
         has_shadow_rays},
        {"shadow_resolution",
         "Size of the map",
         "Shadow",
         "Texels along each side of the six faces of the map.",
         "Beyond the lab",
         "texels",
         WholeSetting{[](Settings& s) -> int& { return s.shadow_resolution; },
                      smallest_shadow_resolution, largest_shadow_resolution},
         {},
         {},
         false,
         true,
         false,
         false,
         has_shadow_map},
        {"shadow_bias",
         "Bias",
         "Shadow",
         "How far behind the depth in the map a point may lie and still be lit. With none, "
         "surfaces "
         "shade themselves in stripes; with much, shadows come loose from what casts them.",
         "Beyond the lab",
         "world units",
         NumberSetting{[](Settings& s) -> float& { return s.shadow_rules.bias; }, 0.0f,
                       largest_place, 0.0005f},
         {},
         {},
         false,
         true,
         false,
         false,
         has_shadow_map},
        {"shadow_slope_bias",
         "Bias by slant",
         "Shadow",
         "Added to the bias: so many texels, times how steeply the surface runs away from the lamp "
         "(the tangent of the angle between the light and the normal).",
         "Beyond the lab",
         "texels",
         NumberSetting{[](Settings& s) -> float& { return s.shadow_rules.slope_bias; }, 0.0f,
                       largest_slope_bias, 0.01f},
         {},
         {},
         false,
         true,
         false,
         false,
         has_shadow_map},
        {"shadow_filter",
         "Texels asked",
         "Shadow",
         "How many texels of the map a point is held against: the one in which it lies, or the "
         "four around it, so that the border of a shadow has steps of a quarter (PCF).",
         "Beyond the lab",
         "",
         choice<&Settings::shadow_filter>(),
         {},
         {},
         false,
         true,
         false,
         false,
         has_shadow_map},
        {"viewport.size", "Picture size", "Picture", "Width and height of the picture.",
         "Drawing points", "pixels",
         SizeSetting{[](Settings& s) -> Viewport& { return s.viewport; }, largest_viewport}},
        {"bounds", "In the picture", "Picture",
         "Which places lie in the picture: those from 0 on, or by mistake only those above 0.",
         "Drawing points", "", choice<&Settings::bounds>()},
        {"encoding", "Bytes hold", "Picture",
         "How light becomes a byte: linearly, so that twice the light is twice the byte; or by the "
         "sRGB curve, which a screen undoes, so that it sends out the light that was computed; or, "
         "by mistake where linear numbers are asked for, to the power of 1/2.2. "
         "Textures are not decoded: their bytes are read as linear numbers either way.",
         "Beyond the lab", "", choice<&Settings::encoding>()},
        {"colour_over_one", "Channels above 1", "Picture",
         "What a channel above 1 is shown as: 1, or what is left of it in 8 bits.", "Illumination",
         "", choice<&Settings::colour_over_one>()},
        {"channel_order", "Order of channels", "Picture",
         "In which order red, green and blue go to the screen: red first, or by mistake blue "
         "first, so that red and blue change places.",
         "Drawing points", "", choice<&Settings::channel_order>()},
    };
}

} // namespace

std::span<const Setting> setting_table() {
    static const std::vector<Setting> table = make_table();
    return table;
}

bool is_of_use(const Setting& setting, const Scene& scene) {
    if (setting.needs_world && scene.space != SceneSpace::world) return false;
    if (setting.needs_alpha && !has_alpha(scene) && !has_texture_alpha(scene)) return false;
    if (setting.needs_texture_alpha && !has_texture_alpha(scene)) return false;
    if (setting.needs_normal_map && !has_normal_map(scene)) return false;
    return !setting.needs_texture || !scene.textures.empty();
}

bool is_of_use(const Setting& setting, const Scene& scene, const Settings& settings) {
    return is_of_use(setting, scene) && (setting.needs == nullptr || setting.needs(settings));
}

const Setting* find_setting(std::string_view name) {
    for (const Setting& setting : setting_table()) {
        if (setting.name == name) return &setting;
    }
    return nullptr;
}

} // namespace rasterwalk
