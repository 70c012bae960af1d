#pragma once

// Which variables a program has, and what they hold: in a variable of a usual name, or in a member
// of a usual object. A reader is a struct whose read() adds numbers to the list, or says no.

#include <iterator>
#include <type_traits>

#include "asking_extras.h"
#include "asking_names.h"
#include "asking_questions.h"
#include "asking_values.h"

namespace rasterwalk_kit {

struct ReadThree {
    template <class Type>
    static bool read(const Type& value, NumberList& list) {
        if constexpr (Spatial<Type>) {
            list.add_three(value.x, value.y, value.z);
            return true;
        } else if constexpr (std::is_array_v<Type> && Number<std::remove_extent_t<Type>>) {
            if constexpr (std::extent_v<Type> >= 3) {
                list.add_three(value[0], value[1], value[2]);
                return true;
            }
        }
        return false;
    }
};

struct ReadOne {
    template <class Type>
    static bool read(const Type& value, NumberList& list) {
        if constexpr (Number<Type>) {
            list.add(static_cast<double>(value));
            return true;
        }
        return false;
    }
};

struct ReadThreeOrOne {
    template <class Type>
    static bool read(const Type& value, NumberList& list) {
        return ReadThree::read(value, list) || ReadOne::read(value, list);
    }
};

struct ReadMatrix {
    template <class Type>
    static bool read(const Type& value, NumberList& list) {
        if constexpr (Matrix<Type>) {
            for (int column = 0; column < 3; ++column) {
                ReadThree::read(value[column], list);
            }
            return true;
        }
        return false;
    }
};

/// Triangles in anything that a loop goes over.
struct ReadTriangles {
    template <class Type>
    static bool read(const Type& value, NumberList& list) {
        if constexpr (requires {
                          requires TriangleLike<std::remove_cvref_t<decltype(*std::begin(value))>>;
                      }) {
            std::size_t room = most_listed;
            for (const auto& triangle : value) {
                if (room-- == 0) break;
                ReadThree::read(triangle.v0, list);
                ReadThree::read(triangle.v1, list);
                ReadThree::read(triangle.v2, list);
                if constexpr (Found<decltype(normal_in(triangle))>) {
                    ReadThree::read(*normal_in(triangle), list);
                } else {
                    list.add_three(0.0, 0.0, 0.0);
                }
                const auto colour = three_of(*colour_in(triangle));
                list.add_three(colour[0], colour[1], colour[2]);
            }
            return true;
        }
        return false;
    }
};

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the name of a member cannot be a parameter.
#define RASTERWALK_READ_MEMBER(member, Reader)                                                     \
    if constexpr (requires { object.member; }) {                                                   \
        if (Reader::read(object.member, list)) return true;                                        \
    }

struct ReadPosition {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        if constexpr (std::is_class_v<Object> && !Vector<Object>) {
            if constexpr (Found<decltype(position_in(object))>) {
                return ReadThree::read(*position_in(object), list);
            }
        }
        return false;
    }
};

struct ReadCameraRotation {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(R, ReadMatrix)
        RASTERWALK_READ_MEMBER(rotation, ReadMatrix)
        RASTERWALK_READ_MEMBER(rot, ReadMatrix)
        RASTERWALK_READ_MEMBER(cameraRot, ReadMatrix)
        RASTERWALK_READ_MEMBER(orientation, ReadMatrix)
        return false;
    }
};

struct ReadCameraYaw {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(yaw, ReadOne)
        RASTERWALK_READ_MEMBER(angle, ReadOne)
        RASTERWALK_READ_MEMBER(rotation.y, ReadOne)
        return false;
    }
};

struct ReadCameraFocalLength {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(focalLength, ReadOne)
        RASTERWALK_READ_MEMBER(focal_length, ReadOne)
        RASTERWALK_READ_MEMBER(FocalLength, ReadOne)
        RASTERWALK_READ_MEMBER(focal, ReadOne)
        RASTERWALK_READ_MEMBER(f, ReadOne)
        return false;
    }
};

