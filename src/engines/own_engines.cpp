#include "engines/own_engines.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engines/student_loop.h"
#include "engines/workload.h"
#include "pipeline/draw.h"
#include "stages/put_pixel.h"

namespace rasterwalk {

namespace {

/// Places the lamp, and times the engine's work after that.
class OwnEngine : public TimedEngine {
  public:
    explicit OwnEngine(const Settings& settings)
        : settings_(settings), lamp_(settings.light.position) {}

    Milliseconds time_pictures(int first, int count) final {
        const Milliseconds begin = milliseconds_now();
        for (int i = 0; i < count; ++i)
            draw_number(first + i);
        return milliseconds_since(begin);
    }

    EnginePicture picture(int number) final {
        draw_number(number);
        return {settings_.viewport, colours()};
    }

  protected:
    virtual void draw(const Settings& settings) = 0;
    /// Of the last picture, 0x00RRGGBB.
    virtual std::vector<std::uint32_t> colours() const = 0;

  private:
    void draw_number(int number) {
        settings_.light.position = lamp_in_picture(lamp_, number);
        draw(settings_);
    }

    Settings settings_;
    glm::vec3 lamp_;
};

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
    void draw(const Settings& settings) override { draw_as_student(scene_, settings, picture_); }
    std::vector<std::uint32_t> colours() const override { return picture_.colour; }

    const Scene& scene_;
    StudentPicture picture_;
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
