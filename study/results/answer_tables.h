#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/data/answer_table.h"
#include "protocols/model/loaded_protocol.h"
#include "study/storage/records.h"

namespace study {

/// An answer with its session.
struct OwnedAnswer {
  const std::string* participant = nullptr;
  const storage::AnswerRecord* record = nullptr;
};

/// A point or a number that was answered; std::nullopt for options and texts.
std::optional<double> numberOf(const questionnaires::Response& response);

/// The conditions that a family compares, in the protocol's order.
std::vector<std::string> conditionsOf(
    const protocols::Protocol& protocol, const protocols::Family& family);

/// Which answers a family compares, and their cells in its table. Methods are the conditions that
/// it compares, rounds the blocks that ask its instrument, statements the items that it compares,
/// or its score. The protocol must outlive it.
class FamilyLayout {
 public:
  FamilyLayout(const protocols::LoadedProtocol& loaded, const protocols::Family& family);

  /// The table without answers.
  const analysis::AnswerTable& table() const noexcept { return table_; }

  /// The score that the family compares; nullptr if it compares items.
  const questionnaires::Score* score() const noexcept { return score_; }

  /// Where an answer was given.
  struct Origin {
    const std::string& instrument;
    const std::string& phase;
    const std::string& condition;
    const std::string& item;  ///< or the score
  };
  struct Cell {
    std::size_t method = 0;
    std::size_t round = 0;
    std::size_t statement = 0;
    double score = 0.0;  ///< the answer, reversed where the key is −1, so that more is better
  };
  /// The cell of an answer. std::nullopt if the family does not compare it, or if it was given on
  /// the scale of an earlier version of the protocol; it then counts as missing.
  std::optional<Cell> cellOf(const Origin& origin, double answer) const;

 private:
  const questionnaires::Instrument& instrument_;
  const questionnaires::Score* score_;
  analysis::AnswerTable table_;
};

/// The answers to a family's instrument in questionnaires (see FamilyLayout); of a score one for
/// each form that gives it. The participants are @p people, whether or not they answered anything.
analysis::AnswerTable answerTable(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const std::vector<std::string>& people,
    const std::vector<OwnedAnswer>& answers);

/// For each method of the table, the number of answers of a participant who answers everything.
std::vector<std::size_t> expectedAnswers(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table);

/// Indices of the statements that compare with the condition before.
std::vector<std::size_t> relativeStatements(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table);

}  // namespace study
