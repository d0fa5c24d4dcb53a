#pragma once

#include <string>

namespace study {

/// Where a session takes place: one computer at one of the sites of a study. All empty in a study
/// of one machine.
struct Station {
  std::string site;   ///< "oslo"
  std::string label;  ///< "oslo", "oslo-2": unique in the study; participants' codes begin with it
  std::string uuid;   ///< drawn when the station was enrolled

  bool isNone() const noexcept { return label.empty(); }
};

}  // namespace study
