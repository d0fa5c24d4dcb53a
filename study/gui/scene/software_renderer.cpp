#include "study/gui/scene/software_renderer.h"

#include <algorithm>
#include <cmath>

namespace study::gui::scene {

namespace {

constexpr float kLeastFacing = -0.25F;
constexpr float kLeastMetalGloss = 0.85F;  // gloss from which a surface is metal
constexpr float kMetalSteepness = 10.0F;

/// The brightness that polished steel reflects from its surroundings, [0, 1]: bright above and
/// below, darker between. @param up  height of the direction that it mirrors, [−1, 1].
float reflectedBrightness(float up) {
  const float square = up * up;
  return (0.25F + 0.75F * square / (square + 0.12F)) * (up > 0.0F ? 1.0F : 0.75F);
}

/// x to the 16th power.
float powerOf16(float x) {
  const float fourth = x * x * x * x;
  return fourth * fourth * fourth * fourth;
}

}  // namespace

Brightness brightnessOf(const Light& light, QVector3D place, QVector3D normal, float gloss) {
  const QVector3D toEye = -place.normalized();
  // A sheet may be seen from behind. A round body's surface only turns away slightly at its edge.
  if (QVector3D::dotProduct(normal, toEye) < kLeastFacing) normal = -normal;
  const bool isNear = light.reach > 0.0F;
  const QVector3D way = isNear ? light.place - place : light.place;
  const float distance = way.length();
  const QVector3D toLamp = way / distance;
  const float share = isNear ? distance / light.reach : 0.0F;
  const float power = light.power / (1.0F + share * share);
  const float facing = std::max(0.0F, QVector3D::dotProduct(normal, toLamp));
  const float mirrored =
      std::max(0.0F, QVector3D::dotProduct(normal, (toLamp + toEye).normalized()));
  const float sharp = powerOf16(mirrored);
  const float sharper = sharp * sharp * sharp * sharp;
  const float sharpest = sharper * sharper * sharper * sharper;
  const float metal = std::clamp(kMetalSteepness * (gloss - kLeastMetalGloss), 0.0F, 1.0F);
  const float facingEye = QVector3D::dotProduct(normal, toEye);
  const float up = 2.0F * facingEye * normal.y() - toEye.y();
  // A wet surface mirrors the bright surfaces above and below, and everything where it turns away
  // from the eye.
  const float grazing = 1.0F - std::max(0.0F, facingEye);
  const float wet =
      (1.0F - metal) * 0.3F * (grazing * grazing * grazing + up * up * up * up * up * up);
  const float square = gloss * gloss;
  const float shine =
      square * (0.5F * (sharp + gloss * (sharper - sharp)) + 1.6F * square * sharpest + wet);
  // Ambient light is slightly brighter from above.
  const float ambient = light.ambient * (1.0F + 0.5F * normal.y());
  const float diffuse = ambient + power * facing;
  const float steel = ambient + power * (0.35F * facing + 0.6F * reflectedBrightness(up));
  return {diffuse + metal * (steel - diffuse), power * shine};
}

float lightAfterShadow(const ContactShadow& shadow, QVector3D place) {
  const QVector3D way = place - shadow.from;
  const float length = std::max(shadow.along.lengthSquared(), 1e-6F);
  const float at = std::clamp(QVector3D::dotProduct(way, shadow.along) / length, 0.0F, 1.0F);
  const float gap = ((way - at * shadow.along).length() - shadow.radius) / shadow.reach;
  const float near = 1.0F - std::clamp(gap, 0.0F, 1.0F);
  return 1.0F - shadow.depth * near * near;
}

Vignette vignette(float radius) {
  const float square = radius * radius;
  return {1.0F - 0.5F * square * square, std::clamp((1.0F - square) / 0.016F, 0.0F, 1.0F)};
}

namespace {

float lightAfterShadows(const std::array<ContactShadow, 2>& shadows, QVector3D place) {
  float left = 1.0F;
  for (const auto& shadow : shadows) {
    if (shadow.depth > 0.0F) left *= lightAfterShadow(shadow, place);
  }
  return left;
}

QRgb asPixel(float red, float green, float blue) {
  const auto byte = [](float value) { return static_cast<int>(std::clamp(value, 0.0F, 255.0F)); };
  return qRgb(byte(red), byte(green), byte(blue));
}

/// A colour channel along a row, in 65536ths.
struct Channel {
  Channel(float first, float last, float steps)
      : begin(fixed(first)),
        step(static_cast<int>(static_cast<float>(fixed(last) - begin) / steps)) {}
  static int fixed(float value) {
    return static_cast<int>(65536.0F * std::clamp(value, 0.0F, 255.0F));
  }
  int at(int i) const { return (begin + i * step) >> 16; }
  int begin;
  int step;
};

/// Converts linear light to a channel of the screen, 0 to 255.
float screenValue(float light) {
  return 255.0F * std::sqrt(std::min(light, 1.0F));
}

}  // namespace

const QImage& SoftwareRenderer::draw(const Scene& scene, QSize size) {
  if (picture_.size() != size) picture_ = QImage(size, QImage::Format_RGB32);
  const QRgb ground = qRgb(scene.ground.red, scene.ground.green, scene.ground.blue);
  picture_.fill(ground);
  nearness_.resize(static_cast<std::size_t>(size.width() * size.height()));
  for (const auto& shot : scene.shots) {
    Frame frame{
        .shot = &shot,
        .place = placeOf(shot, size),
        .projection = {},
        .shadows = inEyeFrame(scene.shadows, shot)};
    frame.projection = projectionOf(shot, frame.place.size());
    begin(frame);
    for (const auto part : shot.parts) {
      if (scene.parts[part].isShown) drawPart(frame, scene.parts[part]);
    }
    if (shot.showsSpheres && scene.spheres != nullptr) drawSpheres(frame, *scene.spheres);
    smoothEdges(frame.place);
    if (shot.isRound) darkenRim(frame, ground);
  }
  return picture_;
}

/// Clears the shot's part of the depth buffer, which an earlier shot may have filled.
void SoftwareRenderer::begin(const Frame& frame) {
  const QRect place = frame.place.intersected(picture_.rect());
  for (int y = place.top(); y <= place.bottom(); ++y) {
    auto* near = nearness_.data() + y * picture_.width();
    std::fill(near + place.left(), near + place.right() + 1, 0.0F);
  }
}

void SoftwareRenderer::drawPart(const Frame& frame, const Part& part) {
  const QMatrix4x4 toEye = frame.shot->view * part.pose;
  corners_.resize(part.mesh.vertices.size());
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const auto& vertex = part.mesh.vertices[i];
    corners_[i].eye = toEye.map(vertex.position);
    const QVector3D normal = toEye.mapVector(vertex.normal).normalized();
    light(frame, vertex, normal, part.isTool, corners_[i]);
    project(frame, corners_[i]);
  }
  for (const auto& t : part.mesh.triangles) {
    const Corner& a = corners_[t.a];
    const Corner& b = corners_[t.b];
    const Corner& c = corners_[t.c];
    // The back of a closed surface is hidden by its front.
    const QVector3D out = QVector3D::crossProduct(b.eye - a.eye, c.eye - a.eye);
    if (part.isTool && QVector3D::dotProduct(out, a.eye) >= 0.0F) continue;
    clip(frame, a, b, c);
  }
}

