#include "scene/read_mtl.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/letter_case.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "scene/companion_file.h"
#include "scene/obj_words.h"

namespace rasterwalk {

namespace {

/// An option of an image: "-bm 0.5".
struct MapOption {
    std::string_view name;
    int fewest, most; ///< words after it; more than the fewest only if they are numbers
};

constexpr MapOption map_options[] = {
    {"-blendu", 1, 1}, {"-blendv", 1, 1},     {"-bm", 1, 1},     {"-boost", 1, 1},   {"-cc", 1, 1},
    {"-clamp", 1, 1},  {"-colorspace", 1, 1}, {"-mm", 2, 2},     {"-imfchan", 1, 1}, {"-o", 1, 3},
    {"-s", 1, 3},      {"-t", 1, 3},          {"-texres", 1, 1}, {"-type", 1, 1},
};

/// The options of an image.
struct MapOptions {
    float strength = 1.0f;               ///< -bm
    std::optional<float> base, gain;     ///< -mm
    glm::vec2 scale{1.0f}, offset{0.0f}; ///< -s and -o; their third number is for solid textures

    /// @param i which number of the option, from 0
    void set(std::string_view option, int i, float number) {
        if (option == "-bm") strength = number;
        if (option == "-mm") (i == 0 ? base : gain) = number;
        if (option == "-s" && i < 2) scale[i] = number;
        if (option == "-o" && i < 2) offset[i] = number;
    }
};

using UsedOptions = std::initializer_list<std::string_view>;

/// The most images of one file that are looked for on the disk.
constexpr std::size_t most_lookups = 2 * most_materials;

constexpr std::string_view skipped_option =
    "the only options of an image that are used are -bm, -mm of disp, and -s and -o of map_Kd";
constexpr std::string_view skipped_halo = "alpha is the same from every direction";
constexpr std::string_view skipped_material = "this property of a material is not used";

/// What an image may be called if no file has the name as written: without the quotes, and without
/// the comment or options after it, or unknown options before it.
std::vector<std::string> readings_of_name(std::string_view name) {
    constexpr std::size_t most_readings = 16;
    std::vector<std::string> readings;
    const auto add = [&](std::string_view reading) {
        reading = trimmed(reading);
        if (const auto quoted = take_quoted(reading)) reading = *quoted;
        const bool is_known =
            std::find(readings.begin(), readings.end(), reading) != readings.end();
        if (!reading.empty() && !is_known && readings.size() < most_readings)
            readings.emplace_back(reading);
    };
    readings.emplace_back(name);
    std::string_view rest = name;
    while (!rest.empty() && readings.size() < most_readings) {
        add(rest);
        for (const char* const mark : {" #", "\t#", " -", "\t-"})
            add(rest.substr(0, rest.find(mark)));
        // Words may belong to an option as long as the name begins with one.
        if (name.front() != '-') break;
        take_word(rest);
        rest = trimmed(rest);
    }
    return readings;
}

class MtlReader {
  public:
    MtlReader(std::string_view text, const std::string& path, const std::string& model_path,
              WatchedSteps& watched, ObjReporter& reporter, std::vector<ObjMaterial>& materials)
        : lines_(text), path_(path), companions_({path, model_path}), watched_(watched),
          reporter_(reporter), materials_(materials) {}

    void read() {
        while (lines_.next()) {
            std::string_view rest = lines_.text();
            const std::string_view word = take_word(rest);
            if (!word.empty() && word.front() != '#') read_statement(word, rest);
            watched_.step();
        }
    }

  private:
    template <class Say>
    void fault(Say say) {
        reporter_.fault(path_, lines_.line(), say);
    }
    void skip(std::string_view word, std::string_view why) {
        reporter_.skip(path_, lines_.line(), word, why);
    }

