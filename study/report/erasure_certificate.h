#pragma once

#include <string>
#include <vector>

#include "study/session/erasure_copies.h"
#include "study/words/words.h"

namespace study::report {

/// What a certificate of erasure tells. It names nobody.
struct ErasureCertificate {
  std::string title;  ///< of the study
  ErasureReport report;
  std::vector<ErasedCopy> copies;  ///< that were erased from, too
  std::vector<KnownCopy> left;     ///< that the study knows, and that were not

  /// Whether no text was found any more, and every copy that was named was erased from.
  bool isClean() const;
};

/// For reading, in the language of @p words; folders, the reason and errors stay as they are. The
/// last line is for `palpate study erase --by`: it erases from other copies.
std::string asText(const ErasureCertificate& certificate, const words::Words& words = {});
/// The same as a page.
std::string asHtml(const ErasureCertificate& certificate, const words::Words& words = {});

/// The erasures that the text of a certificate tells.
std::vector<storage::ListedErasure> erasuresIn(const std::string& text);

}  // namespace study::report
