#pragma once

#include <memory>
#include <string>

#include "engines/opengl_engine.h"
#include "ui/hosts/opengl_context.h"
#include "ui/hosts/opengl_drawing.h"

namespace rasterwalk {

/// OpenGL in this program, in a context that is made for the first picture. To be used by the
/// thread that the host's interface runs on.
class HostOpenGl final : public OpenGlEngine {
  public:
    HostOpenGl() = default;
    ~HostOpenGl() override;
    HostOpenGl(const HostOpenGl&) = delete;
    HostOpenGl& operator=(const HostOpenGl&) = delete;

    /// Makes the context. Throws AccessError.
    std::string name() const override;
    /// Why the context could not be made, once that has failed.
    std::string refusal() const override { return refusal_; }
    void draw(const Scene& scene, const Settings& settings, FastPicture& picture) override;

  private:
    void start() const;

    mutable std::unique_ptr<OpenGlContext> context_;
    mutable std::unique_ptr<OpenGlDrawing> drawing_;
    mutable std::string refusal_;
};

} // namespace rasterwalk
