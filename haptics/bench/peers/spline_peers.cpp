#include <math.h>  // boost 1.74's pchip needs it before

#include <memory>
#include <unsupported/Eigen/Splines>

#include <Eigen/Core>
#include <boost/math/interpolators/makima.hpp>
#include <boost/math/interpolators/pchip.hpp>
#include <boost/version.hpp>

#include "haptics/bench/peers/peers.h"

#ifdef PALPATE_HAS_GSL
#include <gsl/gsl_spline.h>
#include <gsl/gsl_version.h>
#endif

namespace haptics::bench::peers {
namespace {

template <typename Interpolator>
Spline boostSpline(std::string name, std::vector<double> xs, std::vector<double> ys) {
  return splineOf(std::move(name), [spline = Interpolator(std::move(xs), std::move(ys))](double x) {
    return spline(x);
  });
}

Spline eigenSpline(const std::vector<double>& xs, const std::vector<double>& ys) {
  const auto unit = [start = xs.front(), perUnit = 1.0 / (xs.back() - xs.front())](double x) {
    return (x - start) * perUnit;
  };
  Eigen::RowVectorXd parameters(static_cast<Eigen::Index>(xs.size()));
  Eigen::RowVectorXd points(static_cast<Eigen::Index>(ys.size()));
  for (std::size_t i = 0; i < xs.size(); ++i) {
    parameters[static_cast<Eigen::Index>(i)] = unit(xs[i]);
    points[static_cast<Eigen::Index>(i)] = ys[i];
  }
  const auto spline =
      Eigen::SplineFitting<Eigen::Spline<double, 1>>::Interpolate(points, 3, parameters);
  return splineOf("Eigen cubic", [spline, unit](double x) { return spline(unit(x))[0]; });
}

#ifdef PALPATE_HAS_GSL
Spline gslSpline(
    std::string name,
    const gsl_interp_type* type,
    const std::vector<double>& xs,
    const std::vector<double>& ys) {
  const std::shared_ptr<gsl_spline> spline(gsl_spline_alloc(type, xs.size()), gsl_spline_free);
  const std::shared_ptr<gsl_interp_accel> hint(gsl_interp_accel_alloc(), gsl_interp_accel_free);
  gsl_spline_init(spline.get(), xs.data(), ys.data(), xs.size());
  return splineOf(std::move(name), [spline, hint](double x) {
    return gsl_spline_eval(spline.get(), x, hint.get());
  });
}
#endif

}  // namespace

std::vector<Spline> splinePeers(const std::vector<double>& xs, const std::vector<double>& ys) {
  namespace interpolators = boost::math::interpolators;
  using Numbers = std::vector<double>;
  std::vector<Spline> peers{
      boostSpline<interpolators::pchip<Numbers>>("Boost PCHIP", xs, ys),
      boostSpline<interpolators::makima<Numbers>>("Boost makima", xs, ys)};
#ifdef PALPATE_HAS_GSL
  peers.push_back(gslSpline("GSL natural cubic", gsl_interp_cspline, xs, ys));
  peers.push_back(gslSpline("GSL Steffen", gsl_interp_steffen, xs, ys));
#endif
  constexpr std::size_t kFeasible = 100;
  if (xs.size() <= kFeasible) peers.push_back(eigenSpline(xs, ys));
  return peers;
}

std::string versions() {
  std::string words =
      "Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
      "." + std::to_string(EIGEN_MINOR_VERSION) + ", Boost " +
      std::to_string(BOOST_VERSION / 100'000) + "." + std::to_string(BOOST_VERSION / 100 % 1000);
#ifdef PALPATE_HAS_GSL
  words += ", GSL " GSL_VERSION;
#else
  words += "; GSL was not there when this was built (./setup --check installs it)";
#endif
  return words;
}

}  // namespace haptics::bench::peers
