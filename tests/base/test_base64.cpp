#include "base/base64.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/catch.h"

using namespace rasterwalk;

namespace {

/// Reads it back a bit at a time: slow, and written without a look at how it is made.
std::string bytes_of_base64(const std::string& text) {
    const std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<bool> bits;
    for (const char c : text) {
        if (c == '=') break;
        const std::size_t value = alphabet.find(c);
        REQUIRE(value != std::string_view::npos);
        for (int bit = 5; bit >= 0; --bit)
            bits.push_back((value >> bit & 1) != 0);
    }
    std::string bytes;
    for (std::size_t i = 0; i + 8 <= bits.size(); i += 8) {
        int byte = 0;
        for (std::size_t bit = 0; bit < 8; ++bit)
            byte = 2 * byte + (bits[i + bit] ? 1 : 0);
        bytes += static_cast<char>(byte);
    }
    return bytes;
}

} // namespace

TEST_CASE("Base64 is that of RFC 4648, section 10") {
    const std::vector<std::pair<std::string, std::string>> vectors{
        {"", ""},
        {"f", "Zg=="},
        {"fo", "Zm8="},
        {"foo", "Zm9v"},
        {"foob", "Zm9vYg=="},
        {"fooba", "Zm9vYmE="},
        {"foobar", "Zm9vYmFy"},
    };
    for (const auto& vector : vectors)
        CHECK(base64(vector.first) == vector.second);
}

TEST_CASE("Base64 can be read back, whatever the bytes") {
    std::string bytes;
    for (int i = 0; i < 256; ++i)
        bytes += static_cast<char>(i * 167 + 93);
    for (std::size_t size = 250; size <= bytes.size(); ++size) {
        const std::string text = base64(std::string_view(bytes).substr(0, size));
        CHECK(text.size() == (size + 2) / 3 * 4);
        CHECK(bytes_of_base64(text) == bytes.substr(0, size));
    }
    CHECK(base64(std::string(3, '\0')) == "AAAA");
    CHECK(base64("\xfb\xff\xbf") == "+/+/");
    CHECK(base64("\xff\xff\xff") == "////");
}
