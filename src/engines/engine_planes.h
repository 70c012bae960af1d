#pragma once

// The engine that draws a moment, and its picture as the planes that all panels read.

#include <memory>
#include <string>

#include "engines/engine_picture.h"
#include "engines/rays/ray_drawing.h"
#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"
#include "scene/scene.h"

namespace rasterwalk {

/// Why the engine of the settings cannot draw this, a sentence without its full stop; empty if it
/// can. The steps draw everything.
std::string engine_refuses(const Scene& scene, const Settings& settings);

/// The engine that draws everything before this moment: that of the settings, but the steps if that
/// refuses, or if it is not the whole picture.
Engine drawing_engine(const Scene& scene, const Settings& settings, const Cursor& to);

/// Does an engine leave out what the steps leave out for this reason? Some cut it off instead, and
/// draw the rest.
bool is_left_out_by(Engine engine, Rejection reason);

/// A picture drawn by an engine that has no moments.
struct EnginePlanes {
    FastRun fast;
    RayDrawing rays;
    FastPicture opengl;
    Framebuffer planes;
    bool is_begun = false; ///< for the frame
    bool is_whole = false; ///< all of the frame's picture is in the planes, not just some
    /// Why the engine failed with this frame, without a full stop; empty: it did not.
    std::string fault;

    /// For a new frame: nothing is drawn yet.
    void begin();
    /// Can the planes be shown, whole or not?
    bool have_all_rows(const Frame& frame) const;
};

/// Draws a frame by the engine of its settings, as far as the limit allows; does nothing if its
/// picture is whole. OpenGL's failure is its `fault`.
/// @param scene the frame's, or its tessellation
void advance_engine_planes(const std::shared_ptr<const Scene>& scene, const Frame& frame,
                           const WorkLimit& limit, EnginePlanes& drawn);

/// Draws everything before a moment, by the engine of the settings. Throws AccessError if OpenGL
/// fails.
void draw_by_engine(const Frame& frame, const Cursor& to, Framebuffer& planes);

} // namespace rasterwalk
