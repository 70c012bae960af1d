#include "lessons/lesson_advice.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/letter_case.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "text/markdown.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

/// How a link writes a blank.
constexpr std::string_view linked_blank = "%20";

/// A word as it is read, from the way a link writes it.
std::string with_blanks(std::string_view target) {
    std::string word(target);
    for (std::size_t at = word.find(linked_blank); at != word.npos; at = word.find(linked_blank))
        word.replace(at, linked_blank.size(), " ");
    return word;
}

/// And the way back.
std::string without_blanks(std::string_view word) {
    return fmt::format("{}", fmt::join(split(word, ' '), linked_blank));
}

/// A paragraph as advice sees it, in small letters.
struct Paragraph {
    std::string text;       ///< without code, formulas, marks and targets of links
    std::string emphasized; ///< only what is emphasized or links to the glossary; else blanks
    int line = 0;           ///< of the file
};

/// Reads the text of a lesson's part, sign by sign.
class ParagraphReader {
  public:
    explicit ParagraphReader(const LessonPart& part) : line_(part.line) {
        for (const std::string_view line : split_lines(part.text)) {
            if (is_fence(line)) {
                is_code_ = !is_code_;
            } else if (trimmed(line).empty()) {
                end_paragraph();
            } else if (!is_code_) {
                read_line(line);
            }
            ++line_;
        }
        end_paragraph();
    }

    std::vector<Paragraph> take() { return std::move(paragraphs_); }

  private:
    void put(std::string_view words, bool is_emphasized) {
        if (current_.text.empty()) current_.line = line_;
        current_.text += words;
        current_.emphasized += is_emphasized ? std::string(words) : std::string(words.size(), ' ');
    }

    void end_paragraph() {
        if (!current_.text.empty()) {
            current_.text = in_small_letters(current_.text);
            current_.emphasized = in_small_letters(current_.emphasized);
            paragraphs_.push_back(std::move(current_));
        }
        current_ = {};
        is_emphasis_ = false;
    }

    void read_line(std::string_view line) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const char sign = line[i];
            if (sign == '`' || sign == '$') {
                const std::size_t end = line.find(sign, i + 1);
                if (end != line.npos) i = end;
                put(" ", false);
            } else if (sign == '*') {
                const bool is_bullet =
                    line.find_first_not_of(" \t") == i && i + 1 < line.size() && line[i + 1] == ' ';
                while (i + 1 < line.size() && line[i + 1] == '*')
                    ++i;
                is_emphasis_ = is_emphasis_ != !is_bullet;
                put(" ", false);
            } else if (sign == ']' && i + 1 < line.size() && line[i + 1] == '(') {
                const std::size_t end = std::min(line.find(')', i), line.size());
                const std::string_view target = line.substr(i + 2, end - i - 2);
                constexpr std::string_view glossary = "term:";
                put(" ", false);
                if (target.starts_with(glossary))
                    put(with_blanks(target.substr(glossary.size())), true);
                put(" ", false);
                i = end;
            } else {
                put(line.substr(i, 1), is_emphasis_);
            }
        }
        put(" ", false);
    }

    int line_;
    bool is_code_ = false, is_emphasis_ = false;
    Paragraph current_;
    std::vector<Paragraph> paragraphs_;
};

bool joins_word(char sign) {
    const auto byte = static_cast<unsigned char>(sign);
    return std::isalnum(byte) != 0 || sign == '-' || byte >= 0x80;
}

/// Is the word in the text, or its plural? Both in small letters.
bool has_word(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        if (at > 0 && joins_word(text[at - 1])) continue;
        std::string_view rest = text.substr(at + word.size());
        for (const std::string_view plural : {"es", "s", ""}) {
            if (!rest.starts_with(plural)) continue;
            const std::string_view after = rest.substr(plural.size());
            if (after.empty() || !joins_word(after.front())) return true;
        }
    }
    return false;
}

/// Where a lesson has a term.
struct TermPlaces {
    int used_step = -1, used_line = 0;
    int explained_step = -1;
};

using StepParagraphs = std::vector<std::vector<Paragraph>>;

StepParagraphs paragraphs_of(const Lesson& lesson) {
    StepParagraphs steps;
    for (const LessonStep& step : lesson.steps) {
        steps.emplace_back();
        for (const LessonPart& part : step.parts) {
            if (part.kind != LessonPart::Kind::text) continue;
            for (Paragraph& paragraph : ParagraphReader(part).take())
                steps.back().push_back(std::move(paragraph));
        }
    }
    return steps;
}

