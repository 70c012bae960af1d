#include "base/jpeg_header.h"

#include <array>
#include <cstdint>
#include <optional>

namespace rasterwalk {

namespace {

/// Programs write ten scans or so of a progressive picture; each costs as much as the whole.
constexpr int most_scans = 100;
constexpr std::int64_t most_scanned_pixels = std::int64_t{1} << 29;

constexpr std::string_view cut_off = "is cut off.";
constexpr std::string_view damaged = "is damaged.";
constexpr std::string_view other_kind =
    "is a JPG of a rare kind that cannot be read; save it as an ordinary JPG or as PNG.";

/// The bytes of a segment.
class JpegBytes {
  public:
    explicit JpegBytes(std::string_view bytes) : rest_(bytes) {}

    bool is_empty() const { return rest_.empty(); }
    /// The next byte; 0 beyond the end, which is noted.
    int take() {
        if (rest_.empty()) {
            has_ended_early_ = true;
            return 0;
        }
        const auto byte = static_cast<unsigned char>(rest_.front());
        rest_.remove_prefix(1);
        return byte;
    }
    int take_two() {
        const int high = take();
        return high << 8 | take();
    }
    void skip(int count) {
        for (int i = 0; i < count && !has_ended_early_; ++i)
            take();
    }
    bool is_whole() const { return rest_.empty() && !has_ended_early_; }
    bool has_ended_early() const { return has_ended_early_; }

  private:
    std::string_view rest_;
    bool has_ended_early_ = false;
};

class JpegWalk {
  public:
    explicit JpegWalk(std::string_view bytes) : bytes_(bytes) {}

    JpegHeader walk() {
        std::string_view problem;
        while (problem.empty() && !is_at_end_)
            problem = next_segment();
        if (problem.empty() && scans_ == 0) problem = cut_off;
        header_.problem = problem;
        return header_;
    }

  private:
    struct Component {
        int id = 0;
    };

    int byte_here() const { return static_cast<unsigned char>(bytes_[place_]); }

    /// Goes to the next segment, and reads it. Returns what is wrong; empty: nothing.
    std::string_view next_segment() {
        // Some programs put padding before the size.
        while (place_ < bytes_.size() && byte_here() != 0xff) {
            if (is_sized_) return damaged;
            ++place_;
        }
        while (place_ < bytes_.size() && byte_here() == 0xff)
            ++place_;
        if (place_ + 1 > bytes_.size()) return cut_off;
        const int marker = byte_here();
        ++place_;
        if (marker == 0xd9) {
            is_at_end_ = true;
            return {};
        }
        if (place_ + 2 > bytes_.size()) return cut_off;
        const auto length = static_cast<std::size_t>(JpegBytes(bytes_.substr(place_)).take_two());
        if (length < 2) return damaged;
        if (place_ + length > bytes_.size()) return cut_off;
        const std::string_view segment = bytes_.substr(place_ + 2, length - 2);
        place_ += length;
        return read_segment(marker, segment);
    }

    std::string_view read_segment(int marker, std::string_view segment) {
        if (marker == 0xc4) return read_codes(segment);
        if (marker == 0xda) return read_scan(segment);
        if (marker >= 0xc0 && marker <= 0xc2) return read_frame(segment, marker == 0xc2);
        if (marker >= 0xc3 && marker <= 0xcf) return other_kind;
        return {};
    }

    std::string_view read_frame(std::string_view segment, bool is_progressive) {
        if (is_sized_) return damaged;
        JpegBytes bytes(segment);
        const int bits = bytes.take(), height = bytes.take_two(), width = bytes.take_two();
        const int count = bytes.take();
        if (bytes.has_ended_early()) return damaged;
        header_.size = {width, height};
        is_sized_ = true;
        is_progressive_ = is_progressive;
        if (bits != 8 || (count != 1 && count != 3 && count != 4) || height == 0) return other_kind;
        component_count_ = static_cast<std::size_t>(count);
        for (std::size_t i = 0; i < component_count_; ++i) {
            components_[i].id = bytes.take();
            bytes.skip(2);
        }
        return bytes.is_whole() ? std::string_view{} : damaged;
    }

    /// stb_image has room for 256 values, and treats the last one as none.
    std::string_view read_codes(std::string_view segment) {
        constexpr int most_values = 255;
        JpegBytes bytes(segment);
        while (!bytes.is_empty()) {
            const int what = bytes.take(), kind = what >> 4, number = what & 15;
            if (kind > 1 || number > 3) return damaged;
            int values = 0;
            for (int i = 0; i < 16; ++i)
                values += bytes.take();
            if (values > most_values) return damaged;
            bytes.skip(values);
            if (bytes.has_ended_early()) return damaged;
            is_known_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(number)] = true;
        }
        return {};
    }

    std::string_view read_scan(std::string_view segment) {
        if (!is_sized_) return damaged;
        ++scans_;
        const auto most = is_progressive_ ? most_scans : static_cast<int>(component_count_);
        if (scans_ > most || scans_ * pixels() > most_scanned_pixels)
            return "has more scans than a picture needs.";
        JpegBytes bytes(segment);
        const int count = bytes.take();
        if (count < 1 || count > static_cast<int>(component_count_)) return damaged;
        std::array<int, 4> codes{};
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            bool is_there = false;
            const int id = bytes.take();
            for (std::size_t c = 0; c < component_count_; ++c)
                is_there = is_there || components_[c].id == id;
            if (!is_there) return damaged;
            codes[i] = bytes.take();
        }
        const int first = bytes.take();
        bytes.skip(1);
        const int refines = bytes.take() >> 4;
        if (!bytes.is_whole()) return damaged;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const bool needs_dc = !is_progressive_ || (first == 0 && refines == 0);
            const bool needs_ac = !is_progressive_ || first > 0;
            if (needs_dc && !is_known(0, codes[i] >> 4)) return damaged;
            if (needs_ac && !is_known(1, codes[i] & 15)) return damaged;
        }
        pass_over_data();
        return {};
    }

    std::int64_t pixels() const {
        return std::int64_t{header_.size.x} * std::int64_t{header_.size.y};
    }

    bool is_known(std::size_t kind, int number) const {
        return number < 4 && is_known_[kind][static_cast<std::size_t>(number)];
    }

    /// To the next marker that does not belong to the data: 00 and D0 to D7 do.
    void pass_over_data() {
        while (true) {
            place_ = bytes_.find('\xff', place_);
            if (place_ == bytes_.npos || place_ + 1 >= bytes_.size()) {
                place_ = bytes_.size();
                return;
            }
            const int next_byte = static_cast<unsigned char>(bytes_[place_ + 1]);
            if (next_byte != 0 && next_byte != 0xff && (next_byte < 0xd0 || next_byte > 0xd7))
                return;
            place_ += next_byte == 0xff ? 1 : 2;
        }
    }

    std::string_view bytes_;
    std::size_t place_ = 2; ///< after the mark at the beginning
    JpegHeader header_;
    std::array<Component, 4> components_;
    std::size_t component_count_ = 0;
    std::array<std::array<bool, 4>, 2> is_known_{}; ///< codes: DC, AC
    int scans_ = 0;
    bool is_sized_ = false, is_progressive_ = false, is_at_end_ = false;
};

} // namespace

JpegHeader parse_jpeg_header(std::string_view bytes) {
    return JpegWalk(bytes).walk();
}

} // namespace rasterwalk
