#include "lighting.h"
#include <cmath>

using glm::vec3;

vec3 lightPos(0, -0.5f, -0.7f);
vec3 lightPower(12, 12, 12);
vec3 indirectLight(0.5f, 0.5f, 0.5f);

vec3 DirectLight(const vec3& point, const vec3& normal)
{
    const float pi = 4 * std::atan(1.0f);
    vec3 r = lightPos - point;
    float distance = glm::length(r);
    vec3 direction = r / distance;
    float lambert = glm::dot(direction, normal);
    if (lambert <= 0)
        return vec3(0, 0, 0);
    return lightPower * (lambert / (4 * pi * distance * distance));
}

vec3 Reflected(const vec3& point, const vec3& normal, const vec3& reflectance)
{
    return reflectance * (DirectLight(point, normal) + indirectLight);
}
