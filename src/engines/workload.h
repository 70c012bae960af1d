#pragma once

// The workloads that engines are measured with. All of them, and the peer in its own program, get
// their scene, camera and lamp here.

#include <array>
#include <cstdint>
#include <string_view>

#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

enum class Workload : std::uint8_t {
    w1, ///< few large triangles: the lab's room, light per pixel
    w2, ///< many small ones: the knot, light per pixel
    w3, ///< the knot, light per vertex
};

inline constexpr int workload_count = static_cast<int>(enum_words<Workload>.size());

struct WorkloadInfo {
    Workload workload;
    std::string_view title;
};

/// All workloads, indexed by Workload.
inline constexpr std::array<WorkloadInfo, workload_count> workload_list{{
    {Workload::w1, "lit room of 30 triangles, light per pixel"},
    {Workload::w2, "knot of 200,000 triangles, light per pixel"},
    {Workload::w3, "knot of 200,000 triangles, light per vertex"},
}};
static_assert(is_indexed_by(workload_list, &WorkloadInfo::workload));

/// The most threads that are measured.
inline constexpr int most_threads = 2;

/// The scene of a workload.
/// @param room the lab's room, which is a file; its lamp is made bright enough to be seen
Scene workload_scene(Workload workload, const Scene& room);

/// The settings it is drawn with: the camera's focal length is the height of the picture, and a
/// pixel belongs to the triangle that covers its centre, as in OpenGL.
Settings workload_settings(Workload workload, const Scene& scene, Viewport size);

/// Where the lamp is in one picture of a series. It moves a little from each picture to the
/// next, so that no engine can reuse anything of the last one.
/// @param at     where it is in picture 0, world units
/// @param number of the picture, from 0
glm::vec3 lamp_in_picture(const glm::vec3& at, int number);

} // namespace rasterwalk