void SoftwareRenderer::light(
    const Frame& frame, const Vertex& vertex, QVector3D normal, bool isTool, Corner& corner) const {
  const Tint tint = vertex.tint;
  auto bright =
      brightnessOf(frame.shot->light, corner.eye, normal, static_cast<float>(tint.gloss) / 255.0F);
  if (!isTool) bright.diffuse *= lightAfterShadows(frame.shadows, corner.eye);
  corner.red = screenValue(linear(tint.red) * bright.diffuse + bright.shine);
  corner.green = screenValue(linear(tint.green) * bright.diffuse + bright.shine);
  corner.blue = screenValue(linear(tint.blue) * bright.diffuse + bright.shine);
}

void SoftwareRenderer::project(const Frame& frame, Corner& corner) const {
  const float distance = std::max(-corner.eye.z(), 1e-3F);
  const auto wide = static_cast<float>(frame.place.width());
  const auto high = static_cast<float>(frame.place.height());
  corner.inverseDepth = 1.0F / distance;
  corner.x = static_cast<float>(frame.place.left()) +
             0.5F * wide * (1.0F + frame.projection(0, 0) * corner.eye.x() / distance);
  corner.y = static_cast<float>(frame.place.top()) +
             0.5F * high * (1.0F - frame.projection(1, 1) * corner.eye.y() / distance);
}

