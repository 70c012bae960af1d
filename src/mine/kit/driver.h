// Belongs behind the last line of the student's main source, outside all namespaces. It finds out
// which functions, variables and types of the lab the program has, and asks them after the first
// frame, or before main() if the task says so.
//
// A name that the program may lack is also declared in rasterwalk_missing. As ::name it is the
// student's if they have it, and ours otherwise: a qualified name looks into namespaces that are
// made visible only if the namespace itself has no such name. Ours become visible behind the
// student's code, where nothing of theirs can clash with them, and in the unnamed namespace, so
// that what the student declares there goes first as well.

#pragma once

#include <unistd.h>

#include "asking.h"
#include "driver_macros.h"

namespace rasterwalk_missing {}
namespace {
using namespace rasterwalk_missing; // NOLINT(google-build-using-namespace)
}

// NOLINTBEGIN(cppcoreguidelines-macro-usage): a name cannot be a parameter of anything else.

// What there is of a name, if it is one thing and not several functions.
#define RASTERWALK_LOOK(name)                                                                      \
    template <class Any>                                                                           \
    static constexpr auto look(Any any) {                                                          \
        if constexpr (requires { single<::name>(any); }) {                                         \
            return single<::name>(any);                                                            \
        } else {                                                                                   \
            return NotSingle{};                                                                    \
        }                                                                                          \
    }

// A name that can be looked at: a variable or a type.
#define RASTERWALK_NAME(name)                                                                      \
    namespace rasterwalk_missing {                                                                 \
    rasterwalk_kit::Later name(rasterwalk_kit::Later);                                             \
    }                                                                                              \
    namespace rasterwalk_kit {                                                                     \
    struct Name_##name {                                                                           \
        RASTERWALK_LOOK(name)                                                                      \
    };                                                                                             \
    }

// A constant, which may have been a macro.
#define RASTERWALK_CONSTANT(name)                                                                  \
    namespace rasterwalk_missing {                                                                 \
    rasterwalk_kit::Later name(rasterwalk_kit::Later);                                             \
    rasterwalk_kit::Later rasterwalk_value_##name(rasterwalk_kit::Later);                          \
    }                                                                                              \
    namespace rasterwalk_kit {                                                                     \
    struct Name_##name {                                                                           \
        template <class Any>                                                                       \
        static constexpr auto look(Any any) {                                                      \
            if constexpr (MacroValue<decltype(::rasterwalk_value_##name)>) {                       \
                return Macro<::rasterwalk_value_##name>{};                                         \
            } else if constexpr (requires { single<::name>(any); }) {                              \
                return single<::name>(any);                                                        \
            } else {                                                                               \
                return NotSingle{};                                                                \
            }                                                                                      \
        }                                                                                          \
    };                                                                                             \
    }

// A function.
#define RASTERWALK_FUNCTION(name)                                                                  \
    namespace rasterwalk_missing {                                                                 \
    rasterwalk_kit::Later name(rasterwalk_kit::Later);                                             \
    }                                                                                              \
    namespace rasterwalk_kit {                                                                     \
    struct Name_##name {                                                                           \
        RASTERWALK_LOOK(name)                                                                      \
        template <class... Arguments>                                                              \
        static auto call(Arguments&&... arguments)                                                 \
            -> decltype(::name(static_cast<Arguments&&>(arguments)...)) {                          \
            return ::name(static_cast<Arguments&&>(arguments)...);                                 \
        }                                                                                          \
        template <class Any>                                                                       \
        static constexpr bool is_missing(Any any) {                                                \
            return requires {                                                                      \
                { ::name(any) } -> std::same_as<Later>;                                            \
            };                                                                                     \
        }                                                                                          \
    };                                                                                             \
    }

