#pragma once

#include <QCommandLineParser>

namespace study::app {

/// Draws both simulations at 1280 × 800 while simulated hands work in them, as fast as it goes;
/// prints who draws, how many pictures a second, how old what they show is, what was handed on
/// about spheres, and the targets beside them; leaves pictures where it was told. Then the desk
/// (desk_bench.h).
/// @return 0 where all targets were met, 1 otherwise.
int benchStudio(const QCommandLineParser& parser);

}  // namespace study::app
