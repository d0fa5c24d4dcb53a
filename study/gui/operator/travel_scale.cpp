#include "study/gui/operator/travel_scale.h"

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {

TravelScale travelScaleOf(const haptics::devices::DeviceKind& device) {
  const auto& shown = device.shown;
  return {shown.factor, deskText(shown.unit), asText(shown.suffix), deskText(shown.energyUnit)};
}

}  // namespace study::gui
