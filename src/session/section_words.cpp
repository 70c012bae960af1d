#include "session/section_words.h"

namespace rasterwalk {

std::string section_words(std::string_view section) {
    const bool is_beyond = section.starts_with("Beyond the lab");
    return std::string(is_beyond ? "" : "lab: ").append(section);
}

} // namespace rasterwalk
