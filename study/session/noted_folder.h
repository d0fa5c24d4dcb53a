#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "questionnaires/json/document.h"

namespace study {

/// A folder as an event of the audit trail names it. A name that is no UTF-8 cannot be stored.
inline std::string asNoted(const std::filesystem::path& folder) {
  std::error_code ignored;
  auto text = std::filesystem::absolute(folder, ignored).lexically_normal().string();
  return questionnaires::charactersIn(text) ? text : "a folder whose name is not UTF-8";
}

}  // namespace study
