#pragma once

// What the texts of the lessons say.

#include <string>

#include "base/files.h"
#include "session/content.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

/// Checks that the lessons' file says this, so a test fails when its text changes.
inline void require_text(const std::string& file, const std::string& words) {
    INFO(file << " does not say: " << words);
    CHECK(read_file(lessons_folder() + "/" + file).find(words) != std::string::npos);
}

} // namespace rasterwalk::test
