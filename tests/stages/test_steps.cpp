// Each step of the pipeline takes the output of the previous step, and nothing else.

#include <type_traits>

#include "stages/stage_table.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

template <class Function, class... Arguments>
constexpr bool takes = std::is_invocable_v<Function, Arguments...>;

using Line = std::span<LineSample>;

// Vertex shader, then clip and cull, then project.
static_assert(takes<decltype(project), ClipVertex, VertexRules, Stages, VertexSpaces*>);
static_assert(!takes<decltype(project), Vertex, VertexRules, Stages, VertexSpaces*>);
static_assert(!takes<decltype(project), ScreenVertex, VertexRules, Stages, VertexSpaces*>);
static_assert(
    takes<decltype(cull_nothing), std::span<const ClipVertex>, VertexRules, SightRays, CullTest*>);
static_assert(!takes<decltype(cull_nothing), PolygonCorners, VertexRules, SightRays, CullTest*>);

// Coverage begins with vertices on the screen; a sample of an edge becomes the end of a row.
static_assert(takes<decltype(edge_sample_count), ScreenVertex, ScreenVertex>);
static_assert(!takes<decltype(edge_sample_count), ClipVertex, ClipVertex>);
static_assert(!takes<decltype(edge_sample_count), Fragment, Fragment>);
static_assert(!takes<decltype(edge_sample_count), RowEnd, RowEnd>);
static_assert(takes<decltype(add_edge_sample), Fragment, VaryingSet, Stages, PolygonRows&>);
static_assert(!takes<decltype(add_edge_sample), ScreenVertex, VaryingSet, Stages, PolygonRows&>);
static_assert(takes<decltype(span_end), RowEnd>);
static_assert(!takes<decltype(span_end), Fragment>);
static_assert(!takes<decltype(span_end), ScreenVertex>);

// A line goes between ends that were made from vertices or row ends.
static_assert(takes<decltype(interpolate), LineEnd, LineEnd, LineStep, LinePart, Line>);
static_assert(!takes<decltype(interpolate), ScreenVertex, ScreenVertex, LineStep, LinePart, Line>);
static_assert(!takes<decltype(interpolate), RowEnd, RowEnd, LineStep, LinePart, Line>);

// Only fragments are tested and shaded.
static_assert(takes<decltype(depth_test), Fragment, float, DepthRules>);
static_assert(!takes<decltype(depth_test), ScreenVertex, float, DepthRules>);
static_assert(!takes<decltype(depth_test), RowEnd, float, DepthRules>);
static_assert(takes<decltype(pixel_shader), Fragment, Surface, PixelRules, Stages>);
static_assert(!takes<decltype(pixel_shader), ScreenVertex, Surface, PixelRules, Stages>);
static_assert(!takes<decltype(pixel_shader), RowEnd, Surface, PixelRules, Stages>);

} // namespace

TEST_CASE("A vertex on the screen keeps its place inside the pixel that it is snapped to") {
    VertexRules rules;
    rules.camera = {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 100.0f};
    rules.viewport = {30, 20};
    Vertex vertex;
    vertex.position = {0.0325f, -0.0175f, 1.0f};
    const ShadedVertex shaded = shade_vertex(vertex, camera_rotation(rules.camera), rules, {});
    CHECK(shaded.pixel.position.x == Approx(15.0 + 3.25));
    CHECK(shaded.pixel.position.y == Approx(10.0 - 1.75));
    CHECK(shaded.pixel.column == 18);
    CHECK(shaded.pixel.row == 9); // the lab's int() cuts toward the middle

    // In a scene given in pixels, a place is the centre of its pixel.
    rules.space = SceneSpace::pixels;
    vertex.position = {4.75f, 2.5f, 1.0f};
    const ShadedVertex given = shade_vertex(vertex, camera_rotation(rules.camera), rules, {});
    CHECK(given.pixel.position == glm::vec2(5.25f, 3.0f));
    CHECK(given.pixel.column == 4);
    CHECK(given.pixel.row == 2);
}

TEST_CASE("A line can begin and end inside pixels") {
    LineEnd a, b;
    a.x = 0.25f;
    b.x = 4.25f;
    a.y = b.y = 1.5f;
    std::vector<LineSample> samples(5);
    const LinePart part{5, 0, Rounding::floor, {}};
    interpolate(a, b, line_step(a, b, part), part, samples);
    for (int i = 0; i < 5; ++i) {
        const LineSample& sample = samples[static_cast<std::size_t>(i)];
        CHECK(sample.x == 0.25f + static_cast<float>(i));
        CHECK(sample.y == 1.5f);
        CHECK(sample.fragment.column == i);
        CHECK(sample.fragment.row == 1);
    }
}