    void read_statement(std::string_view word, std::string_view rest) {
        if (word == "newmtl") return begin_material(rest);
        const std::string key = in_small_letters(word.substr(0, 16));
        const bool is_bump = key == "bump" || key == "map_bump" || key == "norm";
        const bool is_used = is_bump || key == "disp" || key == "map_kd" || key == "map_d" ||
                             key == "kd" || key == "ks" || key == "ns" || key == "d" || key == "tr";
        if (!is_used) return skip(word, skipped_material);
        if (is_left_out_) return;
        if (!is_begun_) {
            return fault([&] {
                return fmt::format("{} comes before the first newmtl; it is left out.",
                                   in_quotes(word));
            });
        }
        ObjMaterial& material = materials_.back();
        const bool has_numbers = !is_bump && key != "disp" && key != "map_kd" && key != "map_d";
        if (has_numbers && reports_comma(word, rest)) return;
        if (key == "kd") {
            material.diffuse_line = lines_.line();
            return read_colour(word, rest, material.diffuse);
        }
        if (key == "ks") return read_colour(word, rest, material.specular);
        if (key == "ns") return read_shininess(rest, material);
        if (key == "d" || key == "tr") return read_alpha(key == "d", rest, material);
        if (key == "map_kd") {
            material.diffuse_map_line = lines_.line();
            MapOptions options;
            read_map(word, rest, material.diffuse_map, {"-s", "-o"}, options);
            material.map_scale = options.scale;
            material.map_offset = options.offset;
            return;
        }
        MapOptions options;
        if (key == "map_d") {
            material.alpha_map_line = lines_.line();
            return read_map(word, rest, material.alpha_map, {}, options);
        }
        if (key == "disp") {
            material.height_map_line = lines_.line();
            read_map(word, rest, material.height_map, {"-mm"}, options);
            material.has_height_range = options.base || options.gain;
            material.height_base = options.base.value_or(0.0f);
            material.height_gain = options.gain.value_or(1.0f);
            return;
        }
        material.bump_map_line = lines_.line();
        read_map(word, rest, material.bump_map, {"-bm"}, options);
        material.bump_strength = options.strength;
        material.bump_is_normal = key == "norm";
    }

    /// Is a word of a statement a number with a decimal comma? If so, reports it.
    bool reports_comma(std::string_view statement, std::string_view rest) {
        std::string_view word = take_number_word(rest);
        while (!word.empty() && !has_decimal_comma(word))
            word = take_number_word(rest);
        if (word.empty()) return false;
        fault([&] { return decimal_comma_sentence(word, statement); });
        return true;
    }

    void begin_material(std::string_view rest) {
        const std::string_view name = trimmed(rest);
        is_left_out_ = true;
        if (name.empty()) return fault([] { return "'newmtl' has no name; it is left out."; });
        if (materials_.size() >= most_materials) {
            return fault([] {
                return fmt::format("there are more than {} materials; this one is left out.",
                                   most_materials);
            });
        }
        is_left_out_ = false;
        is_begun_ = true;
        materials_.push_back({});
        materials_.back().file = path_;
        materials_.back().name = name.substr(0, longest_material_name);
        ++reporter_.report().counts.materials;
    }

    void read_colour(std::string_view word, std::string_view rest, glm::vec3& colour) {
        std::array<std::string_view, 3> words;
        std::size_t count = 0;
        while (count < words.size() && !(words[count] = take_number_word(rest)).empty())
            ++count;
        if (count == 1) {
            words[1] = words[2] = words[0];
            count = words.size();
        }
        glm::vec3 read(0.0f);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::optional<double> number = parse_model_number(words[i]);
            if (count < words.size() || !number || *number < 0.0 || *number > 1.0) {
                return fault([&] {
                    return fmt::format("{} takes one or three numbers from 0 to 1; it is left out.",
                                       in_quotes(word));
                });
            }
            read[static_cast<int>(i)] = static_cast<float>(*number);
        }
        colour = read;
    }

    void read_shininess(std::string_view rest, ObjMaterial& material) {
        const std::optional<double> number = parse_model_number(take_number_word(rest));
        if (!number || *number < 0.0)
            return fault([] { return "'Ns' takes a number from 0 up; it is left out."; });
        material.shininess = static_cast<float>(*number);
    }

