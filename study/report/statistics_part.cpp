#include <algorithm>
#include <set>
#include <span>

#include "analysis/registry/registry.h"
#include "base/joined.h"
#include "study/model/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/references.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

/// The works that a correction comes from; Bonferroni's has none.
std::string_view publicationsOf(protocols::CorrectionType correction) {
  using enum protocols::CorrectionType;
  switch (correction) {
    case Holm:
    case HolmSidak:
      return "Holm 1979";
    case Hochberg:
      return "Hochberg 1988";
    case Hommel:
      return "Hommel 1988";
    case BenjaminiHochberg:
      return "Benjamini & Hochberg 1995";
    case BenjaminiYekutieli:
      return "Benjamini & Yekutieli 2001";
    case None:
    case Bonferroni:
      break;
  }
  return {};
}

/// Writes what a later version of the protocol did to a family.
class PlanChange {
 public:
  PlanChange(const ReportSection& section, const FamilyChange& change)
      : section_(section), words_(section.words), change_(change) {}

  std::string inWords() const {
    const auto when = this->when();
    switch (change_.kind) {
      case FamilyChange::Kind::Added:
        return words_.say(
            "Version {} ({}) added “{}” after the first participant had begun{}",
            change_.version,
            when,
            change_.title,
            consequence());
      case FamilyChange::Kind::Removed:
        return words_.say(
            "Version {} ({}) dropped “{}”, which had been declared before.",
            change_.version,
            when,
            change_.title);
      case FamilyChange::Kind::Restored:
        return words_.say(
            change_.isHarmless
                ? "Version {} ({}) put “{}” back as it was declared, before anybody had begun with "
                  "the "
                  "change."
                : "Version {} ({}) put “{}” back as it was declared, but participants had begun "
                  "with the change: all of it is exploratory.",
            change_.version,
            when,
            change_.title);
      case FamilyChange::Kind::Changed:
        break;
    }
    return words_.say(
        "Version {} ({}) changed “{}” after the first participant had begun ({}){}",
        change_.version,
        when,
        change_.title,
        base::joined(change_.keys, ", ", [&](auto key) { return changed(key); }),
        consequence());
  }

 private:
  /// "2026-03-01, after 4 participants"
  std::string when() const {
    const auto day = change_.addedUtc.substr(0, change_.addedUtc.find('T'));
    const auto after =
        words_.count(change_.participants, "after {} participant", "after {} participants");
    return change_.participants > 0 ? day + ", " + after : day;
  }

  /// "test: before paired t-test of participants' means, now …"; only the name of a key with lists.
  std::string changed(std::string_view key) const {
    const auto name = words_(key == "equivalence_bound" ? "equivalence bound" : key);
    if (!change_.before || !change_.after) return name;
    const auto before = valueOf(*change_.before, key);
    const auto after = valueOf(*change_.after, key);
    const auto both = words_.say("{}: before {}, now {}", name, before, after);
    return before.empty() || after.empty() ? name : both;
  }

  std::string valueOf(const protocols::Family& family, std::string_view key) const {
    const auto correction = nameOf(family.correction);
    const auto bound = family.equivalenceBound.value_or(0.0);
    if (key == "test") return testInWords(family.test, words_);
    if (key == "correction") return correction.empty() ? words_("none") : std::string(correction);
    if (key == "alpha") return exactDecimal(family.alpha);
    if (key != "equivalence_bound") return {};
    return family.equivalenceBound ? withUnit(section_, family, exactDecimal(bound))
                                   : words_("none");
  }

  /// The consequence for the family, as the end of a sentence.
  std::string consequence() const {
    return words_(
        change_.isHarmless ? "; it was put back as it was declared."
                           : ": all of it is exploratory.");
  }

  const ReportSection& section_;
  const words::Words& words_;
  const FamilyChange& change_;
};

/// Writes what was declared, and which tests the report has. A test without any result is not among
/// them.
class StatisticsWriter : HtmlWriter {
 public:
  StatisticsWriter(const ReportSection& section, Citations& citations)
      : HtmlWriter(section), citations_(citations) {
    for (const auto& family : section.results.families) gather(family);
    for (const std::string_view model : {"mixed_model", "ordinal_model"}) {
      if (auto one = pairs_.extract(model)) models_.insert(std::move(one));
    }
    for (const auto& vote : section.results.votes) {
      if (vote.test.exactP) votes_.insert("equal_shares");
    }
  }

  std::string all() {
    list("Tests of all answers, pooled: {}.", pooled_);
    list("Tests within people, which take each participant’s mean: {}.", pairs_);
    list(
        "Models of single answers, with effects of person and of person × method, and of the round "
        "where there are several: {}.",
        models_);
    list("Tests of all methods together: {}.", overall_);
    list("Between cohorts, on participants’ means: {}.", between_);
    list("Of the scale: {}.", scale_);
    list("Of votes: {}.", votes_);
    const auto wilson = section_.words.say(
        "Shares have Wilson’s interval {}.", citeIf(!votes_.empty(), "Wilson 1927"));
    const auto cliff = section_.words.say(
        "Cliff’s δ has the interval of Feng and Cliff {}.",
        citeIf(!between_.empty(), "Feng & Cliff 2004"));
    const auto standardised = section_.words.say(
        "The effect size {} is that of Hedges {}, with the interval of noncentral t.",
        "g_z",
        citeIf(isStandardised_, "Hedges 1981"));
    const auto exact = section_.words("Exact tests count all arrangements, ties included.");
    const auto mixed = section_.words(
        "The linear mixed model is fitted by REML with Satterthwaite’s degrees of freedom; it "
        "takes all differences to vary alike (sphericity).");
    const auto ordinal =
        section_.words("The ordinal mixed model is fitted by Laplace’s approximation.");
    add(!votes_.empty(), wilson);
    add(!between_.empty(), cliff);
    add(isStandardised_, standardised);
    add(!pairs_.empty() || !between_.empty() || !votes_.empty(), exact);
    add(models_.contains("mixed_model"), mixed);
    add(models_.contains("ordinal_model"), ordinal);
    corrections();
    const auto validity = section_.words.say(
        "Evidence of validity is arranged by the five sources of the Standards {}.",
        citations_.cite("AERA et al. 2014, Messick 1995, Cook & Hatala 2016"));
    add(true, validity);
    put("<p>{} {}</p>", plan(), withSubscripts(escaped(withCurlyQuotes(text_))));
    return std::move(html_);
  }

