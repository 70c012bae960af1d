#include "cli/json.h"

#include <cmath>

#include <fmt/format.h>
#include <utf8cpp/utf8.h>

#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// How a letter is escaped within quotes; "" if it is not.
std::string json_escape(char32_t letter) {
    switch (letter) {
    case '"':
        return "\\\"";
    case '\\':
        return "\\\\";
    case '\b':
        return "\\b";
    case '\f':
        return "\\f";
    case '\n':
        return "\\n";
    case '\r':
        return "\\r";
    case '\t':
        return "\\t";
    default:
        break;
    }
    constexpr char32_t del = 0x7f, next_line = 0x85, line_separator = 0x2028,
                       paragraph_separator = 0x2029;
    const bool is_escaped = letter < 0x20 || letter == del || letter == next_line ||
                            letter == line_separator || letter == paragraph_separator;
    return is_escaped ? fmt::format("\\u{:04X}", static_cast<unsigned>(letter)) : std::string();
}

std::string json_text(std::string_view text) {
    std::string quoted = "\"";
    for (auto at = text.begin(); at != text.end();) {
        const auto begin = at;
        std::string escape;
        try {
            escape = json_escape(utf8::next(at, text.end()));
        } catch (const utf8::exception&) {
            at = begin + 1; // not UTF-8: the byte
            escape = fmt::format("\\u00{:02X}", static_cast<unsigned char>(*begin));
        }
        if (escape.empty()) {
            quoted.append(begin, at);
        } else {
            quoted += escape;
        }
    }
    return quoted + '"';
}

/// All digits of a double; with a point or an exponent, so that it is not mistaken for a whole
/// number.
std::string json_number(double value) {
    if (std::isnan(value)) return "\"NaN\"";
    if (std::isinf(value)) return value > 0.0 ? "\"Infinity\"" : "\"-Infinity\"";
    const std::string digits = significant(value, 17);
    return digits.find_first_of(".e") == digits.npos ? digits + ".0" : digits;
}

/// Appends a value that begins at this depth.
void append_json(std::string& text, const Json& value, int depth) {
    if (value.is_string()) {
        text += json_text(value.get_ref<const std::string&>());
    } else if (value.is_number_float()) {
        text += json_number(value.get<double>());
    } else if (!value.is_structured() || value.empty()) {
        text += value.dump();
    } else {
        const std::string margin(4 * static_cast<std::size_t>(depth), ' ');
        text += value.is_object() ? '{' : '[';
        bool is_first = true;
        for (const auto& [key, member] : value.items()) {
            text.append(is_first ? "\n    " : ",\n    ").append(margin);
            if (value.is_object()) text.append(json_text(key)).append(" : ");
            append_json(text, member, depth + 1);
            is_first = false;
        }
        text.append("\n").append(margin) += value.is_object() ? '}' : ']';
    }
}

} // namespace

Json texts_to_json(const std::vector<std::string>& texts) {
    return Json(texts);
}

Json vector_to_json(const glm::vec3& v) {
    return Json::array({v.x, v.y, v.z});
}

void print_json(const Json& value, std::ostream& out) {
    std::string text;
    append_json(text, value, 0);
    out << text << '\n';
}

} // namespace rasterwalk