struct ReadLightPower {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(power, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(lightPower, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(intensity, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(color, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(colour, ReadThreeOrOne)
        return false;
    }
};

struct ReadLightIndirect {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(indirect, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(indirectPower, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(indirectLight, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(indirectLightPowerPerArea, ReadThreeOrOne)
        RASTERWALK_READ_MEMBER(ambient, ReadThreeOrOne)
        return false;
    }
};

/// The camera, if an object holds more than that.
struct ReadSceneEye {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(cameraPos, ReadThree)
        RASTERWALK_READ_MEMBER(camera, ReadThree)
        RASTERWALK_READ_MEMBER(eye, ReadThree)
        return false;
    }
};

/// And the lamp.
struct ReadSceneLamp {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(lightPos, ReadThree)
        RASTERWALK_READ_MEMBER(light, ReadThree)
        RASTERWALK_READ_MEMBER(lamp, ReadThree)
        return false;
    }
};

struct ReadSceneTriangles {
    template <class Object>
    static bool read(const Object& object, NumberList& list) {
        RASTERWALK_READ_MEMBER(triangles, ReadTriangles)
        RASTERWALK_READ_MEMBER(model, ReadTriangles)
        return false;
    }
};

#undef RASTERWALK_READ_MEMBER

/// Reads what a variable, or the pointer in it, holds.
template <class Reader, class Value>
bool read_behind(Value& variable, NumberList& list) {
    auto* const value = behind(variable);
    using Type = std::remove_pointer_t<std::remove_const_t<decltype(value)>>;
    if constexpr (std::is_object_v<Type>) {
        return value != nullptr && Reader::read(*value, list);
    } else {
        return false;
    }
}

template <class Reader, class... Seen>
bool read_first(List<Seen...>, NumberList& list) {
    return (read_behind<Reader>(Seen::value(), list) || ...);
}

/// Reads the first variable of these names that can be read so.
template <class Names, class Reader>
bool read_names(NumberList& list) {
    return read_first<Reader>(Values<Names>{}, list);
}

template <class Names, class Reader, class Objects, class MemberReader>
void read_global(NumberList& list, Global global) {
    list.begin(global);
    list.end(read_names<Names, Reader>(list) || read_names<Objects, MemberReader>(list));
}

/// A position in a variable, in an object that has nothing but that position, or in a scene.
template <class Program, class Names, class Objects, class SceneReader>
void read_position(NumberList& list, Global global) {
    list.begin(global);
    list.end(read_names<Names, ReadThree>(list) || read_names<Objects, ReadPosition>(list) ||
             read_names<typename Program::Scenes, SceneReader>(list));
}

/// The variables that a program has, as part_globals lists them.
template <class Program>
void list_variables(NumberList& list) {
    using Cameras = typename Program::Cameras;
    using Lights = typename Program::Lights;
    read_position<Program, typename Program::CameraPositions, Cameras, ReadSceneEye>(list,
                                                                                     global_camera);
    read_global<typename Program::Rotations, ReadMatrix, Cameras, ReadCameraRotation>(
        list, global_rotation);
    read_global<typename Program::Yaws, ReadOne, Joined<Cameras, typename Program::Scenes>,
                ReadCameraYaw>(list, global_yaw);
    read_global<typename Program::FocalLengths, ReadOne, Cameras, ReadCameraFocalLength>(
        list, global_focal_length);
    read_position<Program, typename Program::LightPositions, Lights, ReadSceneLamp>(
        list, global_light_position);
    read_global<typename Program::LightPowers, ReadThreeOrOne, Lights, ReadLightPower>(
        list, global_light_power);
    read_global<typename Program::Indirects, ReadThreeOrOne, Lights, ReadLightIndirect>(
        list, global_indirect);
    list.begin(global_screen);
    list.end(read_names<typename Program::Widths, ReadOne>(list) &&
             read_names<typename Program::Heights, ReadOne>(list));
    read_global<typename Program::Triangles, ReadTriangles, typename Program::Scenes,
                ReadSceneTriangles>(list, global_triangles);
}

/// Sets a variable that holds three numbers and may be changed.
template <class Value>
void set_if_three(Value& variable, const double* numbers) {
    if constexpr (Spatial<Value> && !std::is_const_v<Value>) {
        set_three(variable, numbers);
    }
}

template <class... Seen>
void set_all(List<Seen...>, const double* numbers) {
    (set_if_three(Seen::value(), numbers), ...);
}

/// Gives the program the surface that it is about to draw, if it keeps that in variables.
template <class Program>
void set_surface(const Surface& surface) {
    set_all(Values<typename Program::CurrentNormals>{}, surface.normal);
    set_all(Values<typename Program::CurrentColours>{}, surface.colour);
}

template <class Buffer>
void clear_buffer(Buffer& buffer, double depth) {
    if constexpr (Number<Buffer>) {
        buffer = static_cast<Buffer>(depth);
    } else if constexpr (requires { *std::begin(buffer); }) {
        for (auto& inner : buffer)
            clear_buffer(inner, depth);
    }
}

template <class Buffer>
void find_greatest(const Buffer& buffer, double& greatest) {
    if constexpr (Number<Buffer>) {
        if (buffer > greatest) greatest = static_cast<double>(buffer);
    } else if constexpr (requires { *std::begin(buffer); }) {
        for (const auto& inner : buffer)
            find_greatest(inner, greatest);
    }
}

/// A variable that is a depth buffer, not a single depth.
template <class Seen>
constexpr bool is_depth_buffer() {
    using Buffer = std::remove_reference_t<decltype(Seen::value())>;
    return !std::is_const_v<Buffer> && (std::is_array_v<Buffer> || std::is_class_v<Buffer>);
}

template <class... Seen>
constexpr Joined<std::conditional_t<is_depth_buffer<Seen>(), List<Seen>, List<>>...>
depth_buffers(List<Seen...>) {
    return {};
}

template <class... Seen>
void clear_all(List<Seen...>, double depth) {
    (clear_buffer(Seen::value(), depth), ...);
}

template <class Program>
void clear_depth(double depth) {
    clear_all(decltype(depth_buffers(Values<typename Program::DepthBuffers>{})){}, depth);
}

template <class... Seen>
double greatest_in(List<Seen...>) {
    double greatest = 0.0;
    (find_greatest(Seen::value(), greatest), ...);
    return greatest;
}

/// The greatest number in the program's depth buffers, at least 0.
template <class Program>
double greatest_depth() {
    return greatest_in(decltype(depth_buffers(Values<typename Program::DepthBuffers>{})){});
}

} // namespace rasterwalk_kit
