#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/error.h"
#include "session/lesson.h"

namespace rasterwalk {

/// The faults of a lesson while it is read: one does not hide the next.
class FaultList {
  public:
    explicit FaultList(std::string path) : path_(std::move(path)) {}

    void add(int line, std::string sentence) {
        if (faults_.size() < static_cast<std::size_t>(most_lesson_faults)) {
            faults_.push_back({line, std::move(sentence)});
        }
    }

    /// A fault because of which nothing of the lesson is shown.
    void refuse(int line, std::string sentence) {
        is_beyond_limits_ = true;
        add(line, std::move(sentence));
    }
    bool is_beyond_limits() const { return is_beyond_limits_; }

    /// Does something; if it throws, that is a fault in this line, or in the one that the sentence
    /// names.
    template <class Deed>
    void attempt(int line, Deed deed) {
        try {
            deed();
        } catch (const Error& fault) {
            add_error(line, fault.what());
        }
    }

    /// The faults in the order of their lines.
    std::vector<LessonFault> take() {
        std::stable_sort(
            faults_.begin(), faults_.end(),
            [](const LessonFault& a, const LessonFault& b) { return a.line < b.line; });
        return std::move(faults_);
    }

    const std::string& path() const { return path_; }

  private:
    /// InputError says "path:line: sentence".
    void add_error(int line, std::string_view text) {
        if (text.starts_with(path_) && text.substr(path_.size()).starts_with(":")) {
            std::string_view rest = text.substr(path_.size() + 1);
            int named = 0;
            while (!rest.empty() && rest[0] >= '0' && rest[0] <= '9' && named < 100'000'000) {
                named = 10 * named + (rest[0] - '0');
                rest.remove_prefix(1);
            }
            if (rest.starts_with(": ")) rest.remove_prefix(2);
            if (rest.starts_with(" ")) rest.remove_prefix(1);
            add(named > 0 ? named : line, std::string(rest));
        } else {
            add(line, std::string(text));
        }
    }

    std::string path_;
    std::vector<LessonFault> faults_;
    bool is_beyond_limits_ = false;
};

} // namespace rasterwalk
