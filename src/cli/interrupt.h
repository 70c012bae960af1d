#pragma once

namespace rasterwalk {

/// While it lives, Ctrl+C does not end the program but is noted, so that a long command can stop
/// and print what it has. Only one at a time.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    /// Was Ctrl+C pressed?
    bool was_interrupted() const;

  private:
    void (*before_)(int); ///< the old handler; one that ignores Ctrl+C, like nohup's, stays
};

} // namespace rasterwalk
