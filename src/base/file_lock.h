#pragma once

#include <string>

namespace rasterwalk {

/// Keeps other processes, and other locks of this one, away from a file while it is read and
/// rewritten. The lock is held on a file next to it, NAME.lock, which stays there.
class FileLock {
  public:
    /// Waits for at most about half a second. If the file system has no locks, or nothing can be
    /// written, there is no lock. Throws AccessError if another lock holds it for longer.
    explicit FileLock(const std::string& path);
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

  private:
    int descriptor_;
};

} // namespace rasterwalk
