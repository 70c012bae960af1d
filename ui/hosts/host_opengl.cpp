#include "ui/hosts/host_opengl.h"

#include "base/error.h"
#include "engines/opengl_task.h"

namespace rasterwalk {

namespace {

/// A context that is current for a while.
class Entered {
  public:
    explicit Entered(OpenGlContext& context) : context_(context) { context_.enter(); }
    ~Entered() { context_.leave(); }
    Entered(const Entered&) = delete;
    Entered& operator=(const Entered&) = delete;

  private:
    OpenGlContext& context_;
};

} // namespace

HostOpenGl::~HostOpenGl() {
    if (drawing_ == nullptr) return;
    const Entered entered(*context_);
    drawing_.reset();
}

/// Makes the context, if there is none yet.
void HostOpenGl::start() const {
    if (drawing_ != nullptr) return;
    try {
        context_ = make_opengl_context();
        const Entered entered(*context_);
        drawing_ = std::make_unique<OpenGlDrawing>();
    } catch (const AccessError& fault) {
        refusal_ = fault.what();
        if (refusal_.ends_with('.')) refusal_.pop_back();
        throw;
    }
}

std::string HostOpenGl::name() const {
    start();
    return drawing_->name();
}

void HostOpenGl::draw(const Scene& scene, const Settings& settings, FastPicture& picture) {
    start();
    const Entered entered(*context_);
    drawing_->draw(opengl_task(scene, settings), picture);
}

} // namespace rasterwalk
