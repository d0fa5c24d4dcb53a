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

/// The meaning of keys that a protocol leaves out. A study keeps the defaults of the release under
/// which its protocol was added, so that an update of the program does not change the rendering.
enum class Defaults {
  /// The parametric cut ends at its largest force; a filter's recording fades out beyond its ends;
  /// seen tissue follows the force; a reamer removes all that it is pushed through; questions about
  /// a
  /// benchmark need none.
  Release01,
  /// The parametric cut falls to zero; a filter takes no measurement beyond a recording; seen
  /// tissue
  /// follows the penetration; a reamer removes what its teeth can take.
  Current
};

/// A source of what conditions render or show, from outside the protocol: a cut, a material, a bone
/// of spheres, a knee.
struct FeltSource {
  std::string kind;     ///< "cut", "material", "packing" or "anatomy"
  std::string file;     ///< as the protocol names it; empty if it is built into the program
  base::Message title;  ///< for people
  std::vector<base::Message> origin;    ///< empty if the file has none
  bool isSynthetic = false;             ///< neither recorded nor measured
  std::vector<std::string> conditions;  ///< by id
};

/// Its origin in English: "spheres in 'cup.msh', fitted to 'bone.json'".
std::string describeOrigin(const FeltSource& source);

/// "Bone of specimen 7 (material 'bone.json'), test set dynamic-1", and its mark.
std::string describe(const FeltSource& source);

/// A file of a protocol as it was read; a study stores it.
struct SourceFile {
  std::string name;  ///< as the protocol names it, or kCopiesOfLibrary with the file's name there
  std::string text;
};

/// How names of copies of the library's instruments begin, "palpate-library/debrief.json": a study
/// keeps them, so that its words do not change with the program (docs/decisions/0073).
inline constexpr std::string_view kCopiesOfLibrary = "palpate-library/";

/// A protocol with all files that it refers to, ready for sessions.
struct LoadedProtocol {
  Protocol protocol;
  std::vector<questionnaires::Instrument> instruments;  ///< those that it uses
  std::string text;                                     ///< the protocol's own file
  std::vector<SourceFile> files;    ///< instruments (those of the library, too), cuts and so on
  std::vector<FeltSource> sources;  ///< of its conditions, each once
  /// The keys of all blanks "[[key]]" in texts that participants read, filled in or not.
  std::vector<std::string> blanks;

  const questionnaires::Instrument* instrument(std::string_view id) const noexcept;
};

/// Finds the text of a file that a protocol names; std::nullopt if there is none.
using FileFinder = std::function<std::optional<std::string>(const std::string& name)>;

/// Writes what the protocol calls its alternatives into all texts that a participant may read:
/// "{Label}" as the prefix is written, "{label}" with a small first letter, unless it is an
/// abbreviation.
void fillInLabels(LoadedProtocol& loaded);

/// Text in double square brackets that the laboratory has not filled in yet: a participant would
/// read the brackets.
struct Placeholder {
  std::string where;  ///< the instrument, or the place in the protocol; and its languages
  std::string words;  ///< "[[duration]], [[institution]]", of the first of them
};

/// The placeholders in all texts that a participant may read, in every language of the protocol,
/// because participants can change the language: the protocol's own texts, and the texts of its
/// instruments.
std::vector<Placeholder> placeholdersIn(const LoadedProtocol& loaded);

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
