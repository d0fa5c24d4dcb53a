#include "study/gui/scene/shapes/meniscus.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/gui/scene/shapes/noise.h"
#include "study/gui/scene/shapes/tool_shapes.h"

namespace study::gui::scene {
namespace {

constexpr float kDegrees = 180.0F / 3.14159265F;
constexpr float kMillimetresPerTravel = 0.33F;  // at the bite, from the jaw's geometry
constexpr float kBiteHalf = 2.9F;               // along the edge [mm]
constexpr float kBiteDepth = 3.6F;              // across it [mm]
constexpr std::size_t kMostBites = 12;
constexpr int kSections = 120;
constexpr int kPieceSections = 30;
constexpr int kPointsAcross = 12;  // points across a surface
constexpr int kUpright = 2;        // points up a face
constexpr float kThinnest = 0.22F;

constexpr Tint kEdge{250, 248, 240, 200};
constexpr Tint kRim{238, 196, 180, 170};      // with blood vessels
constexpr Tint kCutFace{240, 214, 178, 120};  // fibres
constexpr Tint kCapsule{220, 150, 134, 160};  // where the tissue grows into the synovium

/// The angle of section @p i of the body [°]: closest together at the tool, which @p half [°] to
/// each side leaves room for.
float angleOfSection(int i, float middle, float half) {
  const float at = 2.0F * static_cast<float>(i) / kSections - 1.0F;
  const float away = at * (0.4F + 0.6F * at * at);
  return middle * (1.0F - std::abs(away)) + half * away;
}

/// How far @p share of the way to the rim is into the rounding of the upper edge, from 0 to 1.
float roundingAt(float share) {
  constexpr float kFrom = 0.72F;
  return std::clamp((share - kFrom) / (1.0F - kFrom), 0.0F, 1.0F);
}

/// The height of the undeformed tissue at @p share of the way to its rim [mm].
float restHeight(float share) {
  constexpr float kRounding = 1.7F;  // height of the rounded edge [mm]
  const float t = roundingAt(share);
  return 0.34F + 5.7F * std::pow(share, 1.45F) - kRounding * (1.0F - std::sqrt(1.0F - t * t));
}

/// The place of point @p i across a surface, from 0 (edge) to 1 (rim): closer together at the rim,
/// which is rounded.
float placeAcross(std::size_t i) {
  const float t = static_cast<float>(i) / kPointsAcross;
  return t * (1.5F - 0.5F * t);
}

/// Interpolates the displacements of the string's nodes with a cubic Hermite spline.
float interpolate(const std::vector<haptics::engine::MeshView::Point>& nodes, double place) {
  if (place <= nodes.front().position || place >= nodes.back().position) return 0.0F;
  std::size_t i = 0;
  while (nodes[i + 1].position < place) ++i;
  const auto slope = [&](std::size_t k) {
    const auto& before = nodes[k == 0 ? 0 : k - 1];
    const auto& after = nodes[std::min(k + 1, nodes.size() - 1)];
    return (after.displacement - before.displacement) / (after.position - before.position);
  };
  const double h = nodes[i + 1].position - nodes[i].position;
  const double t = (place - nodes[i].position) / h;
  const double value = (1 + 2 * t) * (1 - t) * (1 - t) * nodes[i].displacement +
                       t * (1 - t) * (1 - t) * h * slope(i) +
                       t * t * (3 - 2 * t) * nodes[i + 1].displacement +
                       t * t * (t - 1) * h * slope(i + 1);
  return static_cast<float>(value);
}

}  // namespace

Meniscus::Meniscus(const KneeLayout& layout)
    : layout_(layout), fromPunch_(punchPose(layout)), toPunch_(fromPunch_.inverted()) {
  squeeze({});
}

void Meniscus::cut() {
  if (bites_.size() == kMostBites) bites_.erase(bites_.begin());
  bites_.push_back(layout_.toolAngle + moved_);
  hasPiece_ = true;
}

/// The radius of the free edge after the first @p bites [mm from the arc's centre].
float Meniscus::edgeAt(float angle, std::size_t bites) const {
  const float own = angle + moved_;
  const float fray = noiseAt({0.45F * own, 0.0F, 0.0F});
  float edge = layout_.innerRadius + 0.14F * std::sin(0.13F * own) + 0.1F * fray;
  for (std::size_t i = 0; i < bites; ++i) {
    const float t = (own - bites_[i]) / kDegrees * layout_.innerRadius / kBiteHalf;
    if (std::abs(t) >= 1.0F) continue;
    const float bite =
        (kBiteDepth + 0.25F * noiseAt({0.8F * own, 4.0F, 0.0F})) * std::pow(1.0F - t * t, 0.45F);
    edge = std::max(edge, layout_.innerRadius + bite);
  }
  return edge;
}

/// The displacement of the string at @p angle [mm].
float Meniscus::displacementAt(float angle, const TissueLoad& squeeze) const {
  const auto& string = squeeze.string;
  if (string.size() < 3) return 0.0F;
  const auto peak =
      std::max_element(string.begin(), string.end(), [](const auto& a, const auto& b) {
        return a.displacement < b.displacement;
      });
  const double perDegree =
      (string.back().position - string.front().position) / static_cast<double>(layout_.heldAngle);
  const double place = peak->position + perDegree * static_cast<double>(angle - layout_.toolAngle);
  return kMillimetresPerTravel * interpolate(string, place);
}

Meniscus::Column Meniscus::column(
    float angle, float radius, float fullness, const TissueLoad& squeeze) const {
  const float share = std::clamp(
      (radius - layout_.innerRadius) / (layout_.outerRadius - layout_.innerRadius), 0.0F, 1.0F);
  Column column{pointOnArc(layout_, angle, radius), {}};
  column.low.setY(plateauHeight(column.low.x(), column.low.z()) + 0.02F);
  column.high = column.low;
  // The capsule holds the tissue at its rim.
  const float dip = (1.0F - share) * displacementAt(angle, squeeze);
  const float rest = fullness * restHeight(share);
  const float height = std::max(rest - dip, 0.3F * rest);
  column.high.setY(column.low.y() + height);
  keepClearOfTheJaws(column, squeeze.openness);
  return column;
}

/// Lifts tissue that lies in the lower jaw and presses down tissue under the upper jaw.
void Meniscus::keepClearOfTheJaws(Column& column, float openness) const {
  constexpr float kEase = 0.16F;  // [1/mm]: how fast the deformation decreases beside the jaws
  QVector3D low = toPunch_.map(column.low);
  QVector3D high = toPunch_.map(column.high);
  const float aside = std::max(0.0F, std::abs(low.z()) - kJawHalfWidth - 0.35F);
  const float beyond = std::max(0.0F, std::max(low.x() - kJawLength, -3.0F - low.x()));
  const float away = kEase * (aside * aside + 2.0F * beyond * beyond);
  const float lift = std::max(0.0F, 0.03F - away - low.y());
  low.setY(low.y() + lift);
  high.setY(high.y() + lift);
  const float x = std::clamp(high.x(), 0.0F, kJawLength);
  const float roof = jawHeight(openness, x) - 0.04F + 1.6F * away;
  if (high.y() > roof) high.setY(std::max(roof, low.y() + kThinnest));
  column.low = fromPunch_.map(low);
  column.high = fromPunch_.map(high);
}

/// Adds one cross-section of the tissue at @p angle: along the top, down the rim, back along the
/// bottom, up the edge. Corners are duplicated so that they stay sharp.
void Meniscus::addSection(Mesh& mesh, float angle, bool isPiece, const TissueLoad& squeeze) const {
  const std::size_t bites = bites_.size();
  const float inner = edgeAt(angle, isPiece ? bites - 1 : bites);
  const float outer = isPiece ? edgeAt(angle, bites) : layout_.outerRadius;
  const float own = angle + moved_;
  const float fullness = 1.0F + 0.07F * noiseAt({0.07F * own, 0.0F, 11.0F});
  const float bloodless = 0.42F - 0.12F * noiseAt({0.16F * own, 0.0F, 7.0F});  // share of the way
  std::array<Column, kPointsAcross + 1> columns;
  std::array<Tint, kPointsAcross + 1> tints;
  for (std::size_t i = 0; i <= kPointsAcross; ++i) {
    const float radius = inner + (outer - inner) * placeAcross(i);
    columns[i] = column(angle, radius, fullness, squeeze);
    const float share =
        (radius - layout_.innerRadius) / (layout_.outerRadius - layout_.innerRadius);
    const float fibre = noiseAt({0.05F * own, 2.6F * radius, 0.0F});  // along the arc
    const float blood = std::clamp((share - bloodless) / 0.45F, 0.0F, 1.0F);
    const Tint tissue = blend(kEdge, kRim, blood * blood);
    tints[i] = shaded(
        blend(tissue, kCapsule, std::clamp((share - 0.84F) / 0.16F, 0.0F, 1.0F)),
        0.96F + 0.04F * fibre);
  }
  const auto add = [&](QVector3D place, Tint tint) { mesh.vertices.push_back({place, {}, tint}); };
  const auto upright = [&](const Column& face, int i) {
    const float share = static_cast<float>(i) / kUpright;
    return face.low + share * (face.high - face.low);
  };
  const bool isCut = inner > layout_.innerRadius + 0.3F;
  for (std::size_t i = 0; i <= kPointsAcross; ++i) add(columns[i].high, tints[i]);
  for (int i = kUpright; i >= 0; --i)
    add(upright(columns.back(), i), isPiece ? kCutFace : kCapsule);
  for (std::size_t i = kPointsAcross + 1; i-- > 0;) add(columns[i].low, shaded(tints[i], 0.9F));
  for (int i = 0; i <= kUpright; ++i) {
    add(upright(columns.front(), i), isCut ? kCutFace : kEdge);
  }
}

void Meniscus::shape(
    Mesh& mesh, float from, float to, bool isPiece, const TissueLoad& squeeze) const {
  const int sections = isPiece ? kPieceSections : kSections;
  mesh.vertices.clear();
  for (int i = 0; i <= sections; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(sections);
    const float angle = isPiece ? from + (to - from) * share
                                : angleOfSection(i, layout_.toolAngle, layout_.halfAngle);
    addSection(mesh, angle, isPiece, squeeze);
  }
  constexpr std::uint32_t kRound = 2 * (kPointsAcross + 1) + 2 * (kUpright + 1);
  const auto last = static_cast<std::uint32_t>(sections) * kRound;
  if (mesh.triangles.empty()) {
    for (std::uint32_t first = 0; first < last; first += kRound) {
      for (std::uint32_t i = 0; i < kRound; ++i) {
        const std::uint32_t next = (i + 1) % kRound;
        mesh.triangles.push_back({first + i, first + kRound + next, first + next});
        mesh.triangles.push_back({first + i, first + kRound + i, first + kRound + next});
      }
    }
    // Close the two ends with triangles between top and bottom.
    for (std::uint32_t i = 0; i + 1 < kRound / 2; ++i) {
      const std::uint32_t j = kRound - 1 - i;
      mesh.triangles.push_back({i, i + 1, j});
      mesh.triangles.push_back({i + 1, j - 1, j});
      mesh.triangles.push_back({last + i, last + j, last + i + 1});
      mesh.triangles.push_back({last + i + 1, last + j, last + j - 1});
    }
  }
  smoothen(mesh);
  glisten(mesh);
}

/// Turns the normals of the upper surface a little: the wet tissue glints in spots.
void Meniscus::glisten(Mesh& mesh) const {
  constexpr std::size_t kRound = 2 * (kPointsAcross + 1) + 2 * (kUpright + 1);
  constexpr float kStrength = 0.2F;
  for (std::size_t first = 0; first < mesh.vertices.size(); first += kRound) {
    for (std::size_t i = first; i <= first + kPointsAcross; ++i) {
      const QVector3D way = mesh.vertices[i].position - layout_.arcCentre;
      const float own = kDegrees * std::atan2(way.x(), -way.z()) + moved_;
      const QVector3D at(0.12F * own, 0.8F * way.length(), 0.0F);
      const QVector3D turn(noiseAt(at), 0.0F, noiseAt(at + QVector3D(0.0F, 0.0F, 3.5F)));
      mesh.vertices[i].normal = (mesh.vertices[i].normal + kStrength * turn).normalized();
    }
  }
}

void Meniscus::squeeze(const TissueLoad& squeeze) {
  shape(body_, -layout_.halfAngle, layout_.halfAngle, false, squeeze);
  if (!hasPiece_) return;
  const float half = kBiteHalf / layout_.innerRadius * kDegrees;
  const float middle = bites_.back() - moved_;
  shape(piece_, middle - half, middle + half, true, squeeze);
}

}  // namespace study::gui::scene
