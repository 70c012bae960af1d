#include "base/pnm.h"

namespace rasterwalk {

namespace {

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Reads numbers separated by blanks, and comments from # to the end of the line.
class PnmNumbers {
  public:
    PnmNumbers(std::string_view bytes, std::size_t place) : bytes_(bytes), place_(place) {}

    std::optional<int> next() {
        while (place_ < bytes_.size() && (is_blank(bytes_[place_]) || bytes_[place_] == '#')) {
            if (bytes_[place_] == '#') {
                while (place_ < bytes_.size() && bytes_[place_] != '\n' && bytes_[place_] != '\r')
                    ++place_;
            } else {
                ++place_;
            }
        }
        constexpr int largest = 100'000'000;
        int number = 0;
        const std::size_t begin = place_;
        for (; place_ < bytes_.size() && bytes_[place_] >= '0' && bytes_[place_] <= '9'; ++place_) {
            if (number > largest) return std::nullopt;
            number = 10 * number + (bytes_[place_] - '0');
        }
        if (place_ == begin) return std::nullopt;
        return number;
    }
    std::size_t place() const { return place_; }

  private:
    std::string_view bytes_;
    std::size_t place_;
};

/// Reads samples of one or two bytes, the high one first.
class PnmBytes {
  public:
    PnmBytes(std::string_view bytes, std::size_t place, bool are_two)
        : bytes_(bytes), place_(place), are_two_(are_two) {}

    std::optional<int> next() {
        int sample = 0;
        for (int i = are_two_ ? 2 : 1; i > 0; --i) {
            if (place_ >= bytes_.size()) return std::nullopt;
            sample = sample << 8 | static_cast<unsigned char>(bytes_[place_++]);
        }
        return sample;
    }

  private:
    std::string_view bytes_;
    std::size_t place_;
    bool are_two_;
};

template <class Samples>
std::optional<Image> parse_samples(const PnmHeader& header, Samples samples) {
    Image image{header.size.x, header.size.y, {}};
    const std::size_t count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgba.reserve(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint8_t channel = 0;
        for (int c = 0; c < header.channels; ++c) {
            const std::optional<int> sample = samples.next();
            if (!sample || *sample > header.largest) return std::nullopt;
            channel =
                static_cast<std::uint8_t>((510 * *sample + header.largest) / (2 * header.largest));
            image.rgba.push_back(channel);
        }
        for (int c = header.channels; c < 3; ++c)
            image.rgba.push_back(channel);
        image.rgba.push_back(255);
    }
    return image;
}

} // namespace

std::size_t PnmHeader::fewest_bytes() const {
    const std::size_t samples = static_cast<std::size_t>(size.x) *
                                static_cast<std::size_t>(size.y) *
                                static_cast<std::size_t>(channels);
    // A digit, and a blank before the next one.
    return is_text ? 2 * samples - 1 : (largest > 255 ? 2 : 1) * samples;
}

std::optional<PnmHeader> parse_pnm_header(std::string_view bytes) {
    PnmHeader header;
    header.is_text = bytes[1] == '2' || bytes[1] == '3';
    header.channels = bytes[1] == '2' || bytes[1] == '5' ? 1 : 3;
    PnmNumbers numbers(bytes, 2);
    const std::optional<int> width = numbers.next(), height = numbers.next(),
                             largest = numbers.next();
    if (!width || !height || !largest || *largest < 1 || *largest > 65535) return std::nullopt;
    header.size = {*width, *height};
    header.largest = *largest;
    header.begin = numbers.place() + 1; // one blank
    // Some programs end lines with two bytes here too; the size of the file shows which.
    if (!header.is_text && bytes.substr(header.begin - 1).starts_with("\r\n") &&
        bytes.size() == header.begin + 1 + header.fewest_bytes())
        ++header.begin;
    return header;
}

std::optional<Image> parse_pnm(std::string_view bytes, const PnmHeader& header) {
    if (header.is_text) return parse_samples(header, PnmNumbers(bytes, header.begin - 1));
    return parse_samples(header, PnmBytes(bytes, header.begin, header.largest > 255));
}

} // namespace rasterwalk
