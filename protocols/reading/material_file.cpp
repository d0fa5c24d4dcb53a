#include "protocols/reading/material_file.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "haptics/recordings/recording.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

namespace reaming = haptics::reaming;
using Json = nlohmann::ordered_json;
using questionnaires::Node;
using questionnaires::Problems;

constexpr std::string_view kMaterialFormat = "palpate-material-1";

/// The JSON keys of a node, for force or torque.
struct NodeKeys {
  const char* value;
  const char* slope;
};
constexpr NodeKeys kForceKeys{"force_n", "slope_n_per_m"};
constexpr NodeKeys kTorqueKeys{"torque_nm", "slope_nm_per_m"};

constexpr double kDeepest = 1.0;  // [m]
// Limit of each depth [m]. Depths between kDeepest and this limit are reported once per file, as a
// wrong unit.
constexpr double kLargestNumber = 1e9;

reaming::CurveNodes readNodes(const Node& curves, const char* which, const NodeKeys& keys) {
  constexpr double kLargest = 1e6;    // [N, N·m]
  constexpr double kSteepest = 1e12;  // [N/m, N·m/m]
  reaming::CurveNodes nodes;
  for (const auto& node : curves.requiredList(which)) {
    if (!node.isObjectWithOnlyKeys({"depth_m", keys.value, keys.slope})) continue;
    const double depth = node.number("depth_m", 0.0, kLargestNumber);
    if (!nodes.empty() && !(depth > nodes.back().position)) {
      node.problem(
          "depth_m",
          "the node does not lie deeper than the one before it",
          "list the nodes in the order of their depth, each depth once");
    }
    nodes.push_back(
        {depth,
         node.number(keys.value, -kLargest, kLargest),
         node.number(keys.slope, -kSteepest, kSteepest)});
  }
  if (nodes.size() == 1) curves.problem(which, "one node is no curve", "list two or more");
  return nodes;
}

reaming::HardnessCurves readCurves(const Node& node, const NodeKeys& keys) {
  // A fit to single specimens has a middle specimen in place of the average.
  const bool isOfSpecimens = node.has("middle_specimen") && !node.has("average");
  const char* middle = isOfSpecimens ? "middle_specimen" : "average";
  if (!node.isObjectWithOnlyKeys({"minimum", middle, "maximum"})) return {};
  return {
      readNodes(node, "minimum", keys),
      readNodes(node, middle, keys),
      readNodes(node, "maximum", keys)};
}

reaming::Jitter readJitter(const Node& node) {
  if (!node.isObjectWithOnlyKeys({"rms_n", "rate_hz"})) return {};
  return {node.number("rms_n", 0.0, 1e4), node.number("rate_hz", 0.1, 1e5)};
}

/// The largest depth of a node in all curves [m].
double deepestOf(const reaming::Material& material) {
  double deepest = 0.0;
  for (const auto& set : material.sets) {
    for (const auto* curves : {&set.force, &set.torque}) {
      for (const auto* nodes : {&curves->minimum, &curves->average, &curves->maximum}) {
        for (const auto& node : *nodes) deepest = std::max(deepest, node.position);
      }
    }
  }
  return deepest;
}

std::optional<reaming::Material> readMaterialRoot(const Node& root) {
  if (!root.isObjectWithOnlyKeys({"format", "name", "title", "synthetic", "sets", "provenance"})) {
    return std::nullopt;
  }
  root.requireFormat("format", kMaterialFormat, "write one with 'palpate material fit'");
  reaming::Material material{
      .name = root.id("name"),
      .title = root.text("title"),
      .isSynthetic = root.flag("synthetic", false)};
  for (const auto& node : root.requiredList("sets")) {
    if (!node.isObjectWithOnlyKeys({"test_set", "force", "torque", "jitter"})) continue;
    reaming::MaterialSet set{.set = node.choice("test_set", kTestSetChoices)};
    if (const auto force = node.requiredObject("force")) set.force = readCurves(*force, kForceKeys);
    if (const auto torque = node.object("torque")) set.torque = readCurves(*torque, kTorqueKeys);
    if (const auto jitter = node.object("jitter")) set.jitter = readJitter(*jitter);
    if (material.find(set.set) != nullptr) {
      node.problem("test_set", "this test set is there already", "keep one of the two");
    }
    material.sets.push_back(std::move(set));
  }
  if (const double deepest = deepestOf(material); deepest > kDeepest) {
    root.problem(
        "sets",
        "the curves go " + haptics::recordings::decimal(deepest, 1) +
            " m deep; depths are in metres and at most 1",
        "if these are millimetres, fit the material again and say so: --unit displacement=mm");
  }
  return material;
}

Json asJson(const reaming::FittedCurve& curve, const NodeKeys& keys) {
  Json nodes = Json::array();
  for (const auto& node : curve.spline.nodes) {
    nodes.push_back(
        {{"depth_m", node.position}, {keys.value, node.force}, {keys.slope, node.slope}});
  }
  return nodes;
}

/// The name of the curve between minimum and maximum.
const char* middleKeyOf(reaming::EnvelopeRule rule) {
  return rule == reaming::EnvelopeRule::Pointwise ? "average" : "middle_specimen";
}

Json asJson(const reaming::FittedEnvelope& envelope, const NodeKeys& keys, const char* middle) {
  return {
      {"minimum", asJson(envelope.minimum, keys)},
      {middle, asJson(envelope.average, keys)},
      {"maximum", asJson(envelope.maximum, keys)}};
}

