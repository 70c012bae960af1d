#include "support/changed_files.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "support/changed_formats.h"
#include "support/random.h"

namespace rasterwalk::test {

const std::vector<std::string> toml_words{
    "[", "]",          "[[",  "{",     "}",       "\"",   "\"\"\"", "=",          "\n",
    "#", "nan",        "inf", "1e999", "-1",      "0",    "1e7",    ",",          "A",
    "p", "texture = ", "a.b", "'",     "\\u0000", "true", "0x10",   "1979-05-27", "\x80"};

std::string problem_of_refusal(const std::string& sentence, bool has_beginning) {
    // The last sentence may ask whether another name was meant.
    const bool is_ended = sentence.ends_with('.') || sentence.ends_with('?');
    const bool is_sentence = is_ended && sentence.size() < 2000;
    if (has_beginning && is_sentence && sentence.find("outofmem") == sentence.npos) return "";
    return "it is refused without its name or without a sentence: " + sentence;
}

std::vector<ChangedFormat> changed_formats() {
    std::vector<ChangedFormat> all = picture_formats();
    for (const auto& formats :
         {model_formats(), course_formats(), view_formats(), program_formats()})
        all.insert(all.end(), formats.begin(), formats.end());
    return all;
}

std::string changed_file(const ChangedFormat& format, std::uint32_t number) {
    Random random(number);
    const auto index = [&](std::size_t size) {
        return static_cast<std::size_t>(random.integer(0, static_cast<int>(size) - 1));
    };
    std::string bytes = format.seeds[index(format.seeds.size())];
    for (int n = random.integer(1, random.integer(1, 6)); n > 0 && !bytes.empty(); --n) {
        const std::size_t place = index(bytes.size());
        switch (random.integer(0, 9)) {
        case 0:
            bytes.insert(place, format.words[index(format.words.size())]);
            break;
        case 1: {
            const std::string& word = format.words[index(format.words.size())];
            bytes.replace(place, word.size(), word);
            break;
        }
        case 2:
            bytes.erase(place, index(9) + 1);
            break;
        case 3:
            bytes.insert(place, bytes.substr(place, index(40) + 1));
            break;
        case 4:
            bytes.resize(place);
            break;
        case 5:
            bytes += format.seeds[index(format.seeds.size())];
            break;
        case 6: // one bit
            bytes[place] = static_cast<char>(bytes[place] ^ 1 << random.integer(0, 7));
            break;
        case 7:
        case 8: { // the next number
            constexpr std::string_view digits = "0123456789";
            const std::size_t begin = std::min(bytes.find_first_of(digits, place), bytes.size());
            const std::size_t end = std::min(bytes.find_first_not_of(digits, begin), bytes.size());
            bytes.replace(begin, end - begin, std::to_string(random.integer(0, 12)));
            break;
        }
        default:
            bytes[place] = static_cast<char>(random.integer(0, 255));
        }
    }
    return bytes;
}

FileOutcome outcome_of(const ChangedFormat& format, const std::string& bytes,
                       const TemporaryFolder& folder) {
    const std::clock_t begin = std::clock();
    FileOutcome outcome;
    try {
        outcome = format.read(bytes, folder);
    } catch (const std::exception& other) {
        outcome.problem = std::string("what is thrown is no InputError: ") + other.what();
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (outcome.problem.empty() && seconds > most_seconds)
        outcome.problem = fmt::format("it takes {:.1f} s.", seconds);
    return outcome;
}

void lay_out(const TemporaryFolder& folder) {
    std::filesystem::create_directories(folder.file("m/changed"));
    const std::string image = picture_formats().front().seeds.front();
    folder.write("m/p.png", image);
    folder.write("m/changed/p.png", image);
    folder.write("m/m.mtl", changed_materials);
}

} // namespace rasterwalk::test
