// Model files that are cut off, or made of junk: they are read or refused, and what comes out is
// sound. test_changed_files.cpp changes them at random.

#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/read_obj.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/sound_model.h"

using namespace rasterwalk;

TEST_CASE("A model cut off at any byte is read or refused") {
    for (const std::string& seed : test::model_seeds()) {
        for (std::size_t length = 0; length < seed.size(); ++length) {
            INFO(length);
            try {
                const ObjModel model = parse_obj(seed.substr(0, length), "m.obj");
                CHECK(test::problem_of_model(model) == "");
            } catch (const InputError& error) {
                CHECK(test::has_line(error.what(), "m.obj"));
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
            CHECK(test::has_line(sentence, "m.obj"));
            CHECK(sentence.size() < 400);
        }
    }
}

TEST_CASE("A fan of many faces around one point is not compared pair by pair") {
    // Without the limit each corner would be compared with all others, 4 x 10^8 times.
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
    CHECK(test::problem_of_model(model) == "");
}
