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

/// A question of a form about the participant.
struct BackgroundQuestion {
  std::string phase;
  const questionnaires::Item* item = nullptr;  ///< of the study's protocol
  Coarsening coarsening;

  /// The name of its column: "background_age_band".
  std::string column() const;
};

/// The people of a public export, and the facts that acquaintances may know: cohort, site, answers
/// to forms about the person, and the order of conditions (which protocol and place reveal). A
/// person is listed once, with their first completed session. The study must outlive this object.
class PublicPeople {
 public:
  PublicPeople(Study& study, RunMode mode);

  std::size_t count() const noexcept { return sessions_.size(); }
  /// In the order of their participation, which is not released.
  const std::vector<storage::SessionRecord>& sessions() const noexcept { return sessions_; }
  const std::vector<storage::AnswerRecord>& answers() const noexcept { return answers_; }
  const std::vector<BackgroundQuestion>& questions() const noexcept { return questions_; }

  /// The index of the person of a session; std::nullopt if it belongs to none of them.
  std::optional<std::size_t> personOf(SessionId session) const;

  /// The cohort first, then the site if there are several, the questions in order, and the order of
  /// conditions.
  std::vector<QuasiIdentifier> identifiers() const;

 private:
  /// A quasi-identifier from a column of the session: released unchanged or not at all.
  QuasiIdentifier described(const char* name, std::string storage::SessionRecord::*member) const;
  QuasiIdentifier background(const BackgroundQuestion& question) const;
  QuasiIdentifier orders() const;

  Study& study_;
  RunMode mode_;
  std::vector<storage::SessionRecord> sessions_;
  std::map<SessionId, std::size_t> people_;
  std::vector<storage::AnswerRecord> answers_;  ///< of these people, from visits that count
  std::vector<storage::TrialRow> trials_;
  std::vector<BackgroundQuestion> questions_;
};

}  // namespace study
