#pragma once

namespace study::gui::simulation {

/// How bright things are: the same as shading.cpp, at every pixel.
inline constexpr const char* kShadingCode = R"glsl(#version 330 core
uniform vec3 lampPlace;
uniform float lampReach;
uniform float ambientLight;
uniform vec3 disc;  // middle and radius in pixels; radius 0: none

vec2 brightness(vec3 place, vec3 normal, float gloss) {
  vec3 toEye = -normalize(place);
  if (dot(normal, toEye) < 0.0) normal = -normal;
  bool isNear = lampReach > 0.0;
  vec3 way = isNear ? lampPlace - place : lampPlace;
  float away = length(way);
  vec3 toLamp = way / away;
  float share = isNear ? away / lampReach : 0.0;
  float power = isNear ? 1.9 / (1.0 + share * share) : 1.05;
  float facing = max(0.0, dot(normal, toLamp));
  float mirrored = max(0.0, dot(normal, normalize(toLamp + toEye)));
  float shine = 0.85 * gloss * gloss * pow(mirrored, 12.0 + 70.0 * gloss);
  return vec2(ambientLight * (1.0 + 0.5 * normal.y) + power * facing, power * shine);
}

vec3 shown(vec3 light) {
  float left = 1.0;
  if (disc.z > 0.0) {
    float radius = distance(gl_FragCoord.xy, disc.xy) / disc.z;
    float square = radius * radius;
    left = clamp((1.0 - radius) / 0.012, 0.0, 1.0) * (1.0 - 0.5 * square * square);
  }
  return left * sqrt(min(light, vec3(1.0)));
}
)glsl";

inline constexpr const char* kBodyVertexCode = R"glsl(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tint;
uniform mat4 toEye;
uniform mat4 projection;
out vec3 eyePlace;
out vec3 eyeNormal;
out vec4 eyeTint;
void main() {
  vec4 place = toEye * vec4(position, 1.0);
  eyePlace = place.xyz;
  eyeNormal = mat3(toEye) * normal;
  eyeTint = vec4(tint.rgb * tint.rgb, tint.a);
  gl_Position = projection * place;
}
)glsl";

inline constexpr const char* kBodyFragmentCode = R"glsl(
in vec3 eyePlace;
in vec3 eyeNormal;
in vec4 eyeTint;
out vec4 pixel;
void main() {
  vec2 bright = brightness(eyePlace, normalize(eyeNormal), eyeTint.a);
  pixel = vec4(shown(eyeTint.rgb * bright.x + bright.y), 1.0);
}
)glsl";

/// A square that faces the eye, for each sphere.
inline constexpr const char* kSphereVertexCode = R"glsl(#version 330 core
layout(location = 0) in vec4 sphere;
layout(location = 1) in vec4 tint;
uniform mat4 toEye;
uniform mat4 projection;
out vec2 across;
flat out vec4 eyeSphere;
flat out vec3 eyeTint;
void main() {
  across = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
  vec4 place = toEye * vec4(sphere.xyz, 1.0);
  eyeSphere = vec4(place.xyz, sphere.w);
  eyeTint = tint.rgb * tint.rgb;
  gl_Position = projection * vec4(place.xy + sphere.w * across, place.z, 1.0);
}
)glsl";

/// EXACT is defined where every pixel has its own depth: dear without a graphics card.
inline constexpr const char* kSphereFragmentCode = R"glsl(
uniform mat4 projection;
in vec2 across;
flat in vec4 eyeSphere;
flat in vec3 eyeTint;
out vec4 pixel;
void main() {
  float rest = 1.0 - dot(across, across);
  if (rest <= 0.0) discard;
  vec3 normal = vec3(across, sqrt(rest));
  float facing = max(0.0, dot(normal, lampPlace));
  float bright =
      (0.45 + 0.55 * normal.z) * (ambientLight * (1.0 + 0.5 * normal.y) + 1.05 * facing);
#ifdef EXACT
  float z = eyeSphere.z + eyeSphere.w * normal.z;
  float depth = (projection[2][2] * z + projection[3][2]) / -z;
  gl_FragDepth = 0.5 * depth + 0.5;
#endif
  pixel = vec4(shown(eyeTint * bright), 1.0);
}
)glsl";

}  // namespace study::gui::simulation
