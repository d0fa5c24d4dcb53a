#pragma once

#include "study/gui/widgets/theme.h"

namespace study::gui {

Theme lightTheme();
Theme darkTheme();
/// Yellow and white on black, for low vision and for bright rooms.
Theme highContrastTheme();

}  // namespace study::gui
