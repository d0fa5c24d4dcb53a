#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "protocols/model/protocol.h"
#include "questionnaires/model/instrument.h"

namespace protocols {

/// What conditions are felt from, or seen as, that stands in no protocol: a cut, a material, a bone
/// of spheres, a knee.
struct FeltSource {
  std::string kind;     ///< "cut", "material", "packing" or "anatomy"
  std::string file;     ///< as the protocol calls it; empty where it is built into the program
  base::Message title;  ///< for people
  std::vector<base::Message> origin;    ///< empty where the file says nothing
  bool isSynthetic = false;             ///< neither recorded nor measured
  std::vector<std::string> conditions;  ///< by id
};

/// Its origin in English: "spheres in 'cup.msh', fitted to 'bone.json'".
std::string describeOrigin(const FeltSource& source);

/// "Bone of specimen 7 (material 'bone.json'), test set dynamic-1", and its mark.
std::string describe(const FeltSource& source);

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

/// Text in double square brackets that the laboratory has not filled in yet: a participant would
/// read the brackets.
struct Placeholder {
  std::string where;          ///< the instrument, or the place in the protocol; and its languages
  std::string words;          ///< "[[number]], [[institution]]", of the first of them
  bool isInProtocol = false;  ///< and not in an instrument
};

/// Those in all texts that a participant may read, in every language of the protocol, since
/// participants can change it: the protocol's own texts, and all texts of the instruments that it
/// uses.
std::vector<Placeholder> placeholdersIn(const LoadedProtocol& loaded);

}  // namespace protocols
