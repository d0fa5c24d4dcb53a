#include "analysis/data/error.h"

#include <algorithm>
#include <cstddef>

namespace analysis {
namespace {

std::string listed(const std::vector<std::string>& problems) {
  constexpr std::size_t kMost = 10;
  std::string text;
  const std::size_t shown = std::min(problems.size(), kMost);
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : "\n") + problems[i];
  if (problems.size() > shown) {
    text += "\nand " + std::to_string(problems.size() - shown) + " more";
  }
  return text;
}

}  // namespace

Error::Error(const std::vector<std::string>& problems) : std::runtime_error(listed(problems)) {}

}  // namespace analysis