 private:
  std::string plan() const {
    std::string text;
    for (const auto& family : section_.protocol.analysis.families) {
      text +=
          say("Declared for “{}” in version {} of the protocol: {}, α = {}, {}.",
              family.title,
              section_.protocol.study.version,
              declaredInWords(family, section_.words),
              exactDecimal(family.alpha),
              section_.words.count(family.comparisons.size(), "{} comparison", "{} comparisons")) +
          " ";
      if (family.equivalenceBound) {
        const auto bound =
            withUnit(section_, family, fmt::format("{:g}", *family.equivalenceBound));
        text += say("Differences below {} count as none.", bound) + " ";
      }
    }
    return text + changes();
  }

  /// What is said of later versions of the protocol; page 1 has their changes to the families.
  std::string changes() const {
    const auto& history = section_.history;
    if (history.versions < 2) return {};
    std::string text =
        say("There are {} versions of the protocol; the audit trail has each with its reason.",
            history.versions);
    for (const auto& sentence : planChangesInWords(section_)) text += " " + escaped(sentence);
    if (!section_.results.changes.empty()) {
      text += " " + say("What was asked or felt was changed as well: see “Limitations”.");
    }
    const bool isLive = section_.results.runMode == RunMode::Live;
    if (!history.changes.empty() || !isLive) return text;
    return text + " " +
           (history.versionsSinceBegun == 0
                ? say("All of them are older than the first participant’s session.")
                : say("None that came after the first participant had begun changed what was "
                      "declared."));
  }

  using Ids = std::set<std::string_view>;

  static void gather(std::span<const analysis::TestRow> rows, Ids& ids) {
    for (const auto& row : rows) {
      if (row.p || (row.effect.value && row.reason.empty())) ids.insert(row.id);
    }
  }

  void gather(const FamilyResult& family) {
    for (const auto& part : family.cohorts) {
      if (family.isNamed("welch")) gather(part.comparisons.rows, pooled_);
      for (const auto& pair : part.within.rows) {
        gather(pair.tests, pairs_);
        if (normalityOf(part, pair).w) pairs_.insert("shapiro_wilk");
        isStandardised_ = isStandardised_ || pair.test("paired_t").effectInterval;
      }
      gather(part.within.overall, overall_);
      for (const auto& method : part.checks.methods) {
        if (method.alpha.value) scale_.insert("cronbach_alpha");
        if (method.omega.value) scale_.insert("omega_total");
      }
    }
    for (const auto& one : family.between) gather(one.tests, between_);
  }

  void add(bool isTrue, const std::string& sentence) {
    if (isTrue) text_ += (text_.empty() ? "" : " ") + sentence;
  }

  std::string citeIf(bool isTrue, std::string_view publications) {
    return isTrue ? citations_.cite(publications) : std::string();
  }

  /// A sentence that lists tests in the order of the registry.
  void list(std::string_view english, const Ids& ids) {
    std::string tests;
    for (const auto& test : analysis::statisticalTests()) {
      if (!ids.contains(test.id)) continue;
      tests += (tests.empty() ? "" : "; ") + section_.words(test.title) + " " +
               citations_.cite(test.source);
    }
    const auto sentence = section_.words.say(english, tests);
    add(!tests.empty(), sentence);
  }

  /// How p values are adjusted, each way once.
  void corrections() {
    std::set<protocols::CorrectionType> all;
    const bool isAnyTested = !pooled_.empty() || !pairs_.empty();
    if (!isAnyTested) return;
    for (const auto& family : section_.results.families) all.insert(family.family.correction);
    std::string list;
    for (const auto correction : all) {
      const auto name = nameOf(correction);
      if (name.empty()) continue;
      const auto publications = publicationsOf(correction);
      list += (list.empty() ? "" : ", ") + std::string(name) +
              (publications.empty() ? std::string() : " " + citations_.cite(publications));
    }
    const auto sentence =
        section_.words.say("p values are adjusted before they are rounded: {}.", list);
    add(!list.empty(), sentence);
    const auto leftOut =
        section_.words("A comparison that could not be tested does not count in the correction.");
    const bool isAnyLeftOut =
        std::ranges::any_of(section_.results.families, [](const auto& family) {
          return std::ranges::any_of(family.cohorts, [&](const auto& part) {
            return !nameOf(family.family.correction).empty() && !leftOutIn(family, part).empty();
          });
        });
    add(isAnyLeftOut, leftOut);
  }

  Citations& citations_;
  std::string text_;
  bool isStandardised_ = false;  ///< whether there is a g_z
  Ids pooled_, pairs_, models_, overall_, between_, scale_, votes_;
};

}  // namespace

std::vector<std::string> planChangesInWords(const ReportSection& section) {
  std::vector<std::string> sentences;
  for (const auto& change : section.history.changes) {
    sentences.push_back(withCurlyQuotes(PlanChange(section, change).inWords()));
  }
  return sentences;
}

std::string statisticsAsHtml(const ReportSection& section, Citations& citations) {
  return StatisticsWriter(section, citations).all();
}

}  // namespace study::report
