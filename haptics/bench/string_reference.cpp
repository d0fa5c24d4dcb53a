#include "haptics/bench/string_reference.h"

namespace haptics::bench {
namespace {

HundredDigits springAfter(const std::vector<double>& k, std::size_t node) {
  if (node == 0) return HundredDigits(k.front());
  if (node == k.size()) return HundredDigits(k.back());
  return 1 / (1 / HundredDigits(k[node - 1]) + 1 / HundredDigits(k[node]));
}

}  // namespace

StringReference::StringReference(const std::vector<double>& k, double toolPosition) {
  const std::size_t n = k.size();
  std::vector<HundredDigits> diagonal(n);
  std::vector<HundredDigits> beside(n);
  std::vector<HundredDigits> tool(n);
  for (std::size_t i = 0; i < n; ++i) {
    diagonal[i] = springAfter(k, i) + springAfter(k, i + 1);
    beside[i] = -springAfter(k, i + 1);
    const HundredDigits distance = abs(HundredDigits(toolPosition) - (HundredDigits(i) + 0.5));
    if (distance < 1) tool[i] = 1 - distance;
  }
  const HundredDigits right = n - HundredDigits(toolPosition);
  if (toolPosition < 0.5) tool.front() = 2 * HundredDigits(toolPosition);
  if (right < 0.5) tool.back() = 2 * right;
  shape = tool;
  for (std::size_t i = 1; i < n; ++i) {
    const HundredDigits factor = beside[i - 1] / diagonal[i - 1];
    diagonal[i] -= factor * beside[i - 1];
    shape[i] -= factor * shape[i - 1];
  }
  shape.back() /= diagonal.back();
  for (std::size_t i = n - 1; i-- > 0;) {
    shape[i] = (shape[i] - beside[i] * shape[i + 1]) / diagonal[i];
  }
  HundredDigits compliance = 0;
  for (std::size_t i = 0; i < n; ++i) compliance += tool[i] * shape[i];
  stiffness = 1 / compliance;
}

}  // namespace haptics::bench
