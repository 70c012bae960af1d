#include "figures/figure_tags.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool is_name_sign(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == ':' || c == '_';
}

/// Reads a file from its front to its end.
class TagReader {
  public:
    TagReader(std::string_view text, const std::string& path) : rest_(text), path_(path) {}

    std::vector<FigureTag> read() {
        skip_declaration();
        while (!rest_.empty()) {
            if (rest_.starts_with("<!--")) {
                skip_comment();
            } else if (rest_.starts_with("</")) {
                read_end();
            } else if (rest_[0] == '<') {
                read_start();
            } else {
                read_text();
            }
        }
        if (!open_.empty()) fail("the element <" + open_.back() + "> is not closed.");
        if (tags_.empty()) fail("there is nothing in this file.");
        return std::move(tags_);
    }

  private:
    [[noreturn]] void fail(const std::string& sentence) const {
        throw InputError(path_, line_, sentence);
    }

    void take(std::size_t length) {
        const std::string_view taken = rest_.substr(0, length);
        line_ += static_cast<int>(std::count(taken.begin(), taken.end(), '\n'));
        rest_.remove_prefix(taken.size());
    }
    void skip_blanks() {
        std::size_t length = 0;
        while (length < rest_.size() && is_blank(rest_[length]))
            ++length;
        take(length);
    }
    std::string take_name() {
        std::size_t length = 0;
        while (length < rest_.size() && is_name_sign(rest_[length]))
            ++length;
        if (length == 0) fail("a name is missing here.");
        std::string name(rest_.substr(0, length));
        take(length);
        return name;
    }

    void skip_declaration() {
        if (!rest_.starts_with("<?xml ")) return;
        const std::size_t end = rest_.find("?>");
        if (end == rest_.npos) fail("the declaration <?xml is not closed.");
        take(end + 2);
    }
    void skip_comment() {
        const std::size_t end = rest_.find("-->", 4);
        if (end == rest_.npos) fail("the comment is not closed.");
        take(end + 3);
    }

    /// The text with its references replaced.
    std::string plain(std::string_view text) const {
        static constexpr std::array<std::pair<std::string_view, char>, 5> references{
            {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
        std::string result;
        while (!text.empty()) {
            if (text[0] != '&') {
                result += text[0];
                text.remove_prefix(1);
                continue;
            }
            const auto* const found =
                std::find_if(references.begin(), references.end(),
                             [&](const auto& known) { return text.starts_with(known.first); });
            if (found == references.end())
                fail("only &amp;, &lt;, &gt;, &quot; and &apos; may begin with &.");
            result += found->second;
            text.remove_prefix(found->first.size());
        }
        return result;
    }

    void read_text() {
        const std::size_t end = std::min(rest_.find('<'), rest_.size());
        const std::string_view text = rest_.substr(0, end);
        if (!trimmed(text).empty()) {
            if (open_.empty()) fail("there is text outside of <svg>.");
            tags_.push_back({FigureTag::Kind::text, plain(text), {}, line_});
        }
        take(end);
    }

    void read_start() {
        take(1);
        if (!rest_.empty() && (rest_[0] == '!' || rest_[0] == '?'))
            fail("only elements and comments are read here.");
        FigureTag tag{FigureTag::Kind::open, "", {}, line_};
        tag.name = take_name();
        if (open_.empty() && !tags_.empty()) fail("there must be one outermost element.");
        if (open_.size() >= deepest_figure)
            fail(fmt::format("elements may be nested {} deep.", deepest_figure));
        bool is_empty = false;
        while (true) {
            const std::size_t before = rest_.size();
            skip_blanks();
            if (rest_.empty()) fail("the tag <" + tag.name + " is not closed.");
            is_empty = rest_.starts_with("/>");
            if (is_empty || rest_[0] == '>') break;
            if (rest_.size() == before) fail("a blank is missing before this attribute.");
            read_attribute(tag);
        }
        take(is_empty ? 2 : 1);
        open_.push_back(tag.name);
        tags_.push_back(std::move(tag));
        if (is_empty) close();
    }

    void read_attribute(FigureTag& tag) {
        FigureAttribute attribute{"", "", line_};
        attribute.name = take_name();
        for (const FigureAttribute& other : tag.attributes) {
            if (other.name == attribute.name)
                fail("the attribute " + in_quotes(attribute.name) + " is there twice.");
        }
        if (tag.attributes.size() >= most_figure_attributes)
            fail(fmt::format("an element may have at most {} attributes.", most_figure_attributes));
        if (!rest_.starts_with("=\"") && !rest_.starts_with("='"))
            fail("write an attribute as name=\"value\".");
        const std::size_t end = rest_.find(rest_[1], 2);
        if (end == rest_.npos) fail("the value of an attribute is not closed.");
        const std::string_view value = rest_.substr(2, end - 2);
        if (value.find('<') != value.npos) fail("write < in a value as &lt;.");
        attribute.value = plain(value);
        take(end + 1);
        tag.attributes.push_back(std::move(attribute));
    }

    void read_end() {
        take(2);
        const std::string name = take_name();
        skip_blanks();
        if (!rest_.starts_with(">")) fail("the tag </" + name + " is not closed.");
        if (open_.empty() || open_.back() != name)
            fail("</" + name + "> closes nothing" +
                 (open_.empty() ? "." : "; <" + open_.back() + "> is open."));
        close();
        take(1);
    }

    void close() {
        tags_.push_back({FigureTag::Kind::close, open_.back(), {}, line_});
        open_.pop_back();
    }

    std::string_view rest_;
    const std::string& path_;
    int line_ = 1;
    std::vector<std::string> open_; ///< names of the elements around
    std::vector<FigureTag> tags_;
};

/// The line of the first byte that no figure may have; 0 if there is none.
int line_of_control(std::string_view text) {
    int line = 1;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte < 0x20 && !is_blank(c)) || byte == 0x7F) return line;
        if (c == '\n') ++line;
    }
    return 0;
}

} // namespace

std::vector<FigureTag> read_figure_tags(std::string_view text, const std::string& path) {
    if (text.size() > largest_figure)
        throw InputError(path + ": " +
                         fmt::format("a figure may have at most {} bytes.", largest_figure));
    if (!is_utf8(text)) throw InputError(path + ": the file is not UTF-8.");
    if (const int line = line_of_control(text); line > 0)
        throw InputError(path, line, "a control character is not text.");
    return TagReader(text, path).read();
}

} // namespace rasterwalk
