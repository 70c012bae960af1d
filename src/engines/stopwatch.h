#pragma once

namespace rasterwalk {

/// How long something took, or the time since some moment, in milliseconds. In a browser all three
/// are elapsed time.
struct Milliseconds {
    double processor = 0.0; ///< of all threads of this process together
    double wall = 0.0;
    double thread = 0.0; ///< processor time of the calling thread

    friend bool operator==(const Milliseconds&, const Milliseconds&) = default;
};

/// Since some moment: only differences mean something.
Milliseconds milliseconds_now();

Milliseconds milliseconds_since(const Milliseconds& begin);

} // namespace rasterwalk
