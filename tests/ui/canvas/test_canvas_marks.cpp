// The marks over the picture listen to the same stages as everything else.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "inspect/row_history.h"
#include "mistakes/interpolate.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/canvas/canvas_marks.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// Everything that is marked on a picture of this frame.
std::vector<ImDrawVert> marks_on(Driver& driver, const Frame& frame, const Cursor& cursor,
                                 const std::optional<Cursor>& done, PicturePlace place) {
    const RowHistory rows = row_history(frame, 0, cursor);
    const PolygonRows whole_rows = row_history(frame, 0).rows;
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRectFullScreen();
    draw_canvas_marks(driver.ui, {frame, rows, whole_rows, cursor, done, place}, &list,
                      {-9999, -9999}, {9999, 9999});
    return {list.VtxBuffer.begin(), list.VtxBuffer.end()};
}

/// Its corners.
std::vector<ImVec2> corners_of_marks(Driver& driver, const Frame& frame, const Cursor& cursor,
                                     const std::optional<Cursor>& done, PicturePlace place) {
    std::vector<ImVec2> corners;
    for (const ImDrawVert& corner : marks_on(driver, frame, cursor, done, place))
        corners.push_back(corner.pos);
    return corners;
}

/// How many corners are on the line from a to b between these shares of its length.
int corners_along(const std::vector<ImVec2>& corners, ImVec2 a, ImVec2 b, float from, float to) {
    const ImVec2 along{b.x - a.x, b.y - a.y};
    const float length = std::hypot(along.x, along.y);
    int count = 0;
    for (const ImVec2& corner : corners) {
        const ImVec2 d{corner.x - a.x, corner.y - a.y};
        const float share = (d.x * along.x + d.y * along.y) / (length * length);
        const float aside = std::abs(d.x * along.y - d.y * along.x) / length;
        count += share > from && share < to && aside < 2.5f ? 1 : 0;
    }
    return count;
}

/// How many corners are about this far from the place of a pixel, in screen pixels.
int corners_around(const std::vector<ImVec2>& corners, PicturePlace place, float x, float y,
                   float radius) {
    int count = 0;
    for (const ImVec2& corner : corners) {
        const float dx = corner.x - (place.origin.x + place.scale * (x + 0.5f));
        const float dy = corner.y - (place.origin.y + place.scale * (y + 0.5f));
        count += std::abs(std::hypot(dx, dy) - radius) < 1.0f ? 1 : 0;
    }
    return count;
}

/// Cuts off the right end: of a triangle with one corner there four corners are left.
Clipped cut_off_right(std::vector<ClipVertex>& corners, const ViewVolume&, ClipSink*) {
    float low = corners[0].position_clip.x, high = low;
    for (const ClipVertex& corner : corners) {
        low = std::min(low, corner.position_clip.x);
        high = std::max(high, corner.position_clip.x);
    }
    const float border = low + 0.7f * (high - low);
    std::vector<ClipVertex> left;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ClipVertex &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const float da = border - a.position_clip.x, db = border - b.position_clip.x;
        if (da >= 0.0f) left.push_back(a);
        if ((da >= 0.0f) == (db >= 0.0f)) continue;
        const float t = da / (da - db);
        left.push_back({a.position_clip + (b.position_clip - a.position_clip) * t,
                        a.varyings + (b.varyings - a.varyings) * t});
    }
    corners = left;
    return {Rejection::none, true};
}

} // namespace

