#include "haptics/recordings/travel_filter.h"

#include <array>

#include "haptics/recordings/kaiser_low_pass.h"

namespace haptics::recordings {
namespace {

constexpr std::array kAll{TravelFilter::AuthorsFir, TravelFilter::None};

}  // namespace

std::vector<double> filtered(std::span<const double> travel, TravelFilter filter) {
  if (filter == TravelFilter::None) return {travel.begin(), travel.end()};
  return KaiserLowPass(KaiserLowPass::Design{}).filtered(travel);
}

std::string_view nameOf(TravelFilter filter) noexcept {
  return filter == TravelFilter::AuthorsFir ? "authors-fir" : "none";
}

std::string parametersOf(TravelFilter filter) {
  if (filter == TravelFilter::None) return "travel as recorded";
  return "49-tap linear-phase Kaiser FIR, beta 5.653, -6 dB at 17.69075 Hz, Fs 1000/3 Hz nominal, "
         "unit gain at rest, delay of 24 rows taken out, end values held";
}

std::optional<TravelFilter> travelFilterNamed(std::string_view name) noexcept {
  for (const TravelFilter filter : kAll) {
    if (nameOf(filter) == name) return filter;
  }
  return std::nullopt;
}

}  // namespace haptics::recordings
