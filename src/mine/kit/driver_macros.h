// Names of variables that students also write as macros. The value of each becomes a function, and
// the macro goes. driver.h includes this behind the student's code and before its own names.

// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#define RASTERWALK_VALUE(name)                                                                     \
    [[maybe_unused]] static auto rasterwalk_value_##name() {                                       \
        return name;                                                                               \
    }

// All values first: one macro may need another.
#ifdef cameraPos
RASTERWALK_VALUE(cameraPos)
#endif
#ifdef camera_pos
RASTERWALK_VALUE(camera_pos)
#endif
#ifdef cameraPosition
RASTERWALK_VALUE(cameraPosition)
#endif
#ifdef camera_position
RASTERWALK_VALUE(camera_position)
#endif
#ifdef CameraPos
RASTERWALK_VALUE(CameraPos)
#endif
#ifdef CameraPosition
RASTERWALK_VALUE(CameraPosition)
#endif
#ifdef camPos
RASTERWALK_VALUE(camPos)
#endif
#ifdef cam_pos
RASTERWALK_VALUE(cam_pos)
#endif
#ifdef campos
RASTERWALK_VALUE(campos)
#endif
#ifdef cameraPOS
RASTERWALK_VALUE(cameraPOS)
#endif
#ifdef eye
RASTERWALK_VALUE(eye)
#endif
#ifdef eyePos
RASTERWALK_VALUE(eyePos)
#endif
#ifdef camera
RASTERWALK_VALUE(camera)
#endif
#ifdef cam
RASTERWALK_VALUE(cam)
#endif
#ifdef Camera
RASTERWALK_VALUE(Camera)
#endif
#ifdef yaw
RASTERWALK_VALUE(yaw)
#endif
#ifdef Yaw
RASTERWALK_VALUE(Yaw)
#endif
#ifdef cameraYaw
RASTERWALK_VALUE(cameraYaw)
#endif
#ifdef camera_yaw
RASTERWALK_VALUE(camera_yaw)
#endif
#ifdef camYaw
RASTERWALK_VALUE(camYaw)
#endif
#ifdef yawAngle
RASTERWALK_VALUE(yawAngle)
#endif
#ifdef rotationY
RASTERWALK_VALUE(rotationY)
#endif
#ifdef theta
RASTERWALK_VALUE(theta)
#endif
#ifdef angle
RASTERWALK_VALUE(angle)
#endif
#ifdef cameraFocalLength
RASTERWALK_VALUE(cameraFocalLength)
#endif
#ifdef f_length
RASTERWALK_VALUE(f_length)
#endif
#ifdef focallength
RASTERWALK_VALUE(focallength)
#endif
#ifdef F
RASTERWALK_VALUE(F)
#endif
#ifdef lightPos
RASTERWALK_VALUE(lightPos)
#endif
#ifdef light_pos
RASTERWALK_VALUE(light_pos)
#endif
#ifdef lightPosition
RASTERWALK_VALUE(lightPosition)
#endif
#ifdef light_position
RASTERWALK_VALUE(light_position)
#endif
#ifdef LightPos
RASTERWALK_VALUE(LightPos)
#endif
#ifdef LightPosition
RASTERWALK_VALUE(LightPosition)
#endif
#ifdef lightpos
RASTERWALK_VALUE(lightpos)
#endif
#ifdef lampPos
RASTERWALK_VALUE(lampPos)
#endif
#ifdef light
RASTERWALK_VALUE(light)
#endif
#ifdef lightPower
RASTERWALK_VALUE(lightPower)
#endif
#ifdef lampPower
RASTERWALK_VALUE(lampPower)
#endif
#ifdef lamp_power
RASTERWALK_VALUE(lamp_power)
#endif
#ifdef light_power
RASTERWALK_VALUE(light_power)
#endif
#ifdef LightPower
RASTERWALK_VALUE(LightPower)
#endif
#ifdef lightpower
RASTERWALK_VALUE(lightpower)
#endif
#ifdef lightIntensity
RASTERWALK_VALUE(lightIntensity)
#endif
#ifdef lightColor
RASTERWALK_VALUE(lightColor)
#endif
#ifdef lightColour
RASTERWALK_VALUE(lightColour)
#endif
#ifdef light_color
RASTERWALK_VALUE(light_color)
#endif
#ifdef LightColor
RASTERWALK_VALUE(LightColor)
#endif
#ifdef indirectLightPowerPerArea
RASTERWALK_VALUE(indirectLightPowerPerArea)
#endif
#ifdef indirectLightPower
RASTERWALK_VALUE(indirectLightPower)
#endif
#ifdef indirectLight
RASTERWALK_VALUE(indirectLight)
#endif
#ifdef indirect_light
RASTERWALK_VALUE(indirect_light)
#endif
#ifdef IndirectLight
RASTERWALK_VALUE(IndirectLight)
#endif
#ifdef indirect
RASTERWALK_VALUE(indirect)
#endif
#ifdef indirectPower
RASTERWALK_VALUE(indirectPower)
#endif
#ifdef indirectIllumination
RASTERWALK_VALUE(indirectIllumination)
#endif
#ifdef ambientLight
RASTERWALK_VALUE(ambientLight)
#endif
#ifdef ambient
RASTERWALK_VALUE(ambient)
#endif
#ifdef CAMERA_POS
RASTERWALK_VALUE(CAMERA_POS)
#endif
#ifdef CAMERA_POSITION
RASTERWALK_VALUE(CAMERA_POSITION)
#endif
#ifdef YAW
RASTERWALK_VALUE(YAW)
#endif
#ifdef focalLength
RASTERWALK_VALUE(focalLength)
#endif
#ifdef FOCAL_LENGTH
RASTERWALK_VALUE(FOCAL_LENGTH)
#endif
#ifdef focal_length
RASTERWALK_VALUE(focal_length)
#endif
#ifdef FocalLength
RASTERWALK_VALUE(FocalLength)
#endif
#ifdef FOCALLENGTH
RASTERWALK_VALUE(FOCALLENGTH)
#endif
#ifdef focal
RASTERWALK_VALUE(focal)
#endif
#ifdef FOCAL
RASTERWALK_VALUE(FOCAL)
#endif
#ifdef f
RASTERWALK_VALUE(f)
#endif
#ifdef LIGHT_POS
RASTERWALK_VALUE(LIGHT_POS)
#endif
#ifdef LIGHT_POSITION
RASTERWALK_VALUE(LIGHT_POSITION)
#endif
#ifdef LIGHT_POWER
RASTERWALK_VALUE(LIGHT_POWER)
#endif
#ifdef LIGHT_COLOR
RASTERWALK_VALUE(LIGHT_COLOR)
#endif
#ifdef INDIRECT
RASTERWALK_VALUE(INDIRECT)
#endif
#ifdef INDIRECT_LIGHT
RASTERWALK_VALUE(INDIRECT_LIGHT)
#endif
#ifdef AMBIENT
RASTERWALK_VALUE(AMBIENT)
#endif
#ifdef SCREEN_WIDTH
RASTERWALK_VALUE(SCREEN_WIDTH)
#endif
#ifdef SCREENWIDTH
RASTERWALK_VALUE(SCREENWIDTH)
#endif
#ifdef ScreenWidth
RASTERWALK_VALUE(ScreenWidth)
#endif
#ifdef screenWidth
RASTERWALK_VALUE(screenWidth)
#endif
#ifdef screen_width
RASTERWALK_VALUE(screen_width)
#endif
#ifdef WINDOW_WIDTH
RASTERWALK_VALUE(WINDOW_WIDTH)
#endif
#ifdef WIDTH
RASTERWALK_VALUE(WIDTH)
#endif
#ifdef Width
RASTERWALK_VALUE(Width)
#endif
#ifdef width
RASTERWALK_VALUE(width)
#endif
#ifdef SCREEN_W
RASTERWALK_VALUE(SCREEN_W)
#endif
#ifdef W
RASTERWALK_VALUE(W)
#endif
#ifdef SCREEN_HEIGHT
RASTERWALK_VALUE(SCREEN_HEIGHT)
#endif
#ifdef SCREENHEIGHT
RASTERWALK_VALUE(SCREENHEIGHT)
#endif
#ifdef ScreenHeight
RASTERWALK_VALUE(ScreenHeight)
#endif
#ifdef screenHeight
RASTERWALK_VALUE(screenHeight)
#endif
#ifdef screen_height
RASTERWALK_VALUE(screen_height)
#endif
#ifdef WINDOW_HEIGHT
RASTERWALK_VALUE(WINDOW_HEIGHT)
#endif
#ifdef HEIGHT
RASTERWALK_VALUE(HEIGHT)
#endif
#ifdef Height
RASTERWALK_VALUE(Height)
#endif
#ifdef height
RASTERWALK_VALUE(height)
#endif
#ifdef SCREEN_H
RASTERWALK_VALUE(SCREEN_H)
#endif
#ifdef H
RASTERWALK_VALUE(H)
#endif

