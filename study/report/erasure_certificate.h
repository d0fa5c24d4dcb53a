#pragma once

#include <string>
#include <vector>

#include "study/session/erasure_copies.h"
#include "study/words/words.h"

namespace study::report {

/// The content of a certificate of erasure. It contains no names.
struct ErasureCertificate {
  std::string title;  ///< of the study
  ErasureReport report;
  std::vector<ErasedCopy> copies;        ///< other copies that were named for erasure
  std::vector<KnownCopy> notErasedFrom;  ///< other known copies, which were not erased from

  /// Whether the search after the erasure found none of the participant's texts, and the erasure
  /// succeeded in every named copy.
  bool isClean() const;
};

/// Plain text in the language of @p words; folders, the reason and errors are not translated.
/// `palpate study erase --by` reads the last line to repeat the erasure in another copy.
std::string asText(const ErasureCertificate& certificate, const words::Words& words = {});
/// The certificate as an HTML page.
std::string asHtml(const ErasureCertificate& certificate, const words::Words& words = {});

/// Where and when a copy was made, and whether it is there now.
std::string inWords(const KnownCopy& copy, const words::Words& words = {});

/// Reads the erasures from asText() of a certificate; empty if there is none.
std::vector<storage::ListedErasure> erasuresIn(const std::string& text);

}  // namespace study::report
