#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rasterwalk {

/// When a file was last written, and its size in bytes: together they show whether it changed.
struct FileState {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;

    friend bool operator==(const FileState&, const FileState&) = default;
};

/// The state of a file as it is now; that of no file, FileState{}, if there is none or it cannot be
/// asked. Never throws.
FileState file_state(const std::string& path);

} // namespace rasterwalk