RASTERWALK_FUNCTION(VertexShader)
RASTERWALK_FUNCTION(vertexShader)
RASTERWALK_FUNCTION(vertex_shader)
RASTERWALK_FUNCTION(Vertexshader)
RASTERWALK_FUNCTION(vertexshader)
RASTERWALK_FUNCTION(ProjectVertex)
RASTERWALK_FUNCTION(projectVertex)
RASTERWALK_FUNCTION(Interpolate)
RASTERWALK_FUNCTION(interpolate)
RASTERWALK_FUNCTION(InterpolatePixel)
RASTERWALK_FUNCTION(InterpolatePixels)
RASTERWALK_FUNCTION(interpolatePixel)
RASTERWALK_FUNCTION(interpolatePixels)
RASTERWALK_FUNCTION(interpolate_pixels)
RASTERWALK_FUNCTION(ComputePolygonRows)
RASTERWALK_FUNCTION(computePolygonRows)
RASTERWALK_FUNCTION(compute_polygon_rows)
RASTERWALK_FUNCTION(ComputeRows)
RASTERWALK_FUNCTION(computeRows)
RASTERWALK_FUNCTION(computepolygonrows)
RASTERWALK_FUNCTION(DrawPolygonRows)
RASTERWALK_FUNCTION(drawPolygonRows)
RASTERWALK_FUNCTION(draw_polygon_rows)
RASTERWALK_FUNCTION(DrawRows)
RASTERWALK_FUNCTION(drawRows)
RASTERWALK_FUNCTION(draw_rows)
RASTERWALK_FUNCTION(DrawPolygonRow)
RASTERWALK_FUNCTION(drawpolygonrows)
RASTERWALK_FUNCTION(PixelShader)
RASTERWALK_FUNCTION(pixelShader)
RASTERWALK_FUNCTION(pixel_shader)
RASTERWALK_FUNCTION(Pixelshader)
RASTERWALK_FUNCTION(pixelshader)
RASTERWALK_FUNCTION(project_vertex)
RASTERWALK_FUNCTION(polygonRows)
RASTERWALK_FUNCTION(PolygonRows)
RASTERWALK_FUNCTION(polygon_rows)
RASTERWALK_FUNCTION(compute_rows)
RASTERWALK_FUNCTION(fillRows)
RASTERWALK_FUNCTION(FillRows)
RASTERWALK_FUNCTION(fill_rows)
RASTERWALK_FUNCTION(shadePixel)
RASTERWALK_FUNCTION(ShadePixel)
RASTERWALK_FUNCTION(shade_pixel)
RASTERWALK_FUNCTION(InitializeSDL)

