#include "cli/progress_line.h"

#include <ostream>

#include "base/quoted.h"

namespace rasterwalk {

void ProgressLine::say(const std::string& words) {
    if (terminal_ == nullptr || words == said_) return;
    said_ = words;
    // To the beginning of the line; the rest of the old words is erased.
    *terminal_ << '\r' << visible_line(words) << "\x1b[K" << std::flush;
}

void ProgressLine::clear() {
    if (said_.empty()) return;
    say("");
}

} // namespace rasterwalk
