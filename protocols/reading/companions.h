#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "haptics/recordings/cut.h"
#include "protocols/reading/draft.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Reads the files that a protocol names, and keeps what it read in the draft. Their problems go
/// where the protocol's go, with the file's name before the path.
class Companions {
 public:
  /// All three outlive this.
  Companions(Draft& draft, const FileFinder& find, questionnaires::Problems& problems)
      : draft_(draft), find_(find), problems_(problems) {}

  /// Those of 'instrument_files', and then those of the library that are used; with their wording
  /// files, where they have or need any.
  void readInstruments();

  /// Puts the material that @p condition names, if it names one, into its scene.
  void readMaterial(Condition& condition);

  /// Puts the bone that @p condition names, if it names one, into its scene.
  void readPacking(Condition& condition);

  /// Gives @p condition the knee that it names, if it names one, to be seen.
  void readAnatomy(Condition& condition);

  /// Puts the cut that @p condition names, if it names one, into its scene.
  void readCut(Condition& condition);

 private:
  struct PackingFile {
    std::shared_ptr<const haptics::reaming::PackedBone> bone;  ///< nothing where it is damaged
    std::vector<base::Message> origin;                         ///< in words
  };
  using Knee = std::shared_ptr<const Anatomy>;
  using CutFile = std::optional<haptics::recordings::Cut>;

  void readInstrument(std::size_t index);
  void addLibraryInstruments();
  void addWording(questionnaires::Instrument& instrument, const std::string& path);
  static void fill(haptics::engine::InterpolationSpec& spec, const haptics::recordings::Cut& cut);
  PackingFile packingOf(const PackingReference& reference);
  /// Passes on what was found in another file, with that file's name before the path.
  static void passOn(
      const questionnaires::Problems& found,
      const std::string& file,
      questionnaires::Problems& problems);
  Knee kneeOf(const AnatomyReference& reference);
  CutFile cutOf(const CutReference& reference);
  void tellSource(FeltSource source, const Condition& condition);
  std::optional<std::string> textOf(const std::string& name, const std::string& path);
  std::optional<std::string> found(const std::string& name, const std::string& path);
  std::optional<std::string> textIfThere(const std::string& name, const std::string& path);

  Draft& draft_;
  const FileFinder& find_;
  questionnaires::Problems& problems_;
  std::map<std::string, PackingFile> packings_;  ///< by file; conditions share them
  std::map<std::string, Knee> knees_;            ///< by file; nothing where it is damaged
  std::map<std::string, CutFile> cuts_;          ///< by file: each is told about once
};

}  // namespace protocols
