#pragma once

#include <functional>
#include <string>

#include "ui/actions/kept_state.h"

namespace rasterwalk {

struct Ui;

/// Takes up a file's content, by `read`. An empty path, or a file that cannot be read: nothing is
/// kept there, the file is left unchanged, and session.notice says so.
/// @param what begins the sentence: "Progress"
void take_up_kept(Ui& ui, KeptFile& file, const std::string& path, const char* what,
                  const std::function<void()>& read);

/// Writes a file by `write`. If that is impossible for now, as on a full disk, session.notice says
/// so once, and it is tried again some seconds later. A file that something else has broken in the
/// meantime is left alone from then on.
void write_kept(Ui& ui, KeptFile& file, const char* what, const std::function<void()>& write);

} // namespace rasterwalk
