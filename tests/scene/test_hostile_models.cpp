// Model files that nobody wrote: small ones changed at random, cut off, and made of junk. Whatever
// they are, they are read or refused, and what comes out is sound.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "base/error.h"
#include "base/faults.h"
#include "base/limits.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random.h"

using namespace rasterwalk;

namespace {

const std::vector<std::string> model_seeds{
    "# a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\ng a\nf 1/1/1 2/2/1 3/1/1 "
    "4/2/1\n",
    "\xef\xbb\xbfo caf\xe9\r\nv +.5 -1e-3 2\r\nv 1 2 3 \\\r\n\r\nv -1 0 1\r\nv .1 .2 .3\r\nv 9 8 "
    "7\r\n"
    "usemtl m\r\ns off\r\nf -5 -4 -3 -2 -1\r\nf -1//-1 1/ 2//\r\n",
    "mtllib . /dev/zero x.mtl\nv 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nv 1 .5 0\nv 0 0 9\nf 1 2 3 4 5 "
    "6\n"
    "f 6 5 4 3 2 1 2 3\nl 1 2\ncurv 0 1 1 2\n",
    "v 9e8 0 0 255 0 0\n#MRGB ffff0000ff00ff00\nv 9e8 1 0 1 0 .5 1\nv 9e8 0 -1 0 300 -1\nvt "
    "nan\nvt .5\n"
    "vn nan 0 0\nf 1/1/1 2/9/9 3/0/0\nf 1/2/-1 2/x/ 3//1/1\n",
};

/// Words at which readers stumble.
const std::vector<std::string> stumbling_words{
    "nan",     "-inf",    "1e999", "0",    "-1",  "4294967297", "9223372036854775808",
    "/",       "//",      "\\",    "\\\n", "#",   "f ",         "v ",
    "mtllib ", "usemtl ", "\n",    "\r",   "g ",  "1/1/1",      "\x80",
    "1e-50",   "#MRGB 7", "+",     "-",    "1e9", " ",          "\t"};

std::string changed_text(test::Random& random) {
    const auto pick = [&](const std::vector<std::string>& list) {
        return list[static_cast<std::size_t>(random.integer(0, static_cast<int>(list.size()) - 1))];
    };
    std::string text = pick(model_seeds);
    for (int n = random.integer(1, 6); n > 0 && !text.empty(); --n) {
        const auto place =
            static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
        switch (random.integer(0, 5)) {
        case 0:
            text[place] = static_cast<char>(random.integer(0, 255));
            break;
        case 1:
            text.insert(place, pick(stumbling_words));
            break;
        case 2:
            text.erase(place, static_cast<std::size_t>(random.integer(1, 9)));
            break;
        case 3:
            text.insert(place, text.substr(place, static_cast<std::size_t>(random.integer(1, 40))));
            break;
        case 4:
            text.resize(place);
            break;
        default:
            text += pick(model_seeds);
        }
    }
    return text;
}

/// What every model that was read keeps to.
void check_sound(const ObjModel& model) {
    const ObjCounts& counts = model.report.counts;
    REQUIRE(model.mesh.triangle_count() > 0);
    CHECK(counts.triangles == model.mesh.triangle_count());
    CHECK(counts.triangles == counts.corners - 2 * counts.faces);
    CHECK(counts.vertices <= counts.corners);
    CHECK(counts.faults >= static_cast<std::int64_t>(model.report.faults.size()));
    int next = 0;
    for (const ObjPart& part : model.parts) {
        CHECK(part.first_triangle == next);
        CHECK(part.triangle_count > 0);
        next += part.triangle_count;
    }
    CHECK(next == model.mesh.triangle_count());
    for (const ObjFault& fault : model.report.faults) {
        CHECK(fault.line >= 1);
        CHECK(fault.line <= counts.lines);
        CHECK(fault.sentence.ends_with('.'));
    }
    const Scene scene = scene_of_model(model);
    for (const Vertex& vertex : scene.mesh.vertices()) {
        const bool is_colour = vertex.reflectance == glm::clamp(vertex.reflectance, 0.0f, 1.0f);
        CHECK(is_colour);
        const bool is_within = std::abs(vertex.position.x) <= 1.001f &&
                               std::abs(vertex.position.y) <= 1.001f &&
                               std::abs(vertex.position.z) <= 1.001f;
        const float length =
            std::sqrt(vertex.normal.x * vertex.normal.x + vertex.normal.y * vertex.normal.y +
                      vertex.normal.z * vertex.normal.z);
        const bool is_unit = length == 0.0f || std::abs(length - 1.0f) < 1e-5f;
        CHECK(is_within);
        CHECK(is_unit);
    }
    CHECK(std::isfinite(scene.camera.position.z));
    CHECK(std::abs(scene.camera.position.z) < largest_place);
}

/// "m.obj:7: ..." for what is refused.
bool has_line(const std::string& sentence) {
    return sentence.starts_with("m.obj:") && sentence.find(": ", 6) != sentence.npos;
}

} // namespace

TEST_CASE("Models changed at random are read or refused, and what is read is sound") {
    test::Random random(303);
    int read = 0, refused = 0;
    const int count = test::rounds(2000, 100);
    for (int i = 0; i < count; ++i) {
        const std::string text = changed_text(random);
        INFO("round " << i << ":\n" << text);
        try {
            check_sound(parse_obj(text, "m.obj"));
            ++read;
        } catch (const InputError& error) {
            CHECK(has_line(error.what()));
            ++refused;
        }
    }
    CHECK(read > count / 4);
    CHECK(refused > count / 50);
}

TEST_CASE("A model cut off at any byte is read or refused") {
    for (const std::string& seed : model_seeds) {
        for (std::size_t length = 0; length < seed.size(); ++length) {
            INFO(length);
            try {
                check_sound(parse_obj(seed.substr(0, length), "m.obj"));
            } catch (const InputError& error) {
                CHECK(has_line(error.what()));
            }
        }
    }
}

TEST_CASE("Large junk is refused in a sentence, whatever it is made of") {
    const auto size = static_cast<std::size_t>(test::rounds(1 << 18, 1 << 14));
    for (const std::string& piece : std::vector<std::string>{
             "x", "\n", "x\n", "\\\n", "f\n", "f 1 1 1\n", "f 1", "v 1 2\n", "a b c d ", "/",
             std::string(1, '\0'), "\xff", "o x\n", "g\nusemtl y\n", "#", "1 "}) {
        INFO(piece);
        std::string junk;
        junk.reserve(size + piece.size());
        while (junk.size() < size)
            junk += piece;
        try {
            parse_obj(junk, "m.obj");
            FAIL_CHECK("junk was read as a model");
        } catch (const InputError& error) {
            const std::string sentence = error.what();
            CHECK(has_line(sentence));
            CHECK(sentence.size() < 400);
        }
    }
}

TEST_CASE("A fan of many faces round one point is not compared pair by pair") {
    // Without the limit each corner would ask all others: 4 x 10^8 questions.
    constexpr int count = 20000;
    std::string text = "v 0 0 1\n";
    for (int i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count;
        text +=
            "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    }
    for (int i = 0; i < count; ++i) {
        text += "f 1 " + std::to_string(i + 2) + " " + std::to_string((i + 1) % count + 2) + "\n";
    }
    const ObjModel model = parse_obj(text, "m.obj");
    CHECK(model.mesh.triangle_count() == count);
    check_sound(model);
}
