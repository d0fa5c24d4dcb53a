#include "analysis/reliability/intraclass_correlation.h"

#include <cmath>
#include <limits>

#include "analysis/data/two_way_layout.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

/// The mean squares as Shrout & Fleiss name them. Only their ratios have a meaning.
struct MeanSquares {
  double n = 0.0;
  double k = 0.0;
  DoubleDouble subjects;
  DoubleDouble raters;
  DoubleDouble residual;
  DoubleDouble within;
};

std::optional<double> quotient(const DoubleDouble& numerator, const DoubleDouble& denominator) {
  if (denominator.isZero()) return std::nullopt;
  return (numerator / denominator).high;
}

void addTest(IntraclassCorrelation& icc, const DoubleDouble& signal, const DoubleDouble& noise) {
  if (signal.isZero() && noise.isZero()) return;
  if (noise.isZero()) {
    icc.f = std::numeric_limits<double>::infinity();
    return;
  }
  icc.f = (signal / noise).high;
  icc.p = FisherDistribution(icc.degreesOfFreedom1, icc.degreesOfFreedom2).upperP(*icc.f);
}

/// The confidence interval of the quotient of the expected mean squares.
std::optional<Interval> quotientInterval(const IntraclassCorrelation& icc, double level) {
  if (!icc.f || !std::isfinite(*icc.f)) return std::nullopt;
  const double tail = 0.5 * (1.0 - level);
  const FisherDistribution distribution(icc.degreesOfFreedom1, icc.degreesOfFreedom2);
  return Interval{
      .low = *icc.f / distribution.upperQuantile(tail),
      .high = *icc.f / distribution.upperQuantile(1.0 - tail)};
}

/// ICC(1,·) and ICC(3,·), which differ only in the mean square that they use as noise.
void addConsistency(
    IntraclassCorrelation& single,
    IntraclassCorrelation& average,
    const MeanSquares& squares,
    const DoubleDouble& noise,
    double level) {
  const DoubleDouble signal = squares.subjects - noise;
  addTest(single, squares.subjects, noise);
  addTest(average, squares.subjects, noise);
  single.value = quotient(signal, squares.subjects + noise * (squares.k - 1.0));
  average.value = quotient(signal, squares.subjects);

  const auto f = quotientInterval(single, level);
  if (!f || !(f->low > 0.0)) return;
  single.interval = Interval{
      .low = (f->low - 1.0) / (f->low + squares.k - 1.0),
      .high = (f->high - 1.0) / (f->high + squares.k - 1.0)};
  average.interval = Interval{.low = 1.0 - 1.0 / f->low, .high = 1.0 - 1.0 / f->high};
}

/// The interval of ICC(2,1), with the degrees of freedom after Satterthwaite.
std::optional<Interval> agreementInterval(const MeanSquares& squares, double icc, double level) {
  const double n = squares.n;
  const double k = squares.k;
  const double subjects = (squares.subjects / squares.residual).high;  // per residual mean square
  const double raters = (squares.raters / squares.residual).high;

  const double ratersTerm = k * icc * raters;
  const double restTerm = n * (1.0 + (k - 1.0) * icc) - k * icc;
  const double sumOfTerms = ratersTerm + restTerm;
  const double degreesOfFreedom = (k - 1.0) * (n - 1.0) * sumOfTerms * sumOfTerms /
                                  ((n - 1.0) * ratersTerm * ratersTerm + restTerm * restTerm);

  const double tail = 0.5 * (1.0 - level);
  const double above = FisherDistribution(n - 1.0, degreesOfFreedom).upperQuantile(tail);
  const double below = FisherDistribution(degreesOfFreedom, n - 1.0).upperQuantile(tail);
  if (!std::isfinite(above) || !std::isfinite(below)) return std::nullopt;
  const double rest = k * raters + (k * n - k - n);
  return Interval{
      .low = n * (subjects - above) / (above * rest + n * subjects),
      .high = n * (below * subjects - 1.0) / (rest + n * below * subjects)};
}

/// The reliability of the mean of k ratings from that of one (Spearman–Brown).
double reliabilityOfAverage(double single, double k) {
  return k * single / (1.0 + (k - 1.0) * single);
}

void addAgreement(IntraclassCorrelations& all, const MeanSquares& squares) {
  IntraclassCorrelation& single = all.twoWayRandomSingle;
  IntraclassCorrelation& average = all.twoWayRandomAverage;
  const DoubleDouble signal = squares.subjects - squares.residual;
  const DoubleDouble ratersTerm = (squares.raters - squares.residual) / squares.n;
  addTest(single, squares.subjects, squares.residual);
  addTest(average, squares.subjects, squares.residual);
  single.value = quotient(
      signal, squares.subjects + squares.residual * (squares.k - 1.0) + ratersTerm * squares.k);
  average.value = quotient(signal, squares.subjects + ratersTerm);
  if (squares.residual.isZero() || squares.subjects.isZero() || !single.value) return;

  single.interval = agreementInterval(squares, *single.value, all.level);
  if (!single.interval) return;
  average.interval = Interval{
      .low = reliabilityOfAverage(single.interval->low, squares.k),
      .high = reliabilityOfAverage(single.interval->high, squares.k)};
}

void addDegreesOfFreedom(IntraclassCorrelations& all, double n, double k) {
  for (auto* icc : {&all.oneWaySingle, &all.oneWayAverage}) {
    icc->degreesOfFreedom1 = n - 1.0;
    icc->degreesOfFreedom2 = n * (k - 1.0);
  }
  for (auto* icc :
       {&all.twoWayRandomSingle,
        &all.twoWayRandomAverage,
        &all.twoWayMixedSingle,
        &all.twoWayMixedAverage}) {
    icc->degreesOfFreedom1 = n - 1.0;
    icc->degreesOfFreedom2 = (n - 1.0) * (k - 1.0);
  }
}

Reason whyMissing(const MeanSquares& squares) {
  if (squares.subjects.isZero() && squares.within.isZero()) {
    return reason("all_ratings_same");
  }
  if (squares.subjects.isZero()) {
    return reason("subject_means_same");
  }
  if (squares.residual.isZero()) {
    return reason("no_residual");
  }
  return {};
}

}  // namespace

IntraclassCorrelations intraclassCorrelations(
    std::span<const std::vector<double>> table, double level) {
  requireConfidenceLevel(level);
  const TwoWayLayout layout = twoWayLayout(table);
  IntraclassCorrelations all;
  all.subjects = layout.rows;
  all.raters = layout.columns;
  all.level = level;
  if (layout.rows < 2 || layout.columns < 2) {
    all.reason = reason("two_subjects_needed");
    return all;
  }

  const MeanSquares squares{
      .n = static_cast<double>(layout.rows),
      .k = static_cast<double>(layout.columns),
      .subjects = layout.rowMeanSquare(),
      .raters = layout.columnMeanSquare(),
      .residual = layout.residualMeanSquare(),
      .within = layout.withinMeanSquare()};
  addDegreesOfFreedom(all, squares.n, squares.k);
  addConsistency(all.oneWaySingle, all.oneWayAverage, squares, squares.within, level);
  addAgreement(all, squares);
  addConsistency(all.twoWayMixedSingle, all.twoWayMixedAverage, squares, squares.residual, level);
  all.reason = whyMissing(squares);
  return all;
}

}  // namespace analysis
