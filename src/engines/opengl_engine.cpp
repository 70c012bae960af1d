#include "engines/opengl_engine.h"

#include "engines/fast/fast_view.h"

namespace rasterwalk {

namespace {

OpenGlEngine* engine_of_program = nullptr;

#ifdef __EMSCRIPTEN__
constexpr const char* none = "the browser's page has no OpenGL engine";
#else
constexpr const char* none = "this program has no OpenGL";
#endif

} // namespace

void set_opengl_engine(OpenGlEngine* engine) {
    engine_of_program = engine;
}

OpenGlEngine* opengl_engine() {
    return engine_of_program;
}

UsedOpenGl::UsedOpenGl(OpenGlEngine& engine) : previous_(opengl_engine()) {
    set_opengl_engine(&engine);
}

UsedOpenGl::~UsedOpenGl() {
    set_opengl_engine(previous_);
}

std::string opengl_refuses(const Scene& scene, const Settings& settings) {
    if (engine_of_program == nullptr) return none;
    std::string refusal = engine_of_program->refusal();
    if (!refusal.empty()) return refusal;
    if (settings.stage == Stage::points || settings.stage == Stage::rows)
        return "OpenGL does not support stages points and rows";
    return fixed_rules_refuse("OpenGL", scene, settings);
}

} // namespace rasterwalk
