#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <QColor>

// How far apart colours are, also for people who do not tell some of them apart.
namespace tests {

using Matrix = std::array<std::array<double, 3>, 3>;

inline constexpr Matrix kNormal{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
/// Colours as seen with one kind of cone missing: protan, deutan, tritan (Machado, Oliveira and
/// Fernandes 2009, 10.1109/TVCG.2009.113, severity 1, in linear light).
inline constexpr std::array<Matrix, 3> kColourBlind{
    {Matrix{
         {{0.152286, 1.052583, -0.204868},
          {0.114503, 0.786281, 0.099216},
          {-0.003882, -0.048116, 1.051998}}},
     Matrix{
         {{0.367322, 0.860646, -0.227968},
          {0.280085, 0.672501, 0.047413},
          {-0.011820, 0.042940, 0.968881}}},
     Matrix{
         {{1.255528, -0.076749, -0.178779},
          {-0.078411, 0.930809, 0.147602},
          {0.004733, 0.691367, 0.303900}}}}};

using Triple = std::array<double, 3>;

inline Triple inLab(const Triple& rgb) {
  const Triple xyz{
      (0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505,
      0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2],
      (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089};
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  return {
      116.0 * f(xyz[1]) - 16.0, 500.0 * (f(xyz[0]) - f(xyz[1])), 200.0 * (f(xyz[1]) - f(xyz[2]))};
}

inline Triple seen(const QColor& colour, const Matrix& eye) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const Triple rgb{linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())};
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i] += eye[i][j] * rgb[j];
    result[i] = std::clamp(result[i], 0.0, 1.0);
  }
  return inLab(result);
}

/// The colour difference ΔE (CIE 1976). Below about 2.3 it is invisible.
inline double colourDifference(const QColor& one, const QColor& other, const Matrix& eye) {
  const auto a = seen(one, eye);
  const auto b = seen(other, eye);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace tests