RASTERWALK_NAME(SDL2Aux)
RASTERWALK_NAME(Pixel)
RASTERWALK_NAME(pixel)
RASTERWALK_NAME(ScreenPixel)
RASTERWALK_NAME(PixelData)
RASTERWALK_NAME(PixelInfo)
RASTERWALK_NAME(Fragment)
RASTERWALK_NAME(Vertex)
RASTERWALK_NAME(vertex)
RASTERWALK_NAME(Vert)
RASTERWALK_NAME(VertexData)
RASTERWALK_NAME(screen)
RASTERWALK_NAME(sdlAux)
RASTERWALK_NAME(sdl)
RASTERWALK_NAME(aux)
RASTERWALK_NAME(sdlaux)
RASTERWALK_NAME(SDLaux)
RASTERWALK_NAME(window)
RASTERWALK_NAME(surface)
RASTERWALK_NAME(theScreen)
RASTERWALK_NAME(mainScreen)
RASTERWALK_NAME(gScreen)
RASTERWALK_NAME(display)
RASTERWALK_NAME(currentNormal)
RASTERWALK_NAME(CurrentNormal)
RASTERWALK_NAME(current_normal)
RASTERWALK_NAME(currNormal)
RASTERWALK_NAME(curNormal)
RASTERWALK_NAME(normal)
RASTERWALK_NAME(currentReflectance)
RASTERWALK_NAME(currentReflectancePerArea)
RASTERWALK_NAME(CurrentReflectance)
RASTERWALK_NAME(current_reflectance)
RASTERWALK_NAME(currentColor)
RASTERWALK_NAME(currentColour)
RASTERWALK_NAME(CurrentColor)
RASTERWALK_NAME(current_color)
RASTERWALK_NAME(current_colour)
RASTERWALK_NAME(curColor)
RASTERWALK_NAME(currColor)
RASTERWALK_NAME(reflectance)
RASTERWALK_NAME(depthBuffer)
RASTERWALK_NAME(depth_buffer)
RASTERWALK_NAME(DepthBuffer)
RASTERWALK_NAME(depthbuffer)
RASTERWALK_NAME(zBuffer)
RASTERWALK_NAME(zbuffer)
RASTERWALK_NAME(z_buffer)
RASTERWALK_NAME(ZBuffer)
RASTERWALK_NAME(DEPTH_BUFFER)
RASTERWALK_NAME(depths)
RASTERWALK_NAME(depth)
RASTERWALK_NAME(depthMap)
RASTERWALK_NAME(invDepth)
RASTERWALK_CONSTANT(cameraPos)
RASTERWALK_CONSTANT(camera_pos)
RASTERWALK_CONSTANT(cameraPosition)
RASTERWALK_CONSTANT(camera_position)
RASTERWALK_CONSTANT(CameraPos)
RASTERWALK_CONSTANT(CameraPosition)
RASTERWALK_CONSTANT(camPos)
RASTERWALK_CONSTANT(cam_pos)
RASTERWALK_CONSTANT(campos)
RASTERWALK_CONSTANT(cameraPOS)
RASTERWALK_CONSTANT(eye)
RASTERWALK_CONSTANT(eyePos)
RASTERWALK_CONSTANT(camera)
RASTERWALK_CONSTANT(cam)
RASTERWALK_CONSTANT(Camera)
RASTERWALK_NAME(R)
RASTERWALK_NAME(rotation)
RASTERWALK_NAME(cameraRot)
RASTERWALK_NAME(cameraRotation)
RASTERWALK_NAME(camera_rotation)
RASTERWALK_NAME(rotationMatrix)
RASTERWALK_NAME(rotation_matrix)
RASTERWALK_NAME(RotationMatrix)
RASTERWALK_NAME(rotMatrix)
RASTERWALK_NAME(rotMat)
RASTERWALK_NAME(rot)
RASTERWALK_NAME(Rot)
RASTERWALK_NAME(camRot)
RASTERWALK_NAME(cam_rot)
RASTERWALK_NAME(Rotation)
RASTERWALK_NAME(cameraR)
RASTERWALK_CONSTANT(yaw)
RASTERWALK_CONSTANT(Yaw)
RASTERWALK_CONSTANT(cameraYaw)
RASTERWALK_CONSTANT(camera_yaw)
RASTERWALK_CONSTANT(camYaw)
RASTERWALK_CONSTANT(yawAngle)
RASTERWALK_CONSTANT(rotationY)
RASTERWALK_CONSTANT(theta)
RASTERWALK_CONSTANT(angle)
RASTERWALK_CONSTANT(cameraFocalLength)
RASTERWALK_CONSTANT(f_length)
RASTERWALK_CONSTANT(focallength)
RASTERWALK_CONSTANT(F)
RASTERWALK_CONSTANT(lightPos)
RASTERWALK_CONSTANT(light_pos)
RASTERWALK_CONSTANT(lightPosition)
RASTERWALK_CONSTANT(light_position)
RASTERWALK_CONSTANT(LightPos)
RASTERWALK_CONSTANT(LightPosition)
RASTERWALK_CONSTANT(lightpos)
RASTERWALK_CONSTANT(lampPos)
RASTERWALK_CONSTANT(light)
RASTERWALK_CONSTANT(lightPower)
RASTERWALK_CONSTANT(lampPower)
RASTERWALK_CONSTANT(lamp_power)
RASTERWALK_CONSTANT(light_power)
RASTERWALK_CONSTANT(LightPower)
RASTERWALK_CONSTANT(lightpower)
RASTERWALK_CONSTANT(lightIntensity)
RASTERWALK_CONSTANT(lightColor)
RASTERWALK_CONSTANT(lightColour)
RASTERWALK_CONSTANT(light_color)
RASTERWALK_CONSTANT(LightColor)
RASTERWALK_CONSTANT(indirectLightPowerPerArea)
RASTERWALK_CONSTANT(indirectLightPower)
RASTERWALK_CONSTANT(indirectLight)
RASTERWALK_CONSTANT(indirect_light)
RASTERWALK_CONSTANT(IndirectLight)
RASTERWALK_CONSTANT(indirect)
RASTERWALK_CONSTANT(indirectPower)
RASTERWALK_CONSTANT(indirectIllumination)
RASTERWALK_CONSTANT(ambientLight)
RASTERWALK_CONSTANT(ambient)
RASTERWALK_NAME(triangles)
RASTERWALK_NAME(Triangles)
RASTERWALK_NAME(TRIANGLES)
RASTERWALK_NAME(model)
RASTERWALK_NAME(tris)
RASTERWALK_NAME(triangleList)
RASTERWALK_NAME(scene)
RASTERWALK_NAME(theCamera)
RASTERWALK_NAME(mainCamera)
RASTERWALK_NAME(view)
RASTERWALK_NAME(Light)
RASTERWALK_NAME(lamp)
RASTERWALK_NAME(theLight)
RASTERWALK_NAME(pointLight)
RASTERWALK_NAME(world)
RASTERWALK_NAME(state)

