#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "study/app/command_options.h"
#include "study/app/planning/study_plan_file.h"

namespace study::app {
namespace {

struct PlanArguments {
  std::string file;
  StudyPlanOptions planOptions;
  std::vector<double> shares;
  std::optional<std::uint64_t> sites;
  double siteDeviation = analysis::SitePlan::kCautiousTau;
  bool json = false;
};

void applyShares(PlanArguments& options) {
  if (options.shares.empty()) return;
  const double sum = options.shares[0] + options.shares[1] + options.shares[2];
  if (std::abs(sum - 1.0) > 1e-9) {
    throw std::runtime_error(
        "The three shares of the variance must add up to 1, for instance --shares 0.3 0.2 0.5.");
  }
  options.planOptions.model.participantShare = options.shares[0];
  options.planOptions.model.participantByConditionShare = options.shares[1];
  options.planOptions.model.residualShare = options.shares[2];
}

int plan(PlanArguments options) {
  applyShares(options);
  if (options.sites) {
    options.planOptions.sites = {.sites = *options.sites, .deviation = options.siteDeviation};
  }
  const auto loaded = loadOrPrintProblems(options.file);
  if (!loaded) return 1;
  const auto found = planOf(*loaded, options.planOptions);
  std::fputs((options.json ? studyPlanAsJson(found) : studyPlanAsText(found)).c_str(), stdout);
  return 0;
}

void addSites(CLI::App& command, PlanArguments& options) {
  auto* sites = command.add_option(
      "--sites",
      options.sites,
      "Number of sites among which each cohort's participants are divided");
  sites->check(CLI::Range(2, 1000));
  command
      .add_option(
          "--site-sd",
          options.siteDeviation,
          "Standard deviation of the effect between sites [d_z]; the default is from Klein et al. "
          "2018")
      ->check(finiteRange(0.0, 10.0))
      ->capture_default_str()
      ->needs(sites);
}

void addAssumptions(CLI::App& command, PlanArguments& options) {
  auto& planOptions = options.planOptions;
  command
      .add_option(
          "--shares",
          options.shares,
          "Simulated answers: shares of variance by participant, participant × condition, chance "
          "(default: 0.3 0.2 0.5)")
      ->type_name("PARTICIPANT INTERACTION CHANCE")
      ->expected(3)
      ->check(finiteRange(0.0, 1.0));
  command
      .add_option(
          "--studies", planOptions.studies, "Number of studies to simulate for the power; 0: none")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  command.add_option("--seed", planOptions.seed, "Seed of the simulation")->capture_default_str();
  command
      .add_option(
          "--seconds-per-item",
          planOptions.pace.perItem,
          "Time to answer a statement or a choice [s]")
      ->check(finiteRange(0.1, 3600.0))
      ->capture_default_str();
  command
      .add_option(
          "--seconds-per-cut",
          planOptions.pace.perCut,
          "Time for a cut on the device or with the real tool [s]")
      ->check(finiteRange(0.1, 3600.0))
      ->capture_default_str();
}

}  // namespace

void addPlanCommand(CLI::App& program, Action& action) {
  auto [command, options] = addCommand(
      program,
      action,
      "plan",
      "Plan a study: sample size, power, detectable effects, duration",
      plan);
  auto& planOptions = options.planOptions;
  addProtocolFile(*command, options.file, "PROTOCOL");
  command
      ->add_option(
          "--participants",
          planOptions.participants,
          "Participants of each cohort (default: as planned)")
      ->check(CLI::Range(1, 1000));
  command
      ->add_option(
          "--effect",
          planOptions.dz,
          "Effect to detect, d_z: mean difference / its standard deviation across participants")
      ->check(finiteRange(0.01, 100.0))
      ->capture_default_str();
  command
      ->add_option(
          "--alpha",
          planOptions.alpha,
          "Significance level of a family of comparisons (default: as declared in the protocol)")
      ->check(finiteRange(1e-6, 0.5));
  command->add_option("--power", planOptions.power, "Power to reach")
      ->check(finiteRange(0.5, 0.9999))
      ->capture_default_str();
  addSites(*command, options);
  addAssumptions(*command, options);
  command->add_flag("--json", options.json, "Print JSON with full precision");
}

}  // namespace study::app
