#pragma once

#include <iosfwd>
#include <string>

namespace rasterwalk {

/// The last line of a terminal, which says how far a long command is and is empty in the end.
class ProgressLine {
  public:
    /// @param terminal null: nothing is said
    explicit ProgressLine(std::ostream* terminal) : terminal_(terminal) {}
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Says this in place of what was said before.
    void say(const std::string& words);

    /// Before something else is written.
    void clear();

  private:
    std::ostream* terminal_;
    std::string said_;
};

} // namespace rasterwalk
