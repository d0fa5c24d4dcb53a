#include "questionnaires/reading/scale_reader.h"

namespace questionnaires {
namespace {

constexpr int kFarthestPoint = 1000;  // from zero, either way

/// The points that @p node asks for; 0, and a problem, where it asks for none.
int readPoints(const Node& node) {
  if (node.has("points")) {
    return static_cast<int>(node.wholeNumber("points", kFewestPoints, kMostPoints, 0));
  }
  node.problem("", "'points' is missing", "add it");
  return 0;
}

void readLabels(const Node& node, const TextReader& texts, Scale& scale) {
  scale.lowLabel = texts.optional(node, "low_label");
  scale.highLabel = texts.optional(node, "high_label");
  if (!node.has("point_labels")) return;
  for (const auto& label : node.requiredList("point_labels")) {
    scale.pointLabels.push_back(texts.read(label));
  }
  const bool isUnread = scale.pointLabels.empty();
  if (scale.lowLabel.isEmpty()) {
    scale.lowLabel = isUnread ? texts.standIn() : scale.pointLabels.front();
  }
  if (scale.highLabel.isEmpty()) {
    scale.highLabel = isUnread ? texts.standIn() : scale.pointLabels.back();
  }
}

}  // namespace

Scale readScale(const Node& node, const TextReader& texts) {
  Scale scale = standInScale(texts);
  if (!node.isObjectWith({"lowest", "points", "low_label", "high_label", "point_labels"})) {
    return scale;
  }
  scale.lowest = static_cast<int>(node.wholeNumber("lowest", -kFarthestPoint, kFarthestPoint, 1));
  readLabels(node, texts, scale);
  const int points = readPoints(node);
  if (points > 0) {
    scale.points = points;
  } else if (scale.pointLabels.size() >= static_cast<std::size_t>(kFewestPoints)) {
    scale.points = static_cast<int>(scale.pointLabels.size());
  }
  return scale;
}

Scale standInScale(const TextReader& texts) {
  Scale scale;
  scale.lowLabel = texts.standIn();
  scale.highLabel = texts.standIn();
  return scale;
}

}  // namespace questionnaires
