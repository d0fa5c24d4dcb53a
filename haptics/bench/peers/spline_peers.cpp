#include "haptics/bench/peers/spline_peers.h"

#include <math.h>  // boost 1.74's pchip needs it before

#include <unsupported/Eigen/Splines>

#include <boost/math/interpolators/makima.hpp>
#include <boost/math/interpolators/pchip.hpp>
#ifdef PALPATE_HAS_GSL
#include <gsl/gsl_spline.h>
#endif

namespace haptics::bench::peers {
namespace {

template <typename Spline>
class BoostPeer final : public SplinePeer {
 public:
  BoostPeer(std::string name, std::vector<double> xs, std::vector<double> ys)
      : name_(std::move(name)), spline_(std::move(xs), std::move(ys)) {}

  std::string name() const override { return name_; }
  double at(double x) const override { return spline_(x); }
  double sweep(std::span<const double> xs) const override {
    return oneAfterTheOther(xs, [this](double x) { return spline_(x); });
  }

 private:
  std::string name_;
  Spline spline_;
};

class EigenPeer final : public SplinePeer {
 public:
  EigenPeer(const std::vector<double>& xs, const std::vector<double>& ys)
      : start_(xs.front()), perUnit_(1.0 / (xs.back() - xs.front())) {
    Eigen::RowVectorXd parameters(static_cast<Eigen::Index>(xs.size()));
    Eigen::RowVectorXd points(static_cast<Eigen::Index>(ys.size()));
    for (std::size_t i = 0; i < xs.size(); ++i) {
      parameters[static_cast<Eigen::Index>(i)] = unit(xs[i]);
      points[static_cast<Eigen::Index>(i)] = ys[i];
    }
    spline_ = Eigen::SplineFitting<Eigen::Spline<double, 1>>::Interpolate(points, 3, parameters);
  }

  std::string name() const override { return "Eigen cubic"; }
  double at(double x) const override { return spline_(unit(x))[0]; }
  double sweep(std::span<const double> xs) const override {
    return oneAfterTheOther(xs, [this](double x) { return at(x); });
  }

 private:
  double unit(double x) const { return (x - start_) * perUnit_; }

  double start_;
  double perUnit_;
  Eigen::Spline<double, 1> spline_;
};

#ifdef PALPATE_HAS_GSL
class GslPeer final : public SplinePeer {
 public:
  GslPeer(
      std::string name,
      const gsl_interp_type* type,
      const std::vector<double>& xs,
      const std::vector<double>& ys)
      : name_(std::move(name)),
        spline_(gsl_spline_alloc(type, xs.size())),
        accelerator_(gsl_interp_accel_alloc()) {
    gsl_spline_init(spline_, xs.data(), ys.data(), xs.size());
  }
  ~GslPeer() override {
    gsl_spline_free(spline_);
    gsl_interp_accel_free(accelerator_);
  }
  GslPeer(const GslPeer&) = delete;
  GslPeer& operator=(const GslPeer&) = delete;

  std::string name() const override { return name_; }
  double at(double x) const override { return gsl_spline_eval(spline_, x, accelerator_); }
  double sweep(std::span<const double> xs) const override {
    return oneAfterTheOther(
        xs, [this](double x) { return gsl_spline_eval(spline_, x, accelerator_); });
  }

 private:
  std::string name_;
  gsl_spline* spline_;
  gsl_interp_accel* accelerator_;
};
#endif

}  // namespace

std::vector<std::unique_ptr<SplinePeer>> splinePeers(
    const std::vector<double>& xs, const std::vector<double>& ys) {
  namespace interpolators = boost::math::interpolators;
  using Numbers = std::vector<double>;
  std::vector<std::unique_ptr<SplinePeer>> peers;
  peers.push_back(
      std::make_unique<BoostPeer<interpolators::pchip<Numbers>>>("Boost PCHIP", xs, ys));
  peers.push_back(
      std::make_unique<BoostPeer<interpolators::makima<Numbers>>>("Boost makima", xs, ys));
#ifdef PALPATE_HAS_GSL
  peers.push_back(std::make_unique<GslPeer>("GSL natural cubic", gsl_interp_cspline, xs, ys));
  peers.push_back(std::make_unique<GslPeer>("GSL Steffen", gsl_interp_steffen, xs, ys));
#endif
  constexpr std::size_t kFeasible = 100;
  if (xs.size() <= kFeasible) peers.push_back(std::make_unique<EigenPeer>(xs, ys));
  return peers;
}

}  // namespace haptics::bench::peers
