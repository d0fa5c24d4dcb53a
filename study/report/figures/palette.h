#pragma once

#include <QColor>

namespace study::report {

/// Colours of categories that can be told apart with any colour vision (Okabe & Ito 2008).
QColor categoryColour(int index);

/// Colours from disagreement to agreement for a scale of @p points, distinct also in grey at the
/// ends (ColorBrewer RdBu).
QColor divergingColour(int index, int points);

}  // namespace study::report
