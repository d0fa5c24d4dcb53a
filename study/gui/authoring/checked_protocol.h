#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/reading/instrument_file.h"
#include "study/gui/widgets/note_list.h"
#include "study/report/report_section.h"
#include "study/session/study.h"

namespace study::gui {

/// A section of a report that has only titles: of conditions, cohorts, blocks, instruments, items.
report::ReportSection titlesOf(const protocols::LoadedProtocol& loaded);
/// What @p newest changes in the meaning of what was answered or felt in @p study so far.
QStringList changesInWords(Study& study, const protocols::LoadedProtocol& newest);
/// How many blanks of texts that participants read are not filled in.
std::size_t blanksLeft(const protocols::LoadedProtocol& loaded);

/// A protocol file as read from disk, with all problems found in it.
struct CheckedProtocol {
  std::string source;                               ///< a path, or the name of a built-in protocol
  std::string text;                                 ///< empty if the file cannot be read
  std::optional<protocols::LoadedProtocol> loaded;  ///< std::nullopt if there are errors
  /// The blanks of all texts are reported as one problem, which is the first.
  std::vector<questionnaires::Problem> problems;
  questionnaires::BlankTexts keptTexts = {};  ///< of an earlier version

  int errors() const noexcept;
  int warnings() const noexcept;
  /// "Valid, 9 warnings", or that it has errors and cannot be used yet.
  std::string verdict() const;
  Mark mark() const noexcept;
  /// The file of the protocol and those that it names; absolute paths. For a file only.
  QStringList files() const;
  /// What it has, if it can be used, and all problems: "Consent › introduction: …", with what to do
  /// below each.
  std::vector<Note> notes() const;
  /// Names the texts that are kept from an earlier version.
  QString keptTextsInWords() const;
  /// A text of a problem, with titles in place of the ids of conditions, cohorts, blocks,
  /// instruments and items.
  QString inWords(const base::Message& message) const;
  /// The place of a problem in a file for readers: "$.phases[4].text" → "phase 5, Round 1 › text".
  /// As long as the protocol has errors, its parts have no titles.
  QString placeInWords(const std::string& path) const;
};

/// Reads and checks a protocol as `palpate protocol check` does. An unreadable file is reported as
/// a problem.
/// @param before  an earlier version, whose texts are kept for the blanks that the file leaves
/// empty
CheckedProtocol checkProtocol(
    const std::string& source, const protocols::LoadedProtocol* before = nullptr);
/// The result for a protocol that was read, with the problems found in it.
CheckedProtocol checkedProtocol(
    std::string source,
    std::string text,
    std::optional<protocols::LoadedProtocol> loaded,
    std::vector<questionnaires::Problem> problems);

}  // namespace study::gui
