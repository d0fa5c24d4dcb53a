#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "study/results/apa_text.h"

namespace study::report {

/// A published work that a report may cite.
struct Publication {
  /// Authors and year, as the registry of tests names its sources: "Mann & Whitney 1947".
  std::string_view key;
  std::string_view authors;  ///< "Mann HB; Whitney DR"; empty if they are not known
  std::string_view title;
  std::string_view journal;  ///< or the publisher of a book
  std::string_view volume;   ///< "18(1)"
  std::string_view pages;
  std::string_view doi;  ///< empty if it has none
};

/// The papers that the simulators rebuild (docs/references.md).
inline constexpr std::string_view kPunchPaper = "“Intraoperative Data-Based Haptic Feedback” n.d.";
inline constexpr std::string_view kPunchCode = "Bjelland 2022";
inline constexpr std::string_view kReamingPaper = "Pelliccia et al. 2020";

std::span<const Publication> publications() noexcept;

/// The sources, separated by "; ", works with their DOI: "Hurlbert 1984, 10.2307/1942661".
std::string sourcesWithDois(std::span<const base::Message> sources);

/// "Mann & Whitney, 1947"
std::string authorsAndYear(std::string_view key);

/// The works that a text cites. APA names author and year in the text and sorts the list by author;
/// the Vancouver style numbers works in the order in which they are cited.
class Citations {
 public:
  explicit Citations(Wording wording) noexcept : wording_(wording) {}

  /// The citation in the text: "(Cronbach, 1951; Feldt, 1965)" or "[3, 4]".
  /// @param keys  one or several, separated by ", "
  /// @throws std::logic_error  if there is no such work.
  std::string cite(std::string_view keys);

  /// The entries of the reference list, as escaped HTML.
  std::vector<std::string> list(const words::Words& words) const;

 private:
  Wording wording_;
  std::vector<const Publication*> cited_;  ///< in the order of their first citation
};

}  // namespace study::report