/// Clips a triangle at the near plane.
void SoftwareRenderer::clip(const Frame& frame, const Corner& a, const Corner& b, const Corner& c) {
  const float nearest = frame.shot->nearest;
  const Corner* in[3] = {&a, &b, &c};
  Corner kept[4];
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const Corner& p = *in[i];
    const Corner& q = *in[(i + 1) % 3];
    const float here = -p.eye.z() - nearest;
    const float there = -q.eye.z() - nearest;
    if (here >= 0.0F) kept[count++] = p;
    if ((here >= 0.0F) == (there >= 0.0F)) continue;
    const float t = here / (here - there);
    Corner between{.eye = p.eye + t * (q.eye - p.eye)};
    between.red = p.red + t * (q.red - p.red);
    between.green = p.green + t * (q.green - p.green);
    between.blue = p.blue + t * (q.blue - p.blue);
    project(frame, between);
    kept[count++] = between;
  }
  for (int i = 2; i < count; ++i) fill(frame, kept[0], kept[i - 1], kept[i]);
}

void SoftwareRenderer::fill(const Frame& frame, const Corner& a, const Corner& b, const Corner& c) {
  const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (std::abs(area) < 1e-6F) return;
  // The change of each value per pixel to the right, and per pixel down.
  const auto along = [&](float Corner::*what, float xb, float xc) {
    return ((b.*what - a.*what) * xc - (c.*what - a.*what) * xb) / area;
  };
  Corner right;
  Corner down;
  for (const auto what : {&Corner::inverseDepth, &Corner::red, &Corner::green, &Corner::blue}) {
    right.*what = along(what, b.y - a.y, c.y - a.y);
    down.*what = -along(what, b.x - a.x, c.x - a.x);
  }
  const QRect place = frame.place.intersected(picture_.rect());
  const auto rowOf = [](float y) { return static_cast<int>(std::ceil(y - 0.5F)); };
  const float lowest = std::max({a.y, b.y, c.y});
  const float highest = std::min({a.y, b.y, c.y});
  const int first = std::max(place.top(), rowOf(std::max(highest, -1e6F)));
  const int last = std::min(place.bottom(), rowOf(std::min(lowest, 1e6F)) - 1);
  const Corner* corner[3] = {&a, &b, &c};
  for (int y = first; y <= last; ++y) {
    const float middle = static_cast<float>(y) + 0.5F;
    float from = 1e9F;
    float to = -1e9F;
    for (int i = 0; i < 3; ++i) {
      const Corner& p = *corner[i];
      const Corner& q = *corner[(i + 1) % 3];
      if ((p.y <= middle) == (q.y <= middle)) continue;
      const float x = p.x + (q.x - p.x) * (middle - p.y) / (q.y - p.y);
      from = std::min(from, x);
      to = std::max(to, x);
    }
    const int begin = std::max(place.left(), rowOf(std::max(from, -1e6F)));
    const int end = std::min(place.right() + 1, rowOf(std::min(to, 1e6F)));
    if (begin >= end) continue;
    const float dx = static_cast<float>(begin) + 0.5F - a.x;
    const float dy = middle - a.y;
    Corner at;
    for (const auto what : {&Corner::inverseDepth, &Corner::red, &Corner::green, &Corner::blue}) {
      at.*what = a.*what + right.*what * dx + down.*what * dy;
    }
    fillRow(y, begin, end, at, right);
  }
}

void SoftwareRenderer::fillRow(int y, int from, int to, const Corner& at, const Corner& perPixel) {
  const auto steps = static_cast<float>(std::max(1, to - from - 1));
  const Channel red(at.red, at.red + steps * perPixel.red, steps);
  const Channel green(at.green, at.green + steps * perPixel.green, steps);
  const Channel blue(at.blue, at.blue + steps * perPixel.blue, steps);
  auto* row = reinterpret_cast<QRgb*>(picture_.scanLine(y)) + from;
  float* near = nearness_.data() + y * picture_.width() + from;
  for (int i = 0; i < to - from; ++i) {
    const float inverseDepth = at.inverseDepth + static_cast<float>(i) * perPixel.inverseDepth;
    if (inverseDepth <= near[i]) continue;
    near[i] = inverseDepth;
    row[i] = qRgb(red.at(i), green.at(i), blue.at(i));
  }
}

void SoftwareRenderer::drawSpheres(const Frame& frame, SphereCloud& spheres) {
  sphereBytes_ += sizeof(SphereInstance) * spheres.uploadChanges([](std::size_t, auto) {});
  const QVector3D toLamp = frame.shot->light.place.normalized();
  for (const auto& sphere : spheres.instances()) {
    if (sphere.radius > 0.0F) drawSphere(frame, sphere, toLamp);
  }
}

