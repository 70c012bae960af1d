#include "base/file_state.h"

#include <system_error>

namespace rasterwalk {

FileState file_state(const std::string& path) {
    FileState state;
    std::error_code fault;
    const auto written = std::filesystem::last_write_time(path, fault);
    if (!fault) state.written = written;
    const std::uintmax_t size = std::filesystem::file_size(path, fault);
    if (!fault) state.size = size;
    return state;
}

} // namespace rasterwalk
