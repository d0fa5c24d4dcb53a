#pragma once

#include <string>

#include "base/user_error.h"

namespace tests {

/// What the error says that @p action throws; empty where it throws none.
template <class Error = base::UserError>
std::string complaintOf(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace tests
