// Draws the room at every stage, by several rules and from several places, and prints a hash of
// each picture. The numbers must not depend on the compiler, its flags or the processor.

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"

namespace {

using namespace rasterwalk;

/// FNV-1a over the added bytes.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325u;

    template <class T>
    void add(const std::vector<T>& plane) {
        std::vector<unsigned char> bytes(plane.size() * sizeof(T));
        std::memcpy(bytes.data(), plane.data(), bytes.size());
        for (const unsigned char byte : bytes)
            value = (value ^ byte) * 0x100000001b3u;
    }
};

/// A way of drawing: the lab's rules with some of them changed.
struct Rules {
    const char* name;
    void (*change)(Settings&);
};

/// A place to draw from.
struct Pose {
    const char* name;
    int size; ///< of both sides of the picture; the focal length follows
    glm::vec3 position;
    float yaw, pitch;
};

constexpr std::array<Rules, 4> all_rules{{
    {"handout", [](Settings&) {}},
    {"exact",
     [](Settings& settings) {
         set_rounding(settings, Rounding::floor);
         settings.line_walk = LineWalk::exact;
     }},
    {"multiply-affine",
     [](Settings& settings) {
         set_rounding(settings, Rounding::round);
         settings.line_walk = LineWalk::multiply;
         settings.interpolation = Interpolation::affine;
     }},
    {"linear-z",
     [](Settings& settings) {
         settings.depth_test = DepthTest::linear_z;
         settings.edge_samples = EdgeSamples::rows;
         settings.light.power = glm::vec3(14.0f);
     }},
}};

constexpr std::array<Pose, 4> all_poses{{
    {"front", 500, {0.0f, 0.0f, -3.001f}, 0.0f, 0.0f},
    {"from-the-left", 160, {-1.3f, 0.2f, -2.7f}, 0.45f, 0.0f},
    {"from-above", 160, {0.3f, -1.1f, -2.9f}, -0.1f, 0.4f},
    {"within", 160, {0.1f, 0.05f, -0.9f}, 0.7f, -0.2f},
}};

void print_hash(const Scene& scene, const Rules& rules, const Pose& pose, const StageInfo& stage) {
    Settings settings = default_settings(scene);
    set_step(settings, stage.step);
    settings.viewport = {pose.size, pose.size};
    settings.camera = {pose.position, pose.yaw, pose.pitch, static_cast<float>(pose.size)};
    rules.change(settings);
    const Frame frame = prepare_frame(scene, settings);
    const Framebuffer framebuffer = draw_frame(frame);
    Hash hash;
    hash.add(framebuffer.colour);
    hash.add(framebuffer.depth);
    hash.add(framebuffer.owner);
    hash.add(framebuffer.overdraw);
    hash.add(view_image(framebuffer, View::colour).rgba);
    hash.add(view_image(framebuffer, View::depth).rgba);
    std::printf("%-15s %-13s %-12s %016llx\n", rules.name, pose.name,
                std::string(stage.name).c_str(), static_cast<unsigned long long>(hash.value));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: hash_pictures SCENE\n", stderr);
        return 2;
    }
    try {
        const Scene scene = read_scene(argv[1]);
        for (const Rules& rules : all_rules) {
            for (const Pose& pose : all_poses) {
                for (const StageInfo& stage : stage_list())
                    print_hash(scene, rules, pose, stage);
            }
        }
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "%s\n", fault.what());
        return 1;
    }
    return 0;
}
