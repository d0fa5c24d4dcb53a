#pragma once

#include <span>

#include "base/embedded_file.h"

namespace study {

/// The R and Python scripts of study/library, which are exported unchanged.
std::span<const base::EmbeddedFile> exportScripts();

}  // namespace study
