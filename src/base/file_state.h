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

/// The current state of a file; FileState{} if there is none or its state cannot be read. Never
/// throws.
FileState file_state(const std::string& path);

} // namespace rasterwalk
