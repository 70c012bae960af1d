#include "scene/model_source.h"

#include "scene/obj_words.h"

namespace rasterwalk {

std::string_view text_from_line(const ModelSource& source, int line) {
    const auto mark = static_cast<std::size_t>((line - 1) / lines_per_mark);
    if (line < 1 || mark >= source.line_marks.size()) return {};
    std::string_view rest = source.text;
    rest.remove_prefix(source.line_marks[mark]);
    for (int skipped = (line - 1) % lines_per_mark; skipped > 0 && !rest.empty(); --skipped)
        take_line(rest);
    return rest;
}

} // namespace rasterwalk
