#pragma once

#include <string_view>

#include "questionnaires/json/problem.h"

namespace study::gui {

/// The line of @p json, from 0, on which stands what a JSON path means ("$.phases[3].order"); where
/// that is not there, the line of the nearest thing around it that is. JSON that breaks off is read
/// as far as it goes.
int lineOf(std::string_view json, std::string_view path);

/// The line that a problem is about: the one that it names itself, where the file is no JSON there,
/// or else that of its path.
int lineOf(std::string_view json, const questionnaires::Problem& problem);

}  // namespace study::gui
