#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engines/llvmpipe_peer.h"
#include "engines/timed_engine.h"
#include "scene/scene.h"
#include "ui/hosts/opengl_context.h"

namespace rasterwalk {

/// The workload of a task, drawn by llvmpipe into memory: vertices in one buffer,
/// light by shaders of GLSL 1.30, a depth buffer of 24 bits, nothing culled. Only one at a time,
/// because the environment sets how many threads llvmpipe has. Throws AccessError.
class LlvmpipeDrawing final : public TimedEngine {
  public:
    /// @param scene of the task
    LlvmpipeDrawing(const PeerTask& task, const Scene& scene);
    ~LlvmpipeDrawing() override;

    /// The renderer: "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string name() const;

    Milliseconds time_pictures(int first, int count) override;
    EnginePicture picture(int number) override;

  private:
    void draw(int number);

    Viewport size_;
    Settings settings_;
    std::unique_ptr<OpenGlContext> context_;
    int indices_ = 0; ///< three for each triangle
    int lamp_ = -1;   ///< where the shaders take its position
};

} // namespace rasterwalk
