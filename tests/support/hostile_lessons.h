#pragma once

#include <string>
#include <vector>

namespace rasterwalk::test {

/// A lesson made to cause harm, and the fault that refuses it.
struct HostileLesson {
    std::string about;
    std::string text;
    int line = 0; ///< of the fault
    std::string sentence;
    bool is_readable = false; ///< the rest of it is shown
};

/// The head of a lesson without faults, nine lines.
std::string lesson_head();

std::vector<HostileLesson> hostile_lessons();

/// Lessons without nesting that would keep a slow reader busy; each is about 900 kB.
std::vector<HostileLesson> tiring_lessons();

/// The beginning of a PNG that says it has 100000 x 100000 pixels, and none of them.
std::string endless_picture();

} // namespace rasterwalk::test
