#pragma once

namespace study::gui::scene {

/// EXACT is defined on a graphics card: light and depth are computed per pixel. Otherwise light is
/// computed per vertex, and each sphere has one depth.
inline constexpr const char* kPerPixelShading = "#version 330 core\n#define EXACT\n";
inline constexpr const char* kPerVertexShading = "#version 330 core\n";

/// Computes brightness with the same equations as brightnessOf() in software_renderer.cpp.
inline constexpr const char* kShadingCode = R"glsl(
uniform vec3 lampPlace;
uniform float lampReach;
uniform float lampPower;
uniform float ambientLight;
uniform vec3 shadowFrom[2];
uniform vec3 shadowAlong[2];
uniform vec3 shadowSize[2];  // radius, reach, depth
uniform vec3 disc;  // middle and radius in pixels; radius 0: none
uniform vec3 ground;

/// The share of light that is left, with the same equations as lightAfterShadow().
float leftByTool(vec3 place) {
  float left = 1.0;
  for (int i = 0; i < 2; ++i) {
    if (shadowSize[i].z <= 0.0) continue;
    vec3 along = shadowAlong[i];
    vec3 way = place - shadowFrom[i];
    float at = clamp(dot(way, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
    float gap = (length(way - at * along) - shadowSize[i].x) / shadowSize[i].y;
    float near = 1.0 - clamp(gap, 0.0, 1.0);
    left *= 1.0 - shadowSize[i].z * near * near;
  }
  return left;
}

vec2 brightness(vec3 place, vec3 normal, float gloss) {
  vec3 toEye = -normalize(place);
  if (dot(normal, toEye) < -0.25) normal = -normal;
  bool isNear = lampReach > 0.0;
  vec3 way = isNear ? lampPlace - place : lampPlace;
  float away = length(way);
  vec3 toLamp = way / away;
  float share = isNear ? away / lampReach : 0.0;
  float power = lampPower / (1.0 + share * share);
  float facing = max(0.0, dot(normal, toLamp));
  float mirrored = max(0.0, dot(normal, normalize(toLamp + toEye)));
  float sharp = mirrored * mirrored;  // to the 16th and 64th, dull and glossy
  sharp *= sharp;
  sharp *= sharp;
  sharp *= sharp;
  float sharper = sharp * sharp;
  sharper *= sharper;
  float sharpest = sharper * sharper;
  sharpest *= sharpest;
  float facingEye = dot(normal, toEye);
  float metal = clamp(10.0 * (gloss - 0.85), 0.0, 1.0);
  float grazing = 1.0 - max(0.0, facingEye);
  float up = 2.0 * facingEye * normal.y - toEye.y;
  float opposite = up * up * up * up;
  opposite *= up * up;
  float wet = (1.0 - metal) * (0.3 * grazing * grazing * grazing + 0.3 * opposite);
  float square = gloss * gloss;
  float shine =
      square * (0.5 * mix(sharp, sharper, gloss) + 1.6 * square * sharpest + wet);
  float ambient = ambientLight * (1.0 + 0.5 * normal.y);
  float mirror = (0.25 + 0.75 * up * up / (up * up + 0.12)) * (up > 0.0 ? 1.0 : 0.75);
  float steel = ambient + power * (0.35 * facing + 0.6 * mirror);
  return vec2(leftByTool(place) * mix(ambient + power * facing, steel, metal), power * shine);
}

vec3 shown(vec3 light) {
  return sqrt(min(light, vec3(1.0)));
}

/// A round view darkens towards its rim, where the background begins.
vec3 throughTheScope(vec2 pixel, vec3 colour) {
  if (disc.z <= 0.0) return colour;
  vec2 away = (pixel - disc.xy) / disc.z;
  float square = dot(away, away);
  float inside = clamp((1.0 - square) / 0.016, 0.0, 1.0);
  return mix(ground, colour * (1.0 - 0.5 * square * square), inside);
}
)glsl";

inline constexpr const char* kBodyVertexCode = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tint;
uniform mat4 toEye;
uniform mat4 projection;
#ifdef EXACT
out vec3 eyePlace;
out vec3 eyeNormal;
out vec4 eyeTint;
#else
out vec3 eyeColour;
#endif
void main() {
  vec4 place = toEye * vec4(position, 1.0);
  vec3 turned = mat3(toEye) * normal;
  vec3 surface = tint.rgb * tint.rgb;
#ifdef EXACT
  eyePlace = place.xyz;
  eyeNormal = turned;
  eyeTint = vec4(surface, tint.a);
#else
  vec2 bright = brightness(place.xyz, normalize(turned), tint.a);
  eyeColour = shown(surface * bright.x + bright.y);
#endif
  gl_Position = projection * place;
}
)glsl";

inline constexpr const char* kBodyFragmentCode = R"glsl(
#ifdef EXACT
in vec3 eyePlace;
in vec3 eyeNormal;
in vec4 eyeTint;
#else
in vec3 eyeColour;
#endif
out vec4 pixel;
void main() {
#ifdef EXACT
  vec2 bright = brightness(eyePlace, normalize(eyeNormal), eyeTint.a);
  vec3 eyeColour = shown(eyeTint.rgb * bright.x + bright.y);
#endif
  pixel = vec4(throughTheScope(gl_FragCoord.xy, eyeColour), 1.0);
}
)glsl";

