#pragma once

#include <functional>

namespace rasterwalk {

struct Ui;

/// Runs a part of a frame, or something between two frames. An exception ends neither the frame nor
/// the program: it becomes a sentence in session.notice, and ImGui's windows, fonts and colours
/// that the part left open are closed. To be called with no window open. Returns true if all went
/// well.
bool guarded(Ui& ui, const std::function<void()>& part);

} // namespace rasterwalk
