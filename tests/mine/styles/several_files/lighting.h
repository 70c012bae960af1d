#ifndef LIGHTING_H
#define LIGHTING_H

#include <glm/glm.hpp>

extern glm::vec3 lightPos;
extern glm::vec3 lightPower;
extern glm::vec3 indirectLight;

// light that reaches a point of a surface straight from the lamp
glm::vec3 DirectLight(const glm::vec3& point, const glm::vec3& normal);

// what the surface sends back
glm::vec3 Reflected(const glm::vec3& point, const glm::vec3& normal, const glm::vec3& reflectance);

#endif
