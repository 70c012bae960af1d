#include "text/sentences.h"

#include <cctype>
#include <string_view>
#include <utility>

#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

using BlockKind = MarkdownBlock::Kind;

bool is_space(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool is_end_mark(char c) {
    return c == '.' || c == '?' || c == '!';
}

/// Does the text go on in lower case? Then what ended was "e.g." or the like.
bool goes_on_small(const MarkdownRun& run, std::size_t at) {
    const std::size_t next = run.text.find_first_not_of(" \n", at);
    return next != run.text.npos && std::islower(static_cast<unsigned char>(run.text[next])) != 0;
}

/// Is it a whole sentence, and not continued by what follows?
bool is_whole_sentence(const MarkdownDocument& sentence) {
    const std::string text = plain_text(sentence.blocks);
    const std::size_t last = text.find_last_not_of(")\"'");
    return last != text.npos && is_end_mark(text[last]) && !sentence.blocks.back().runs.back().code;
}

/// One block of a page, with the page's links.
MarkdownDocument page_of(MarkdownBlock block, const MarkdownDocument& page) {
    return {{std::move(block)}, page.links, {}, {}, {}};
}

std::vector<MarkdownDocument> sentences_of(const MarkdownBlock& paragraph,
                                           const MarkdownDocument& page) {
    std::vector<MarkdownDocument> sentences;
    MarkdownBlock sentence;
    bool is_ended = false; // the sentence, except for closing quotes and marks of emphasis
    const auto end_sentence = [&] {
        if (!sentence.runs.empty()) sentences.push_back(page_of(std::exchange(sentence, {}), page));
    };
    for (const MarkdownRun& run : paragraph.runs) {
        if (run.link >= 0 && page.links[static_cast<std::size_t>(run.link)].starts_with("note:"))
            continue;
        const bool is_plain = has_same_style(run, {});
        for (std::size_t i = 0; i < run.text.size(); ++i) {
            const char c = run.text[i];
            if (is_space(c) && is_ended && is_plain && !goes_on_small(run, i)) {
                end_sentence();
            } else if (!is_space(c) || !sentence.runs.empty()) {
                run_like(sentence.runs, run).text += c;
            }
            const bool goes_on = is_space(c) || std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                                 c == ',' || c == ';';
            // A full stop in code is a key or a member.
            is_ended = is_end_mark(c) ? is_ended || !run.code : is_ended && !goes_on;
        }
    }
    end_sentence();
    return sentences;
}

/// The items of a list, each as a list.
std::vector<MarkdownDocument> items_of(const MarkdownBlock& list, const MarkdownDocument& page) {
    std::vector<MarkdownDocument> items;
    for (const MarkdownBlock& item : list.children) {
        MarkdownBlock one = list;
        one.start += static_cast<int>(items.size());
        one.children = {item};
        items.push_back(page_of(std::move(one), page));
    }
    return items;
}

} // namespace

std::vector<ReadingPiece> reading_pieces(const MarkdownDocument& page) {
    std::vector<ReadingPiece> pieces;
    bool is_running = false; // the previous piece comes from a paragraph
    // A line and the list of the footnotes are at the end.
    const std::size_t notes = page.notes.empty() ? 0 : 2;
    for (std::size_t i = 0; i + notes < page.blocks.size(); ++i) {
        const MarkdownBlock& block = page.blocks[i];
        const bool is_paragraph = block.kind == BlockKind::paragraph;
        const bool is_list = block.kind == BlockKind::list;
        const bool goes_on = std::exchange(is_running, is_paragraph);
        if (!is_paragraph && !is_list && goes_on && !is_whole_sentence(pieces.back().page)) {
            pieces.back().page.blocks.push_back(block);
            continue;
        }
        // Running text goes on from one paragraph to the next.
        bool is_first = !is_paragraph || !goes_on;
        for (MarkdownDocument& part : is_paragraph ? sentences_of(block, page)
                                      : is_list    ? items_of(block, page)
                                                   : std::vector{page_of(block, page)}) {
            pieces.push_back({std::move(part), is_first});
            is_first = is_list && !block.is_tight;
        }
    }
    return pieces;
}

MarkdownDocument continued(MarkdownDocument page, const MarkdownDocument& piece) {
    MarkdownBlock& last = page.blocks.back();
    const MarkdownBlock& next = piece.blocks.front();
    if (!last.runs.empty()) run_like(last.runs, {}).text += ' ';
    for (const MarkdownRun& run : next.runs)
        run_like(last.runs, run).text += run.text;
    last.children.insert(last.children.end(), next.children.begin(), next.children.end());
    page.blocks.insert(page.blocks.end(), piece.blocks.begin() + 1, piece.blocks.end());
    return page;
}

} // namespace rasterwalk
