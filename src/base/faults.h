#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace rasterwalk {

/// Something wrong in a text file.
struct Fault {
    int line = 0;         ///< of the file, from 1; 0: the whole file
    std::string sentence; ///< ends with a full stop

    friend bool operator==(const Fault&, const Fault&) = default;
};

/// The most faults kept for one file; later ones are not reported.
inline constexpr int most_faults = 200;

/// Collects the faults of a file while it is read, so that one does not hide the next.
class FaultList {
  public:
    explicit FaultList(std::string path) : path_(std::move(path)) {}

    void add(int line, std::string sentence) {
        if (faults_.size() < static_cast<std::size_t>(most_faults)) {
            faults_.push_back({line, std::move(sentence)});
        }
    }

    /// A fault that keeps the whole file from being shown.
    void refuse(int line, std::string sentence) {
        is_beyond_limits_ = true;
        add(line, std::move(sentence));
    }
    bool is_beyond_limits() const { return is_beyond_limits_; }

    /// Runs an action; if it throws, that is a fault in this line, or in the one that the sentence
    /// names.
    template <class Action>
    void attempt(int line, Action action) {
        try {
            action();
        } catch (const Error& fault) {
            add_error(line, fault.what());
        }
    }

    /// The faults in the order of their lines.
    std::vector<Fault> take() {
        std::stable_sort(faults_.begin(), faults_.end(),
                         [](const Fault& a, const Fault& b) { return a.line < b.line; });
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
    std::vector<Fault> faults_;
    bool is_beyond_limits_ = false;
};

} // namespace rasterwalk
