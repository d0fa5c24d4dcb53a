#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace study::app {

/// A range of finite numbers. CLI::Range accepts "nan", because it is neither below nor above a
/// bound.
inline CLI::Validator finiteRange(double least, double most) {
  const CLI::Range range(least, most);
  return CLI::Validator(
      [range](std::string& text) {
        const bool isNumber = text.find_first_of("nN") == std::string::npos;  // nan, inf
        return isNumber ? range(text) : text + " is no number";
      },
      range.get_description());
}

}  // namespace study::app
