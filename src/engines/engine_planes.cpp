#include "engines/engine_planes.h"

#include <cstddef>
#include <utility>

#include "base/error.h"
#include "engines/fast/fast_view.h"
#include "engines/opengl_engine.h"
#include "pipeline/clearing.h"
#include "pipeline/draw.h"

namespace rasterwalk {

namespace {

/// Draws what the engine can only draw at once; what is left is to put it into the planes.
void draw_whole(const std::shared_ptr<const Scene>& scene, const Frame& frame,
                EnginePlanes& drawn) {
    switch (frame.settings.engine) {
    case Engine::steps:
        break;
    case Engine::fast:
        drawn.fast.draw(scene, frame.settings);
        break;
    case Engine::rays:
        drawn.rays.begin(frame);
        break;
    case Engine::opengl:
        opengl_engine()->draw(*scene, frame.settings, drawn.opengl);
        break;
    }
}

/// @return true if the planes have the whole picture
bool fill_planes(const Frame& frame, const WorkLimit& limit, EnginePlanes& drawn) {
    if (frame.settings.engine == Engine::rays)
        return clear_rows(drawn.planes, limit) && drawn.rays.advance(limit, drawn.planes);
    const bool is_fast = frame.settings.engine == Engine::fast;
    return copy_rows(is_fast ? drawn.fast.picture() : drawn.opengl, limit, drawn.planes);
}

} // namespace

std::string engine_refuses(const Scene& scene, const Settings& settings) {
    switch (settings.engine) {
    case Engine::steps:
        break;
    case Engine::fast:
        return fast_engine_refuses(scene, settings);
    case Engine::rays:
        return rays_refuse(scene, settings);
    case Engine::opengl:
        return opengl_refuses(scene, settings);
    }
    return {};
}

Engine drawing_engine(const Scene& scene, const Settings& settings, const Cursor& to) {
    const bool is_its = to == cursor_end && engine_refuses(scene, settings).empty();
    return is_its ? settings.engine : Engine::steps;
}

bool is_left_out_by(Engine engine, Rejection reason) {
    const bool cuts = engine == Engine::fast || engine == Engine::opengl;
    return !cuts || (reason != Rejection::behind_camera && reason != Rejection::too_far_out);
}

void EnginePlanes::begin() {
    is_begun = is_whole = false;
    fault.clear();
    rays.end();
}

bool EnginePlanes::have_all_rows(const Frame& frame) const {
    const Viewport size = frame.settings.viewport;
    return is_begun && planes.owner.size() == static_cast<std::size_t>(size.width) *
                                                  static_cast<std::size_t>(size.height);
}

void advance_engine_planes(const std::shared_ptr<const Scene>& scene, const Frame& frame,
                           const WorkLimit& limit, EnginePlanes& drawn) {
    if (drawn.is_whole || !drawn.fault.empty()) return;
    try {
        if (!drawn.is_begun) {
            begin_clearing(drawn.planes, frame);
            draw_whole(scene, frame, drawn);
            drawn.is_begun = true;
        }
        drawn.is_whole = fill_planes(frame, limit, drawn);
    } catch (const AccessError& error) {
        // Sentences end in a full stop, and this one goes on.
        drawn.fault = error.what();
        if (drawn.fault.ends_with('.')) drawn.fault.pop_back();
    }
}

void draw_by_engine(const Frame& frame, const Cursor& to, Framebuffer& planes) {
    if (drawing_engine(*frame.scene, frame.settings, to) == Engine::steps) {
        clear(planes, frame);
        draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, planes);
        return;
    }
    EnginePlanes drawn;
    // The frame outlives the drawing, and its scene with it.
    advance_engine_planes({std::shared_ptr<void>(), frame.scene}, frame, {}, drawn);
    if (!drawn.fault.empty()) throw AccessError(drawn.fault + '.');
    planes = std::move(drawn.planes);
}

} // namespace rasterwalk
