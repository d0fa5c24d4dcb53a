#include <algorithm>
#include <array>
#include <cstdlib>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

constexpr std::size_t kMostOnThePage = 3;

/// Warnings about a study's files that say nothing about its results.
constexpr std::array<std::string_view, 14> kFileWarnings{
    "no_normals",
    "normals_without_direction",
    "knee_never_seen",
    "device_not_used",
    "condition_not_used",
    "no_text",
    "no_texts_in",
    "language_not_listed",
    "blank_left",
    "blank_left_in",
    "text_not_used",
    "instrument_not_asked",
    "hides_library_instrument",
    "items_not_analysed"};

/// A kind of flag, with what was found in each cohort, of all families together.
struct Limitation {
  const analysis::Flag* flag;
  std::vector<std::pair<std::string, std::string>> found;  ///< sentence, cohorts
};

/// Writes what weakens the answer. The page has a title for each, the appendix explains it.
class LimitationsWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  /// The caveats on the rendering: the answer is then about something other than the methods. They
  /// come before the weaknesses.
  std::string renderingCaveats() {
    for (const auto& limitation : limitations()) {
      if (!limitation.flag->concernsRendering) continue;
      for (const auto& found : limitation.found) {
        put("<p><strong>{}</strong></p>", sentenceOf(limitation, found));
      }
    }
    return std::move(html_);
  }

  std::string briefly() {
    std::vector<std::string> points;
    for (const auto& limitation : limitations()) {
      // the sentences of the answer mention these two already
      if (limitation.flag->concernsRendering || limitation.flag->id == "pseudo_replication")
        continue;
      std::string cohorts;
      for (const auto& [sentence, own] : limitation.found) {
        cohorts += (cohorts.empty() ? "" : ", ") + own;
      }
      points.push_back(inWords(limitation.flag->title()));
      const bool isOfAll = cohortsIn(limitation) == section_.results.flow.size();
      if (!isOfAll) points.back() += " (" + escaped(cohorts) + ")";
    }
    const auto warned = warnings();
    if (!warned.empty()) {
      points.push_back(count(warned.size(), "{} remark on the design", "{} remarks on the design"));
    }
    if (points.empty()) return {};
    heading("What weakens the answer");
    std::string items;
    for (std::size_t i = 0; i < std::min(points.size(), kMostOnThePage); ++i) {
      items += "<li>" + points[i] + "</li>";
    }
    put("<ul>{}</ul>", items);
    note("All of it is explained in the appendix, under “Limitations”.");
    return std::move(html_);
  }

  std::string all() {
    const auto found = limitations();
    if (!found.empty()) put("<dl class=\"flags\">");
    for (const auto& limitation : found) {
      const auto& flag = *limitation.flag;
      put("<dt>{}</dt><dd>", inWords(flag.title()));
      std::string sentences;
      for (const auto& one : limitation.found) sentences += sentenceOf(limitation, one) + " ";
      if (flag.concernsRendering) sentences.clear();  // the page has them
      put("<p>{}{} <span class=\"source\">({})</span></p></dd>",
          sentences,
          inWords(flag.why),
          escaped(section_.words(flag.source)));
    }
    if (!found.empty()) put("</dl>");
    std::string items;
    for (const auto& warning : warnings()) items += "<li>" + warning + ".</li>";
    if (!items.empty()) put("<p>{}</p><ul>{}</ul>", say("The design:"), items);
    return std::move(html_);
  }

 private:
  /// All limitations of the families, each kind once. Flags on pooled tests are left out if the
  /// protocol declares no pooled test, because the report then has none.
  std::vector<Limitation> limitations() const {
    std::vector<Limitation> all;
    for (const auto& family : section_.results.families) {
      for (const auto& raised : flagsByKind(family, isPooled(Profile::Declared, family.family))) {
        auto same = std::ranges::find_if(
            all, [&](const auto& other) { return other.flag->id == raised.flag->id; });
        if (same == all.end()) same = all.insert(all.end(), {raised.flag, {}});
        for (const auto& [cohort, flag] : raised.found) add(same->found, cohort, *flag);
      }
    }
    return all;
  }

  void add(
      std::vector<std::pair<std::string, std::string>>& found,
      const std::string& cohort,
      const analysis::Flag& flag) const {
    std::string what;
    for (const auto& part : flag.what) what += section_.inWords(part);
    const auto& title = section_.cohortTitle(cohort);
    const auto same = std::ranges::find(found, what, &std::pair<std::string, std::string>::first);
    if (same == found.end()) {
      found.emplace_back(what, title);
    } else if (same->second.find(title) == std::string::npos) {
      same->second += ", " + title;
    }
  }

  std::size_t cohortsIn(const Limitation& limitation) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(section_.results.flow, [&](const auto& flow) {
          return std::ranges::any_of(limitation.found, [&](const auto& found) {
            return found.second.find(section_.cohortTitle(flow.cohort)) != std::string::npos;
          });
        }));
  }

  /// What was found, after the names of the cohorts to which it applies.
  std::string sentenceOf(
      const Limitation& limitation, const std::pair<std::string, std::string>& found) const {
    const auto& [what, who] = found;
    const auto each = say("In each cohort") + ": ";
    const bool isOfAll =
        limitation.found.size() == 1 && cohortsIn(limitation) == section_.results.flow.size();
    const bool isOnlyCohort = section_.results.flow.size() == 1;
    return (isOnlyCohort ? "" : isOfAll ? each : escaped(who) + ": ") + escaped(what);
  }

  /// What the check of the protocol says about its design.
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    for (const auto& warning : section_.warnings) {
      if (std::ranges::find(kFileWarnings, warning.what.key()) != kFileWarnings.end()) continue;
      auto sentence = placeOf(warning.path) + inWords(warning.what);
      if (std::ranges::find(all, sentence) == all.end()) all.push_back(std::move(sentence));
    }
    return all;
  }

  /// The title of the condition or block to which a place in the protocol belongs.
  std::string placeOf(const std::string& path) const {
    const auto indexIn = [&](const std::string& list) -> std::size_t {
      const auto at = path.find("$." + list + "[");
      if (at != 0) return std::string::npos;
      return static_cast<std::size_t>(std::atoi(path.c_str() + list.size() + 3));
    };
    const auto& phases = section_.protocol.phases;
    const auto& conditions = section_.protocol.conditions;
    if (const auto i = indexIn("phases"); i < phases.size()) {
      const bool isBlock = phases[i].type == protocols::PhaseType::Block;
      return isBlock ? escaped(section_.blockTitle(phases[i].id)) + ": " : std::string();
    }
    if (const auto i = indexIn("conditions"); i < conditions.size()) {
      return escaped(conditions[i].title) + ": ";
    }
    return {};
  }
};

}  // namespace

std::string caveatsOfRenderingAsHtml(const ReportSection& section) {
  return LimitationsWriter(section).renderingCaveats();
}

std::string weaknessesAsHtml(const ReportSection& section) {
  return LimitationsWriter(section).briefly();
}

std::string limitationsAsHtml(const ReportSection& section) {
  return LimitationsWriter(section).all();
}

}  // namespace study::report
