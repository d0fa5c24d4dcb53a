#pragma once

#include <memory>
#include <string>
#include <vector>

#include "protocols/reading/referenced_files.h"

namespace protocols {

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
