#include <cmath>
#include <memory>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "haptics/bench/peers/peers.h"

namespace haptics::bench::peers {
namespace {

/// K and c of eq. (5)–(9); K is tridiagonal.
struct System {
  Eigen::VectorXd diagonal;
  Eigen::VectorXd offDiagonal;
  Eigen::VectorXd tool;

  System(const std::vector<double>& k, double toolPosition) {
    const auto n = static_cast<Eigen::Index>(k.size());
    const auto spring = [&](Eigen::Index node) {
      if (node == 0) return k.front();
      if (node == n) return k.back();
      const auto i = static_cast<std::size_t>(node);
      return 1.0 / (1.0 / k[i - 1] + 1.0 / k[i]);
    };
    diagonal.resize(n);
    offDiagonal.resize(n);
    tool = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      diagonal[i] = spring(i) + spring(i + 1);
      offDiagonal[i] = -spring(i + 1);
      const double distance = std::abs(toolPosition - (static_cast<double>(i) + 0.5));
      if (distance < 1.0) tool[i] = 1.0 - distance;
    }
  }

  Eigen::Index size() const { return diagonal.size(); }

  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd matrix = diagonal.asDiagonal();
    for (Eigen::Index i = 0; i + 1 < size(); ++i)
      matrix(i, i + 1) = matrix(i + 1, i) = offDiagonal[i];
    return matrix;
  }

  Eigen::SparseMatrix<double> sparse() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < size(); ++i) {
      entries.emplace_back(i, i, diagonal[i]);
      if (i + 1 == size()) break;
      entries.emplace_back(i, i + 1, offDiagonal[i]);
      entries.emplace_back(i + 1, i, offDiagonal[i]);
    }
    Eigen::SparseMatrix<double> matrix(size(), size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
};

/// A solver that computes force and mesh from the solution of K u = c.
/// @param solve  writes u for a given c; does not allocate if possible.
template <typename Solve>
StringSolver solverOf(std::string name, const Eigen::VectorXd& tool, Solve solve) {
  return {std::move(name), [tool, solve, mesh = Eigen::VectorXd()](double y) mutable {
            solve(tool, mesh);
            const double force = y / tool.dot(mesh);
            mesh *= force;
            return force;
          }};
}

/// Thomas' algorithm for a tridiagonal matrix.
struct Thomas {
  System system;
  Eigen::VectorXd reduced{system.size()};

  void operator()(const Eigen::VectorXd& tool, Eigen::VectorXd& solution) {
    const auto n = system.size();
    solution = tool;
    reduced[0] = system.diagonal[0];
    for (Eigen::Index i = 1; i < n; ++i) {
      const double factor = system.offDiagonal[i - 1] / reduced[i - 1];
      reduced[i] = system.diagonal[i] - factor * system.offDiagonal[i - 1];
      solution[i] -= factor * solution[i - 1];
    }
    solution[n - 1] /= reduced[n - 1];
    for (Eigen::Index i = n - 1; i-- > 0;) {
      solution[i] = (solution[i] - system.offDiagonal[i] * solution[i + 1]) / reduced[i];
    }
  }
};

}  // namespace

std::vector<StringSolver> stringPeers(
    const std::vector<double>& elementStiffnesses, double toolPosition) {
  using Vector = Eigen::VectorXd;
  using Lu = Eigen::PartialPivLU<Eigen::MatrixXd>;
  using Ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
  const System system(elementStiffnesses, toolPosition);
  std::vector<StringSolver> peers;
  constexpr Eigen::Index kDenseIsFeasible = 1000;
  if (system.size() <= kDenseIsFeasible) {
    const auto luEachStep = [system](const Vector& tool, Vector& solution) {
      solution = system.dense().partialPivLu().solve(tool);
    };
    const auto luOnce = [lu = Lu(system.dense())](const Vector& tool, Vector& solution) {
      solution = lu.solve(tool);
    };
    peers.push_back(solverOf("Eigen dense LU, each step", system.tool, luEachStep));
    peers.push_back(solverOf("Eigen dense LU, once", system.tool, luOnce));
  }
  const auto ldltOnce = [ldlt = std::make_shared<const Ldlt>(system.sparse())](
                            const Vector& tool, Vector& solution) { solution = ldlt->solve(tool); };
  peers.push_back(solverOf("Eigen sparse LDLᵀ, once", system.tool, ldltOnce));
  peers.push_back(solverOf("Thomas, each step", system.tool, Thomas{system}));
  return peers;
}

}  // namespace haptics::bench::peers