    /// d is alpha, Tr is 1 - alpha. If a file has both, d counts.
    void read_alpha(bool is_dissolve, std::string_view rest, ObjMaterial& material) {
        const std::string_view word = is_dissolve ? "'d'" : "'Tr'";
        std::string_view first = take_number_word(rest);
        if (is_dissolve && first == "-halo") {
            skip(first, skipped_halo);
            first = take_number_word(rest);
        }
        const std::optional<double> number = parse_model_number(first);
        if (!number || *number < 0.0 || *number > 1.0) {
            return fault([&] {
                return fmt::format("{} takes a number from 0 to 1; it is left out.", word);
            });
        }
        if (!is_dissolve && material.has_dissolve) return;
        // Some programs write Tr 1 and mean opaque; no model is meant to be invisible.
        if (!is_dissolve && *number == 1.0) {
            return fault(
                [] { return "'Tr' 1 would make the material invisible, so it is drawn opaque."; });
        }
        material.alpha = static_cast<float>(is_dissolve ? *number : 1.0 - *number);
        material.alpha_line = lines_.line();
        material.has_dissolve = material.has_dissolve || is_dissolve;
    }

    /// Takes the options that precede an image's name.
    /// @param used the options that have an effect; others are reported as skipped
    void read_options(std::string_view& rest, const UsedOptions& used, MapOptions& options) {
        while (true) {
            std::string_view remainder = rest;
            const std::string_view option = take_word(remainder);
            const auto known = std::find_if(std::begin(map_options), std::end(map_options),
                                            [&](const MapOption& o) { return o.name == option; });
            if (known == std::end(map_options)) return;
            const bool is_used = std::find(used.begin(), used.end(), option) != used.end();
            bool is_right = true;
            for (int i = 0; i < known->most; ++i) {
                std::string_view after = remainder;
                const std::string_view word = take_word(after);
                // The name follows: it may look like a number, but there is always one.
                if (trimmed(after).empty()) break;
                const std::optional<double> number = parse_model_number(word);
                if (is_used && has_decimal_comma(word))
                    fault([&] { return decimal_comma_sentence(word, option); });
                else if (i >= known->fewest && !number)
                    break;
                else if (is_used && !number)
                    fault([&] {
                        return fmt::format("{} is not a valid number for {}, which is left out.",
                                           in_quotes(word), in_quotes(option));
                    });
                is_right = is_right && number.has_value();
                if (number) options.set(option, i, static_cast<float>(*number));
                remainder = after;
            }
            // One number of a range means nothing without the other.
            if (!is_right && option == "-mm") options.base = options.gain = std::nullopt;
            if (!is_used) skip(option, skipped_option);
            rest = remainder;
        }
    }

    void read_map(std::string_view word, std::string_view rest, std::string& map,
                  const UsedOptions& used, MapOptions& options) {
        read_options(rest, used, options);
        if (++lookups_ > most_lookups) {
            return fault([&] {
                return fmt::format("{}: more than {} images are named; the image is left out.",
                                   in_quotes(word), most_lookups);
            });
        }
        const CompanionFile file = companions_.find(readings_of_name(trimmed(rest)));
        if (file.problem.empty()) {
            map = file.path;
            if (!file.remark.empty())
                reporter_.note(path_, lines_.line(),
                               fmt::format("{}: {}.", in_quotes(word), file.remark));
            return;
        }
        fault([&] {
            return fmt::format("{}: {}; the image is left out.", in_quotes(word), file.problem);
        });
    }

    ObjLines lines_;
    const std::string& path_;
    CompanionFiles companions_;
    WatchedSteps& watched_;
    ObjReporter& reporter_;
    std::vector<ObjMaterial>& materials_;
    std::size_t lookups_ = 0; ///< images, whether they are there or not
    bool is_begun_ = false;
    bool is_left_out_ = false; ///< the material to which the statements belong
};

} // namespace

void parse_mtl(std::string_view text, const std::string& path, const std::string& model_path,
               WatchedSteps& watched, ObjReporter& reporter, std::vector<ObjMaterial>& materials) {
    MtlReader(text, path, model_path, watched, reporter, materials).read();
}

} // namespace rasterwalk
