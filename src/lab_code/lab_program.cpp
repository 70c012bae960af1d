#include "lab_code/lab_program.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/files.h"
#include "lab_code/code_words.h"

namespace rasterwalk {

const std::vector<std::string>& lab_file_names() {
    static const std::vector<std::string> names{"types.cpp",
                                                "put_pixel.cpp",
                                                "shadow.cpp",
                                                "light.cpp",
                                                "clip_space.cpp",
                                                "vertex_shader.cpp",
                                                "clip.cpp",
                                                "cull.cpp",
                                                "texture.cpp",
                                                "texture_level.cpp",
                                                "normal_map.cpp",
                                                "pixel_shader.cpp",
                                                "interpolate.cpp",
                                                "lines.cpp",
                                                "edges.cpp",
                                                "rows.cpp",
                                                "fan.cpp",
                                                "edge_functions.cpp",
                                                "scan_conversion.cpp",
                                                "active_edges.cpp",
                                                "row_ends.cpp",
                                                "fill.cpp",
                                                "samples.cpp",
                                                "warnock.cpp",
                                                "draw.cpp"};
    return names;
}

LabCode read_lab_code(const std::string& folder) {
    LabCode code;
    const auto note_word = [&](std::string_view word) {
        code.words.emplace(word);
        return false;
    };
    for (const std::string& name : lab_file_names()) {
        const std::string path = folder + "/" + name;
        code.files.push_back({name, read_file(path)});
        std::vector<ChosenLine> ignored;
        choose_lines(code.files.back().text, path, 0, note_word, ignored);
    }
    return code;
}

std::vector<ChosenLine> lines_for(const LabCode& code, const Frame& frame) {
    std::map<std::string, bool, std::less<>> known; // most words are asked for several times
    bool has_mistake = false;
    const auto holds = [&](std::string_view word) {
        const auto found = known.find(word);
        if (found != known.end()) return found->second;
        const bool answer = code_word_holds(word, frame);
        has_mistake = has_mistake || (answer && is_mistake_word(word));
        return known.emplace(std::string(word), answer).first->second;
    };
    const auto holds_rightly = [&](std::string_view word) {
        return holds(word) && !is_mistake_word(word);
    };
    std::vector<ChosenLine> lines;
    for (std::size_t i = 0; i < code.files.size(); ++i) {
        const LabFile& file = code.files[i];
        const auto number = static_cast<int>(i);
        std::vector<ChosenLine> own, right;
        choose_lines(file.text, file.name, number, holds, own);
        if (has_mistake) {
            choose_lines(file.text, file.name, number, holds_rightly, right);
            mark_mistakes(own, right);
        }
        // A line between files, which shows where one ends.
        if (!own.empty() && !lines.empty()) lines.push_back({{}, number, 0});
        lines.insert(lines.end(), own.begin(), own.end());
    }
    return lines;
}

FileLines file_around(const std::vector<ChosenLine>& lines, int line) {
    const auto size = static_cast<int>(lines.size());
    const auto at = [&](int number) -> const ChosenLine& {
        return lines[static_cast<std::size_t>(number - 1)];
    };
    line = std::clamp(line, 1, size);
    FileLines found{at(line).file, line, line};
    // The empty line between two files belongs to neither.
    while (found.first > 1 && at(found.first - 1).file == found.file &&
           at(found.first - 1).line > 0)
        --found.first;
    while (found.last < size && at(found.last + 1).file == found.file)
        ++found.last;
    return found;
}

std::string source_text(const std::vector<ChosenLine>& lines, Viewport picture) {
    std::string text;
    for (const ChosenLine& line : lines) {
        if (line.text.starts_with("const int SCREEN_WIDTH"))
            text += fmt::format("const int SCREEN_WIDTH = {};", picture.width);
        else if (line.text.starts_with("const int SCREEN_HEIGHT"))
            text += fmt::format("const int SCREEN_HEIGHT = {};", picture.height);
        else
            text += line.text;
        text += '\n';
    }
    return text;
}

} // namespace rasterwalk
