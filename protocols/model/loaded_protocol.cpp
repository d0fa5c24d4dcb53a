#include "protocols/model/loaded_protocol.h"

#include <algorithm>

namespace protocols {

const questionnaires::Instrument* LoadedProtocol::instrument(std::string_view id) const noexcept {
  const auto found = std::find_if(
      instruments.begin(), instruments.end(), [&](const auto& i) { return i.id == id; });
  return found == instruments.end() ? nullptr : &*found;
}

}  // namespace protocols
