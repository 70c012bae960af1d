#pragma once

#include <functional>
#include <string>

#include "ui/actions/kept_state.h"

namespace rasterwalk {

struct Ui;

/// Takes up what stands in a file, by `read`. An empty path, or a file that cannot be read: nothing
/// is kept there, it stays as it is, and session.notice says so.
/// @param what begins the sentence: "Progress"
void take_up_kept(Ui& ui, KeptFile& file, const std::string& path, const char* what,
                  const std::function<void()>& read);

/// Writes a file by `write`. Where that does not go now, as on a full disk, session.notice says so
/// once, and it is tried again some seconds later. A file that someone else has broken meanwhile is
/// left alone from then on.
void write_kept(Ui& ui, KeptFile& file, const char* what, const std::function<void()>& write);

} // namespace rasterwalk