#undef cameraPos
#undef camera_pos
#undef cameraPosition
#undef camera_position
#undef CameraPos
#undef CameraPosition
#undef camPos
#undef cam_pos
#undef campos
#undef cameraPOS
#undef eye
#undef eyePos
#undef camera
#undef cam
#undef Camera
#undef yaw
#undef Yaw
#undef cameraYaw
#undef camera_yaw
#undef camYaw
#undef yawAngle
#undef rotationY
#undef theta
#undef angle
#undef cameraFocalLength
#undef f_length
#undef focallength
#undef F
#undef lightPos
#undef light_pos
#undef lightPosition
#undef light_position
#undef LightPos
#undef LightPosition
#undef lightpos
#undef lampPos
#undef light
#undef lightPower
#undef lampPower
#undef lamp_power
#undef light_power
#undef LightPower
#undef lightpower
#undef lightIntensity
#undef lightColor
#undef lightColour
#undef light_color
#undef LightColor
#undef indirectLightPowerPerArea
#undef indirectLightPower
#undef indirectLight
#undef indirect_light
#undef IndirectLight
#undef indirect
#undef indirectPower
#undef indirectIllumination
#undef ambientLight
#undef ambient
#undef CAMERA_POS
#undef CAMERA_POSITION
#undef YAW
#undef focalLength
#undef FOCAL_LENGTH
#undef focal_length
#undef FocalLength
#undef FOCALLENGTH
#undef focal
#undef FOCAL
#undef f
#undef LIGHT_POS
#undef LIGHT_POSITION
#undef LIGHT_POWER
#undef LIGHT_COLOR
#undef INDIRECT
#undef INDIRECT_LIGHT
#undef AMBIENT
#undef SCREEN_WIDTH
#undef SCREENWIDTH
#undef ScreenWidth
#undef screenWidth
#undef screen_width
#undef WINDOW_WIDTH
#undef WIDTH
#undef Width
#undef width
#undef SCREEN_W
#undef W
#undef SCREEN_HEIGHT
#undef SCREENHEIGHT
#undef ScreenHeight
#undef screenHeight
#undef screen_height
#undef WINDOW_HEIGHT
#undef HEIGHT
#undef Height
#undef height
#undef SCREEN_H
#undef H

