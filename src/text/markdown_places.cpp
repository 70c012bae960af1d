#include "text/markdown_places.h"

#include <algorithm>
#include <functional>

#include "base/text_parts.h"

namespace rasterwalk {

namespace {

int breaks_in(std::string_view text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace

MarkdownPlaces::MarkdownPlaces(std::string_view page)
    : page_(page), is_drawn_(static_cast<std::size_t>(breaks_in(page)) + 1) {}

std::optional<std::size_t> MarkdownPlaces::find(std::string_view letters) const {
    const std::less_equal<const char*> precedes;
    const char* const begin = page_.data();
    const bool is_inside = letters.data() != nullptr && precedes(begin, letters.data()) &&
                           precedes(letters.data() + letters.size(), begin + page_.size());
    return is_inside ? std::optional(static_cast<std::size_t>(letters.data() - begin))
                     : std::nullopt;
}

int MarkdownPlaces::line_at(std::size_t place) {
    line_ += place >= counted_ ? breaks_in(page_.substr(counted_, place - counted_))
                               : -breaks_in(page_.substr(place, counted_ - place));
    counted_ = place;
    return line_;
}

int MarkdownPlaces::line_ahead() {
    const std::size_t from = end == 0 ? 0 : std::min(page_.find('\n', end), page_.size());
    return line_at(std::min(page_.find_first_not_of(" \t\n", from), page_.size()));
}

int MarkdownPlaces::note(std::string_view letters, std::size_t place) {
    const int line = line_at(place);
    is_drawn_[static_cast<std::size_t>(line)] = true;
    end = place + letters.size();
    return line;
}

std::vector<int> MarkdownPlaces::definitions() const {
    std::vector<int> lines;
    std::string_view rest = page_;
    for (std::size_t line = 0; line < is_drawn_.size(); ++line) {
        const std::string_view whole = take_part(rest, '\n');
        // After the marks of quotes and lists.
        const std::size_t start = whole.find_first_not_of(" \t>-*+0123456789.)");
        const bool is_definition = !is_drawn_[line] && start != whole.npos && whole[start] == '[' &&
                                   whole.find("]:", start) != whole.npos;
        if (is_definition) lines.push_back(static_cast<int>(line));
    }
    return lines;
}

} // namespace rasterwalk
