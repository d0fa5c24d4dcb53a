#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "analysis/planning/power.h"
#include "study/results/apa_text.h"
#include "study/results/study_plan.h"
#include "study/words/counted.h"

namespace study {
namespace {

using words::counted;

/// A p value: ".03125", "7.6e-06"; with as many digits as the flag of too few participants has.
std::string pText(double p) {
  if (p >= 0.99995) return "1";
  if (p < 0.0001) return fmt::format("{:.1e}", p);
  return fmt::format("{:.4g}", p).substr(1);
}

std::string pText(const analysis::AttainableP& p) {
  if (p.p > 0.0) return pText(p.p);
  return fmt::format("1e{:.0f}", std::floor(p.log10P));
}

std::string share(double rate) {
  return rate >= 0.995 ? "1.00" : fmt::format("{:.2f}", rate).substr(1);
}

std::string sizeText(const std::optional<std::uint64_t>& size) {
  return size ? std::to_string(*size) : "more than a million";
}

std::string ordersText(const StudyPlan& plan) {
  std::string text = "Orders\n";
  for (const auto& block : plan.blocks) {
    text += fmt::format("  {}: {}, ", block.phase, counted(block.conditions, "condition"));
    if (block.conditions < 2) {
      text += "nothing to balance.\n";
    } else if (block.hasOneOrder) {
      text +=
          "the same order for everybody. No number of participants balances it: what is felt "
          "later may seem better or worse for that alone.\n";
    } else if (block.multipleOf == 0) {
      text += "an order drawn for everybody: balanced on average, exactly for no number.\n";
    } else {
      text += fmt::format("balanced for every multiple of {}.\n", block.multipleOf);
    }
  }
  if (plan.balancedBy < 2) return text;
  if (plan.planOptions.sites) {
    text += fmt::format(
        "  Each site draws orders of its own: they are balanced where each site has a multiple of "
        "{}.\n",
        plan.balancedBy);
  }
  for (const auto& cohort : plan.cohorts) {
    if (cohort.participants == 0) continue;
    const auto over = cohort.participants % plan.balancedBy;
    text += fmt::format("  {}: {} ", cohort.id, counted(cohort.participants, "participant"));
    if (cohort.isBalanced) {
      text += "balance every block.\n";
    } else {
      text += fmt::format(
          "do NOT balance every block; {}{} do.\n",
          cohort.participants > over ? fmt::format("{} or ", cohort.participants - over) : "",
          cohort.participants - over + plan.balancedBy);
    }
  }
  return text;
}

/// Whether an exact paired test can be significant only if others of its family have small p, too.
bool needsOthers(const FamilyPlan& family, const Detectability& detectability) {
  return detectability.canPairsBeSignificant && detectability.pair.p > family.levels.strictest;
}

/// At which level tests are simulated, for corrections that can ask less.
std::string atStrictestStep(const FamilyPlan& family) {
  return family.levels.mostLenient > family.levels.strictest
             ? ", at the strictest step of the correction"
             : "";
}

std::string pairVerdict(const FamilyPlan& family, const Detectability& detectability) {
  const auto smallestP = pText(detectability.pair);
  if (needsOthers(family, detectability)) {
    return fmt::format(
        "smallest exact p of a pair {}: above {} and below {}, so that an exact paired test can "
        "find something only if others of the family do, too",
        smallestP,
        pText(family.levels.strictest),
        pText(family.levels.mostLenient));
  }
  if (detectability.canPairsBeSignificant) {
    return fmt::format(
        "smallest exact p of a pair {}: below {}, so that exact paired tests can find something",
        smallestP,
        pText(family.levels.strictest));
  }
  return fmt::format(
      "smallest exact p of a pair {}: above {}, so that NO exact paired test can ever be "
      "significant, whatever people answer. At least {} are needed",
      smallestP,
      pText(family.levels.mostLenient),
      family.fewestForSignificance);
}

std::string friedmanVerdict(const FamilyPlan& family, const Detectability& detectability) {
  if (!detectability.friedman) return {};
  const bool can = detectability.friedman->p <= family.alpha;
  return fmt::format(
      "    smallest exact p of Friedman's test {}: it {} find something at {}.\n",
      pText(*detectability.friedman),
      can ? "can" : "can NOT",
      pText(family.alpha));
}

std::string simulationText(const FamilyPlan& family, const Detectability& detectability) {
  if (!detectability.found || !detectability.falsePositives) return {};
  const auto& found = *detectability.found;
  const auto& falsePositives = *detectability.falsePositives;
  const auto pooled =
      fmt::format("by Welch's t-test on pooled answers {}, ", share(found.pooledWelch.rate));
  std::string text = fmt::format(
      "    simulated{}: found {}by the paired t-test {}, by the exact sign-flip test {}, by the "
      "exact signed rank test {}, by Friedman's test {}.\n",
      atStrictestStep(family),
      family.test == protocols::TestType::Welch ? pooled : std::string(),
      share(found.pairedT.rate),
      share(found.signFlip.rate),
      share(found.signedRank.rate),
      share(found.friedman.rate));
  text += fmt::format(
      "    simulated without any difference, at least one is found: paired t-tests {}, Welch's on "
      "pooled answers {}.\n",
      share(falsePositives.anyPairedT.rate),
      share(falsePositives.anyPooledWelch.rate));
  return text;
}

std::string siteVerdict(const StudyPlan& plan, const Detectability& detectability) {
  const auto& sites = *plan.planOptions.sites;
  if (!detectability.sites) {
    return fmt::format(
        "    at {}: too few. A site needs two participants to be pooled, {} in all.\n",
        counted(sites.sites, "site"),
        sites.fewestParticipants());
  }
  const auto& at = *detectability.sites;
  std::string text = fmt::format(
      "    at {}, between which the effect has a standard deviation of {:g} d_z: design effect "
      "{:.2f}; power of the\n    pooled difference {}.\n",
      counted(sites.sites, "site"),
      sites.deviation,
      at.designEffect,
      share(at.power));
  if (!at.found || !at.falsePositives) return text;
  text += fmt::format(
      "    simulated: found by the pooled difference {}, by a paired t-test that ignores sites "
      "{}.{}\n",
      share(at.found->pooled.rate),
      share(at.found->pairedT.rate),
      at.found->medianHalfWidth
          ? fmt::format(" Pooled interval: ± {:.2f} points (median).", *at.found->medianHalfWidth)
          : std::string());
  text += fmt::format(
      "    simulated without any difference over all sites, at least one is found: pooled {}, "
      "ignoring sites {}.\n",
      share(at.falsePositives->anyPooled.rate),
      share(at.falsePositives->anyPairedT.rate));
  return text;
}

std::string prospectsText(const StudyPlan& plan, const FamilyPlan& family) {
  std::string text;
  for (std::size_t i = 0; i < plan.cohorts.size(); ++i) {
    const auto& detectability = family.detectabilities[i];
    if (detectability.participants == 0) {
      text += fmt::format(
          "  {}: nobody has said how many will come (\"planned\", or --participants).\n",
          plan.cohorts[i].id);
      continue;
    }
    text += fmt::format(
        "  {}, {}:\n    {}.\n{}",
        plan.cohorts[i].id,
        counted(detectability.participants, "participant"),
        pairVerdict(family, detectability),
        friedmanVerdict(family, detectability));
    if (detectability.power) {
      text += fmt::format(
          "    power of a paired t-test for d_z = {:g}{}: {}.\n",
          plan.planOptions.dz,
          family.isCorrected ? " at the strictest step of the correction" : "",
          share(*detectability.power));
    }
    text += simulationText(family, detectability);
    if (plan.planOptions.sites) text += siteVerdict(plan, detectability);
  }
  return text;
}

/// A sentence on the number of participants that the desired power needs at these sites.
std::string sitesText(const StudyPlan& plan, const FamilyPlan& family) {
  if (!plan.planOptions.sites) return {};
  const auto sites = counted(plan.planOptions.sites->sites, "site");
  if (family.sampleSizeForPowerAtSites) {
    return fmt::format(
        "  at {}: {} participants a cohort, over all sites; {} are equally many at each{}.\n",
        sites,
        *family.sampleSizeForPowerAtSites,
        *family.recommendedAtSites,
        plan.balancedBy > 1 ? " and balance the orders" : "");
  }
  return fmt::format(
      "  at {}: no number of participants is enough. More of them at few sites tell nothing of "
      "other sites: more sites do.\n",
      sites);
}

std::string powerTable(const StudyPlan& plan, const FamilyPlan& family) {
  const auto effects = effectsToShow(plan);
  std::string text = "  power of a paired t-test on participants' means, by d_z:\n             N";
  for (const double dz : effects) text += fmt::format("{:>8g}", dz);
  for (const auto n : sizesToShow(family)) {
    text += fmt::format("\n{:>14}", n);
    for (const double dz : effects) {
      text += fmt::format("{:>8}", share(analysis::pairedTPower(dz, n, family.levels.strictest)));
    }
  }
  std::set<double> powers{0.8, 0.9, plan.planOptions.power};
  for (const double power : powers) {
    if (power <= family.levels.strictest) continue;
    text += fmt::format("\n{:>14}", fmt::format("N for {:g}", power));
    for (const double dz : effects) {
      const auto n = analysis::participantsForPower(dz, family.levels.strictest, power);
      text += fmt::format("{:>8}", n ? std::to_string(*n) : "> 1e6");
    }
  }
  return text + "\n";
}

/// "alpha = .01667 each"; "alpha = .01667 to .05 each, depending on the others" for corrections
/// that ask less where several p values are small.
std::string levelText(const FamilyPlan& family) {
  const auto strictest = pText(family.levels.strictest);
  if (family.levels.mostLenient <= family.levels.strictest) {
    return fmt::format("alpha = {} each", strictest);
  }
  return fmt::format(
      "alpha = {} to {} each, depending on the others",
      strictest,
      pText(family.levels.mostLenient));
}

/// What the declared test finds, if another one than the paired t-test of all powers is declared.
std::string foundIfRecommended(const FamilyPlan& family) {
  if (!family.foundIfRecommended) return {};
  return fmt::format(
      " The declared test finds it with {} in {} of simulated studies{}.",
      *family.recommended,
      share(family.foundIfRecommended->rate),
      atStrictestStep(family));
}

std::string familyText(const StudyPlan& plan, const FamilyPlan& family) {
  std::string text = fmt::format(
      "\n{} ({}): {} of {}, {}, so {}\n  Declared test: {}.\n",
      family.title,
      family.id,
      counted(family.comparisons, "comparison"),
      counted(family.conditions, "condition"),
      family.isCorrected ? fmt::format("{} within {:g}", family.correction, family.alpha)
                         : fmt::format("not corrected, {:g}", family.alpha),
      levelText(family),
      testInWords(family.test));
  text += fmt::format(
      "  Each participant {} about each condition, on {}.\n",
      family.isScore ? "gives " + counted(family.answers, "score")
                     : "answers " + counted(family.answers, "statement"),
      family.isContinuous ? "a scale without steps"
                          : counted(static_cast<std::uint64_t>(family.points), "point"));
  text += prospectsText(plan, family);
  text += powerTable(plan, family);
  text += fmt::format(
      "  for d_z = {:g} with power {:g} by a paired t-test: {} participants a cohort{}.{}\n",
      plan.planOptions.dz,
      plan.planOptions.power,
      sizeText(family.sampleSizeForPower),
      family.recommended && plan.balancedBy > 1
          ? fmt::format("; {} balance the orders as well", *family.recommended)
          : "",
      foundIfRecommended(family));
  return text + sitesText(plan, family);
}

std::string cohortsText(const StudyPlan& plan) {
  if (plan.cohortPairs.empty()) return {};
  std::string text = "\nBetween cohorts, in one condition\n";
  for (const auto& pair : plan.cohortPairs) {
    text += fmt::format(
        "  {} against {}: smallest exact p of Mann and Whitney's test {}.\n",
        pair.first,
        pair.second,
        pText(pair.smallestP));
  }
  return text;
}

std::string votesText(const StudyPlan& plan) {
  if (plan.votes.empty()) return {};
  std::string text = "\nVotes\n";
  std::set<std::string> rounds;
  for (const auto& vote : plan.votes) {
    rounds.insert(vote.phase);
    if (vote.votes == 0 || vote.alternatives < 2) continue;
    text += fmt::format(
        "  {}, {}: {} for {}; ",
        vote.phase,
        vote.cohort,
        counted(vote.votes, "vote"),
        counted(vote.alternatives, "alternative"));
    text += vote.votesForSignificance
                ? fmt::format(
                      "one that gets {} or more is preferred by more than chance (exact "
                      "multinomial test).\n",
                      *vote.votesForSignificance)
            : vote.canDecide ? "too many to be counted out before the study.\n"
                             : "too few: not even all votes for one would be more than chance.\n";
  }
  text += "  A tie for the first place decides nothing; it is reported as one.\n";
  if (rounds.size() > 1) {
    text +=
        "  Votes of one person in several rounds depend on each other: each round is tested for "
        "itself, never their sum.\n";
  }
  return text;
}

std::string lengthText(const StudyPlan& plan) {
  const auto& pace = plan.planOptions.pace;
  std::string text =
      fmt::format("\nA session lasts about {} minutes\n", minutesOf(plan.length.seconds));
  for (const auto& part : plan.length.parts) {
    std::string of = counted(part.steps, "step");
    if (part.items > 0) of += ", " + counted(part.items, "item");
    if (part.cuts > 0) of += ", " + counted(static_cast<std::uint64_t>(part.cuts), "cut");
    text +=
        fmt::format("  {:>6.1f} min  {} ({})\n", part.seconds / 60.0, partInWords(part.kind), of);
  }
  text += fmt::format(
      "  Assumed: {:g} s an item, {:g} s an answer in words, {:g} s a cut, {:g} s before a trial, "
      "{:g} words read a second; without arrival and leaving.\n",
      pace.perItem,
      pace.perText,
      pace.perCut,
      pace.perPreparation,
      pace.wordsPerSecond);
  return text;
}

std::string siteSimulationText(const StudyPlan& plan) {
  if (!plan.planOptions.sites) return {};
  return fmt::format(
      "At sites, d_z is in units of the standard deviation of one site's participants. The effect "
      "of a site is normal around it\n(standard deviation {:g}, intraclass correlation {:.3f}). "
      "Pooled: random effects by REML, Knapp and Hartung's standard\nerror, as 'stats run' pools "
      "sites.\n",
      plan.planOptions.sites->deviation,
      plan.planOptions.sites->intraclassCorrelation());
}

std::string simulationText(const StudyPlan& plan) {
  const auto& model = plan.planOptions.model;
  if (plan.planOptions.studies == 0 || plan.families.empty()) return {};
  return fmt::format(
             "\nd_z is the mean difference of two conditions divided by the standard deviation of "
             "the "
             "participants' differences.\nSimulated: {} studies, seed {}; behind each answer a "
             "normal "
             "number cut into points, of whose variance the\nparticipant has {:g}, the "
             "participant's "
             "taste for a condition {:g}, chance {:g}; the first condition is ahead of the\nothers "
             "by d_z "
             "before it is cut into points. A plan, never a finding.\n",
             plan.planOptions.studies,
             plan.planOptions.seed,
             model.participantShare,
             model.participantByConditionShare,
             model.residualShare) +
         siteSimulationText(plan);
}

std::string cohortsInWords(const StudyPlan& plan) {
  std::string words;
  for (const auto& cohort : plan.cohorts) {
    if (cohort.participants == 0) continue;
    words += fmt::format(
        "{}{} in the cohort “{}”",
        words.empty() ? "" : ", ",
        counted(cohort.participants, "participant"),
        cohort.title);
  }
  return words;
}

std::string detectableInWords(const StudyPlan& plan, const FamilyPlan& family) {
  std::string words = fmt::format(
      " The family “{}” consists of {} of {} ({}). A paired t-test on participants' mean ratings "
      "needs {} participants a cohort to find a standardised difference of d_z = {:g} with a "
      "power of {:g}",
      family.title,
      counted(family.comparisons, "comparison"),
      counted(family.conditions, "condition"),
      family.isCorrected ? family.correction + ", " + levelText(family)
                         : levelText(family) + ", not corrected",
      sizeText(family.sampleSizeForPower),
      plan.planOptions.dz,
      plan.planOptions.power);
  std::set<std::uint64_t> seen;
  for (const auto& detectability : family.detectabilities) {
    if (!detectability.power || !seen.insert(detectability.participants).second) continue;
    words += fmt::format(
        "; with {} its power is {}, and an exact paired test {}",
        detectability.participants,
        share(*detectability.power),
        needsOthers(family, detectability)
            ? "can reach significance only together with others of the family"
        : detectability.canPairsBeSignificant ? "can reach significance"
                                              : "cannot reach significance");
    if (detectability.sites) {
      words += fmt::format(
          "; pooled over {}, between which the effect has a standard deviation of {:g} d_z, the "
          "power is {}",
          counted(plan.planOptions.sites->sites, "site"),
          plan.planOptions.sites->deviation,
          share(detectability.sites->power));
    }
  }
  words += ".";
  if (family.test == protocols::TestType::PairedT) return words;
  words += fmt::format(" The declared test is the {}.", testInWords(family.test));
  for (const auto& detectability : family.detectabilities) {
    if (!detectability.found || seen.erase(detectability.participants) == 0) continue;
    words += fmt::format(
        " With {} it finds this difference in {} of simulated studies{}.",
        counted(detectability.participants, "participant"),
        share(rateOf(family.test, *detectability.found).rate),
        atStrictestStep(family));
  }
  return words + foundIfRecommended(family);
}

/// "all 3 conditions"; for several blocks "3 conditions in “a” and 2 conditions in “b”". Empty if
/// no block has two conditions or more.
std::string conditionsInWords(const StudyPlan& plan) {
  std::string words;
  std::size_t most = 0;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    const auto& block = plan.blocks[i];
    most = std::max(most, block.conditions);
    if (plan.blocks.size() == 1) return most > 1 ? fmt::format("all {} conditions", most) : "";
    words += i == 0 ? "" : i + 1 == plan.blocks.size() ? " and " : ", ";
    words += fmt::format("{} in “{}”", counted(block.conditions, "condition"), block.phase);
  }
  return most > 1 ? words : "";
}

std::string devicesInWords(const StudyPlan& plan) {
  std::string limits;
  for (std::size_t i = 0; i < plan.forceLimits.size(); ++i) {
    const auto* separator = i == 0 ? "" : i + 1 == plan.forceLimits.size() ? " and " : ", ";
    limits += fmt::format("{}{:g} N", separator, plan.forceLimits[i]);
  }
  const bool isOne = plan.forceLimits.size() == 1;
  return (isOne ? "the device, which is limited to " : "the devices, which are limited to ") +
         limits;
}

}  // namespace

