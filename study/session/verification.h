#pragma once

#include <string>
#include <vector>

#include "study/model/progress.h"
#include "study/session/study.h"

namespace study {

/// What a look at everything that a study has written came to.
struct Verification {
  struct Check {
    std::string what;                   ///< "the audit trail is unbroken"
    std::vector<std::string> problems;  ///< empty where it holds
  };

  std::vector<Check> checks;

  bool isSound() const noexcept;
};

/// Reads a study to its last byte: files and their relations, the audit trail, every answer against
/// it, the names and the protocols against their hashes, every order against the one that the seed
/// draws, every trace against its trial. Changes nothing.
/// @param progress  told before every check and every trace; whatever it throws ends it.
Verification verify(Study& study, const Progress& progress = {});

}  // namespace study
