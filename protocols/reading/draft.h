#pragma once

#include <string_view>

#include "protocols/model/loaded_protocol.h"

namespace protocols {

/// A protocol in the making: whatever could be read of it and of the files that it names.
///
/// What could not be read has been told and is empty here. The rules say nothing more about it, nor
/// about a name that may mean it: so everything that is wrong with a file comes out in one reading,
/// and nothing that follows from it.
struct Draft {
  LoadedProtocol loaded;
  bool hasAllInstruments = true;  ///< every one of 'instrument_files' could be read

  /// Whether @p id is a name, and the name of nothing.
  bool lacksDevice(std::string_view id) const noexcept;
  bool lacksCondition(std::string_view id) const noexcept;
  bool lacksInstrument(std::string_view id) const noexcept;

  /// Whether every phase could be read, if only its id and its type.
  bool hasAllPhases() const noexcept;
};

}  // namespace protocols
