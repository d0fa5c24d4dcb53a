#include "protocols/reading/cut_file.h"

#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using haptics::recordings::CurvePoint;
using haptics::recordings::Cut;
using haptics::recordings::ForceCurve;
using Json = nlohmann::ordered_json;
using questionnaires::Node;
using questionnaires::Problems;

constexpr std::string_view kFormat = "palpate-cut-1";
constexpr std::string_view kUnit = "travel_unit";
constexpr double kLargestTravel = 1e6;  // [travel units]
constexpr double kLargestForce = 1e4;   // [N]

std::optional<CurvePoint> readPoint(const Node& node) {
  if (!node.isObjectWithOnlyKeys({"travel", "force_n"})) return std::nullopt;
  return CurvePoint{
      node.number("travel", -kLargestTravel, kLargestTravel),
      node.number("force_n", -kLargestForce, kLargestForce)};
}

std::optional<CurvePoint> readLandmark(const Node& landmarks, std::string_view key) {
  const auto node = landmarks.object(key);
  return node ? readPoint(*node) : std::nullopt;
}

void readLandmarks(const Node& node, Cut& cut) {
  if (!node.isObjectWithOnlyKeys({"interception", "yield", "bottom_out", "opening"})) return;
  cut.landmarks.interception = readLandmark(node, "interception");
  cut.landmarks.yield = readLandmark(node, "yield");
  cut.landmarks.bottomOut = readLandmark(node, "bottom_out");
  cut.landmarks.opening = readLandmark(node, "opening");
}

/// The curve; std::nullopt if its travel does not increase from point to point.
std::optional<ForceCurve> readCurve(const Node& root, const char* key) {
  std::vector<CurvePoint> points;
  std::vector<Node> falling;  // whose travel does not rise from the point before
  bool isSound = true;
  for (const auto& node : root.requiredList(key)) {
    const auto point = readPoint(node);
    const bool rises = !point || points.empty() || point->travel > points.back().travel;
    if (!rises) falling.push_back(node);
    isSound = isSound && point && rises;
    if (point) points.push_back(*point);
  }
  if (!falling.empty()) {
    const auto more = falling.size() == 1 ? std::string()
                                          : ", nor at " + std::to_string(falling.size() - 1) +
                                                " points that follow";
    falling.front().problem(
        "travel",
        "the travel does not rise from the point before" + more,
        "list the points in the order of their travel, each travel once");
  }
  if (isSound && points.size() == 1) {
    root.problem(key, "one point is no curve", "list two or more");
  }
  if (!isSound || points.size() < 2 || !root.isSound()) return std::nullopt;
  return ForceCurve(std::move(points));
}

/// Reads the required unit. Other units than travel units are refused, because a punch would
/// interpret the numbers as travel units.
std::string readUnit(const Node& root) {
  const std::string unit = root.text("unit");
  if (!unit.empty() && unit != kUnit) {
    root.problem(
        "unit",
        "a punch's travel is in travel units, not in '" + questionnaires::shown(unit) + "'",
        "convert every travel (0 is open, 10 is closed) and write \"travel_unit\"");
  }
  return unit;
}

std::optional<Cut> readCutRoot(const Node& root) {
  if (!root.isObjectWithOnlyKeys(
          {"format",
           "name",
           "title",
           "unit",
           "synthetic",
           "curve",
           "opening_curve",
           "landmarks",
           "provenance"})) {
    return std::nullopt;
  }
  root.requireFormat("format", kFormat, "write one with 'palpate recording import'");
  auto curve = readCurve(root, "curve");
  std::optional<ForceCurve> opening;
  if (root.has("opening_curve")) opening = readCurve(root, "opening_curve");
  Cut cut{
      .name = root.id("name"),
      .title = root.text("title"),
      .unit = readUnit(root),
      .curve = curve ? std::move(*curve) : ForceCurve({{0.0, 0.0}, {1.0, 0.0}}),
      .opening = std::move(opening),
      .provenance = readProvenance(root),
      .isSynthetic = root.flag("synthetic", false)};
  if (const auto landmarks = root.object("landmarks")) readLandmarks(*landmarks, cut);
  return cut;
}

Json pointAsJson(const CurvePoint& point) {
  return {{"travel", point.travel}, {"force_n", point.force}};
}

Json pointsAsJson(const ForceCurve& curve) {
  Json points = Json::array();
  for (const auto& point : curve.nodes()) points.push_back(pointAsJson(point));
  return points;
}

Json provenanceAsJson(const haptics::recordings::Provenance& p, std::string_view sha256) {
  Json json;
  json["statement"] = p.statement;
  if (!p.sourceFile.empty()) json["source_file"] = p.sourceFile;
  if (!sha256.empty()) json["source_sha256"] = sha256;
  for (const auto& range : p.rows) json["rows"].push_back({range.first, range.last});
  if (!p.closures.empty()) json["closures"] = p.closures;
  if (!p.calibration.empty()) json["calibration"] = p.calibration;
  if (!p.filter.empty()) json["filter"] = p.filter;
  if (!p.filterParameters.empty()) json["filter_parameters"] = p.filterParameters;
  if (p.slopeLimit) json["slope_limit_n_per_travel_unit"] = *p.slopeLimit;
  if (!p.changes.empty()) json["changes"] = p.changes;
  return json;
}

}  // namespace

std::optional<Cut> readCut(std::string_view json, Problems& problems) {
  return questionnaires::readJson<Cut>(json, problems, readCutRoot);
}

std::string cutAsJson(const Cut& cut, std::string_view sha256) {
  Json json;
  json["format"] = kFormat;
  json["name"] = cut.name;
  json["title"] = cut.title;
  json["unit"] = cut.unit;
  json["synthetic"] = cut.isSynthetic;
  json["landmarks"] = Json::object();
  const auto add = [&](const char* key, const std::optional<CurvePoint>& landmark) {
    if (landmark) json["landmarks"][key] = pointAsJson(*landmark);
  };
  add("interception", cut.landmarks.interception);
  add("yield", cut.landmarks.yield);
  add("bottom_out", cut.landmarks.bottomOut);
  add("opening", cut.landmarks.opening);
  json["provenance"] = provenanceAsJson(cut.provenance, sha256);
  json["curve"] = pointsAsJson(cut.curve);
  if (cut.opening) json["opening_curve"] = pointsAsJson(*cut.opening);
  // invalid UTF-8 in file names, which may be any bytes, is replaced
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<haptics::models::CurveNode<double>> nodesOf(const ForceCurve& curve) {
  std::vector<haptics::models::CurveNode<double>> nodes;
  for (const auto& point : curve.nodes()) nodes.push_back({point.travel, point.force});
  return nodes;
}

}  // namespace protocols
