#include "lessons/lesson_search.h"

#include <algorithm>

#include "base/letter_case.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

std::vector<std::string> words_of(std::string_view query) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : in_small_letters(query.substr(0, 200))) {
        if (c != ' ') {
            word += c;
        } else if (!word.empty()) {
            words.push_back(std::move(word));
            word.clear();
        }
    }
    if (!word.empty()) words.push_back(std::move(word));
    return words;
}

bool has_all(const std::string& text, const std::vector<std::string>& words) {
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return text.find(word) != text.npos; });
}

/// Moves a place in UTF-8 back to where a character begins.
std::size_t character_start(std::string_view text, std::size_t at) {
    while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u)
        --at;
    return std::min(at, text.size());
}

/// About a hundred letters around a place, cut at blanks where possible.
std::string excerpt_at(const std::string& text, std::size_t place) {
    constexpr std::size_t before = 36, length = 110;
    std::size_t begin = character_start(text, place > before ? place - before : 0);
    if (begin > 0) {
        const std::size_t blank = text.find(' ', begin);
        if (blank != text.npos && blank < place) begin = blank + 1;
    }
    std::size_t end = character_start(text, std::min(begin + length, text.size()));
    if (end < text.size()) {
        const std::size_t blank = text.rfind(' ', end);
        if (blank != text.npos && blank > place) end = blank;
    }
    std::string excerpt = begin > 0 ? "…" : "";
    excerpt.append(text, begin, end - begin);
    if (end < text.size()) excerpt.append("…");
    return excerpt;
}

/// Everything that a reader of the step sees.
std::string text_of(const Lesson& lesson, const LessonStep& step) {
    std::string text;
    const auto add = [&](const std::string& markdown) {
        text += plain_text(parse_markdown(markdown).blocks) + " ";
    };
    for (const LessonPart& part : step.parts) {
        const auto index = static_cast<std::size_t>(part.index);
        switch (part.kind) {
        case LessonPart::Kind::text:
            add(with_footnotes(lesson, part.text));
            break;
        case LessonPart::Kind::task:
            add(lesson.tasks[index].text);
            break;
        case LessonPart::Kind::prediction:
            add(lesson.predictions[index].text);
            break;
        case LessonPart::Kind::puzzle:
            add(lesson.puzzles[index].text);
            break;
        case LessonPart::Kind::control:
            text += lesson.controls[index].setting->title;
            text += " ";
            break;
        }
    }
    return text;
}

} // namespace

std::vector<SearchHit> search_lessons(const std::vector<Lesson>& lessons,
                                      const std::vector<Term>& glossary, std::string_view query) {
    std::vector<SearchHit> hits;
    const std::vector<std::string> words = words_of(query);
    if (words.empty()) return hits;
    for (const Term& term : glossary) {
        if (has_all(in_small_letters(term.word + " " + term.sentence), words)) {
            hits.push_back({{}, 0, term.word, term.sentence});
        }
    }
    std::vector<SearchHit> others;
    for (const Lesson& lesson : lessons) {
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const std::string heading = heading_text(lesson.steps[i]);
            const std::string text = text_of(lesson, lesson.steps[i]);
            const std::string lower_text = in_small_letters(text);
            if (!has_all(in_small_letters(heading) + " " + lower_text, words)) continue;
            const std::size_t place = lower_text.find(words.front());
            SearchHit hit{lesson.id, static_cast<int>(i), heading,
                          excerpt_at(text, place == text.npos ? 0 : place)};
            (has_all(in_small_letters(heading), words) ? hits : others).push_back(std::move(hit));
        }
    }
    hits.insert(hits.end(), others.begin(), others.end());
    if (hits.size() > most_search_hits) hits.resize(most_search_hits);
    return hits;
}

} // namespace rasterwalk
