#pragma once

// What the texts of the lessons say.

#include <string>

#include "base/files.h"
#include "session/content.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

/// The file of the lessons says this, so that a text that changes takes its test along.
inline void require_said(const std::string& file, const std::string& words) {
    INFO(file << " does not say: " << words);
    CHECK(read_file(lessons_folder() + "/" + file).find(words) != std::string::npos);
}

} // namespace rasterwalk::test
