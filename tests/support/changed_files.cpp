#include "tests/support/changed_files.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <exception>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/image.h"
#include "figures/figure_drawing.h"
#include "scene/read_obj.h"
#include "scene/read_scene.h"
#include "tests/support/made_images.h"
#include "tests/support/made_jpeg.h"
#include "tests/support/random.h"
#include "tests/support/sound_model.h"

namespace rasterwalk::test {

namespace {

// Pictures

/// Pixels without pattern, so that a byte that is lost moves all others.
std::string pixels(int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i)
        bytes += byte((i * 73 + i / 5 * 11) & 255);
    return bytes;
}

/// Deflate data that hold the bytes uncompressed; there are fewer than 65536.
std::string stored(const std::string& bytes) {
    const int size = static_cast<int>(bytes.size());
    return "\x78\x01\x01" + two_bytes(size) + two_bytes(size ^ 0xffff) + bytes + "????";
}

/// @param kind the type of colour, followed by how rows are interlaced
std::string png_of(std::uint32_t width, std::uint32_t height, int bits, std::array<int, 2> kind,
                   const std::string& more_blocks, const std::string& data) {
    const std::string head = big_endian(width) + big_endian(height) + byte(bits) + byte(kind[0]) +
                             byte(0) + byte(0) + byte(kind[1]);
    return "\x89PNG\r\n\x1a\n" + png_block("IHDR", head) + more_blocks + png_block("IDAT", data) +
           png_block("IEND", "");
}

std::vector<std::string> png_seeds() {
    const TemporaryFolder folder;
    Image image{9, 7, {}};
    for (int i = 0; i < 9 * 7; ++i)
        for (const int channel : {i * 3, i % 7 * 20, 128, 255 - i})
            image.rgba.push_back(static_cast<std::uint8_t>(channel));
    write_png(image, folder.file("written.png"));
    std::string rows; // each with its own filter
    for (int row = 0; row < 5; ++row)
        rows += byte(row) + pixels(12);
    // 5 x 3 pixels, Adam7: the rows of passes 1, 2, 4, 5, 6, 6 and 7.
    std::string passes;
    for (const int width : {1, 1, 1, 3, 2, 2, 5})
        passes += byte(0) + pixels(2 * width);
    const std::string palette = png_block("PLTE", pixels(30)) + png_block("tRNS", pixels(5));
    return {bytes_of(folder.file("written.png")),
            png_of(4, 5, 8, {2, 0}, png_block("tRNS", std::string(6, '\0')), stored(rows)),
            png_of(5, 3, 16, {0, 1}, "", stored(passes)),
            png_of(4, 2, 4, {3, 0}, palette, stored(byte(0) + "\x12\x34" + byte(0) + "\x50\x67")),
            png_of(9, 2, 1, {0, 0}, "", stored(byte(0) + "\xa5\x80" + byte(2) + "\x5a\x80"))};
}

std::vector<std::string> tga_seeds() {
    const std::string packed = byte(3) + pixels(16) + byte(0x87) + pixels(4) + byte(2) + pixels(12);
    return {tga_head(2, 5, 3, 24, 0) + pixels(45),
            tga_head(10, 5, 3, 32, from_top | eight_alpha_bits) + packed,
            tga_head(1, 4, 3, 8, 0, 5, 24) + pixels(15) +
                std::string("\0\1\2\3\4\0\1\2\3\4\0\1", 12),
            tga_head(9, 4, 2, 8, from_top, 3, 16) + pixels(6) + byte(0x85) + byte(2) + byte(1) +
                byte(0) + byte(1),
            tga_head(11, 6, 2, 8, 16) + byte(0x83) + byte(9) + byte(7) + pixels(8),
            tga_head(2, 3, 2, 16, 1) + pixels(12)};
}

/// A BMP of one of the kinds that have a palette or masks.
std::string bmp_of(int width, int height, int bits, int packing, const std::string& between,
                   const std::string& rows) {
    const auto word = [](int value) { return little_endian(static_cast<std::uint32_t>(value)); };
    const int begin = 54 + static_cast<int>(between.size());
    return "BM" + word(begin + static_cast<int>(rows.size())) + word(0) + word(begin) + word(40) +
           word(width) + word(height) + two_bytes(1) + two_bytes(bits) + word(packing) +
           std::string(20, '\0') + between + rows;
}

std::vector<std::string> bmp_seeds() {
    const std::string masks = little_endian(0xf800) + little_endian(0x07e0) + little_endian(0x001f);
    return {bmp(5, 3),
            bmp(5, -3),
            bmp_of(3, 2, 8, 0, pixels(4 * 256), pixels(8)),
            bmp_of(5, -2, 4, 0, pixels(4 * 16), pixels(8)),
            bmp_of(9, 2, 1, 0, pixels(8), pixels(8)),
            bmp_of(3, 2, 16, 3, masks, pixels(16)),
            bmp_of(3, 2, 32, 0, "", pixels(24))};
}

std::string problem_of_refusal(const std::string& sentence, bool has_beginning) {
    // The last sentence may ask whether another name was meant.
    const bool is_ended = sentence.ends_with('.') || sentence.ends_with('?');
    const bool is_sentence = is_ended && sentence.size() < 2000;
    if (has_beginning && is_sentence && sentence.find("outofmem") == sentence.npos) return "";
    return "it is refused without its name or without a sentence: " + sentence;
}

FileOutcome picture_outcome(const std::string& bytes, const TemporaryFolder&) {
    try {
        const Image image = parse_image(bytes, "x");
        const auto is_side = [](int side) { return side >= 1 && side <= largest_image_side; };
        const bool is_whole = is_side(image.width) && is_side(image.height) &&
                              image.rgba.size() == 4 * static_cast<std::size_t>(image.width) *
                                                       static_cast<std::size_t>(image.height);
        return {true, is_whole ? "" : "its pixels are not as many as its sides say."};
    } catch (const InputError& fault) {
        const std::string said = fault.what();
        return {false, problem_of_refusal(said, said.starts_with("x: "))};
    }
}

// Models, materials and scenes

const std::string materials =
    "newmtl a\nKd 0.5 1 0.25\nKs 0.5\nNs 10\nd -halo 0.5\nTr 0.25\n"
    "map_Kd -s 2 2 -o .5 p.png\nbump -bm 2 p.png\ndisp -mm 0 .5 p.png\nnewmtl b c\nKd .2\n"
    "map_d \"p.png\" # a\nmap_Kd C:\\\\p.png\nnorm p.png\nillum 2\n"
    "newmtl c\nKd 0\n";
const std::string painted_model =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl a\n"
    "f 1/1/1 2/2/1 3/3/1\nusemtl b c\nf 1/1 3/3 2/2\n";

const std::string scene_seed =
    "name = \"s\"\nstage = \"edges\"\n[viewport]\nwidth = 40\nheight = 30\n[camera]\n"
    "position = [0, 0, -3]\nyaw = 0.5\n[light]\nposition = [0, -1, 0]\npower = [9, 9, 9]\n"
    "[points.p]\nA = [0, 0, 1]\nB = [1, 0, 1.5]\nC = [0, 1, 1e0]\n[materials.m]\n"
    "diffuse = [0.5, 0.5, 1]\nalpha = 0.5\n[[part]]\nname = \"q\"\npoints = \"p\"\n"
    "material = \"m\"\ntexture = \"p.png\"\ntexcoords = [[[0, 0], [1, 0], [0, 1]]]\n"
    "model = [{ scale = [2, 1, 1] }, { rotate_y = 0.5 }]\ntriangles = [\"A B C\"]\n";

/// Calls a reader of a file that names other files next to it.
template <class Read>
FileOutcome text_outcome(const std::string& path, const std::string& other_path, Read read) {
    try {
        return {true, read()};
    } catch (const InputError& fault) {
        const std::string said = fault.what();
        return {false,
                problem_of_refusal(said, has_line(said, path) || has_line(said, other_path))};
    }
}

FileOutcome model_outcome(const std::string& bytes, const TemporaryFolder& folder) {
    const std::string path = folder.file("m/m.obj");
    return text_outcome(path, folder.file("m/m.mtl"),
                        [&] { return problem_of_model(parse_obj(bytes, path)); });
}

FileOutcome material_outcome(const std::string& bytes, const TemporaryFolder& folder) {
    folder.write("m/changed/m.mtl", bytes);
    const std::string path = folder.file("m/changed/m.obj");
    bool is_whole = true;
    FileOutcome outcome = text_outcome(path, folder.file("m/changed/m.mtl"), [&] {
        const ObjModel model = parse_obj(painted_model, path);
        is_whole = model.report.counts.faults == 0;
        return problem_of_model(model);
    });
    outcome.is_read = outcome.is_read && is_whole;
    return outcome;
}

FileOutcome scene_outcome(const std::string& bytes, const TemporaryFolder& folder) {
    const std::string path = folder.file("m/s.toml");
    return text_outcome(path, path, [&] { return problem_of_scene(parse_scene(bytes, path)); });
}

// Figures

const std::string figure_seed =
    "<svg viewBox=\"0 0 90 60\">\n<style>.a{}</style><!-- b -->\n"
    "<g class=\"edge-1\" transform=\"translate(4, 5)\" data-if=\"stage == fill\">\n"
    "<line class=\"dashed arrow\" x1=\"1\" y1=\"2\" x2=\"30\" y2=\"4\"/>\n"
    "<polygon class=\"soft\" points=\"0,0 9,0 9,9\" data-points=\"1;2;camera.yaw;4;5;6\"/></g>\n"
    "<circle cx=\"50\" cy=\"5\" r=\"4\" data-cx=\"camera.focal_length / 10\""
    " data-drag=\"camera.focal_length 100 900 50\"/>\n"
    "<path d=\"M0 0 L1 1 Q2 3 4 5 C1 2 3 4 5 6 Z\"/><rect x=\"1\" y=\"2\" width=\"3\" "
    "height=\"4\"/>\n"
    "<text x=\"3\" y=\"4\">p<tspan class=\"sub\" data-value=\"pixel.z\">1</tspan> &lt; 4</text>\n"
    "</svg>\n";

FileOutcome figure_outcome(const std::string& bytes, const TemporaryFolder&) {
    try {
        const Figure figure = read_figure(bytes, "x");
        const FactReader no_facts = [](std::string_view) { return Value(); };
        const FigureDrawing drawing = draw_figure(figure, no_facts);
        std::size_t places = 0;
        bool is_short = false;
        for (const FigureLine& line : drawing.lines) {
            places += line.places.size();
            is_short = is_short || line.places.size() < 2;
        }
        if (is_short) return {true, "a line of it has less than two places."};
        for (const FigureHandle& handle : figure.handles)
            dragged_value(figure, handle, {0.0f, 0.0f}, no_facts);
        return {true, places <= 100'000 ? "" : "it is drawn through too many places."};
    } catch (const InputError& fault) {
        const std::string said = fault.what();
        return {false, problem_of_refusal(said, said.starts_with("x:"))};
    }
}

const std::vector<std::string> figure_words{
    "<",       ">",      "/>",       "</g>",      "<g>",   "\"",   "'",
    "&",       "&lt;",   "<!--",     "-->",       "<?xml", "<!",   "<text x='0' y='0'>",
    "<tspan>", "class=", "1e9",      "-1",        "nan",   "M",    "Z",
    ";",       "(",      "data-x1=", "data-if='", "soft",  "\x80", "<defs>",
    "<style>"};

// Changes

const std::vector<std::string> binary_words{std::string(1, '\0'),
                                            std::string(4, '\0'),
                                            "\xff",
                                            "\xff\xff",
                                            "\xff\xff\xff\xff",
                                            "\x7f\xff\xff\xff",
                                            "\x80",
                                            "\1",
                                            std::string("\0\1", 2),
                                            "\x10"};

std::vector<std::string> with_binary_words(std::vector<std::string> words) {
    words.insert(words.end(), binary_words.begin(), binary_words.end());
    return words;
}

const std::vector<std::string> number_words{
    "0", "-1", "+", ".", "#", "\n", " ", "65536", "4097", "99999999999", "1e999", "nan", "\x80"};

const std::vector<std::string> model_words{
    "nan",     "-inf",    "1e999", "0",    "-1",  "4294967297", "9223372036854775808",
    "/",       "//",      "\\",    "\\\n", "#",   "f ",         "v ",
    "mtllib ", "usemtl ", "\n",    "\r",   "g ",  "1/1/1",      "\x80",
    "1e-50",   "#MRGB 7", "+",     "-",    "1e9", " ",          "\t"};

const std::vector<std::string> material_words{
    "newmtl ", "usemtl ", "Kd ",   "Ks ",   "d ",    "Tr ",   "Ns ",     "map_Kd ",
    "map_d ",  "bump ",   "disp ", "norm ", "p.png", "-bm ",  "-o 1 2 ", "-s ",
    "\"",      "'",       "#",     "..",    "/",     "\\",    "\n",      "\r",
    "1e99",    "nan",     "-1",    "2",     "\x80",  "m.obj", "m.mtl\n"};

const std::vector<std::string> scene_words{
    "[", "]",          "[[",  "{",     "}",       "\"",   "\"\"\"", "=",          "\n",
    "#", "nan",        "inf", "1e999", "-1",      "0",    "1e7",    ",",          "A",
    "p", "texture = ", "a.b", "'",     "\\u0000", "true", "0x10",   "1979-05-27", "\x80"};

} // namespace

std::vector<ChangedFormat> changed_formats() {
    const std::string samples = std::string("\0\1\5\17\11\14\3\7\2\16\10\13", 12);
    std::vector<std::string> models = model_seeds();
    models.push_back(painted_model);
    return {
        {"PNG", png_seeds(), with_binary_words({"IHDR", "PLTE", "tRNS", "IDAT", "IEND", "CgBI"}),
         picture_outcome},
        {"JPG",
         {jpeg(20, 12, 60, ramp(20, 12)), jpeg(9, 9, 95, ramp(9, 9)), progressive_jpeg()},
         with_binary_words({"\xff\xd8", "\xff\xd9", "\xff\xda", "\xff\xc4", "\xff\xc0", "\xff\xc2",
                            "\xff\xdb", "\xff\xdd", "\xff\xd0", "\xff\xfe"}),
         picture_outcome},
        {"TGA", tga_seeds(), binary_words, picture_outcome},
        {"BMP", bmp_seeds(), binary_words, picture_outcome},
        {"PPM",
         {"P6 2 2 15\n" + samples, "P6\r\n# a\r\n2 1\r\n65535\r\n" + samples,
          "P3\n# by hand\n2 2\n15\n0 1 5  15 9 12\n3 7 2 # two\n14 8 11\n"},
         number_words,
         picture_outcome},
        {"PGM",
         {"P5\n4 3\n255\n" + samples, "P2 2\t2\r\n15\n0 1 5 15"},
         number_words,
         picture_outcome},
        {"OBJ", models, model_words, model_outcome},
        {"MTL", {materials}, material_words, material_outcome},
        {"scene", {scene_seed}, scene_words, scene_outcome},
        {"figure", {figure_seed}, figure_words, figure_outcome},
    };
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
    const std::string image = changed_formats().front().seeds.front();
    folder.write("m/p.png", image);
    folder.write("m/changed/p.png", image);
    folder.write("m/m.mtl", materials);
}

} // namespace rasterwalk::test
