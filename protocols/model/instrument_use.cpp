#include "protocols/model/instrument_use.h"

namespace protocols {

std::vector<InstrumentUse> instrumentUses(const Protocol& protocol) {
  std::vector<InstrumentUse> uses;
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto& phase = protocol.phases[i];
    const std::string path = "$.phases[" + std::to_string(i) + "]";
    if (!phase.instrument.empty()) {
      uses.push_back({phase.instrument, path + ".instrument", phase.type});
    }
    for (std::size_t j = 0; j < phase.trials.questionnaires.size(); ++j) {
      const auto& asked = phase.trials.questionnaires[j];
      if (asked.instrument.empty()) continue;
      uses.push_back(
          {asked.instrument,
           path + ".questionnaires[" + std::to_string(j) + "].instrument",
           phase.type});
    }
  }
  return uses;
}

}  // namespace protocols
