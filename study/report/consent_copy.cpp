#include "study/report/consent_copy.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/joined.h"
#include "study/model/user_error.h"
#include "study/report/html_text.h"
#include "study/storage/evidence/signed_head.h"
#include "study/storage/records.h"
#include "study/words/words.h"

namespace study::report {
namespace {

using questionnaires::Item;

/// The chosen option as it was shown; empty if the answer is neither a choice nor a number.
std::string chosenText(
    const Item& item, const questionnaires::Response& response, const std::string& language) {
  const auto textOf = [&](const std::string& id) -> std::string {
    const auto option = std::find_if(
        item.options.begin(), item.options.end(), [&](const auto& o) { return o.id == id; });
    return option == item.options.end() ? id : option->text.in(language);
  };
  if (const auto* id = std::get_if<std::string>(&response)) return textOf(*id);
  const auto* ids = std::get_if<std::vector<std::string>>(&response);
  return ids == nullptr ? "" : base::joined(*ids, ", ", textOf);
}

/// The answers to a participant's consent form in one session.
struct Consent {
  storage::SessionRecord session;
  std::map<std::string, storage::AnswerRecord> answers;  ///< by item
  std::string instrument;
};

/// The newest of a participant's consents.
std::optional<Consent> findConsent(Study& study, const std::string& code) {
  const storage::Records records(study.database());
  std::map<SessionId, Consent> consents;
  for (const auto& record : records.answers()) {
    if (!record.step.isFinished() || record.step.kind != StepKind::Consent) continue;
    auto& consent = consents[record.step.visit.session];
    consent.instrument = record.step.instrument;
    consent.answers[record.answer.item] = record;
  }
  std::optional<Consent> newest;
  for (const auto& session : records.sessions()) {
    const auto found = consents.find(session.id);
    if (session.participant != code || found == consents.end()) continue;
    newest = std::move(found->second);
    newest->session = session;
  }
  return newest;
}

class ConsentPage {
 public:
  ConsentPage(
      const protocols::LoadedProtocol& protocol,
      const Consent& consent,
      storage::TrailEnd trail,
      const TextToHtml& htmlOf)
      : protocol_(protocol),
        consent_(consent),
        trail_(std::move(trail)),
        language_(consent.answers.begin()->second.answer.language),
        htmlOf_(htmlOf),
        words_(words::wordsOrEnglish(language_)) {}

  std::string html() {
    const auto& study = protocol_.protocol.study;
    putElement("h1", study.title);
    putElement("p", words_.say("Copy for the participant {}", consent_.session.participant));
    for (const auto& phase : protocol_.protocol.phases) {
      const bool isConsent = phase.type == protocols::PhaseType::Consent;
      if (!isConsent && phase.type != protocols::PhaseType::Information) continue;
      text(*protocol_.instrument(phase.instrument));
      if (isConsent) break;
    }
    choices(*protocol_.instrument(consent_.instrument));
    end();
    return htmlPage(study.title, html_, language_);
  }

 private:
  void putElement(const std::string& name, const std::string& words) {
    html_ += "<" + name + ">" + escaped(words) + "</" + name + ">\n";
  }

  void text(const questionnaires::Instrument& instrument) {
    putElement("h2", instrument.title.in(language_));
    html_ += htmlOf_(instrument.introduction.in(language_));
  }

  void choices(const questionnaires::Instrument& instrument) {
    for (const auto& item : instrument.items) {
      const auto answer = consent_.answers.find(item.id);
      if (item.isIdentifying) continue;
      putElement("h3", item.text.in(language_));
      putElement(
          "p",
          answer == consent_.answers.end()
              ? words_("not answered")
              : "→ " + chosenText(item, answer->second.answer.response, language_));
    }
  }

  void end() {
    const auto& last =
        std::max_element(
            consent_.answers.begin(),
            consent_.answers.end(),
            [](const auto& a, const auto& b) { return a.second.savedUtc < b.second.savedUtc; })
            ->second;
    const auto& instrument = *protocol_.instrument(consent_.instrument);
    putElement("p", words_("Signature, if one is asked for: ______________________________"));
    html_ += "<p class=\"note\">" +
             escaped(words_.say(
                 "Answered at {} (UTC). Text {}, version {}; protocol {}, SHA-256 {}.",
                 last.savedUtc,
                 instrument.id,
                 instrument.version,
                 protocol_.protocol.study.version,
                 consent_.session.protocolHash)) +
             "</p>\n<p class=\"note\">" +
             escaped(words_.say(
                 "When this copy was written, the study's audit trail had {} events, and its last "
                 "one the code {}. These eight groups can be read aloud: with them it can be "
                 "checked later that nothing recorded until then was changed or removed.",
                 trail_.events,
                 storage::inGroupsOfFour(trail_.hash))) +
             "</p>\n";
  }

  const protocols::LoadedProtocol& protocol_;
  const Consent& consent_;
  storage::TrailEnd trail_;
  std::string language_;
  const TextToHtml& htmlOf_;
  words::Words words_;
  std::string html_;
};

}  // namespace

std::string plainTextAsHtml(const std::string& text) {
  std::string html;
  const auto add = [&](const std::string& words) { html += "<p>" + escaped(words) + "</p>\n"; };
  std::string rest = text;
  for (auto end = rest.find("\n\n"); end != std::string::npos; end = rest.find("\n\n")) {
    add(rest.substr(0, end));
    rest.erase(0, end + 2);
  }
  add(rest);
  return html;
}

std::string consentCopy(Study& study, const std::string& participant, const TextToHtml& htmlOf) {
  const auto consent = findConsent(study, participant);
  if (!consent) {
    throw UserError(
        "Nobody of the code '" + participant +
        "' has come to the end of a consent form here. 'palpate study status' lists the codes.");
  }
  return ConsentPage(
             study.protocol(consent->session.protocol),
             *consent,
             storage::endOf(study.database()),
             htmlOf)
      .html();
}

}  // namespace study::report