TEST_CASE("With a different walk along the edges the marks are where its samples are") {
    Driver driver("one-triangle.toml");
    Settings settings = driver.ui.session.a.settings;
    settings.stage = Stage::fill;
    driver.ui.results.a.triangle = 0;
    const Scene& scene = *driver.ui.session.scene;
    const Frame usual = prepare_frame(scene, settings);
    const Frame other =
        prepare_frame(scene, settings, [](Stages& s) { s.line_step = line_step_of_integers; });
    PicturePlace place = driver.ui.canvas.place;
    place.scale = 40.0f;
    const std::vector<ImVec2> marks = corners_of_marks(driver, other, cursor_end, {}, place);
    const float dot = 0.09f * place.scale;
    int moved = 0;
    const std::vector<EdgeSample> there = edge_samples(other, 0), before = edge_samples(usual, 0);
    REQUIRE(there.size() == before.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        CAPTURE(there[i].edge, there[i].sample);
        CHECK(corners_around(marks, place, there[i].x, there[i].y, dot) >= 6);
        const bool is_moved = std::hypot(there[i].x - before[i].x, there[i].y - before[i].y) > 0.5f;
        moved += is_moved ? 1 : 0;
    }
    CHECK(moved > 0);
    // The sample that was entered last is framed.
    const EdgeSample& last = there[there.size() / 2];
    const Cursor done{0, Phase::edges, last.edge, last.sample};
    const Cursor cursor{0, Phase::edges, last.edge, last.sample + 1};
    const std::vector<ImVec2> framed = corners_of_marks(driver, other, cursor, done, place);
    const float corner = std::hypot(0.5f * place.scale, 0.5f * place.scale);
    CHECK(corners_around(framed, place, static_cast<float>(last.fragment.column),
                         static_cast<float>(last.fragment.row), corner) >= 4);
}

TEST_CASE("The marks of a clipped triangle are at the corners and samples of what is left") {
    Driver driver("one-triangle.toml");
    Settings settings = driver.ui.session.a.settings;
    settings.stage = Stage::fill;
    driver.ui.results.a.triangle = 0;
    const Frame frame = prepare_frame(*driver.ui.session.scene, settings,
                                      [](Stages& s) { s.clip = cut_off_right; });
    PicturePlace place = driver.ui.canvas.place;
    place.scale = 40.0f;
    const std::vector<ImVec2> marks = corners_of_marks(driver, frame, cursor_end, {}, place);
    const PolygonCorners corners = frame.triangle_vertices(0);
    REQUIRE(corners.size() == 4);
    for (const ScreenVertex& corner : corners) {
        CAPTURE(corner.column, corner.row);
        CHECK(corners_around(marks, place, static_cast<float>(corner.column),
                             static_cast<float>(corner.row),
                             5.5f * driver.ui.options.text_scale) >= 6);
    }
    std::array<int, 4> samples{};
    for (const EdgeSample& sample : edge_samples(frame, 0)) {
        ++samples[static_cast<std::size_t>(sample.edge)];
        CAPTURE(sample.edge, sample.sample);
        CHECK(corners_around(marks, place, sample.x, sample.y, 0.09f * place.scale) >= 6);
    }
    for (const int count : samples)
        CHECK(count > 0);
}

TEST_CASE("At a low zoom the outline is whole where it is walked, and dashed where it is not") {
    Driver driver("one-triangle.toml");
    Settings settings = driver.ui.session.a.settings;
    settings.stage = Stage::edges;
    driver.ui.results.a.triangle = 0;
    const Frame frame = prepare_frame(*driver.ui.session.scene, settings);
    PicturePlace place = driver.ui.canvas.place;
    place.scale = 7.5f;
    const Cursor cursor{0, Phase::edges, 1, 6}; // edge 1 has 11 samples
    const std::vector<ImVec2> corners = corners_of_marks(driver, frame, cursor, {}, place);
    const PolygonCorners v = frame.triangle_vertices(0);
    const auto at = [&](int i) {
        return ImVec2(place.origin.x + place.scale * (static_cast<float>(v[i].column) + 0.5f),
                      place.origin.y + place.scale * (static_cast<float>(v[i].row) + 0.5f));
    };
    // A whole line has corners at its ends alone, each dash has its own.
    CHECK(corners_along(corners, at(0), at(1), 0.1f, 0.9f) == 0);
    CHECK(corners_along(corners, at(1), at(2), 0.1f, 0.4f) == 0);
    CHECK(corners_along(corners, at(1), at(2), 0.6f, 0.95f) > 4);
    CHECK(corners_along(corners, at(2), at(0), 0.1f, 0.9f) > 8);
}