void SoftwareRenderer::drawSphere(
    const Frame& frame, const SphereInstance& sphere, QVector3D toLamp) {
  Corner middle{.eye = frame.shot->view.map(QVector3D(sphere.x, sphere.y, sphere.z))};
  if (-middle.eye.z() < frame.shot->nearest) return;
  project(frame, middle);
  const float scale = 0.5F * static_cast<float>(frame.place.height()) * frame.projection(1, 1) *
                      middle.inverseDepth;
  const float radius = std::max(0.7F, scale * sphere.radius);
  const QRect place = frame.place.intersected(picture_.rect());
  const int top = std::max(place.top(), static_cast<int>(std::ceil(middle.y - radius - 0.5F)));
  const int bottom = std::min(place.bottom(), static_cast<int>(middle.y + radius - 0.5F));
  const int first = std::max(place.left(), static_cast<int>(std::ceil(middle.x - radius - 0.5F)));
  const int last = std::min(place.right(), static_cast<int>(middle.x + radius - 0.5F));
  const float left = lightAfterShadows(frame.shadows, middle.eye);
  const float red = left * linear(sphere.tint.red);
  const float green = left * linear(sphere.tint.green);
  const float blue = left * linear(sphere.tint.blue);
  const float ambient = frame.shot->light.ambient;
  const float power = frame.shot->light.power;
  for (int y = top; y <= bottom; ++y) {
    auto* row = reinterpret_cast<QRgb*>(picture_.scanLine(y));
    float* near = nearness_.data() + y * picture_.width();
    const float ny = (middle.y - static_cast<float>(y) - 0.5F) / radius;
    for (int x = first; x <= last; ++x) {
      const float nx = (static_cast<float>(x) + 0.5F - middle.x) / radius;
      const float rest = 1.0F - nx * nx - ny * ny;
      if (rest <= 0.0F || middle.inverseDepth <= near[x]) continue;
      const float nz = std::sqrt(rest);
      const float inverseDepth = 1.0F / (-middle.eye.z() - sphere.radius * nz);
      if (inverseDepth <= near[x]) continue;
      near[x] = inverseDepth;
      // Softer than a ball, so that the spheres are seen as one porous body.
      const float facing = std::max(
          0.0F, 0.45F * (nx * toLamp.x() + ny * toLamp.y()) + (0.55F + 0.45F * nz) * toLamp.z());
      // Little light reaches the gaps between spheres.
      const float bright = (0.7F + 0.3F * nz) * (ambient * (1.0F + 0.5F * ny) + power * facing);
      row[x] = asPixel(
          screenValue(red * bright), screenValue(green * bright), screenValue(blue * bright));
    }
  }
}

namespace {

/// The brightness of a pixel, 0 to 255, as a mean in which green has the double weight.
int brightness(QRgb pixel) {
  return (qRed(pixel) + 2 * qGreen(pixel) + qBlue(pixel)) / 4;
}

/// Adds @p weight times the picture's colour at (x, y), interpolated linearly, to @p sum. Pixel
/// centres have whole coordinates.
void addInterpolated(const QImage& picture, float x, float y, float weight, float (&sum)[3]) {
  const int left = std::clamp(static_cast<int>(x), 0, picture.width() - 2);
  const int top = std::clamp(static_cast<int>(y), 0, picture.height() - 2);
  const float across = std::clamp(x - static_cast<float>(left), 0.0F, 1.0F);
  const float down = std::clamp(y - static_cast<float>(top), 0.0F, 1.0F);
  for (const int row : {0, 1}) {
    const auto* pixels = reinterpret_cast<const QRgb*>(picture.constScanLine(top + row)) + left;
    const float share = weight * (row == 0 ? 1.0F - down : down);
    for (const int column : {0, 1}) {
      const float part = share * (column == 0 ? 1.0F - across : across);
      sum[0] += part * static_cast<float>(qRed(pixels[column]));
      sum[1] += part * static_cast<float>(qGreen(pixels[column]));
      sum[2] += part * static_cast<float>(qBlue(pixels[column]));
    }
  }
}

/// The mean of the picture along the edge through a pixel, which is at a right angle to the
/// steepest change of brightness around it.
QRgb meanAlongEdge(const QImage& picture, int x, int y) {
  const auto at = [&](int dx, int dy) {
    return brightness(reinterpret_cast<const QRgb*>(picture.constScanLine(y + dy))[x + dx]);
  };
  const int across = at(-1, -1) + at(-1, 0) + at(-1, 1) - at(1, -1) - at(1, 0) - at(1, 1);
  const int down = at(-1, -1) + at(0, -1) + at(1, -1) - at(-1, 1) - at(0, 1) - at(1, 1);
  const auto steepness = static_cast<float>(std::max(std::abs(across), std::abs(down)));
  const auto here = reinterpret_cast<const QRgb*>(picture.constScanLine(y))[x];
  constexpr float kFaint = 24.0F;  // of 3 × 255: a smaller step is not visible
  if (steepness < kFaint) return here;
  constexpr float kReach = 1.5F;  // [px] to each side
  const float dx = kReach * static_cast<float>(-down) / steepness;
  const float dy = kReach * static_cast<float>(across) / steepness;
  const auto px = static_cast<float>(x);
  const auto py = static_cast<float>(y);
  float sum[3]{};
  for (const float step : {-1.0F, -0.33F, 0.33F, 1.0F}) {
    addInterpolated(picture, px + step * dx, py + step * dy, 0.25F, sum);
  }
  return asPixel(sum[0], sum[1], sum[2]);
}

}  // namespace