RASTERWALK_CONSTANT(CAMERA_POS)
RASTERWALK_CONSTANT(CAMERA_POSITION)
RASTERWALK_CONSTANT(YAW)
RASTERWALK_CONSTANT(focalLength)
RASTERWALK_CONSTANT(FOCAL_LENGTH)
RASTERWALK_CONSTANT(focal_length)
RASTERWALK_CONSTANT(FocalLength)
RASTERWALK_CONSTANT(FOCALLENGTH)
RASTERWALK_CONSTANT(focal)
RASTERWALK_CONSTANT(FOCAL)
RASTERWALK_CONSTANT(f)
RASTERWALK_CONSTANT(LIGHT_POS)
RASTERWALK_CONSTANT(LIGHT_POSITION)
RASTERWALK_CONSTANT(LIGHT_POWER)
RASTERWALK_CONSTANT(LIGHT_COLOR)
RASTERWALK_CONSTANT(INDIRECT)
RASTERWALK_CONSTANT(INDIRECT_LIGHT)
RASTERWALK_CONSTANT(AMBIENT)
RASTERWALK_CONSTANT(SCREEN_WIDTH)
RASTERWALK_CONSTANT(SCREENWIDTH)
RASTERWALK_CONSTANT(ScreenWidth)
RASTERWALK_CONSTANT(screenWidth)
RASTERWALK_CONSTANT(screen_width)
RASTERWALK_CONSTANT(WINDOW_WIDTH)
RASTERWALK_CONSTANT(WIDTH)
RASTERWALK_CONSTANT(Width)
RASTERWALK_CONSTANT(width)
RASTERWALK_CONSTANT(SCREEN_W)
RASTERWALK_CONSTANT(W)
RASTERWALK_CONSTANT(SCREEN_HEIGHT)
RASTERWALK_CONSTANT(SCREENHEIGHT)
RASTERWALK_CONSTANT(ScreenHeight)
RASTERWALK_CONSTANT(screenHeight)
RASTERWALK_CONSTANT(screen_height)
RASTERWALK_CONSTANT(WINDOW_HEIGHT)
RASTERWALK_CONSTANT(HEIGHT)
RASTERWALK_CONSTANT(Height)
RASTERWALK_CONSTANT(height)
RASTERWALK_CONSTANT(SCREEN_H)
RASTERWALK_CONSTANT(H)

#undef RASTERWALK_NAME
#undef RASTERWALK_CONSTANT
#undef RASTERWALK_FUNCTION
// NOLINTEND(cppcoreguidelines-macro-usage)

