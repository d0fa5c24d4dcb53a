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

/// Reads the files that a protocol refers to, each once, and keeps their texts for the study.
///
/// Each function returns the content of the file called @p name. If the file cannot be read, the
/// result is empty, and a problem is reported: at @p path in the protocol if the file is missing,
/// otherwise at the file's name followed by a path in the file. For an empty name nothing is
/// reported, because it has been reported already. Returned objects live as long as this object.
class ReferencedFiles {
 public:
  /// All arguments must outlive this object.
  /// @param copies  finds copies of the library's instruments, whose names begin with
  ///     kLibraryCopyPrefix; empty if there are none.
  ReferencedFiles(
      const FileFinder& find,
      const FileFinder& copies,
      questionnaires::Problems& problems,
      Defaults defaults)
      : find_(find), copies_(copies), problems_(problems), defaults_(defaults) {}

  /// The defaults of keys that the protocol leaves out.
  Defaults defaults() const noexcept { return defaults_; }

  /// A bone of spheres, and the origin in its file.
  struct PackingFile {
    std::shared_ptr<const haptics::reaming::PackedBone> bone;
    PackingOrigin origin;
  };

  const haptics::recordings::Cut* cut(const std::string& name, const std::string& path);
  const haptics::reaming::Material* material(const std::string& name, const std::string& path);
  const PackingFile* packing(const std::string& name, const std::string& path);
  std::shared_ptr<const Anatomy> anatomy(const std::string& name, const std::string& path);

  /// The instrument in a file. Its wording files in @p languages are added if they exist, and are
  /// required where its texts are withheld; @p blanks fills in its blanks.
  std::optional<questionnaires::Instrument> instrument(
      const std::string& name,
      const std::string& path,
      const std::vector<std::string>& languages,
      questionnaires::BlankFiller& blanks);

  /// The instrument @p id of the library, completed like an instrument in a file: from the study's
  /// copy or, without one, from the program; std::nullopt without a problem if neither has it.
  std::optional<questionnaires::Instrument> libraryInstrument(
      const std::string& id,
      const std::string& path,
      const std::vector<std::string>& languages,
      questionnaires::BlankFiller& blanks);

  /// All files that were read, with their texts.
  std::vector<SourceFile> takeFiles() { return std::move(files_); }

 private:
  template <typename T>
  using ByName = std::map<std::string, std::optional<T>>;  ///< std::nullopt if the file is damaged

  /// The required extension of a kind of file, and the fix that is reported for another extension.
  struct FileExtension {
    std::string_view extension;
    std::string_view fix;
  };

  template <typename T, typename Read>
  const T* readOnce(
      ByName<T>& known,
      const std::string& name,
      const std::string& path,
      const Read& read,
      const FileExtension& extension = {});
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

/// The data for the scene of one condition: reads the files that it refers to, provides built-in
/// data, and adds each of them to the protocol's list of sources.
///
/// Results and problems are as in ReferencedFiles.
class SceneSources {
 public:
  /// All arguments must outlive this object.
  /// @param condition  id of the condition.
  SceneSources(
      ReferencedFiles& files, std::vector<SceneDataSource>& all, const std::string& condition)
      : files_(files), all_(all), condition_(condition) {}

  /// The defaults of keys that the scene leaves out.
  Defaults defaults() const noexcept { return files_.defaults(); }

  /// The cut in a file, or the built-in cut if @p name is kParametricCut.
  const haptics::recordings::Cut* cut(const std::string& name, const std::string& path);

  /// A material and the curves of one of its test sets; nullptr if the material lacks the set.
  struct MaterialChoice {
    const haptics::reaming::Material* material = nullptr;
    const haptics::reaming::MaterialSet* set = nullptr;
  };
  MaterialChoice material(
      const std::string& name, haptics::reaming::TestSet set, const std::string& path);

  /// Adds the built-in material to the sources.
  void addParametricMaterial();

  /// The bone in a file, or the built-in bone if @p name is kParametricBone.
  std::shared_ptr<const haptics::reaming::PackedBone> packing(
      const std::string& name, const std::string& path);

  std::shared_ptr<const Anatomy> anatomy(const std::string& name, const std::string& path);

 private:
  void add(
      const char* kind,
      const std::string& file,
      base::Message title,
      std::vector<base::Message> origin,
      bool isSynthetic);

  ReferencedFiles& files_;
  std::vector<SceneDataSource>& all_;
  const std::string& condition_;
};

}  // namespace protocols
