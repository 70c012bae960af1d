#pragma once

// Lines, words and numbers of model and material files (OBJ, MTL).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rasterwalk {

/// Takes the first line from a text that is not empty, without its end: LF, CR or CR LF.
std::string_view take_line(std::string_view& text);

/// Removes the backslash that joins the next line to this one, and the blanks after it. False if
/// there is none.
bool take_backslash(std::string_view& line);

/// Is it a comment, which no backslash can continue?
bool is_comment(std::string_view line);

/// The statements of a text, one by one. A line ends with LF, CR or CR LF; a backslash at its end
/// joins the next line to it, except in a comment. A byte order mark at the beginning is skipped.
class ObjLines {
  public:
    explicit ObjLines(std::string_view text);

    /// Goes to the next statement; false at the end of the text.
    bool next();

    /// The statement, without the end of its line. Valid until next() is called again.
    std::string_view text() const { return statement_; }
    /// The line it begins on, from 1.
    int line() const { return line_; }
    /// Lines read so far, including joined ones.
    int line_count() const { return line_count_; }
    /// Bytes of the text that have not been read yet.
    std::size_t bytes_left() const { return rest_.size(); }
    /// Where lines 1, 65, 129 ... (see lines_per_mark) begin in the text, of those read so far.
    std::vector<std::uint32_t> take_marks() { return std::move(marks_); }

  private:
    std::string_view next_line();

    const char* begin_; ///< of the whole text
    std::vector<std::uint32_t> marks_;
    std::string_view rest_;
    std::string_view statement_;
    std::string joined_;
    int line_ = 0;
    int line_count_ = 0;
};

/// Takes the first word from a text; empty if there is none.
std::string_view take_word(std::string_view& text);

/// Takes the text in quotes, " or ', from the beginning of a text, without blanks at its ends;
/// nothing if the text does not begin with a quote. Without a second quote that is all of it.
std::optional<std::string_view> take_quoted(std::string_view& text);

/// Takes the first file name from a text: a word, or text in quotes, since some programs quote
/// names with blanks.
std::string_view take_name(std::string_view& text);

/// Takes the first word from the text of a statement that consists of numbers: "#" begins a
/// comment, but not in "1.#INF", "1.#IND", "1.#QNAN" and "1.#SNAN", as some programs write values
/// that are not numbers.
std::string_view take_number_word(std::string_view& text);

/// A number as models write it: 1, -1.5, +.5, 1e-3; one too small for double is 0. Nothing for
/// anything else, for nan and inf, and beyond `largest_model_coordinate`.
std::optional<double> parse_model_number(std::string_view word);

/// Is this a number with a decimal comma, "1,5", as programs write it under some locales?
bool has_decimal_comma(std::string_view word);

/// "'1,5' has a decimal comma, and numbers have a point here; 'v' is left out."
std::string decimal_comma_sentence(std::string_view word, std::string_view statement);

/// Is the text UTF-16? It has its byte order mark, or a zero in its first character.
bool is_utf16(std::string_view text);

} // namespace rasterwalk
