#include "haptics/bench/peers/string_peers.h"

#include <cmath>

#include <Eigen/Dense>
#include <Eigen/Sparse>

namespace haptics::bench::peers {
namespace {

/// K and c of eq. (5)–(9), as three diagonals.
struct System {
  Eigen::VectorXd diagonal;
  Eigen::VectorXd beside;
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
    beside.resize(n);
    tool = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      diagonal[i] = spring(i) + spring(i + 1);
      beside[i] = -spring(i + 1);
      const double distance = std::abs(toolPosition - (static_cast<double>(i) + 0.5));
      if (distance < 1.0) tool[i] = 1.0 - distance;
    }
  }

  Eigen::Index size() const { return diagonal.size(); }

  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd matrix = diagonal.asDiagonal();
    for (Eigen::Index i = 0; i + 1 < size(); ++i) matrix(i, i + 1) = matrix(i + 1, i) = beside[i];
    return matrix;
  }

  Eigen::SparseMatrix<double> sparse() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < size(); ++i) {
      entries.emplace_back(i, i, diagonal[i]);
      if (i + 1 == size()) break;
      entries.emplace_back(i, i + 1, beside[i]);
      entries.emplace_back(i + 1, i, beside[i]);
    }
    Eigen::SparseMatrix<double> matrix(size(), size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
};

/// Force and mesh from a solution of K u = c.
class Peer : public StringPeer {
 public:
  Peer(std::string name, System system) : system_(std::move(system)), name_(std::move(name)) {}
  std::string name() const override { return name_; }
  const double* mesh() const override { return mesh_.data(); }

  double solve(double y) override {
    solveForTool(mesh_);
    const double force = y / system_.tool.dot(mesh_);
    mesh_ *= force;
    return force;
  }

 protected:
  virtual void solveForTool(Eigen::VectorXd& solution) = 0;
  System system_;

 private:
  std::string name_;
  Eigen::VectorXd mesh_;
};

class LuEachStep final : public Peer {
 public:
  explicit LuEachStep(const System& system) : Peer("Eigen dense LU, each step", system) {}

 private:
  void solveForTool(Eigen::VectorXd& solution) override {
    solution = system_.dense().partialPivLu().solve(system_.tool);
  }
};

class LuOnce final : public Peer {
 public:
  explicit LuOnce(const System& system)
      : Peer("Eigen dense LU, once", system), lu_(system_.dense()) {}

 private:
  void solveForTool(Eigen::VectorXd& solution) override { solution = lu_.solve(system_.tool); }
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

class LdltOnce final : public Peer {
 public:
  explicit LdltOnce(const System& system)
      : Peer("Eigen sparse LDLᵀ, once", system), ldlt_(system_.sparse()) {}

 private:
  void solveForTool(Eigen::VectorXd& solution) override { solution = ldlt_.solve(system_.tool); }
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt_;
};

class ThomasEachStep final : public Peer {
 public:
  explicit ThomasEachStep(const System& system)
      : Peer("Thomas, each step", system), reduced_(system.size()) {}

 private:
  void solveForTool(Eigen::VectorXd& solution) override {
    const auto n = system_.size();
    solution = system_.tool;
    reduced_[0] = system_.diagonal[0];
    for (Eigen::Index i = 1; i < n; ++i) {
      const double factor = system_.beside[i - 1] / reduced_[i - 1];
      reduced_[i] = system_.diagonal[i] - factor * system_.beside[i - 1];
      solution[i] -= factor * solution[i - 1];
    }
    solution[n - 1] /= reduced_[n - 1];
    for (Eigen::Index i = n - 1; i-- > 0;) {
      solution[i] = (solution[i] - system_.beside[i] * solution[i + 1]) / reduced_[i];
    }
  }
  Eigen::VectorXd reduced_;
};

}  // namespace

std::vector<std::unique_ptr<StringPeer>> stringPeers(
    const std::vector<double>& elementStiffnesses, double toolPosition) {
  const System system(elementStiffnesses, toolPosition);
  constexpr Eigen::Index kDenseIsFeasible = 1000;
  std::vector<std::unique_ptr<StringPeer>> peers;
  if (system.size() <= kDenseIsFeasible) {
    peers.push_back(std::make_unique<LuEachStep>(system));
    peers.push_back(std::make_unique<LuOnce>(system));
  }
  peers.push_back(std::make_unique<LdltOnce>(system));
  peers.push_back(std::make_unique<ThomasEachStep>(system));
  return peers;
}

}  // namespace haptics::bench::peers
