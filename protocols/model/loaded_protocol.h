#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/model/felt_source.h"
#include "protocols/model/protocol.h"
#include "questionnaires/model/instrument.h"

namespace protocols {

/// A file that a protocol consists of, as it was read: what a study keeps.
struct SourceFile {
  std::string name;  ///< as the protocol calls it
  std::string text;
};

/// A protocol with everything that it refers to, ready to be run.
struct LoadedProtocol {
  Protocol protocol;
  std::vector<questionnaires::Instrument> instruments;  ///< those it uses
  std::string text;                                     ///< the protocol's own file
  std::vector<SourceFile>
      files;  ///< its instruments and cuts, but for what is built into the program
  std::vector<FeltSource> sources;  ///< of its conditions, each once

  const questionnaires::Instrument* instrument(std::string_view id) const noexcept;
};

/// Finds the text of a file that a protocol names; nothing where there is none.
using FileFinder = std::function<std::optional<std::string>(const std::string& name)>;

}  // namespace protocols
