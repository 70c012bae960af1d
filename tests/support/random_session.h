#pragma once

#include "session/session.h"
#include "tests/support/random.h"

namespace rasterwalk::test {

/// A session such as a student might have: some scene or step of a lesson, with anything set,
/// selected, compared, moved. Its cursor is a moment that exists.
Session random_session(Random& random);

/// Checks that two sessions show the same.
void check_same_view(const Session& is, const Session& expected);

} // namespace rasterwalk::test
