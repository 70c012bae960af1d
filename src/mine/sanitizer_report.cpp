#include "mine/sanitizer_report.h"

#include <array>
#include <charconv>
#include <system_error>
#include <utility>

namespace rasterwalk {

namespace {

/// What each kind of fault means.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> meanings{{
    {"heap-buffer-overflow", "It reads or writes beyond the end of a vector or of another array."},
    {"heap-use-after-free", "It uses memory that has been given back: a vector that has grown or "
                            "has been destroyed."},
    {"global-buffer-overflow", "It reads or writes outside a global array."},
    {"stack-buffer-overflow", "It reads or writes outside a local array."},
    {"stack-buffer-underflow", "It reads or writes before the beginning of a local array."},
    {"stack-overflow", "Its calls go too deep: a function calls itself without an end, or a local "
                       "array is too large for the stack."},
    {"SEGV", "It uses a pointer or an index that leads to no memory."},
    {"out of bounds", "It uses an index that the array does not have."},
    {"signed integer overflow", "A calculation with int gives more than an int can hold."},
    {"outside the range of representable values",
     "It makes an int of a number that is too large for one, or of NaN."},
    {"division by zero", "It divides by zero."},
    {"null pointer", "It uses a pointer that leads nowhere."},
    {"reached the end of a value-returning function", "A function that should return a value ends "
                                                      "without a return."},
    {"attempting free", "It gives back memory that is not there to be given back."},
}};

std::string sentence_for(std::string_view kind) {
    for (const auto& [word, sentence] : meanings)
        if (kind.find(word) != std::string_view::npos) return std::string(sentence);
    return "It does something that C++ does not define.";
}

/// Takes ":NUMBER" off the end of a text; 0: it does not end so.
int cut_last_number(std::string_view& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos) return 0;
    const char* const end = text.data() + text.size();
    int number = 0;
    const auto [stop, fault] = std::from_chars(text.data() + colon + 1, end, number);
    if (fault != std::errc{} || stop != end) return 0;
    text = text.substr(0, colon);
    return number;
}

/// "FILE:LINE:COLUMN" or "FILE:LINE".
ProgramPlace parse_sanitizer_place(std::string_view text) {
    ProgramPlace place;
    const int last = cut_last_number(text);
    const int before = last > 0 ? cut_last_number(text) : 0;
    place.line = before > 0 ? before : last;
    place.file = std::string(text);
    return place;
}

/// A line of a stack, "    #1 0x55... in DrawPolygonRows(...) FILE:LINE", if its file is in the
/// folder. Both the function and the file may have blanks in them.
ProgramPlace parse_frame(std::string_view line, const std::string& folder) {
    const std::size_t in = line.find(" in ");
    const std::size_t gap = line.find(' ' + folder + '/');
    if (in == std::string_view::npos || gap == std::string_view::npos || gap < in + 4) return {};
    ProgramPlace place = parse_sanitizer_place(line.substr(gap + 1));
    place.function = std::string(line.substr(in + 4, gap - in - 4));
    return place;
}

} // namespace

std::optional<SanitizerFault> parse_sanitizer_report(std::string_view printed,
                                                     const std::string& folder) {
    constexpr std::string_view runtime_error = ": runtime error: ";
    constexpr std::string_view address_error = "ERROR: AddressSanitizer: ";
    std::optional<SanitizerFault> fault;
    while (!printed.empty()) {
        const std::size_t end = printed.find('\n');
        const std::string_view line = printed.substr(0, end);
        printed.remove_prefix(end == std::string_view::npos ? printed.size() : end + 1);
        if (const std::size_t at = line.find(runtime_error); !fault && at != line.npos) {
            fault.emplace();
            fault->kind = std::string(line.substr(at + runtime_error.size()));
            const ProgramPlace place = parse_sanitizer_place(line.substr(0, at));
            if (place.line > 0 && is_in_folder(place.file, folder)) fault->place = place;
        } else if (const std::size_t found = line.find(address_error);
                   !fault && found != line.npos) {
            fault.emplace();
            std::string_view kind = line.substr(found + address_error.size());
            if (const std::size_t on = kind.find(" on "); on != kind.npos)
                kind = kind.substr(0, on);
            fault->kind = std::string(kind);
        } else if (fault && fault->place.line == 0 && line.find('#') != line.npos) {
            // The first stack is where it happened; those after it say where memory came from.
            const ProgramPlace place = parse_frame(line, folder);
            if (place.line > 0) fault->place = place;
        }
    }
    if (fault) fault->sentence = sentence_for(fault->kind);
    return fault;
}

} // namespace rasterwalk
