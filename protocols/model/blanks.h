#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "protocols/model/loaded_protocol.h"

namespace protocols {

/// A blank "[[key]]" in the texts that participants read.
struct Blank {
  std::string key;
  base::Message title;  ///< what to write there; for a blank of the laboratory's own, its key
  LocalizedText text;   ///< what the protocol's "texts" have for it; empty: still blank
};

/// The key of the duration of a session [minutes], which the program can estimate.
inline constexpr std::string_view kDurationBlank = "duration";

/// Each blank once, filled in or not: those of the shipped texts in the order of a form, then
/// others in the order in which they are read.
std::vector<Blank> blanksOf(const LoadedProtocol& loaded);

}  // namespace protocols
