#include <Eigen/Dense>

#include "haptics/bench/peers/peers.h"

namespace haptics::bench::peers {
namespace {

/// The Kalman filter of the punch paper as eq. (14)–(21) write it, with a matrix library: even the
/// 1×1 matrix S = H P Hᵀ + R is inverted as a matrix.
template <typename Matrix, typename Column, typename Row, typename One>
double filterWith(const KalmanNoiseValues& n, int steps, double travelled) {
  Column x = Column::Zero(2, 1);
  Matrix q(2, 2);
  q << n.q11, n.q12, n.q12, n.q22;
  Matrix p(2, 2);
  p << n.start11, 0.0, 0.0, n.start22;
  Row h(1, 2);
  h << 1.0, 0.0;
  const Matrix identity = Matrix::Identity(2, 2);
  One r(1, 1);
  One z(1, 1);
  const auto correct = [&](double measured, double variance) {
    r << variance;
    z << measured;
    const One s = h * p * h.transpose() + r;
    const Column k = p * h.transpose() * s.inverse();
    x = x + k * (z - h * x);
    p = (identity - k * h) * p;
  };
  for (int i = 0; i < steps; ++i) {
    Matrix a(2, 2);
    a << 1.0, (i & 64) != 0 ? travelled : -travelled, 0.0, 1.0;
    x = a * x;
    p = a * p * a.transpose() + q;
    correct(3.0, n.rElastic);
    correct(2.0, n.rRecorded);
  }
  return x(0);
}

}  // namespace

double eigenFixed(const KalmanNoiseValues& numbers, int steps, double travelled) {
  return filterWith<
      Eigen::Matrix2d,
      Eigen::Vector2d,
      Eigen::RowVector2d,
      Eigen::Matrix<double, 1, 1>>(numbers, steps, travelled);
}

double eigenDynamic(const KalmanNoiseValues& numbers, int steps, double travelled) {
  return filterWith<Eigen::MatrixXd, Eigen::MatrixXd, Eigen::MatrixXd, Eigen::MatrixXd>(
      numbers, steps, travelled);
}

}  // namespace haptics::bench::peers
