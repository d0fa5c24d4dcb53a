#pragma once

#include <string>
#include <vector>

#include "analysis/data/answer_table.h"
#include "protocols/model/loaded_protocol.h"
#include "study/storage/records.h"

namespace study {

/// An answer, and whose it is.
struct OwnedAnswer {
  const std::string* participant = nullptr;
  const storage::AnswerRecord* record = nullptr;
};

/// The conditions that a family compares, in the protocol's order.
std::vector<std::string> conditionsOf(
    const protocols::Protocol& protocol, const protocols::Family& family);

/// What people answered to a family's instrument, keyed so that more is better: methods are the
/// conditions that it compares, rounds the blocks that ask it, statements its Likert items.
/// Participants are those of @p people, whether or not they answered anything.
analysis::AnswerTable answerTable(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const std::vector<std::string>& people,
    const std::vector<OwnedAnswer>& answers);

/// How many answers about each of the table's methods one participant gives who leaves out none.
std::vector<std::size_t> expectedAnswers(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table);

/// Places of the statements that compare with what was felt just before.
std::vector<std::size_t> relativeStatements(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table);

}  // namespace study