namespace rasterwalk_kit {

/// What a program of the lab may call its own, the usual name first.
struct Program {
    using VertexShader =
        List<Name_VertexShader, Name_vertexShader, Name_vertex_shader, Name_Vertexshader,
             Name_vertexshader, Name_ProjectVertex, Name_projectVertex>;
    using Interpolate =
        List<Name_Interpolate, Name_interpolate, Name_InterpolatePixel, Name_InterpolatePixels,
             Name_interpolatePixel, Name_interpolatePixels, Name_interpolate_pixels>;
    using PolygonRows =
        List<Name_ComputePolygonRows, Name_computePolygonRows, Name_compute_polygon_rows,
             Name_ComputeRows, Name_computeRows, Name_computepolygonrows>;
    using DrawRows =
        List<Name_DrawPolygonRows, Name_drawPolygonRows, Name_draw_polygon_rows, Name_DrawRows,
             Name_drawRows, Name_draw_rows, Name_DrawPolygonRow, Name_drawpolygonrows>;
    using PixelShader = List<Name_PixelShader, Name_pixelShader, Name_pixel_shader,
                             Name_Pixelshader, Name_pixelshader>;
    // Names that other functions have as well.
    using OtherVertexShaders = List<Name_project_vertex>;
    using OtherPolygonRows =
        List<Name_polygonRows, Name_PolygonRows, Name_polygon_rows, Name_compute_rows>;
    using OtherDrawRows = List<Name_fillRows, Name_FillRows, Name_fill_rows>;
    using OtherPixelShaders = List<Name_shadePixel, Name_ShadePixel, Name_shade_pixel>;
    using PixelTypeNames = List<Name_Pixel, Name_pixel, Name_ScreenPixel, Name_PixelData,
                                Name_PixelInfo, Name_Fragment>;
    using VertexTypeNames = List<Name_Vertex, Name_vertex, Name_Vert, Name_VertexData>;
    using Windows =
        List<Name_screen, Name_sdlAux, Name_sdl, Name_aux, Name_sdlaux, Name_SDLaux, Name_window,
             Name_surface, Name_theScreen, Name_mainScreen, Name_gScreen, Name_display>;
    using CurrentNormals = List<Name_currentNormal, Name_CurrentNormal, Name_current_normal,
                                Name_currNormal, Name_curNormal, Name_normal>;
    using CurrentColours =
        List<Name_currentReflectance, Name_currentReflectancePerArea, Name_CurrentReflectance,
             Name_current_reflectance, Name_currentColor, Name_currentColour, Name_CurrentColor,
             Name_current_color, Name_current_colour, Name_curColor, Name_currColor,
             Name_reflectance>;
    using DepthBuffers =
        List<Name_depthBuffer, Name_depth_buffer, Name_DepthBuffer, Name_depthbuffer, Name_zBuffer,
             Name_zbuffer, Name_z_buffer, Name_ZBuffer, Name_DEPTH_BUFFER, Name_depths, Name_depth,
             Name_depthMap, Name_invDepth>;
    using CameraPositions =
        List<Name_cameraPos, Name_camera_pos, Name_cameraPosition, Name_camera_position,
             Name_CameraPos, Name_CameraPosition, Name_camPos, Name_cam_pos, Name_campos,
             Name_cameraPOS, Name_CAMERA_POS, Name_CAMERA_POSITION, Name_eye, Name_eyePos,
             Name_camera, Name_cam, Name_Camera>;
    using Rotations = List<Name_R, Name_rotation, Name_cameraRot, Name_cameraRotation,
                           Name_camera_rotation, Name_rotationMatrix, Name_rotation_matrix,
                           Name_RotationMatrix, Name_rotMatrix, Name_rotMat, Name_rot, Name_Rot,
                           Name_camRot, Name_cam_rot, Name_Rotation, Name_cameraR>;
    using Yaws = List<Name_yaw, Name_Yaw, Name_YAW, Name_cameraYaw, Name_camera_yaw, Name_camYaw,
                      Name_yawAngle, Name_rotationY, Name_theta, Name_angle>;
    using FocalLengths =
        List<Name_focalLength, Name_FOCAL_LENGTH, Name_focal_length, Name_FocalLength,
             Name_FOCALLENGTH, Name_focal, Name_FOCAL, Name_cameraFocalLength, Name_f_length,
             Name_focallength, Name_f, Name_F>;
    using LightPositions =
        List<Name_lightPos, Name_light_pos, Name_lightPosition, Name_light_position, Name_LightPos,
             Name_LightPosition, Name_LIGHT_POS, Name_LIGHT_POSITION, Name_lightpos, Name_lampPos,
             Name_light, Name_lamp>;
    using LightPowers =
        List<Name_lightPower, Name_light_power, Name_LightPower, Name_LIGHT_POWER, Name_lightpower,
             Name_lightIntensity, Name_lightColor, Name_lightColour, Name_light_color,
             Name_LightColor, Name_LIGHT_COLOR, Name_lampPower, Name_lamp_power>;
    using Indirects =
        List<Name_indirectLightPowerPerArea, Name_indirectLightPower, Name_indirectLight,
             Name_indirect_light, Name_IndirectLight, Name_indirect, Name_indirectPower,
             Name_INDIRECT, Name_INDIRECT_LIGHT, Name_indirectIllumination, Name_ambientLight,
             Name_ambient, Name_AMBIENT>;
    using Widths = List<Name_SCREEN_WIDTH, Name_SCREENWIDTH, Name_ScreenWidth, Name_screenWidth,
                        Name_screen_width, Name_WINDOW_WIDTH, Name_WIDTH, Name_Width, Name_width,
                        Name_SCREEN_W, Name_W>;
    using Heights = List<Name_SCREEN_HEIGHT, Name_SCREENHEIGHT, Name_ScreenHeight,
                         Name_screenHeight, Name_screen_height, Name_WINDOW_HEIGHT, Name_HEIGHT,
                         Name_Height, Name_height, Name_SCREEN_H, Name_H>;
    using Triangles = List<Name_triangles, Name_Triangles, Name_TRIANGLES, Name_model, Name_tris,
                           Name_triangleList, Name_scene>;
    using Cameras =
        List<Name_camera, Name_cam, Name_Camera, Name_theCamera, Name_mainCamera, Name_view>;
    using Lights = List<Name_light, Name_Light, Name_lamp, Name_theLight, Name_pointLight>;
    using Scenes = List<Name_scene, Name_world, Name_state>;

