#include "tests/support/made_jpeg.h"

#include <string_view>

#include <stb_image_write.h>

namespace rasterwalk::test {

namespace {

/// Two digits a byte: the writer at hand makes no such file.
constexpr std::string_view progressive_digits =
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d"
    "0f13201513121213271c1e17202e2931302e292d2c333a4a3e333646372c2d405741464c4e52"
    "5352323e5a615a50604a51524fffdb0043010e0e0e131113261515264f352d354f4f4f4f4f4f"
    "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f"
    "4f4f4f4f4f4fffc2001108000a000c03012200021101031101ffc40014000100000000000000"
    "000000000000000004ffc40014010100000000000000000000000000000002ffda000c030100"
    "021003100000011318d07fffc40017100100030000000000000000000000000000010203ffda"
    "0008010100010502a628c5443fffc40017110003010000000000000000000000000000020411"
    "ffda0008010301013f019686c3ffc400161101010100000000000000000000000000020003ff"
    "da0008010201013f017b2bffc40014100100000000000000000000000000000020ffda000801"
    "0100063f021fffc4001a100002020300000000000000000000000000011131215161ffda0008"
    "010100013f21e261a116845147ffda000c03010002000300000010efffc40014110100000000"
    "000000000000000000000000ffda0008010301013f105fffc400151101010000000000000000"
    "0000000000000011ffda0008010201013f10b9ffc40019100002030100000000000000000000"
    "00000021113191c1ffda0008010100013f10a4afc8826112987fffd9";

} // namespace

std::string jpeg(int width, int height, int quality, const std::vector<std::uint8_t>& rgb) {
    std::string bytes;
    stbi_write_jpg_to_func(
        [](void* into, void* data, int size) {
            static_cast<std::string*>(into)->append(static_cast<const char*>(data),
                                                    static_cast<std::size_t>(size));
        },
        &bytes, width, height, 3, rgb.data(), quality);
    return bytes;
}

std::string progressive_jpeg() {
    const auto value = [](char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; };
    std::string bytes;
    for (std::size_t i = 0; i < progressive_digits.size(); i += 2) {
        bytes +=
            static_cast<char>(16 * value(progressive_digits[i]) + value(progressive_digits[i + 1]));
    }
    return bytes;
}

std::vector<std::uint8_t> ramp(int width, int height) {
    std::vector<std::uint8_t> rgb;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            for (const int channel : {40 + 4 * column, 60 + 5 * row, 128})
                rgb.push_back(static_cast<std::uint8_t>(channel));
        }
    }
    return rgb;
}

} // namespace rasterwalk::test
