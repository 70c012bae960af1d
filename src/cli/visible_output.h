#pragma once

#include <ostream>
#include <streambuf>
#include <string>

#include "base/quoted.h"

namespace rasterwalk {

/// A stream on top of another one that lets only visible() text through: names and texts from files
/// must not control the terminal. Passes on whole lines; the rest when it is flushed. In JSON,
/// escaped text still means the same.
class VisibleOutput : public std::ostream {
  public:
    explicit VisibleOutput(std::ostream& target) : std::ostream(nullptr), buffer_(target) {
        rdbuf(&buffer_);
    }
    VisibleOutput(const VisibleOutput&) = delete;
    VisibleOutput& operator=(const VisibleOutput&) = delete;
    ~VisibleOutput() override { flush(); }

  private:
    class Buffer : public std::streambuf {
      public:
        explicit Buffer(std::ostream& target) : target_(target) {}

      protected:
        int_type overflow(int_type c) override {
            if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
            const char letter = traits_type::to_char_type(c);
            return xsputn(&letter, 1) == 1 ? c : traits_type::eof();
        }
        std::streamsize xsputn(const char* text, std::streamsize count) override {
            line_.append(text, static_cast<std::size_t>(count));
            return pass_on(line_.rfind('\n') + 1) ? count : 0;
        }
        int sync() override { return pass_on(line_.size()) && target_.flush() ? 0 : -1; }

      private:
        bool pass_on(std::size_t count) {
            if (count == 0) return true;
            target_ << visible(std::string_view(line_).substr(0, count));
            line_.erase(0, count);
            return static_cast<bool>(target_);
        }

        std::ostream& target_;
        std::string line_;
    };

    Buffer buffer_;
};

} // namespace rasterwalk
