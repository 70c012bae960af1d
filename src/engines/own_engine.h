#pragma once

#include <cstdint>
#include <vector>

#include "engines/timed_engine.h"
#include "engines/workload.h"
#include "settings/settings.h"

namespace rasterwalk {

/// An engine of this program: places the lamp, and times the engine's work after that.
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

} // namespace rasterwalk
