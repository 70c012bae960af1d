#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// The sentences of the first paragraph of a Markdown text, as they are written, without references
/// to footnotes. Headings, lists, code, quotes, tables and pictures are no paragraphs; a sentence
/// does not end within code, a formula, a link or emphasis. Empty where there is no paragraph.
std::vector<std::string> leading_sentences(std::string_view markdown);

} // namespace rasterwalk
