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
  GeneralisationHierarchy hierarchy;

  /// The name of the question's column: "background_age_band".
  std::string column() const;
};

/// The background questions whose answers analysts see. @p loaded must outlive the result.
std::vector<BackgroundQuestion> backgroundQuestionsOf(const protocols::LoadedProtocol& loaded);

/// The people in a public export, and the facts about them that acquaintances may know: cohort,
/// site, answers to forms about the person, and the order of conditions (which the protocol and the
/// place in the design determine). A person is listed once, with their first completed session. The
/// study must outlive this object.
class PublicPeople {
 public:
  PublicPeople(Study& study, RunMode mode);

  std::size_t count() const noexcept { return sessions_.size(); }
  /// In the order of participation, which must not be released.
  const std::vector<storage::SessionRecord>& sessions() const noexcept { return sessions_; }
  const std::vector<storage::AnswerRecord>& answers() const noexcept { return answers_; }
  const std::vector<BackgroundQuestion>& questions() const noexcept { return questions_; }

  /// The index of the person of a session; std::nullopt for sessions of other people.
  std::optional<std::size_t> personOf(SessionId session) const;

  /// In this order: the cohort, the site if there are several, the questions, and the order of
  /// conditions.
  std::vector<QuasiIdentifier> identifiers() const;

 private:
  /// A quasi-identifier from a member of SessionRecord: released unchanged or not at all.
  QuasiIdentifier identifierFrom(
      const char* name, std::string storage::SessionRecord::*member) const;
  /// The quasi-identifier from the answers to a question, in levels of generalisation.
  QuasiIdentifier backgroundIdentifier(const BackgroundQuestion& question) const;
  /// The quasi-identifier of the order of conditions.
  QuasiIdentifier orderIdentifier() const;

  Study& study_;
  RunMode mode_;
  std::vector<storage::SessionRecord> sessions_;
  std::map<SessionId, std::size_t> people_;
  std::vector<storage::AnswerRecord> answers_;  ///< answers of these people, from finished visits
  std::vector<storage::StoredTrial> trials_;
  std::vector<BackgroundQuestion> questions_;
};

}  // namespace study
