#pragma once

// The peer: llvmpipe, Mesa's rasterizer on the processor, in a separate program,
// `rasterwalk-llvmpipe`. The two exchange lines:
//
//   its arguments                 WORKLOAD WIDTHxHEIGHT THREADS
//   it says when it is ready      "ready NAME"
//   asked "round FIRST COUNT"     draws pictures, says "PROCESSOR WALL": milliseconds
//
//   asked "picture NUMBER"        "bytes COUNT", then blue, green, red, nothing per pixel
//
//   at the end of its input       ends
//
// A failure is a sentence on its standard error, and an exit code of ExitCode.

#include <memory>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "engines/timed_engine.h"
#include "engines/workload.h"

namespace rasterwalk {

/// What the peer should draw, and on how many threads.
struct PeerTask {
    Workload workload = Workload::w1;
    Viewport size;
    int threads = 1;
};

/// The words of a task as the peer's program takes them, and back. Throws UsageError.
std::vector<std::string> peer_arguments(const PeerTask& task);
PeerTask parse_peer_arguments(const std::vector<std::string>& words);

/// An engine, and what it calls itself: "llvmpipe (LLVM 15.0.6, 256 bits)".
struct Peer {
    std::string name;
    std::unique_ptr<TimedEngine> engine;
};

/// Starts the peer's program and waits until it is ready. This and reading its answers throw
/// AccessError and WaitingStopped.
Peer start_llvmpipe(const std::string& program, const PeerTask& task,
                    const ChildProcess::Patience& patience);

/// The path of `rasterwalk-llvmpipe`: $RASTERWALK_LLVMPIPE, or else next to this program, or
/// in libexec/ if they are installed.
std::string llvmpipe_program();

} // namespace rasterwalk
