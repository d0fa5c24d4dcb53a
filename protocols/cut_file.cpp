#include "protocols/cut_file.h"

#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "questionnaires/document.h"

namespace protocols {
namespace {

using haptics::recordings::CurvePoint;
using haptics::recordings::Cut;
using Json = nlohmann::ordered_json;
using questionnaires::Node;

constexpr std::string_view kFormat = "palpate-cut-1";
constexpr double kLargestTravel = 1e6;  // [travel units]
constexpr double kLargestForce = 1e4;   // [N]

std::optional<CurvePoint> readPoint(const Node& node) {
  if (!node.isObjectWith({"travel", "force_n"})) return std::nullopt;
  return CurvePoint{
      node.number("travel", -kLargestTravel, kLargestTravel),
      node.number("force_n", -kLargestForce, kLargestForce)};
}

std::optional<CurvePoint> readLandmark(const Node& landmarks, std::string_view key) {
  const auto node = landmarks.object(key);
  return node ? readPoint(*node) : std::nullopt;
}

void readLandmarks(const Node& node, Cut& cut) {
  if (!node.isObjectWith({"interception", "yield", "bottom_out", "opening"})) return;
  cut.landmarks.interception = readLandmark(node, "interception");
  cut.landmarks.yield = readLandmark(node, "yield");
  cut.landmarks.bottomOut = readLandmark(node, "bottom_out");
  cut.landmarks.opening = readLandmark(node, "opening");
}

std::vector<CurvePoint> readCurve(const Node& root) {
  std::vector<CurvePoint> curve;
  for (const auto& node : root.requiredList("curve")) {
    if (const auto point = readPoint(node)) curve.push_back(*point);
  }
  return curve;
}

Json pointAsJson(const CurvePoint& point) {
  return {{"travel", point.travel}, {"force_n", point.force}};
}

Json provenanceAsJson(const haptics::recordings::Provenance& p, std::string_view sha256) {
  Json json;
  json["statement"] = p.statement;
  if (p.sourceFile.empty()) return json;
  json["source_file"] = p.sourceFile;
  json["source_sha256"] = sha256;
  json["rows"] = Json::array();
  for (const auto& range : p.rows) json["rows"].push_back({range.first, range.last});
  json["closures"] = p.closures;
  json["calibration"] = p.calibration;
  json["filter"] = p.filter;
  json["filter_parameters"] = p.filterParameters;
  if (p.slopeLimit) json["slope_limit_n_per_travel_unit"] = *p.slopeLimit;
  json["changes"] = p.changes;
  return json;
}

}  // namespace

std::optional<Cut> readCut(std::string_view json, questionnaires::Problems& problems) {
  const auto value = questionnaires::parseJson(json, problems);
  if (!value) return std::nullopt;
  const Node root(*value, "$", problems);
  if (!root.isObjectWith(
          {"format", "name", "title", "unit", "synthetic", "curve", "landmarks", "provenance"})) {
    return std::nullopt;
  }
  if (root.text("format") != kFormat) {
    root.problem(
        "format",
        "this is no cut file of the kind that this program reads",
        "write one with 'palpate recording import'");
  }
  const auto points = readCurve(root);
  try {
    Cut cut{
        .name = root.id("name"),
        .title = root.text("title"),
        .unit = root.text("unit"),
        .curve = haptics::recordings::ForceCurve(points),
        .isSynthetic = root.flag("synthetic", false)};
    if (const auto landmarks = root.object("landmarks")) readLandmarks(*landmarks, cut);
    if (const auto provenance = root.object("provenance")) {
      cut.provenance.statement = provenance->text("statement", "");
      cut.provenance.sourceFile = provenance->text("source_file", "");
    }
    return problems.hasErrors() ? std::nullopt : std::optional(std::move(cut));
  } catch (const std::invalid_argument& error) {
    root.problem("curve", error.what(), "travel must rise from point to point");
    return std::nullopt;
  }
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
  json["curve"] = Json::array();
  for (const auto& point : cut.curve.nodes()) json["curve"].push_back(pointAsJson(point));
  return json.dump(1) + "\n";
}

std::vector<haptics::models::CurveNode<double>> nodesOf(const Cut& cut) {
  std::vector<haptics::models::CurveNode<double>> nodes;
  for (const auto& point : cut.curve.nodes()) nodes.push_back({point.travel, point.force});
  return nodes;
}

}  // namespace protocols
