#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// An instrument as JSON says it (docs/questionnaire-format.md), and everything that is wrong with
/// it, problemsOf() included; std::nullopt if there are errors. Warnings come once there are none.
std::optional<Instrument> readInstrument(std::string_view json, Problems& problems);

/// The same, from one that must be sound.
/// @throws Error  listing all problems of the instrument called @p name.
Instrument readSoundInstrument(std::string_view json, const std::string& name);

}  // namespace questionnaires
