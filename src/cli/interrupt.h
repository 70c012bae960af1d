#pragma once

namespace rasterwalk {

/// While it lives, Ctrl+C does not end the program but is noted, for a long command to stop and
/// print what it has. One at a time.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    /// Was Ctrl+C pressed?
    bool is_noted() const;

  private:
    void (*before_)(int); ///< what stood there; what ignores Ctrl+C, as nohup does, stays
};

} // namespace rasterwalk
