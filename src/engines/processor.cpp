#include "engines/processor.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include "base/text_parts.h"

namespace rasterwalk {

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(':');
        if (colon != std::string::npos && line.starts_with("model name"))
            return std::string(trimmed(std::string_view(line).substr(colon + 1)));
    }
    return {};
}

int processor_count() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

} // namespace rasterwalk
