#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/data/answer_table.h"
#include "protocols/model/loaded_protocol.h"
#include "study/storage/records.h"

namespace study {

/// An answer with the participant who gave it.
struct ParticipantAnswer {
  const std::string* participant = nullptr;
  const storage::AnswerRecord* record = nullptr;
  /// The instrument in the version of the answer's session; nullptr: the newest version.
  const questionnaires::Instrument* asked = nullptr;
};

/// The value of a point or a number; std::nullopt for options and free texts.
std::optional<double> numberOf(const questionnaires::Response& response);

/// The conditions that a family compares, in the protocol's order.
std::vector<std::string> conditionsOf(
    const protocols::Protocol& protocol, const protocols::Family& family);

/// Determines which answers a family compares, and their cells in its table. The table's methods
/// are the compared conditions, its rounds the blocks that ask the family's instrument, its
/// statements the compared items or the score. The protocol must outlive this object.
class FamilyLayout {
 public:
  FamilyLayout(const protocols::LoadedProtocol& loaded, const protocols::Family& family);

  /// The table's methods, rounds and statements; it has no answers.
  const analysis::AnswerTable& table() const noexcept { return table_; }

  /// The score that the family compares; nullptr if it compares items.
  const questionnaires::Score* score() const noexcept { return score_; }

  /// Where an answer was given, and to what.
  struct Origin {
    const std::string& instrument;
    const std::string& phase;
    const std::string& condition;
    const std::string& item;  ///< id of the item, or of the score
    /// The instrument in the version of the answer's session; nullptr: the newest version.
    const questionnaires::Instrument* asked = nullptr;
  };
  /// The indices of an answer in the table, and its value.
  struct Cell {
    std::size_t method = 0;
    std::size_t round = 0;
    std::size_t statement = 0;
    double score = 0.0;  ///< the answer, reversed where its key was −1, so that more is better
  };
  /// The cell of an answer. std::nullopt if the family does not compare the answer, or if it was
  /// given on another scale than that of the newest version.
  std::optional<Cell> cellOf(const Origin& origin, double answer) const;

 private:
  const questionnaires::Instrument& instrument_;
  const questionnaires::Score* score_;
  analysis::AnswerTable table_;
};

/// The table of a family's answers (see FamilyLayout); for a score, one value for each form from
/// which the score can be computed, by the rule of the form's own version. Values of a score on
/// another scale than that of the newest version are left out. The table's participants are @p
/// people, also those without answers.
analysis::AnswerTable answerTable(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const std::vector<std::string>& people,
    const std::vector<ParticipantAnswer>& answers);

/// For each method of the table, the number of answers of a participant who answers all items.
std::vector<std::size_t> completeAnswerCounts(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table);

/// Whether the protocol asks the same statements about every method of a family; a score counts as
/// one.
bool asksSameStatements(const protocols::LoadedProtocol& loaded, const protocols::Family& family);

/// The indices of answered statements that ask for a comparison with the previous condition; none
/// if the family compares a score.
std::vector<std::size_t> comparativeStatements(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table);

}  // namespace study