TEST_CASE("The numbers of the vertices are on dark ground, however bright the pixels are") {
    Driver driver("one-triangle.toml");
    Settings settings = driver.ui.session.a.settings;
    settings.stage = Stage::edges;
    driver.ui.results.a.triangle = 0;
    const Frame frame = prepare_frame(*driver.ui.session.scene, settings);
    PicturePlace place = driver.ui.canvas.place;
    place.scale = 40.0f;
    const std::vector<ImDrawVert> marks = marks_on(driver, frame, cursor_end, {}, place);
    const ImU32 bright = packed(colour_of(Meaning::current, Theme::dark));
    const ImVec2 white = ImGui::GetIO().Fonts->TexUvWhitePixel;
    const auto is_letter = [&](const ImDrawVert& m) {
        const bool is_filled = std::abs(m.uv.x - white.x) + std::abs(m.uv.y - white.y) < 0.01f;
        return m.col == bright && !is_filled;
    };
    int letters = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (!is_letter(marks[i])) continue;
        ++letters;
        // What is drawn just before has corners around it, and is dark and hardly transparent.
        ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
        for (std::size_t j = i >= 80 ? i - 80 : 0; j < i; ++j) {
            const ImColor colour(marks[j].col);
            const bool is_dark = colour.Value.x + colour.Value.y + colour.Value.z < 0.3f;
            if (!is_dark || colour.Value.w < 0.75f || is_letter(marks[j])) continue;
            low = {std::min(low.x, marks[j].pos.x), std::min(low.y, marks[j].pos.y)};
            high = {std::max(high.x, marks[j].pos.x), std::max(high.y, marks[j].pos.y)};
        }
        const ImVec2 at = marks[i].pos;
        CHECK(low.x + 1.0f <= at.x);
        CHECK(at.x <= high.x - 1.0f);
        CHECK(low.y <= at.y);
        CHECK(at.y <= high.y);
    }
    CHECK(letters == 3 * 11 * 4); // "vertices[0]", four corners a letter
}

TEST_CASE("Where the picture is larger than the canvas its numbers have a strip of their own") {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        Driver driver("one-triangle.toml");
        driver.ui.options.theme = theme;
        const Frame frame = prepare_frame(*driver.ui.session.scene, driver.ui.session.a.settings);
        const RowHistory rows;
        driver.ui.results.a.triangle = std::nullopt;
        PicturePlace place;
        place.origin = {-200.0f, -200.0f};
        place.scale = 40.0f;
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        list.PushTextureID(ImGui::GetIO().Fonts->TexID);
        list.PushClipRectFullScreen();
        const Cursor cursor = cursor_end;
        const std::optional<Cursor> done;
        draw_canvas_marks(driver.ui, {frame, rows, rows.rows, cursor, done, place}, &list, {0, 0},
                          {400, 400});
        const ImVec2 white = ImGui::GetIO().Fonts->TexUvWhitePixel;
        const ImU32 ground = packed(palette(theme).canvas);
        float strip_bottom = 0.0f, strip_right = 0.0f;
        int letters = 0;
        for (const ImDrawVert& corner : list.VtxBuffer) {
            const bool is_filled =
                std::abs(corner.uv.x - white.x) + std::abs(corner.uv.y - white.y) < 0.01f;
            if (corner.col == ground && is_filled) {
                if (corner.pos.x > 399.0f && corner.pos.y < 399.0f)
                    strip_bottom = std::max(strip_bottom, corner.pos.y);
                if (corner.pos.y > 399.0f && corner.pos.x < 399.0f)
                    strip_right = std::max(strip_right, corner.pos.x);
            }
            // On the bare canvas they would be dim.
            const ImU32 bright = packed(palette(theme).text), dim = packed(palette(theme).dim);
            if (is_filled || (corner.col != bright && corner.col != dim)) continue;
            ++letters;
            CHECK(corner.col == bright);
            CHECK((corner.pos.y <= strip_bottom || corner.pos.x <= strip_right));
        }
        CHECK(letters >= 4 * 2 * 8);
    }
}

} // namespace rasterwalk
