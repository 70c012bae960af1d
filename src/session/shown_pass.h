#pragma once

// Which pass of a run a session shows: the picture, or a face of the shadow map before it.

#include "pipeline/frame.h"
#include "session/session.h"

namespace rasterwalk {

/// The pass in which the session's cursor is: 0, the picture, unless the run has passes before it.
int shown_pass(const Session& session, const Run& run);

/// The run with the settings of that pass.
Run shown_run(const Session& session, const Run& run);

/// The size of the picture that the session shows of run A: of a face, in its pass.
Viewport shown_size(const Session& session);

/// If run A no longer has the pass that the cursor is in, goes to the end of the picture.
void leave_missing_pass(Session& session);

/// The frame of run A that the session shows, prepared now. Its own moment is in_frame() of the
/// session's cursor.
Frame shown_frame(const Session& session);

} // namespace rasterwalk