std::vector<double> effectsToShow(const StudyPlan& plan) {
  std::set<double> effects{0.5, 0.8, 1.0, 1.2, 1.5, std::abs(plan.planOptions.dz)};
  effects.erase(0.0);
  return {effects.begin(), effects.end()};
}

std::vector<std::uint64_t> sizesToShow(const FamilyPlan& family) {
  std::set<std::uint64_t> sizes{6, 8, 10, 12, 16, 20, 24, 30};
  for (const auto& detectability : family.detectabilities) {
    if (detectability.participants > 1) sizes.insert(detectability.participants);
  }
  return {sizes.begin(), sizes.end()};
}

std::string partInWords(StepKind kind) {
  switch (kind) {
    case StepKind::Reading:
      return "information and debriefing";
    case StepKind::Consent:
      return "consent";
    case StepKind::Form:
      return "forms";
    case StepKind::Benchmark:
      return "the real tool";
    case StepKind::Trial:
      return "trials on the device";
    case StepKind::Questionnaire:
      return "questions about what was felt";
    case StepKind::Preference:
      return "votes";
    case StepKind::Break:
      return "breaks";
    case StepKind::Interview:
      return "interview";
  }
  return {};
}

std::string ethicsParagraph(const StudyPlan& plan) {
  const auto cohorts = cohortsInWords(plan);
  std::string words = cohorts.empty() ? "The number of participants has not been decided."
                                      : "We plan to include " + cohorts + ".";
  if (plan.planOptions.sites) {
    words += fmt::format(" They come from {}.", counted(plan.planOptions.sites->sites, "site"));
  }
  if (const auto felt = conditionsInWords(plan); !felt.empty()) {
    words += " Every participant feels " + felt +
             ", so that conditions are compared within participants";
    words += plan.balancedBy > 1
                 ? fmt::format("; orders are balanced for every {} participants.", plan.balancedBy)
                 : ".";
  }
  for (const auto& family : plan.families) words += detectableInWords(plan, family);
  words += fmt::format(
      " A session takes about {} minutes, of which about {} are spent touching {}. "
      "Participants may pause or stop at any time.",
      minutesOf(plan.length.seconds),
      minutesOf(plan.length.secondsOnDevice),
      devicesInWords(plan));
  return words;
}

std::string studyPlanAsText(const StudyPlan& plan) {
  std::string text = plan.title + "\n\n" + ordersText(plan);
  if (plan.families.empty()) {
    text +=
        "\nThe protocol declares no comparisons (\"analysis\"): there is no power to be told.\n";
  }
  for (const auto& family : plan.families) text += familyText(plan, family);
  text += cohortsText(plan) + votesText(plan) + lengthText(plan) + simulationText(plan);
  return text + "\nFor an application to an ethics committee\n" + ethicsParagraph(plan) + "\n";
}

}  // namespace study
