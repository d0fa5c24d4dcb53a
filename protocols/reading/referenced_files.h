#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "haptics/reaming/material/material.h"
#include "haptics/reaming/packing/packed_bone.h"
#include "haptics/recordings/cut.h"
#include "protocols/model/loaded_protocol.h"
#include "protocols/reading/anatomy_file.h"
#include "protocols/reading/packing_file.h"
#include "questionnaires/json/problem.h"
#include "questionnaires/reading/instrument_file.h"

namespace protocols {

/// The files that a protocol names. Searches for each once, reads it, and keeps its text for the
/// study.
///
/// Each function returns the content of the file called @p name. If it cannot be read, a problem is
/// reported at @p path in the protocol, or in the file with its name before the path, and the
/// result is empty. An empty name has been reported already. Returned objects live as long as this
/// object.
class ReferencedFiles {
 public:
  /// All arguments must outlive this object.
  /// @param copies  of the library's instruments, under kCopiesOfLibrary; empty: there are none.
  ReferencedFiles(
      const FileFinder& find,
      const FileFinder& copies,
      questionnaires::Problems& problems,
      Defaults defaults)
      : find_(find), copies_(copies), problems_(problems), defaults_(defaults) {}

  /// The defaults of keys that the protocol leaves out.
  Defaults defaults() const noexcept { return defaults_; }

  struct PackingFile {
    std::shared_ptr<const haptics::reaming::PackedBone> bone;
    PackingOrigin origin;
  };

  const haptics::recordings::Cut* cut(const std::string& name, const std::string& path);
  const haptics::reaming::Material* material(const std::string& name, const std::string& path);
  const PackingFile* packing(const std::string& name, const std::string& path);
  std::shared_ptr<const Anatomy> anatomy(const std::string& name, const std::string& path);

  /// The instrument in a file, with its wording in @p languages, if it has or needs any, and with
  /// its blanks filled in by @p blanks.
  std::optional<questionnaires::Instrument> instrument(
      const std::string& name,
      const std::string& path,
      const std::vector<std::string>& languages,
      questionnaires::BlankFiller& blanks);

  /// The instrument of the library with that @p id, in the same way: its copy, or else what the
  /// program has; std::nullopt without a problem if there is neither.
  std::optional<questionnaires::Instrument> libraryInstrument(
      const std::string& id,
      const std::string& path,
      const std::vector<std::string>& languages,
      questionnaires::BlankFiller& blanks);

  /// Every file that was found, as it was read.
  std::vector<SourceFile> takeFiles() { return std::move(files_); }

 private:
  template <typename T>
  using ByName = std::map<std::string, std::optional<T>>;  ///< std::nullopt if the file is damaged

  /// The required extension of a kind of file, and the fix for another one.
  struct FileExtension {
    std::string_view ending;
    std::string_view fix;
  };

  template <typename T, typename Read>
  const T* once(
      ByName<T>& known,
      const std::string& name,
      const std::string& path,
      const Read& read,
      const FileExtension& ending = {});
  void addProblemsOf(const questionnaires::Problems& found, const std::string& file);
  void completeWording(
      questionnaires::Instrument& instrument,
      const std::string& path,
      const std::vector<std::string>& languages);
  std::optional<std::string> textOf(const std::string& name, const std::string& path);
  std::optional<std::string> find(const std::string& name, const std::string& path, bool isNeeded);

  const FileFinder& find_;
  const FileFinder& copies_;
  questionnaires::Problems& problems_;
  Defaults defaults_;
  std::vector<SourceFile> files_;
  ByName<haptics::recordings::Cut> cuts_;
  ByName<haptics::reaming::Material> materials_;
  ByName<PackingFile> packings_;
  ByName<std::shared_ptr<const Anatomy>> anatomies_;
};

/// Where the scene of one condition takes its data from: reads the files that it names, uses the
/// built-in data, and lists each of them among the sources of the protocol.
///
/// Results and problems are as in ReferencedFiles.
class SceneSources {
 public:
  /// All arguments must outlive this object.
  /// @param condition  its id.
  SceneSources(ReferencedFiles& files, std::vector<FeltSource>& all, const std::string& condition)
      : files_(files), all_(all), condition_(condition) {}

  /// The defaults of keys that the scene leaves out.
  Defaults defaults() const noexcept { return files_.defaults(); }

  /// The cut of a file, or the built-in one called kParametricCut.
  const haptics::recordings::Cut* cut(const std::string& name, const std::string& path);

  /// The material of a file, and the curves of one of its test sets; none if it has no such set.
  struct MaterialChoice {
    const haptics::reaming::Material* material = nullptr;
    const haptics::reaming::MaterialSet* set = nullptr;
  };
  MaterialChoice material(
      const std::string& name, haptics::reaming::TestSet set, const std::string& path);

  /// Notes that the scene uses the built-in material.
  void useParametricMaterial();

  /// The bone of a file, or the built-in one called kParametricBone.
  std::shared_ptr<const haptics::reaming::PackedBone> packing(
      const std::string& name, const std::string& path);

  std::shared_ptr<const Anatomy> anatomy(const std::string& name, const std::string& path);

 private:
  void add(FeltSource source);

  ReferencedFiles& files_;
  std::vector<FeltSource>& all_;
  const std::string& condition_;
};

}  // namespace protocols
