#pragma once

#include "view/situation.h"

namespace rasterwalk {

/// What the session shows, as the situation that brings a fresh session on the same scene there.
/// The scene itself is left out, because it is a path; so is a selection that lies outside the
/// picture. The cursor is the moment at or after the session's that exists.
/// @param original the scene as it stands in its file: vertices that lie elsewhere are told
Situation situation_of(const Session& session, const Scene& original);

/// The session's scene as it stands in its file; the session's own where nothing in it can be
/// moved. Throws Error: UsageError for a scene that was not read from a file.
Scene scene_in_file(const Session& session);

} // namespace rasterwalk
