#pragma once

#include <memory>
#include <string>
#include <vector>

#include "protocols/reading/referenced_files.h"

namespace protocols {

/// Where the scene of one condition takes its data from: reads the files that it names, takes what
/// is built into the program, and lists each of them among the sources of the protocol.
///
/// Answers and problems are those of ReferencedFiles.
class SceneSources {
 public:
  /// All outlive this. @param condition  its id.
  SceneSources(ReferencedFiles& files, std::vector<FeltSource>& all, const std::string& condition)
      : files_(files), all_(all), condition_(condition) {}

  /// What the scene means where it says nothing.
  Defaults defaults() const noexcept { return files_.defaults(); }

  /// The cut of a file, or the one called kParametricCut.
  const haptics::recordings::Cut* cut(const std::string& name, const std::string& path);

  /// The material of a file, and the curves of one of its test sets; none where it lacks that set.
  struct MaterialChoice {
    const haptics::reaming::Material* material = nullptr;
    const haptics::reaming::MaterialSet* set = nullptr;
  };
  MaterialChoice material(
      const std::string& name, haptics::reaming::TestSet set, const std::string& path);

  /// The scene uses the program's own material.
  void useParametricMaterial();

  /// The bone of a file, or the one called kParametricBone.
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
