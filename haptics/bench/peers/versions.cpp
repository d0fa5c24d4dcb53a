#include "haptics/bench/peers/versions.h"

#include <Eigen/Core>
#include <boost/version.hpp>
#ifdef PALPATE_HAS_GSL
#include <gsl/gsl_version.h>
#endif

namespace haptics::bench::peers {

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
