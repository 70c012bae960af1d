#include "ui/hand/key_names.h"

#include <string>
#include <utility>

#include "base/error.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

constexpr std::pair<std::string_view, int> named_keys[] = {
    {"SPACE", key::space},         {"ESCAPE", key::escape},
    {"ENTER", key::enter},         {"TAB", key::tab},
    {"BACKSPACE", key::backspace}, {"DELETE", key::del},
    {"RIGHT", key::right},         {"LEFT", key::left},
    {"DOWN", key::down},           {"UP", key::up},
    {"HOME", key::home},           {"END", key::end},
    {"PAGEUP", key::page_up},      {"PAGEDOWN", key::page_down},
    {"INSERT", key::insert},       {"COMMA", key::comma},
    {"PERIOD", key::period},       {"PLUS", key::equal},
    {"MINUS", key::minus},         {"+", key::equal},
};

std::string upper_case(std::string_view text) {
    std::string upper(text);
    for (char& c : upper)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return upper;
}

bool cut_front(std::string& text, std::string_view front) {
    if (!text.starts_with(front) || text.size() == front.size()) return false;
    text.erase(0, front.size());
    return true;
}

/// 0 if there is no such key.
int find_key(const std::string& name) {
    for (const auto& [known, code] : named_keys) {
        if (known == name) return code;
    }
    if (name.size() == 1 && name[0] > ' ' && name[0] <= 'Z') return name[0];
    if (name == "[" || name == "]") return name[0];
    if (name.starts_with('F')) {
        for (int n = 1; n <= 12; ++n) {
            if (name.substr(1) == std::to_string(n)) return key::f1 + n - 1;
        }
    }
    return 0;
}

} // namespace

KeyPress parse_key(std::string_view text) {
    std::string name = upper_case(text);
    KeyPress pressed;
    while (true) {
        if (cut_front(name, "CTRL+")) {
            pressed.modifiers.ctrl = true;
        } else if (cut_front(name, "SHIFT+")) {
            pressed.modifiers.shift = true;
        } else if (cut_front(name, "ALT+")) {
            pressed.modifiers.alt = true;
        } else {
            break;
        }
    }
    pressed.key = find_key(name);
    if (pressed.key == 0) {
        throw UsageError("there is no key '" + std::string(text) +
                         "'; key names are A, 7, F1, Space, Left, Ctrl+Z ...");
    }
    return pressed;
}

} // namespace rasterwalk