TermPlaces places_of(const StepParagraphs& steps, std::string_view word) {
    TermPlaces places;
    for (std::size_t step = 0; step < steps.size(); ++step) {
        for (const Paragraph& paragraph : steps[step]) {
            if (places.used_step < 0 && has_word(paragraph.text, word)) {
                places.used_step = static_cast<int>(step);
                places.used_line = paragraph.line;
            }
            if (places.explained_step < 0 && has_word(paragraph.emphasized, word))
                places.explained_step = static_cast<int>(step);
        }
    }
    return places;
}

/// @param known terms explained so far; receives those of this lesson
void advise_on_words(const Lesson& lesson, std::span<const Term> glossary,
                     std::set<std::string>& known, std::vector<Fault>& advice) {
    const StepParagraphs steps = paragraphs_of(lesson);
    for (const Term& term : glossary) {
        const std::string word = in_small_letters(term.word);
        if (term.is_everyday || known.count(word) > 0) continue;
        const TermPlaces places = places_of(steps, word);
        if (places.used_step < 0 && places.explained_step < 0) continue;
        known.insert(word); // is said once
        if (places.explained_step < 0) {
            advice.push_back(
                {places.used_line,
                 fmt::format("{} is used here and explained nowhere before. Explain it and "
                             "emphasize it there, or link it: [{}](term:{}).",
                             in_quotes(term.word), term.word, without_blanks(term.word))});
        } else if (places.used_step >= 0 && places.used_step < places.explained_step) {
            advice.push_back(
                {places.used_line, fmt::format("{} is used here, but explained only in step {}.",
                                               in_quotes(term.word), places.explained_step)});
        }
    }
}

void advise_on_length(const Lesson& lesson, std::vector<Fault>& advice) {
    constexpr int head = 1; // the line of the lesson's comment
    const int steps = static_cast<int>(lesson.steps.size()) - 1;
    if (steps < fewest_steps || steps > most_steps) {
        advice.push_back(
            {head, fmt::format("a lesson of {} to {} steps suits one sitting; this one "
                               "has {}.",
                               fewest_steps, most_steps, steps)});
    }
    const double minutes = minutes_by_length(lesson);
    if (std::abs(minutes - lesson.minutes) > most_minutes_off) {
        advice.push_back({head, fmt::format("its text, predictions and tasks take about {:.0f} "
                                            "minutes, not {}.",
                                            minutes, lesson.minutes)});
    }
    for (const LessonStep& step : lesson.steps) {
        const int words = count_words(step);
        if (words <= most_step_words) continue;
        advice.push_back(
            {step.line, fmt::format("this step has {} words. With at most {} it can be "
                                    "read at a glance; divide it or shorten it.",
                                    words, most_step_words)});
    }
}

} // namespace

int count_words(const LessonStep& step) {
    std::ptrdiff_t count = 0;
    for (const LessonPart& part : step.parts) {
        if (part.kind != LessonPart::Kind::text) continue;
        std::vector<MarkdownBlock> blocks = parse_markdown(part.text).blocks;
        // The words of a picture are not part of the text.
        std::erase_if(blocks, [](const MarkdownBlock& block) {
            return block.kind == MarkdownBlock::Kind::picture;
        });
        const std::string text = plain_text(blocks);
        const std::vector<std::string_view> words = split(text, ' ');
        count += std::count_if(words.begin(), words.end(), [](std::string_view word) {
            return std::any_of(word.begin(), word.end(), [](char sign) {
                return std::isalnum(static_cast<unsigned char>(sign)) != 0;
            });
        });
    }
    return static_cast<int>(count);
}

double minutes_by_length(const Lesson& lesson) {
    int words = 0;
    for (const LessonStep& step : lesson.steps)
        words += count_words(step);
    return words / 130.0 + static_cast<double>(lesson.predictions.size()) + task_count(lesson);
}

std::vector<std::vector<Fault>> advice_on(std::span<const Lesson> lessons,
                                          std::span<const Term> glossary) {
    std::set<std::string> known;
    std::vector<std::vector<Fault>> all;
    for (const Lesson& lesson : lessons) {
        all.emplace_back();
        if (!is_readable(lesson)) continue;
        advise_on_length(lesson, all.back());
        advise_on_words(lesson, glossary, known, all.back());
        std::stable_sort(all.back().begin(), all.back().end(),
                         [](const Fault& a, const Fault& b) { return a.line < b.line; });
    }
    return all;
}

} // namespace rasterwalk
