#include <algorithm>
#include <array>
#include <cmath>

#include "base/joined.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr double kThinBand = 0.01;         // of the largest force: as wide as a line is drawn
constexpr double kPrintedAlike = 0.005;    // forces that differ by less are printed alike [N]
constexpr std::ptrdiff_t kFewestFlat = 3;  // points in a row

constexpr std::string_view kOpening = "opening";
constexpr std::string_view kLargestForce = "largest force";

/// What the landmarks are, see CutDetector.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kMeanings{
    {{"interception", "where the force begins to rise"},
     {"yield", "the largest force before it falls while the tool goes on"},
     {"bottom-out", "the smallest force after that, before it rises again at the end"},
     {kOpening, "the largest force before the tool goes back"}}};

/// How a trial ended, by TrialEnding.
constexpr std::array<std::string_view, 6> kEndings{
    "all cuts made",
    "stopped",
    "device failed",
    "trace not stored",
    "too few cuts in the time allowed",
    "program ended"};

/// @param rising  not empty.
double medianOf(const std::vector<double>& rising) {
  const auto middle = rising.size() / 2;
  return rising.size() % 2 == 1 ? rising[middle] : 0.5 * (rising[middle - 1] + rising[middle]);
}

class RenderingWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    if (section_.quality.trials == 0) {
      paragraph("There are no trials that count.");
      return std::move(html_);
    }
    const auto& figures = section_.figures.renderedForce;
    const auto remarks = remarksOnCurves();
    for (std::size_t i = 0; i < figures.size(); ++i) {
      const bool isLast = i + 1 == figures.size() && !remarks.empty();
      putFigure(figures[i], curvesCaption() + (isLast ? " " + remarks : std::string()));
    }
    if (figures.empty() && !remarks.empty()) put("<p>{}</p>", remarks);
    const bool isEmpty =
        std::all_of(section_.curves.begin(), section_.curves.end(), [](const auto& curve) {
          return curve.points.empty();
        });
    if (section_.curvesReason.empty() && isEmpty) {
      note("No tool advanced in any trial: there is no curve of force over travel.");
    } else if (section_.curvesReason.empty()) {
      if (section_.figures.renderedForce.empty())
        figure("", "Force over travel for every alternative.");
      putManipulationCheck();
      putMaterialComparison();
    } else {
      put("<p>{}</p>",
          escaped(say("What was felt is not known: {}", section_.inWords(section_.curvesReason))));
    }
    landmarks();
    quality();
    return std::move(html_);
  }

 private:
  void putManipulationCheck() {
    const auto all = renderedForceDifferences(section_.curves);
    // of one person, the mean over participants is that of all strokes
    const bool isOfSeveral =
        std::ranges::any_of(all, [](const auto& one) { return one.participants > 1; });
    table(
        say("Manipulation check: root mean square difference of the median forces"),
        {say("Pair"), say("All strokes [N]"), kN, say("By participant [N]"), say("95 % CI")});
    bool isAnyAlike = false;  // in all participants, so that an interval has no width
    for (const auto& d : all) {
      isAnyAlike = isAnyAlike || (d.interval && !hasWidth(*d.interval));
      row(
          {condition(d.condition1) + " vs. " + condition(d.condition2),
           rounded(d.pooled, 2),
           std::to_string(d.participants),
           isOfSeveral ? cellOf(d.mean, 2) : std::string(),
           d.interval && hasWidth(*d.interval) ? cellOf(d.interval) : std::string()});
    }
    endTable();
    const auto sameTravel =
        say("Both columns are over the same travel: what everyone who felt both alternatives "
            "passed with both.");
    const auto ofChance = say(
        "A mean square is never below zero: also two alternatives that are alike differ by what "
        "hands do differently from one stroke to the next.");
    put("<p class=\"note\">{}{}</p>", isOfSeveral ? sameTravel + " " : std::string(), ofChance);
    if (isAnyAlike) note("Where no interval is given, both its ends would be printed alike.");
  }

  /// Whether the ends of an interval are printed differently: simulated hands all move alike.
  static bool hasWidth(const analysis::Interval& interval) {
    return rounded(interval.low, 2) != rounded(interval.high, 2);
  }

  std::string curvesCaption() const {
    auto caption =
        say("Force at the handle on the way in: median and the middle 80 % of all strokes, each of "
            "which counts once. A curve ends where fewer than half of them came.");
    const auto thin = say("Most of the middle 80 % is no wider than the lines.");
    const auto dashed = say("Dashed: what the untouched material gives to a slow push.");
    const auto hole = say(
        "The first stroke and the later ones, which go through its hole, are in this together.");
    if (areBandsThin()) caption += " " + thin;
    if (isOfBone()) caption += " " + dashed;
    const bool hasHole = std::ranges::any_of(section_.curves, [&](const auto& curve) {
      const auto parts =
          haptics::engine::partsOf(*section_.protocol.condition(curve.condition)->model);
      return parts.packing != nullptr && parts.packing->isRemoved;
    });
    return hasHole ? caption + " " + hole : caption;
  }

  bool areBandsThin() const {
    std::vector<double> widths;
    double most = 0.0;
    for (const auto& curve : section_.curves) {
      for (const auto& point : curve.points) {
        widths.push_back(point.high - point.low);
        most = std::max(most, point.high);
      }
    }
    std::ranges::sort(widths);
    return !widths.empty() && medianOf(widths) < kThinBand * most;
  }

  bool isOfBone() const {
    return std::any_of(section_.curves.begin(), section_.curves.end(), [](const auto& curve) {
      return rmsFromIntended(curve).has_value();
    });
  }

  /// Why curves are flat at their largest force, or fall at their end.
  std::string remarksOnCurves() const {
    std::string text;
    for (const auto& curve : section_.curves) {
      const auto plateau = plateauOf(curve);
      for (const auto& why :
           {plateau ? whyFlat(curve.condition, plateau->force) : std::string(), whyFalling(curve)})
        if (!why.empty()) text += (text.empty() ? "" : " ") + why;
    }
    return text;
  }

  /// Where a curve is flat at its largest force.
  struct Plateau {
    double travel = 0.0;  ///< of its first point [device's travel unit]
    double force = 0.0;   ///< the largest median force [N]
    bool isAtEnd = true;  ///< whether the curve stays flat to its end
  };
  /// A curve has a plateau if at least kFewestFlat points in a row are within kPrintedAlike of its
  /// largest median force. The place of the largest force means nothing on it: noise decides.
  static std::optional<Plateau> plateauOf(const RenderedForceCurve& curve) {
    if (curve.points.empty()) return std::nullopt;
    const auto most = std::ranges::max(curve.points, {}, &RenderedForceCurve::Point::median).median;
    const auto isMost = [&](const auto& point) { return point.median > most - kPrintedAlike; };
    const auto first = std::ranges::find_if(curve.points, isMost);
    const auto end = std::find_if_not(first, curve.points.end(), isMost);
    if (most <= 0.0 || end - first < kFewestFlat) return std::nullopt;
    return Plateau{.travel = first->travel, .force = most, .isAtEnd = end == curve.points.end()};
  }

  std::optional<Plateau> plateauOf(const std::string& id) const {
    const auto curve = std::ranges::find(section_.curves, id, &RenderedForceCurve::condition);
    return curve == section_.curves.end() ? std::nullopt : plateauOf(*curve);
  }

  /// Where the force of a cut fades at its end, which hands may pass.
  std::string whyFalling(const RenderedForceCurve& curve) const {
    const auto parts =
        haptics::engine::partsOf(*section_.protocol.condition(curve.condition)->model);
    const bool isFading =
        parts.cut != nullptr && !parts.cut->curve.empty() &&
        parts.cut->options.extrapolation == haptics::models::Extrapolation::RampOut;
    const auto points = curve.points.size();
    const bool isFalling = points > 1 && curve.points[points - 1].median <
                                             curve.points[points - 2].median - kPrintedAlike;
    if (!isFading || !isFalling) return {};
    auto end = parts.cut->curve.end() - 1;  // of the cut, before its own fall to 0
    while (end != parts.cut->curve.begin() && (end - 1)->force > end->force) --end;
    const auto fades =
        say("{} fades beyond {:.1f} {}, where its cut ends.",
            section_.conditionTitle(curve.condition),
            end->travel * kindOf(curve.condition).shown.factor,
            shownUnit(curve.condition));
    return curve.points.back().travel > end->travel ? fades : std::string();
  }

  std::string whyFlat(const std::string& id, double force) const {
    const auto& title = section_.conditionTitle(id);
    const auto parts = haptics::engine::partsOf(*section_.protocol.condition(id)->model);
    const auto is = [&](double limit) { return std::abs(force - limit) < kPrintedAlike; };
    const auto atLimit =
        say("{} is flat at {:.2f} N, the largest force that the study allows.", title, force);
    const auto fused = say(
        "{} is flat at {:.2f} N, where the models that its filter fuses are flat.", title, force);
    const auto clamped =
        say("{} is flat at {:.2f} N, to which the published code limits it.", title, force);
    const auto yielding =
        say("{} is flat at {:.2f} N, its yield force: beyond it the model’s force is constant.",
            title,
            force);
    if (is(section_.protocol.device(section_.protocol.condition(id)->device)->maxForce))
      return atLimit;
    if (parts.filter != nullptr) return fused;
    const bool isClamped = parts.cut != nullptr && parts.cut->options.extrapolation ==
                                                       haptics::models::Extrapolation::AuthorsClamp;
    if (isClamped && is(haptics::models::Interpolation<double>::kAuthorsMaxForce)) return clamped;
    const bool isYielding = parts.elements != nullptr && is(parts.elements->parameters.yieldForce);
    return isYielding ? yielding : std::string();
  }

  const haptics::devices::DeviceKind& kindOf(const std::string& id) const {
    return *section_.protocol.device(section_.protocol.condition(id)->device)->kind;
  }

  /// The unit in which the travel of a condition is shown: "mm", "travel units".
  std::string shownUnit(const std::string& id) const {
    const auto& kind = kindOf(id);
    return kind.shown.factor == 1.0 ? say(kind.travel.unitName) : std::string(kind.shown.unit);
  }

  static std::optional<double> scaled(const std::optional<double>& value, double factor) {
    return value ? std::optional(*value * factor) : std::nullopt;
  }

  /// Whether a landmark has the mean of all strokes that have it: at least half of the strokes of
  /// its condition do.
  bool isInMostStrokes(const LandmarkSummary& one) const {
    return 2 * one.force.n >= strokesOf(one.condition);
  }

  /// The strokes of a condition, each of which has a largest force.
  std::uint64_t strokesOf(const std::string& id) const {
    std::uint64_t most = 0;
    for (const auto& one : section_.landmarks) {
      if (one.condition == id) most = std::max(most, one.force.n);
    }
    return most;
  }

  /// Whether a landmark is at the origin in every stroke, such as the first contact with bone,
  /// which has no backlash before it.
  bool isAlwaysAtOrigin(const LandmarkSummary& one) const {
    const auto isZero = [](const std::optional<double>& value, double factor) {
      constexpr double kPrintedAsZero = 0.005;
      return std::abs(value.value_or(0.0) * factor) < kPrintedAsZero;
    };
    const auto factor = kindOf(one.condition).shown.factor;
    return isZero(one.travel.mean, factor) && isZero(one.travel.standardDeviation, factor) &&
           isZero(one.force.mean, 1.0) && isZero(one.force.standardDeviation, 1.0);
  }

  /// Whether the largest force of every condition is that of its opening.
  bool isForceOfOpening() const {
    return std::ranges::all_of(section_.landmarks, [&](const auto& one) {
      if (one.landmark != kLargestForce) return true;
      return std::ranges::any_of(section_.landmarks, [&](const auto& opening) {
        return opening.landmark == kOpening && opening.condition == one.condition &&
               opening.force.n == one.force.n &&
               withDeviation(opening.force.mean, opening.force.standardDeviation) ==
                   withDeviation(one.force.mean, one.force.standardDeviation);
      });
    });
  }

  /// Whether a row on this landmark says something.
  bool isShown(std::string_view name) const {
    if (name == kLargestForce && isForceOfOpening()) return false;
    return std::ranges::any_of(section_.landmarks, [&](const auto& one) {
      return one.landmark == name && isInMostStrokes(one) && !isAlwaysAtOrigin(one);
    });
  }

  /// Whether an opening is on a plateau at the end of its curve, where it has no place of its own.
  bool isOnPlateau(const LandmarkSummary& one) const {
    const auto plateau = plateauOf(one.condition);
    return one.landmark == kOpening && plateau && plateau->isAtEnd && one.force.mean &&
           std::abs(*one.force.mean - plateau->force) < kPrintedAlike;
  }

  /// "7.20 (0.28); 4.50 (0.71)", with n if not all strokes have the landmark.
  std::string landmarkCell(const LandmarkSummary& one) const {
    const auto n = fmt::format("{} = {}", kN, one.force.n);
    if (!isInMostStrokes(one)) return n;
    const auto factor = kindOf(one.condition).shown.factor;
    const auto place = withDeviation(
        scaled(one.travel.mean, factor), scaled(one.travel.standardDeviation, factor));
    const auto begin = plateauOf(one.condition).value_or(Plateau()).travel;
    const auto plateau = say("from {:.1f}", factor * begin);
    const auto& travel = isOnPlateau(one) ? plateau : place;
    return travel + (travel.empty() ? "" : "; ") +
           withDeviation(one.force.mean, one.force.standardDeviation) +
           (one.force.n < strokesOf(one.condition) ? ", " + n : std::string());
  }

  /// A row for each landmark, a column for each condition with cuts.
  void landmarks() {
    std::vector<std::string> conditions;
    std::vector<std::string_view> names;
    std::vector<std::string> columns{say("Landmark")};
    for (const auto& one : section_.landmarks) {
      const bool isNew = std::ranges::find(names, one.landmark) == names.end();
      if (isNew && isShown(one.landmark)) names.push_back(one.landmark);
      if (std::ranges::find(conditions, one.condition) != conditions.end()) continue;
      conditions.push_back(one.condition);
      columns.push_back(condition(one.condition) + " [" + shownUnit(one.condition) + "; N]");
    }
    if (names.empty()) return;
    table(
        say("Landmarks of all strokes, over all participants: place; force, M with SD in brackets"),
        columns);
    std::vector<std::string> counts{kN};
    for (const auto& id : conditions) counts.push_back(std::to_string(strokesOf(id)));
    row(counts);
    bool isAnyRare = false;
    bool isAnyEmpty = false;
    bool isAnyFlat = false;
    for (const auto name : names) {
      std::vector<std::string> cells(columns.size());
      cells.front() = say(name);
      for (const auto& one : section_.landmarks) {
        if (one.landmark != name) continue;
        const auto place = std::ranges::find(conditions, one.condition) - conditions.begin() + 1;
        cells[static_cast<std::size_t>(place)] = landmarkCell(one);
        isAnyFlat = isAnyFlat || (isInMostStrokes(one) && isOnPlateau(one));
        isAnyRare = isAnyRare || one.force.n < strokesOf(one.condition);
      }
      isAnyEmpty = isAnyEmpty || std::ranges::any_of(cells, &std::string::empty);
      row(cells);
    }
    endTable();
    std::string text;
    for (const auto& [name, meaning] : kMeanings) {
      const auto defined = say(meaning);  // of all: tests find missing translations
      if (isIn(names, name)) text += (text.empty() ? "" : "; ") + say(name) + ": " + defined;
    }
    const auto flat = say("from: the force is flat from there on, at its largest.");
    const auto none = say("An empty cell: no stroke has it.");
    const auto rare =
        say("n in a cell: the strokes that have the landmark, where not all have it. It has no "
            "mean where fewer than half of them have it, and no row where this is so in every "
            "column.");
    if (!text.empty()) text += ".";
    if (isAnyFlat) text += " " + flat;
    if (isAnyEmpty) text += " " + none;
    const auto* kind = section_.protocol.onlyDeviceKind();
    const bool hasYields = isIn(names, "yield") && !isAnyEmpty;
    if (kind != nullptr && !hasYields) text += " " + leastFallOf(*kind);
    if (isAnyRare) text += " " + rare;
    if (!text.empty()) put("<p class=\"note\">{}</p>", text);
  }

  std::string leastFallOf(const haptics::devices::DeviceKind& kind) const {
    return say(
        "A fall by less than {:g} N, or by less than {:g} % of the load, counts as no yield.",
        kind.stroke.yieldDrop,
        100.0 * kind.stroke.yieldDropRatio);
  }

  static bool isIn(const std::vector<std::string_view>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  }

  void putMaterialComparison() {
    if (!isOfBone()) return;
    std::string all;
    for (const auto& curve : section_.curves) {
      const auto difference = rmsFromIntended(curve);
      if (!difference) continue;
      all += (all.empty() ? "" : ", ") + section_.conditionTitle(curve.condition) + " " +
             rounded(difference, 2) + " N";
    }
    paragraph(
        "Felt against the material, root mean square difference of the median force: {}.", all);
    feedLimits();
  }

  /// Where hands pushed against the speed at which the reamer cuts.
  void feedLimits() {
    std::string all;
    const RenderedForceCurve* last = nullptr;
    for (const auto& curve : section_.curves) {
      const auto found = feedLimitedIn(curve);
      if (!found) continue;
      last = &curve;
      const auto& shown = kindOf(curve.condition).shown;
      all += (all.empty() ? "" : ", ") + section_.words.say(
                                             "{} up to {} N ({} to {} {})",
                                             section_.conditionTitle(curve.condition),
                                             rounded(found->most, 1),
                                             rounded(shown.factor * found->from, 1),
                                             rounded(shown.factor * found->to, 1),
                                             shownUnit(curve.condition));
    }
    if (last == nullptr) return;
    const auto& shown = kindOf(last->condition).shown;
    paragraph(
        "The reamer advances by at most {:g} {}: pushing harder gives more force, not more speed. "
        "Where most strokes were as fast as that, more was felt than the material gives, and a dip "
        "of the force was flattened. By how much, and where: {}.",
        shown.factor * last->mostFeed,
        shown.velocityUnit,
        all);
  }

  std::string counts() const {
    const auto& q = section_.quality;
    const auto trials = section_.words.count(q.trials, "{} trial", "{} trials");
    const auto cuts = section_.words.count(q.cuts, "{} cut or stroke", "{} cuts or strokes");
    const auto all = say("{}, {}: all passed every check.", trials, cuts);
    const auto some =
        say("{}, {}: {} passed every check, {} did with a warning, {} failed.",
            trials,
            cuts,
            q.pass,
            q.warn,
            q.fail);
    std::string text = q.pass == q.trials ? all : some;
    const auto beyond =
        say("The scene asked for more than the force limit for {:.1f} s of {:.1f} s of contact.",
            q.saturated,
            q.contact);
    if (q.saturated > 0.0) text += " " + beyond;
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

  /// What was felt beside the trials that count, and what was not felt; empty if nothing was.
  std::string interruptions() const {
    const auto& found = section_.quality.interrupted;
    int brokenOff = 0;
    int skipped = 0;
    for (const auto& [ending, trials] : found.brokenOff) brokenOff += trials;
    for (const auto& [block, trials] : found.skipped) skipped += trials;
    if (brokenOff + found.repeated + skipped == 0) return {};
    const auto reasons = base::joined(found.brokenOff, ", ", [&](const auto& one) {
      return say(kEndings.at(static_cast<std::size_t>(one.first))) + ": " +
             std::to_string(one.second);
    });
    return " " + say("Beside these trials: {} broken off{}, {} repeated, {} skipped.",
                     brokenOff,
                     reasons.empty() ? reasons : " (" + reasons + ")",
                     found.repeated,
                     skipped);
  }

  void quality() {
    const auto& q = section_.quality;
    put("<h4>{}</h4>", say("Rendering quality"));
    const auto lateness =
        q.worstLateness ? say("In the worst trial 99 % of the ticks were at most {:.0f} µs late.",
                              *q.worstLateness)
                        : say("The trials ran in virtual time, so there is no lateness to report.");
    put("<p>{} {}{}</p>", counts(), lateness, interruptions());
    saturatedTrials();
    if (q.reasons.empty()) return;
    put("<ul>");
    for (const auto& [reasons, trials] : q.reasons) {
      put("<li>{}</li>",
          trials == 1 ? escaped(section_.words(reasons))
                      : say("{} trials, the first one: {}", trials, section_.words(reasons)));
    }
    put("</ul>");
  }

  /// The alternatives whose scene asked for more force than the device may give.
  void saturatedTrials() {
    const auto& all = section_.quality.saturatedTrials;
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
