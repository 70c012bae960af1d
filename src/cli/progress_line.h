#pragma once

#include <iosfwd>
#include <string>

namespace rasterwalk {

/// The last line of a terminal, which shows the progress of a long command and is empty at the end.
class ProgressLine {
  public:
    /// @param terminal null: nothing is shown
    explicit ProgressLine(std::ostream* terminal) : terminal_(terminal) {}
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Shows these words in place of the previous ones.
    void say(const std::string& words);

    /// To be called before anything else is written.
    void clear();

  private:
    std::ostream* terminal_;
    std::string said_;
};

} // namespace rasterwalk
