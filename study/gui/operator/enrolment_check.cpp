#include "study/gui/operator/enrolment_check.h"

#include "protocols/model/loaded_protocol.h"
#include "study/gui/widgets/desk_language.h"

namespace study::gui {

std::vector<FindingsDialog::Found> checkTexts(
    const protocols::LoadedProtocol& protocol, const Enrolment& enrolment) {
  FindingsDialog::Found texts{"texts", {}};
  if (enrolment.runMode != RunMode::Live) return {};
  for (const auto& blank : protocols::placeholdersIn(protocol)) {
    texts.results.push_back(
        {haptics::devices::Finding::Fail,
         blank.where,
         said("still to be filled in: {}", blank.words),
         "Fill in the texts of the study, or try it with a pilot session."});
  }
  if (texts.results.empty()) return {};
  return {texts};
}

}  // namespace study::gui