/// Draws each sphere as the smallest triangle around its disc, facing the eye. Without EXACT it
/// draws a point as large as the disc, which is cheaper on a processor.
inline constexpr const char* kSphereVertexCode = R"glsl(
layout(location = 0) in vec4 sphere;
layout(location = 1) in vec4 tint;
uniform mat4 toEye;
uniform mat4 projection;
uniform float pointScale;  // pixels per millimetre at a distance of 1 mm
#ifdef EXACT
out vec2 corner;
#endif
flat out vec4 eyeSphere;
flat out vec3 eyeTint;
void main() {
  vec4 place = toEye * vec4(sphere.xyz, 1.0);
  eyeSphere = vec4(place.xyz, sphere.w);
  eyeTint = leftByTool(place.xyz) * tint.rgb * tint.rgb;
#ifdef EXACT
  corner = gl_VertexID == 2 ? vec2(0.0, 2.0) : vec2(1.7320508 * float(2 * gl_VertexID - 1), -1.0);
  gl_Position = projection * vec4(place.xy + sphere.w * corner, place.z, 1.0);
#else
  gl_Position = sphere.w > 0.0 ? projection * place : vec4(0.0, 0.0, 2.0, 1.0);
  gl_PointSize = max(1.5, 2.0 * sphere.w * pointScale / -place.z);
#endif
}
)glsl";

inline constexpr const char* kSphereFragmentCode = R"glsl(
uniform mat4 projection;
#ifdef EXACT
in vec2 corner;
#endif
flat in vec4 eyeSphere;
flat in vec3 eyeTint;
out vec4 pixel;
void main() {
#ifdef EXACT
  vec2 across = corner;
#else
  vec2 across = 2.0 * gl_PointCoord - 1.0;
#endif
  float rest = 1.0 - dot(across, across);
  if (rest <= 0.0) discard;
  vec3 normal = vec3(across, sqrt(rest));
  // Softer than a ball, so that the spheres are seen as one porous body.
  float facing = max(0.0, dot(mix(normal, vec3(0.0, 0.0, 1.0), 0.55), lampPlace));
  float bright =
      (0.7 + 0.3 * normal.z) * (ambientLight * (1.0 + 0.5 * normal.y) + lampPower * facing);
#ifdef EXACT
  float z = eyeSphere.z + eyeSphere.w * normal.z;
  float depth = (projection[2][2] * z + projection[3][2]) / -z;
  gl_FragDepth = 0.5 * depth + 0.5;
#endif
  pixel = vec4(shown(eyeTint * bright), 1.0);
}
)glsl";

}  // namespace study::gui::scene
