#include "engines/own_engines.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engines/ladder/rungs.h"
#include "engines/own_engine.h"
#include "pipeline/draw.h"
#include "stages/put_pixel.h"

namespace rasterwalk {

namespace {

class StepsEngine final : public OwnEngine {
  public:
    StepsEngine(const Scene& scene, const Settings& settings)
        : OwnEngine(settings), scene_(scene) {}

  private:
    void draw(const Settings& settings) override {
        prepare_frame(scene_, settings, nullptr, frame_);
        clear(framebuffer_, frame_);
        rasterwalk::draw(frame_, {}, framebuffer_);
    }

    std::vector<std::uint32_t> colours() const override {
        std::vector<std::uint32_t> result;
        result.reserve(framebuffer_.colour.size());
        const auto byte = [](float channel) { return std::uint32_t{to_byte(channel)}; };
        for (const glm::vec3& colour : framebuffer_.colour)
            result.push_back(byte(colour.r) << 16 | byte(colour.g) << 8 | byte(colour.b));
        return result;
    }

    const Scene& scene_;
    Frame frame_;
    Framebuffer framebuffer_;
};

class StudentEngine final : public OwnEngine {
  public:
    StudentEngine(const Scene& scene, const Settings& settings)
        : OwnEngine(settings), scene_(scene) {}

  private:
    void draw(const Settings& settings) override {
        rungs::lab_loop::draw(scene_, settings, picture_);
    }
    std::vector<std::uint32_t> colours() const override { return picture_.colour; }

    const Scene& scene_;
    LadderPicture picture_;
};

class FastDrawing final : public OwnEngine {
  public:
    FastDrawing(const Scene& scene, const Settings& settings, const FastOptions& options)
        : OwnEngine(settings), engine_(scene, options) {}

  private:
    void draw(const Settings& settings) override { engine_.draw(settings, picture_); }

    std::vector<std::uint32_t> colours() const override {
        std::vector<std::uint32_t> result;
        for (int row = 0; row < picture_.size.height; ++row) {
            const auto begin =
                picture_.colour.begin() + static_cast<std::ptrdiff_t>(picture_.at(0, row));
            result.insert(result.end(), begin, begin + picture_.size.width);
        }
        return result;
    }

    FastEngine engine_;
    FastPicture picture_;
};

} // namespace

std::unique_ptr<TimedEngine> steps_engine(const Scene& scene, const Settings& settings) {
    return std::make_unique<StepsEngine>(scene, settings);
}

std::unique_ptr<TimedEngine> student_engine(const Scene& scene, const Settings& settings) {
    return std::make_unique<StudentEngine>(scene, settings);
}

std::unique_ptr<TimedEngine> fast_engine(const Scene& scene, const Settings& settings,
                                         SimdLevel level, int threads) {
    FastOptions options;
    options.level = level;
    options.threads = threads;
    options.keeps_planes = false;
    return std::make_unique<FastDrawing>(scene, settings, options);
}

} // namespace rasterwalk
