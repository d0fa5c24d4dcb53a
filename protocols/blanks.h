#pragma once

#include <string>
#include <vector>

#include "protocols/loaded_protocol.h"

namespace protocols {

/// What the author of a text left for a laboratory to fill in, and nobody has: a participant would
/// read the brackets.
struct Blank {
  std::string where;  ///< the instrument, or the place in the protocol
  std::string words;  ///< "[[number]], [[institution]]"
};

/// Those in what a participant of @p language reads: the protocol's own texts, and title,
/// introduction and statements of the instruments that it uses, each instrument once.
std::vector<Blank> blanksOf(const LoadedProtocol& loaded, const std::string& language);

}  // namespace protocols
