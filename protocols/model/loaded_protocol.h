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

/// The release whose default values apply to keys that a protocol leaves out. A study keeps the
/// defaults of the release under which its protocol was added, so that an update of the program
/// does not change the rendering.
enum class Defaults {
  /// The parametric cut ends at its largest force; a filter's recording fades out beyond its ends;
  /// displayed tissue follows the force; a reamer removes all bone that it is pushed through;
  /// questions about a benchmark are allowed without a benchmark.
  Release01,
  /// The force of the parametric cut falls to zero after its maximum; a filter uses no measurement
  /// beyond a recording; displayed tissue follows the penetration; the removal rate of a reamer is
  /// limited by its teeth.
  Current
};

/// Data outside of the protocol that conditions render or display: a cut, a material, a bone of
/// spheres, or a knee.
struct SceneDataSource {
  std::string kind;     ///< "cut", "material", "packing" or "anatomy"
  std::string file;     ///< as the protocol names it; empty if it is built into the program
  base::Message title;  ///< display name
  /// The origin of the data, in parts; empty if the file does not contain it.
  std::vector<base::Message> origin;
  bool isSynthetic = false;             ///< whether the data were neither recorded nor measured
  std::vector<std::string> conditions;  ///< ids of the conditions that use it
};

/// The origin in English: "spheres in 'cup.msh', fitted to 'bone.json'".
std::string describeOrigin(const SceneDataSource& source);

/// Title, file and origin in English: "Bone of specimen 7 (material 'bone.json'), test set
/// dynamic-1". Synthetic data are marked.
std::string describe(const SceneDataSource& source);

/// A file that a protocol refers to, as it was read; a study stores a copy.
struct SourceFile {
  /// The name in the protocol; kLibraryCopyPrefix + file name for a copy from the library.
  std::string name;
  std::string text;
};

/// Prefix of the names of copies of the library's instruments, "palpate-library/debrief.json". A
/// study keeps copies, so that its texts do not change with the program (docs/decisions/0073).
inline constexpr std::string_view kLibraryCopyPrefix = "palpate-library/";

/// A valid protocol with all files that it refers to.
struct LoadedProtocol {
  Protocol protocol;
  std::vector<questionnaires::Instrument> instruments;  ///< the instruments that the protocol uses
  std::string text;                                     ///< text of the protocol file itself
  Defaults defaults = Defaults::Current;                ///< with which it was read
  /// All files that it refers to, including instruments of the library.
  std::vector<SourceFile> files;
  std::vector<SceneDataSource> sources;  ///< data that its conditions use, without duplicates
  /// The keys of all blanks "[[key]]" in texts that participants read, filled in or not.
  std::vector<std::string> blanks;

  /// The instrument with this id; nullptr if the protocol does not use it.
  const questionnaires::Instrument* instrument(std::string_view id) const noexcept;
};

/// Returns the text of a file that a protocol refers to; std::nullopt if there is none.
using FileFinder = std::function<std::optional<std::string>(const std::string& name)>;

/// Replaces placeholders in all texts that a participant may read by the protocol's word for an
/// alternative (Labels::prefix): "{Label}" by the word itself, "{label}" by the word with a
/// lower-case first letter, unless it is an abbreviation. In the texts of phases "{minimum_cuts}"
/// is replaced by the phase's number.
void fillInLabels(LoadedProtocol& loaded);

/// A text in double square brackets that the laboratory has not replaced yet, so that participants
/// would read the brackets.
struct Placeholder {
  std::string where;  ///< the instrument or the place in the protocol, and the languages
  std::string words;  ///< "[[duration]], [[institution]]", in the first of these languages
};

/// The placeholders in all texts that a participant may read: in the protocol's own texts and in
/// those of its instruments, in every language of the protocol, because participants can change the
/// language.
std::vector<Placeholder> unfilledPlaceholdersIn(const LoadedProtocol& loaded);

/// A blank "[[key]]" in texts that participants read.
struct Blank {
  std::string key;
  base::Message title;  ///< what to write there; the key if the laboratory added the blank
  LocalizedText text;   ///< the laboratory's text, from the protocol's "texts"; empty if not filled
                        ///< in
};

/// The key of the blank for the duration of a session [minutes], which the program can estimate.
inline constexpr std::string_view kDurationBlank = "duration";

/// All blanks without duplicates, filled in or not: first those of the shipped texts in the order
/// of a form, then the others in the order in which participants read them.
std::vector<Blank> blanksOf(const LoadedProtocol& loaded);

}  // namespace protocols