/// Smooths the outlines of bodies, which are found as steps in the depth buffer. Drawing everything
/// twice as large would take four times as long; this computes only the few pixels at edges.
void SoftwareRenderer::smoothEdges(QRect place) {
  constexpr float kJump = 0.03F;  // relative step of the nearness at an outline; the surface of a
                                  // body has smaller steps
  const int width = picture_.width();
  place = place.intersected(picture_.rect()).adjusted(1, 1, -1, -1);  // has neighbours all around
  smoothed_.clear();
  for (int y = place.top(); y <= place.bottom(); ++y) {
    const float* near = nearness_.data() + y * width;
    for (int x = place.left(); x <= place.right(); ++x) {
      const float largest =
          std::max(std::max(near[x - 1], near[x + 1]), std::max(near[x - width], near[x + width]));
      const float least =
          std::min(std::min(near[x - 1], near[x + 1]), std::min(near[x - width], near[x + width]));
      if (largest - least <= kJump * largest) continue;
      smoothed_.push_back({y * width + x, meanAlongEdge(picture_, x, y)});
    }
  }
  for (const auto& [at, colour] : smoothed_) {
    reinterpret_cast<QRgb*>(picture_.scanLine(at / width))[at % width] = colour;
  }
}

/// Cuts the view to a disc on the background that darkens towards its rim.
void SoftwareRenderer::darkenRim(const Frame& frame, QRgb ground) {
  constexpr int kSteps = 1024;  // number of table entries, over the square of the radius
  struct Share {
    int left = 0;    // of the brightness, in 256ths
    int ground = 0;  // weight of the background, in 256ths
  };
  std::array<Share, kSteps + 1> shares;
  for (int i = 0; i <= kSteps; ++i) {
    const auto at = vignette(std::sqrt(static_cast<float>(i) / kSteps));
    shares[static_cast<std::size_t>(i)] = {
        static_cast<int>(256.0F * at.brightness * at.visibleShare),
        static_cast<int>(256.0F * (1.0F - at.visibleShare))};
  }
  const QRect place = frame.place.intersected(picture_.rect());
  const float half = 0.5F * static_cast<float>(frame.place.width());
  const QPointF middle = QRectF(frame.place).center();
  for (int y = place.top(); y <= place.bottom(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(picture_.scanLine(y));
    const float dy = (static_cast<float>(y) + 0.5F - static_cast<float>(middle.y())) / half;
    for (int x = place.left(); x <= place.right(); ++x) {
      const float dx = (static_cast<float>(x) + 0.5F - static_cast<float>(middle.x())) / half;
      const auto at = std::min(kSteps, static_cast<int>(kSteps * (dx * dx + dy * dy)));
      const Share& share = shares[static_cast<std::size_t>(at)];
      const auto mixed = [&](int channel, int behind) {
        return (channel * share.left + behind * share.ground) >> 8;
      };
      const QRgb pixel = row[x];
      row[x] = qRgb(
          mixed(qRed(pixel), qRed(ground)),
          mixed(qGreen(pixel), qGreen(ground)),
          mixed(qBlue(pixel), qBlue(ground)));
    }
  }
}

}  // namespace study::gui::scene
