#include "mine/key_runs.h"

#include "support/catch.h"

using namespace rasterwalk;

TEST_CASE("The keys of a source are those that it names, each once, in order") {
    const std::string source = R"(
        if (keystate[SDLK_UP]) cameraPos.z += 0.1f;
        if (keystate[ SDLK_w ]||keystate[SDLK_UP]) light.z += 0.1f;
        else if (keys[SDL_SCANCODE_W] || keys[SDL_SCANCODE_PAGEDOWN]) light.y += 0.1f;
        switch (event.key.keysym.sym) { case SDLK_SPACE: case SDLK_5: reset(); }
    )";
    const std::vector<ProgramKey> keys = keys_in(source);
    // What SDL's headers say: a scancode with bit 30, or the character.
    CHECK(
        keys ==
        std::vector<ProgramKey>{
            {"UP", 0x40000052}, {"w", 'w'}, {"PAGEDOWN", 0x4000004e}, {"SPACE", ' '}, {"5", '5'}});
}

TEST_CASE("A letter has the code of its small letter, as in SDL") {
    CHECK(keys_in("SDL_SCANCODE_Q") == std::vector<ProgramKey>{{"Q", 'q'}});
    CHECK(keys_in("SDLK_q") == std::vector<ProgramKey>{{"q", 'q'}});
}

TEST_CASE("Comments and strings name no keys") {
    CHECK(keys_in("// SDLK_UP\n/* SDLK_LEFT\n SDLK_RIGHT */ x = \"SDLK_DOWN\";").empty());
    CHECK(keys_in("/* SDLK_UP */ SDLK_LEFT").size() == 1);
}

TEST_CASE("Longer names that contain a key are none") {
    CHECK(keys_in("MY_SDLK_x").empty());
    CHECK(keys_in("XSDLK_UP").empty());
    CHECK(keys_in("SDLK_UPPER").empty());
    CHECK(keys_in("SDLK_").empty());
    CHECK(keys_in("SDL_SCANCODE_").empty());
    CHECK(keys_in("SDL_PollEvent(&event); SDL_Delay(3); SDL").empty());
}

TEST_CASE("Escape is left out, because it ends programs") {
    CHECK(keys_in("case SDLK_ESCAPE: return false; case SDL_SCANCODE_ESCAPE:").empty());
}

TEST_CASE("A key at the end of the source is found") {
    CHECK(keys_in("SDLK_LEFT") == std::vector<ProgramKey>{{"LEFT", 0x40000050}});
    CHECK(keys_in("").empty());
}
