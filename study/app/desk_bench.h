#pragma once

#include <QString>

namespace study::app {

/// Measures the desk: what a core has to give for the live plots of force, travel and velocity at
/// 1 kHz and sixty pictures a second, and how long a participant waits from pressing Next until the
/// answers are safe and the new page is drawn. Prints both beside their targets.
/// @param seconds  of plotting. @param folder  where a study is made for it, and removed.
/// @return whether both targets were met.
bool benchDesk(double seconds, const QString& folder);

}  // namespace study::app
