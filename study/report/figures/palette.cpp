#include "study/report/figures/palette.h"

#include <array>
#include <cmath>

namespace study::report {
namespace {

QColor blended(const QColor& a, const QColor& b, double t) {
  const auto mix = [t](int x, int y) { return static_cast<int>(std::lround(x + t * (y - x))); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

}  // namespace

QColor categoryColour(int index) {
  static const std::array<QColor, 7> kColours{
      QColor(0x00, 0x72, 0xb2),
      QColor(0xd5, 0x5e, 0x00),
      QColor(0x00, 0x9e, 0x73),
      QColor(0xcc, 0x79, 0xa7),
      QColor(0xe6, 0x9f, 0x00),
      QColor(0x56, 0xb4, 0xe9),
      QColor(0x44, 0x44, 0x44)};
  return kColours[static_cast<std::size_t>(index) % kColours.size()];
}

QColor divergingColour(int index, int points) {
  static const std::array<QColor, 5> kColours{
      QColor(0xca, 0x00, 0x20),
      QColor(0xf4, 0xa5, 0x82),
      QColor(0xd9, 0xd9, 0xd9),
      QColor(0x92, 0xc5, 0xde),
      QColor(0x05, 0x71, 0xb0)};
  const double place = points < 2 ? 2.0 : 4.0 * index / (points - 1);
  const auto left = static_cast<std::size_t>(std::fmin(3.0, std::floor(place)));
  return blended(kColours[left], kColours[left + 1], place - static_cast<double>(left));
}

}  // namespace study::report