Json errorsOf(const reaming::FittedEnvelope& envelope, const char* middle) {
  Json json;
  const std::pair<const char*, const reaming::FittedCurve*> curves[]{
      {"minimum", &envelope.minimum}, {middle, &envelope.average}, {"maximum", &envelope.maximum}};
  for (const auto& [name, curve] : curves) {
    const auto& e = curve->error;
    json[name] = {
        {"nodes", curve->spline.nodes.size()},
        {"e_a_published", e.published},
        {"e_a_at_m", e.publishedPosition},
        {"floored", e.floored},
        {"floored_at_m", e.flooredPosition},
        {"largest", e.largest},
        {"rms", e.rms},
        {"r_squared", e.rSquared}};
  }
  return json;
}

/// The number of specimens behind the curves, at each depth at which it changes.
Json specimenCounts(const reaming::FittedEnvelope& envelope) {
  Json stretches = Json::array();
  for (const auto& stretch : reaming::specimenCountsOf(envelope)) {
    stretches.push_back(
        {{"from_m", stretch.from}, {"measured", stretch.measured}, {"held", stretch.held}});
  }
  return stretches;
}

Json seriesAsJson(const reaming::PreparedSeries& series, const MaterialSource& source) {
  Json json{{"name", series.name}, {"test_set", nameOf(series.set)}};
  if (!source.file.empty()) json["file"] = source.file;
  if (!source.sha256.empty()) json["sha256"] = source.sha256;
  json["used"] = !series.exclusion.isExcluded();
  if (series.exclusion.isExcluded()) json["excluded_because"] = series.exclusion.words;
  if (series.cutoff > 0.0) json["cutoff_hz"] = series.cutoff;
  if (series.torqueCutoff > 0.0) json["torque_cutoff_hz"] = series.torqueCutoff;
  if (series.largestDisplacement > 0.0) json["largest_depth_m"] = series.largestDisplacement;
  if (series.isCensored) json["ended_at_force_limit"] = true;
  return json;
}

}  // namespace

std::string_view nameOf(reaming::NodeRule rule) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"greedy", "paper-literal", "thinned", "optimal"};
  return kNames[static_cast<std::size_t>(rule)];
}
std::string_view nameOf(reaming::SplineKind kind) noexcept {
  constexpr std::array<std::string_view, 5> kNames{
      "hermite-data-slope", "pchip", "makima", "cubic-natural", "linear"};
  return kNames[static_cast<std::size_t>(kind)];
}
std::string_view nameOf(reaming::EnvelopeRule rule) noexcept {
  return rule == reaming::EnvelopeRule::Pointwise ? "pointwise" : "single-sample";
}
std::string_view nameOf(reaming::DepthAxis axis) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"depth", "normalised", "normalised-series"};
  return kNames[static_cast<std::size_t>(axis)];
}
std::string_view nameOf(haptics::filters::CutoffRule rule) noexcept {
  return rule == haptics::filters::CutoffRule::Floor ? "detrended-hann" : "plain";
}

std::optional<reaming::Material> readMaterial(std::string_view json, Problems& problems) {
  return questionnaires::readJson<reaming::Material>(json, problems, readMaterialRoot);
}

std::string materialAsJson(
    const std::string& name,
    const std::string& title,
    bool isSynthetic,
    const reaming::MaterialFit& fit,
    const reaming::FitOptions& options,
    const std::vector<MaterialSource>& sources) {
  Json json{
      {"format", kMaterialFormat}, {"name", name}, {"title", title}, {"synthetic", isSynthetic}};
  json["sets"] = Json::array();
  Json errors = Json::object();
  const char* middle = middleKeyOf(options.envelope);
  for (const auto& set : fit.sets) {
    Json entry{{"test_set", nameOf(set.set)}, {"force", asJson(set.force, kForceKeys, middle)}};
    if (set.torque) entry["torque"] = asJson(*set.torque, kTorqueKeys, middle);
    if (set.jitter.rms > 0.0) {
      entry["jitter"] = {{"rms_n", set.jitter.rms}, {"rate_hz", set.jitter.rate}};
    }
    json["sets"].push_back(std::move(entry));
    auto& of = errors[std::string(nameOf(set.set))];
    of = {
        {"series", set.used},
        {"scale_m", set.scale},
        {"specimens", specimenCounts(set.force)},
        {"force", errorsOf(set.force, middle)}};
    if (set.torque) of["torque"] = errorsOf(*set.torque, middle);
  }
  Json provenance{
      {"settings",
       {{"axis", nameOf(options.axis)},
        {"cutoff_rule", nameOf(options.cutoffRule)},
        {"envelope", nameOf(options.envelope)},
        {"nodes", nameOf(options.nodes)},
        {"spline", nameOf(options.spline)},
        {"wanted_error", options.wantedError},
        {"force_floor_n", options.forceFloor},
        {"torque_floor_nm", options.torqueFloor},
        {"force_limit_n", options.forceLimit}}},
      {"errors", std::move(errors)},
      {"series", Json::array()}};
  auto& settings = provenance["settings"];
  if (options.cutoff) settings["cutoff_hz"] = *options.cutoff;
  if (options.torqueCutoff) settings["torque_cutoff_hz"] = *options.torqueCutoff;
  if (options.nodeCount) {
    settings["nodes"] = *options.nodeCount;
    settings.erase("wanted_error");
  }
  if (options.nodesOf) settings["nodes_of"] = nameOf(*options.nodesOf);
  for (std::size_t i = 0; i < fit.series.size(); ++i) {
    provenance["series"].push_back(seriesAsJson(fit.series[i], sources[i]));
  }
  json["provenance"] = std::move(provenance);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace protocols
