#include "lessons/lesson_comment.h"

#include <algorithm>
#include <string>

#include "base/text_parts.h"
#include "base/toml_input.h"

namespace rasterwalk {

LessonComment read_comment(const std::vector<std::string_view>& lines, std::size_t& next,
                           FaultList& faults) {
    LessonComment comment;
    comment.line = static_cast<int>(next) + 1;
    // The TOML keeps its place in the file, so that faults find their lines.
    std::string toml(next, '\n');
    std::string_view line = lines[next].substr(4);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::size_t end = line.find("-->");
    comment.kind = line.substr(0, std::min(line.find_first_of(" \t"), end));
    comment.kind = comment.kind.substr(0, comment.kind.find("-->"));
    line.remove_prefix(comment.kind.size());
    while (true) {
        const std::size_t close = line.find("-->");
        toml.append(line.substr(0, close)).append("\n");
        ++next;
        if (close != line.npos) {
            if (!trimmed(line.substr(close + 3)).empty()) {
                faults.add(static_cast<int>(next), "nothing may follow '-->' on its line.");
            }
            break;
        }
        if (next == lines.size()) {
            faults.add(comment.line, "the comment does not end because '-->' is missing.");
            return comment;
        }
        line = lines[next];
    }
    if (comment.kind == "note") return comment;
    faults.attempt(comment.line, [&] {
        comment.table = parse_toml(toml, faults.path());
        comment.is_good = true;
    });
    return comment;
}

} // namespace rasterwalk
