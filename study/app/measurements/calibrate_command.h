#pragma once

#include <CLI/CLI.hpp>

#include "study/app/commands.h"

namespace study::app {

/// `recording calibrate`: readings of a force sensor under known loads become a calibration file.
void addCalibrate(CLI::App& noun, Action& action);

}  // namespace study::app
