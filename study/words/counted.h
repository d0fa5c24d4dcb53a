#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace study::words {

/// A number with its English noun: "1 cut", "3 cuts". An irregular plural is given by the caller.
inline std::string counted(std::uint64_t number, std::string_view one, std::string_view many = {}) {
  std::string text = std::to_string(number) + " ";
  if (number == 1) return text.append(one);
  return many.empty() ? text.append(one) + "s" : text.append(many);
}

}  // namespace study::words
