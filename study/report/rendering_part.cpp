#include <algorithm>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr std::string_view kCurvesCaption =
    "Force at the handle while the tool closed or advanced, over travel: median and the middle 80 "
    "% of all strokes, each of which counts once.";

constexpr std::string_view kBoneCurvesCaption =
    "Force at the handle while the tool closed or advanced, over travel: median and the middle 80 "
    "% of all strokes, each of which counts once. Dashed, for bone: what its material gives where "
    "nothing has been reamed away. Where bone is taken away, the first stroke and the later ones, "
    "which go through its hole, are in this together: the median then lies between both.";

/// @param rising  not empty.
double medianOf(const std::vector<double>& rising) {
  const auto middle = rising.size() / 2;
  return rising.size() % 2 == 1 ? rising[middle] : 0.5 * (rising[middle - 1] + rising[middle]);
}

class RenderingWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    if (s_.quality.trials == 0) {
      paragraph("There are no trials that count.");
      return std::move(html_);
    }
    for (const auto& svg : s_.figures.felt) {
      figure(svg, isOfBone() ? kBoneCurvesCaption : kCurvesCaption);
    }
    const bool isEmpty = std::all_of(
        s_.curves.begin(), s_.curves.end(), [](const auto& curve) { return curve.points.empty(); });
    if (s_.curvesReason.empty() && isEmpty) {
      note("No tool advanced in any trial: there is no curve of force over travel.");
    } else if (s_.curvesReason.empty()) {
      if (s_.figures.felt.empty()) figure("", "Force over travel for every alternative.");
      manipulation();
      againstMaterial();
    } else {
      put("<p>{}</p>", escaped(say("What was felt is not known: {}", s_.words(s_.curvesReason))));
    }
    landmarks();
    quality();
    return std::move(html_);
  }

 private:
  void manipulation() {
    table(
        say("Manipulation check: root mean square difference of the median forces"),
        {say("Pair"), say("All strokes [N]"), "n", say("By participant [N]"), say("95 % CI")});
    for (const auto& d : feltDifferences(s_.curves)) {
      row(
          {condition(d.condition1) + " vs. " + condition(d.condition2),
           rounded(d.pooled, 2),
           std::to_string(d.participants),
           cellOf(d.mean, 2),
           cellOf(d.interval)});
    }
    endTable();
    note(
        "Both columns are over the same travel: what everyone who felt both alternatives passed "
        "with both. A mean square is never below zero: also two alternatives that are alike differ "
        "by what hands do differently from one cut to the next.");
  }

  bool isOfBone() const {
    return std::any_of(s_.curves.begin(), s_.curves.end(), [](const auto& curve) {
      return rmsFromIntended(curve).has_value();
    });
  }

  void landmarks() {
    if (s_.landmarks.empty()) return;
    constexpr std::size_t kColumns = 6;
    table(
        say("Landmarks of the cuts, over all participants"),
        {say("Landmark"), "n", say("Travel: mean"), say("SD"), say("Force [N]: mean"), say("SD")});
    std::string condition;
    for (const auto& one : s_.landmarks) {
      if (one.condition != condition) {
        const auto& device = s_.protocol.condition(one.condition)->device;
        const auto unit = s_.protocol.device(device)->kind->travel.unitName;
        rowOver(this->condition(one.condition) + " (" + say(unit) + ")", kColumns);
      }
      condition = one.condition;
      row(
          {say(one.landmark),
           std::to_string(one.force.n),
           cellOf(one.travel.mean, 2),
           cellOf(one.travel.standardDeviation, 2),
           cellOf(one.force.mean, 2),
           cellOf(one.force.standardDeviation, 2)});
    }
    endTable();
    note("Each cut counts once; n is the number of cuts in which the landmark was found.");
  }

  void againstMaterial() {
    if (!isOfBone()) return;
    table(
        say("Felt against the material: root mean square difference of the median force"),
        {say("Alternative"), "[N]"});
    for (const auto& curve : s_.curves) {
      const auto difference = rmsFromIntended(curve);
      if (difference) row({condition(curve.condition), rounded(difference, 2)});
    }
    endTable();
  }

  std::string counts() const {
    const auto& q = s_.quality;
    std::string text =
        say("{}, {}: {} PASS, {} WARN, {} FAIL.",
            s_.words.count(q.trials, "{} trial", "{} trials"),
            s_.words.count(q.cuts, "{} cut or stroke", "{} cuts or strokes"),
            q.pass,
            q.warn,
            q.fail);
    text += " " + say("The scene asked for more than the force limit for {:.1f} s of {:.1f} s of "
                      "contact.",
                      q.saturated,
                      q.contact);
    if (q.optionalTrials > 0) {
      text += " " + count(
                        q.optionalTrials,
                        "Not among them: {} time an alternative was felt once more before a "
                        "choice.",
                        "Not among them: {} times an alternative was felt once more before a "
                        "choice.");
    }
    return text;
  }

  void quality() {
    const auto& q = s_.quality;
    put("<h4>{}</h4>", say("Rendering quality"));
    put("<p>{}</p>", counts());
    if (q.worstLateness) {
      paragraph(
          "In the worst trial 99 % of the ticks were at most {:.0f} µs late.", *q.worstLateness);
      figure(
          s_.figures.timing,
          "How late the ticks of every trial were: 99 % of them at most, and the latest.");
    } else {
      paragraph("The trials ran in virtual time, so there is no lateness to report.");
    }
    cutOff();
    if (q.reasons.empty()) return;
    put("<ul>");
    for (const auto& [reasons, trials] : q.reasons) {
      put("<li>{}</li>",
          trials == 1 ? escaped(s_.words(reasons))
                      : say("{} trials, the first one: {}", trials, s_.words(reasons)));
    }
    put("</ul>");
  }

  /// The alternatives whose scene asked for more force than the device may give.
  void cutOff() {
    const auto& all = s_.quality.cutOff;
    if (all.empty()) return;
    table(
        say("Trials in which the scene asked for more force than the device may give"),
        {say("Alternative"), say("Trials"), say("Share of the contact: median"), say("largest")});
    for (const auto& one : all) {
      row(
          {condition(one.condition),
           say("{} of {}", one.shares.size(), one.trials),
           fmt::format("{:.1f} %", 100.0 * medianOf(one.shares)),
           fmt::format("{:.1f} %", 100.0 * one.shares.back())});
    }
    endTable();
  }
};

}  // namespace

std::string renderingAsHtml(const ReportSection& section) {
  return RenderingWriter(section).all();
}

}  // namespace study::report
