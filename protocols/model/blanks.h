#pragma once

#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"

namespace protocols {

/// What the author of a text left for a laboratory to fill in, and nobody has: a participant would
/// read the brackets.
struct Blank {
  std::string where;          ///< the instrument, or the place in the protocol; and its languages
  std::string words;          ///< "[[number]], [[institution]]", of the first of them
  bool isInProtocol = false;  ///< and not in an instrument
};

/// Those in whatever a participant may come to read, in any language of the protocol, since they
/// can change it: the protocol's own texts, and all texts of the instruments that it uses.
std::vector<Blank> blanksOf(const LoadedProtocol& loaded);

}  // namespace protocols
