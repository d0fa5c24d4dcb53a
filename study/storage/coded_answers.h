#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// What is asked, as a study's number for it: an item of an instrument, in a phase, about a
/// condition.
struct Question {
  std::int64_t id = 0;
  std::string kind;  ///< of the step: "questionnaire", "preference"
  std::string phase;
  std::string instrument;
  std::string condition;  ///< empty where nothing was felt
  std::string item;
};

/// A point on a scale, as it is counted: whole numbers all through.
struct CodedAnswer {
  SessionId session{};
  std::int64_t question = 0;
  std::int64_t point = 0;
};

/// Sessions by their numbers: from @p first on, and before @p end.
struct SessionRange {
  SessionId first{};
  SessionId end{std::numeric_limits<std::int64_t>::max()};
};

/// The answers that are points on a scale, read from an index that holds nothing else.
///
/// Ten million of them pass within a second, one at a time; none is kept. Belongs to the thread of
/// its database, which outlives it.
class CodedAnswers {
 public:
  using Visitor = std::function<void(const CodedAnswer&)>;

  explicit CodedAnswers(Database& database) : database_(database) {}

  /// What the numbers of questions above @p known stand for; in their order.
  std::vector<Question> questionsAfter(std::int64_t known) const;

  /// Shows all of them to @p visitor, session by session, whether or not they count.
  /// @throws StorageError  and whatever the visitor throws.
  void visitAll(const Visitor& visitor, const SessionRange& sessions = {}) const;

  /// The last session's number; 0 before the first.
  SessionId lastSession() const;

  /// Those of one session that were given in visits that were finished and not repeated.
  void visitFinished(SessionId session, const Visitor& visitor) const;

  /// Sessions in which something answered was not finished, or was repeated.
  std::vector<SessionId> sessionsWithMore() const;

  /// Answers that are not counted as the question that they were given to, in words.
  std::vector<std::string> misplaced() const;

 private:
  Database& database_;
};

}  // namespace study::storage
