#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/blanks.h"

namespace questionnaires {

/// Reads an instrument from JSON (docs/questionnaire-format.md) and reports all problems, those of
/// problemsOf() included; std::nullopt if there are errors. Warnings are only reported if there are
/// no errors.
/// @param blanks  fills in blanks before the texts are checked; nullptr: they stay.
std::optional<Instrument> readInstrument(
    std::string_view json, Problems& problems, BlankFiller* blanks = nullptr);

/// The same, from JSON that must be valid.
/// @throws Error  listing all problems of the instrument called @p name.
Instrument readSoundInstrument(std::string_view json, const std::string& name);

}  // namespace questionnaires