    /// Is this a window of the kit, which the program has not kept in a variable?
    template <class Pointer>
    static constexpr bool makes_window() {
        return is_from_helper<Pointer>() || is_auxiliary<Pointer>();
    }

    /// A window as large as the program's.
    template <class Pointer>
    static Pointer make_window() {
        constexpr int usual_side = 500;
        NumberList list;
        const bool is_known =
            read_names<Widths, ReadOne>(list) && read_names<Heights, ReadOne>(list);
        const int width = is_known ? static_cast<int>(list.numbers()[0]) : usual_side;
        const int height = is_known ? static_cast<int>(list.numbers()[1]) : usual_side;
        if constexpr (is_auxiliary<Pointer>()) {
            return new std::remove_pointer_t<Pointer>(width, height);
        } else {
            return Name_InitializeSDL::call(width, height);
        }
    }

    using Window = decltype(window_type(Values<Windows>{}));

  private:
    template <class Pointer>
    static constexpr bool is_from_helper() {
        return requires {
            static_cast<Pointer>(Name_InitializeSDL::call(1, 1));
        };
    }
    template <class Pointer>
    static constexpr bool is_auxiliary() {
        return std::is_same_v<Look<Name_SDL2Aux>, TypeFound<std::remove_pointer_t<Pointer>>>;
    }
};

/// Asks the program, or has the runtime do so after the first frame.
struct Driver {
    Driver() noexcept {
        Recorded* const memory = recorded();
        if (memory == nullptr) return;
        if (memory->task.before_main == 0) {
            after_first_frame = ask_program<Program>;
            return;
        }
        open_windows<Program>(Values<Program::Windows>{});
        ask_program<Program>();
        memory->progress.moment = moment_ended;
        _exit(0);
    }
};

namespace {
const Driver driver;
}

} // namespace rasterwalk_kit