// These have no value to be read.
#undef SDL2Aux
#undef Pixel
#undef pixel
#undef ScreenPixel
#undef PixelData
#undef PixelInfo
#undef Fragment
#undef Vertex
#undef vertex
#undef Vert
#undef VertexData
#undef screen
#undef sdlAux
#undef sdl
#undef aux
#undef sdlaux
#undef SDLaux
#undef window
#undef surface
#undef theScreen
#undef mainScreen
#undef gScreen
#undef display
#undef currentNormal
#undef CurrentNormal
#undef current_normal
#undef currNormal
#undef curNormal
#undef normal
#undef currentReflectance
#undef currentReflectancePerArea
#undef CurrentReflectance
#undef current_reflectance
#undef currentColor
#undef currentColour
#undef CurrentColor
#undef current_color
#undef current_colour
#undef curColor
#undef currColor
#undef reflectance
#undef depthBuffer
#undef depth_buffer
#undef DepthBuffer
#undef depthbuffer
#undef zBuffer
#undef zbuffer
#undef z_buffer
#undef ZBuffer
#undef DEPTH_BUFFER
#undef depths
#undef depth
#undef depthMap
#undef invDepth
#undef R
#undef rotation
#undef cameraRot
#undef cameraRotation
#undef camera_rotation
#undef rotationMatrix
#undef rotation_matrix
#undef RotationMatrix
#undef rotMatrix
#undef rotMat
#undef rot
#undef Rot
#undef camRot
#undef cam_rot
#undef Rotation
#undef cameraR
#undef triangles
#undef Triangles
#undef TRIANGLES
#undef model
#undef tris
#undef triangleList
#undef scene
#undef theCamera
#undef mainCamera
#undef view
#undef Light
#undef lamp
#undef theLight
#undef pointLight
#undef world
#undef state
#undef RASTERWALK_VALUE
// NOLINTEND(cppcoreguidelines-macro-usage)
