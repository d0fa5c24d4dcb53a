#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/export/coarsening.h"
#include "study/export/export.h"
#include "study/export/k_anonymity.h"
#include "study/export/study_tables.h"
#include "study/storage/records.h"

namespace study {

/// A question about the person that a form asks.
struct BackgroundQuestion {
  std::string phase;
  const questionnaires::Item* item = nullptr;  ///< of the study's protocol
  Coarsening coarsening;

  /// As a column is called: "background_age_band".
  std::string column() const;
};

/// Those whose answers go to strangers, and what acquaintances may know of them: the cohort, what
/// forms ask about the person, the order in which they felt the conditions (the protocol and a
/// place in it give it away). Somebody is there once, with the first session that they completed.
///
/// The study outlives it.
class PublicPeople {
 public:
  PublicPeople(Study& study, RunMode mode);

  std::size_t count() const noexcept { return sessions_.size(); }
  /// In the order in which they came: of no concern to strangers.
  const std::vector<storage::SessionRecord>& sessions() const noexcept { return sessions_; }
  const std::vector<storage::AnswerRecord>& answers() const noexcept { return answers_; }
  const std::vector<BackgroundQuestion>& questions() const noexcept { return questions_; }

  /// Which of them a session is of; nothing where it is nobody's.
  std::optional<std::size_t> personOf(SessionId session) const;

  /// The cohort first, then what is asked in the order in which it is asked, then the order.
  std::vector<QuasiIdentifier> identifiers() const;

 private:
  QuasiIdentifier cohorts() const;
  QuasiIdentifier background(const BackgroundQuestion& question) const;
  QuasiIdentifier orders() const;

  Study& study_;
  std::vector<storage::SessionRecord> sessions_;
  std::map<SessionId, std::size_t> people_;
  std::vector<storage::AnswerRecord> answers_;  ///< theirs, in visits that count
  std::vector<storage::TrialRow> trials_;
  std::vector<BackgroundQuestion> questions_;
};

}  // namespace study
