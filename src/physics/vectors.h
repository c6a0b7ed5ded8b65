#pragma once

// Vectors and matrices, from GLM. Double wherever spacetime is computed; float where Embree,
// textures and pixels are.

#include <glm/glm.hpp>

namespace restframe {

using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;

}  // namespace restframe
