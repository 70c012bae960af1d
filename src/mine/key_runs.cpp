#include "mine/key_runs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "mine/compile/source_text.h"
#include "mine/compile/two_at_a_time.h"

namespace rasterwalk {

namespace {

/// What SDL adds to a scancode to make the code of a key that has no character.
constexpr int scancode_bit = 1 << 30;

/// The keys with names longer than a letter, as SDL 2 numbers them.
constexpr std::array<std::pair<std::string_view, int>, 14> named_keys{{
    {"UP", scancode_bit | 82},
    {"DOWN", scancode_bit | 81},
    {"LEFT", scancode_bit | 80},
    {"RIGHT", scancode_bit | 79},
    {"PAGEUP", scancode_bit | 75},
    {"PAGEDOWN", scancode_bit | 78},
    {"HOME", scancode_bit | 74},
    {"END", scancode_bit | 77},
    {"SPACE", ' '},
    {"RETURN", '\r'},
    {"TAB", '\t'},
    {"PLUS", '+'},
    {"MINUS", '-'},
    {"RSHIFT", scancode_bit | 229},
}};

/// The code of a key by its name in SDL; 0: not known. Escape is left out, because it ends
/// programs.
int key_code(std::string_view name) {
    if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])) != 0)
        return std::tolower(static_cast<unsigned char>(name[0]));
    for (const auto& [word, code] : named_keys)
        if (word == name) return code;
    return 0;
}

std::vector<KeyFault> hold_key(const StudentFiles& files, const std::string& sanitized_program,
                               const KeyRuns& runs, const ProgramKey& key,
                               const std::function<bool()>& is_stopped) {
    ProgramOrder order;
    order.task.frames = key.code == 0 ? 1 : runs.frames;
    order.task.key = key.code;
    order.time = runs.time;
    order.is_sanitized = true;
    order.is_stopped = is_stopped;
    const ProgramRun run = run_program(files, sanitized_program, order);
    std::vector<KeyFault> faults;
    for (const ProgramFault& fault : run.faults)
        faults.push_back({key, static_cast<int>(run.recording.progress.frames), fault});
    return faults;
}

bool is_known(const std::vector<KeyFault>& faults, const ProgramFault& fault) {
    return std::any_of(faults.begin(), faults.end(), [&](const KeyFault& known) {
        return known.fault.place == fault.place && known.fault.sentence == fault.sentence;
    });
}

} // namespace

std::vector<ProgramKey> keys_in(std::string_view source) {
    const std::string code = bare_code(source);
    std::vector<ProgramKey> keys;
    for (std::size_t at = code.find("SDL"); at != std::string::npos;
         at = code.find("SDL", at + 3)) {
        std::size_t begin = at;
        for (const std::string_view prefix : {"SDLK_", "SDL_SCANCODE_"})
            if (code.compare(at, prefix.size(), prefix) == 0) begin = at + prefix.size();
        if (begin == at || (at > 0 && is_name_letter(code[at - 1]))) continue;
        const auto end = std::find_if_not(code.begin() + static_cast<std::ptrdiff_t>(begin),
                                          code.end(), is_name_letter);
        const std::string name(code.begin() + static_cast<std::ptrdiff_t>(begin), end);
        const ProgramKey key{name, key_code(name)};
        const bool is_new = std::none_of(
            keys.begin(), keys.end(), [&](const ProgramKey& one) { return one.code == key.code; });
        if (key.code != 0 && is_new) keys.push_back(key);
    }
    return keys;
}

std::vector<KeyFault> hold_keys(const StudentFiles& files, const std::string& sanitized_program,
                                const KeyRuns& runs) {
    std::vector<ProgramKey> keys{{}};
    std::vector<std::string> sources = files.sources;
    sources.insert(sources.begin(), files.main);
    for (const std::string& source : sources)
        for (const ProgramKey& key : keys_in(read_source(source)))
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    keys.resize(std::min(keys.size(), static_cast<std::size_t>(runs.most_keys) + 1));
    const std::function<bool()> is_stopped = asked_one_at_a_time(runs.is_stopped);
    std::vector<std::vector<KeyFault>> found(keys.size());
    do_two_at_a_time(keys.size(), [&](std::size_t i) {
        if (!is_stopped || !is_stopped())
            found[i] = hold_key(files, sanitized_program, runs, keys[i], is_stopped);
    });
    std::vector<KeyFault> faults;
    for (const std::vector<KeyFault>& of_key : found)
        for (const KeyFault& fault : of_key)
            if (!is_known(faults, fault.fault)) faults.push_back(fault);
    return faults;
}

} // namespace rasterwalk
