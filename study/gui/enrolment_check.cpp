#include "study/gui/enrolment_check.h"

#include "protocols/blanks.h"

namespace study::gui {

std::vector<FindingsDialog::Found> textsBefore(
    const protocols::LoadedProtocol& protocol, const Enrolment& enrolment) {
  FindingsDialog::Found texts{"texts", {}};
  if (enrolment.runMode != RunMode::Live) return {};
  for (const auto& blank : protocols::blanksOf(protocol, enrolment.language)) {
    texts.results.push_back(
        {haptics::devices::Finding::Fail,
         blank.where,
         "still to be filled in: " + blank.words,
         "Copy it beside the protocol, write what holds there, and amend the study; or try it with "
         "a pilot session."});
  }
  if (texts.results.empty()) return {};
  return {texts};
}

}  // namespace study::gui
