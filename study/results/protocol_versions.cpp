#include "study/results/protocol_versions.h"

#include <algorithm>
#include <utility>

namespace study {

using protocols::ChangedMeaning;

ProtocolVersions::ProtocolVersions(Study& study, const protocols::LoadedProtocol& newest)
    : newest_(&newest) {
  for (const auto& session : study.sessions().all()) {
    const auto& version = study.protocol(session.protocol);
    const bool isNew = versions_.emplace(session.protocol, &version).second;
    if (isNew && &version != newest_) {
      changes_.emplace(session.protocol, protocols::changedMeaning(version, newest));
    }
  }
}

const protocols::LoadedProtocol& ProtocolVersions::of(ProtocolId id) const {
  const auto found = versions_.find(id);
  return found == versions_.end() ? *newest_ : *found->second;
}

const questionnaires::Item* ProtocolVersions::item(
    ProtocolId id, const std::string& instrument, const std::string& item) const {
  const auto* asked = of(id).instrument(instrument);
  return asked == nullptr ? nullptr : asked->item(item);
}

bool ProtocolVersions::isPooled(
    ProtocolId id, const std::string& instrument, const std::string& item) const {
  if (!changes_.contains(id)) return true;
  const auto* asked = this->item(id, instrument, item);
  const auto* now = newest_->instrument(instrument);
  const auto* nowItem = now == nullptr ? nullptr : now->item(item);
  return asked == nullptr || nowItem == nullptr || protocols::haveSameScale(*asked, *nowItem);
}

const std::vector<ChangedMeaning>& ProtocolVersions::changesSince(ProtocolId id) const {
  static const std::vector<ChangedMeaning> kNone;
  const auto found = changes_.find(id);
  return found == changes_.end() ? kNone : found->second;
}

std::vector<base::Message> changesSince(
    const ProtocolVersions& versions, const VersionsOfPeople& people, const IsMeant& isMeant) {
  struct Changed {
    std::set<std::string> ids;
    std::set<std::string> participants;
  };
  std::map<std::pair<ChangedMeaning::Aspect, std::string>, Changed> all;
  for (const auto& [participant, used] : people) {
    for (const auto version : used) {
      for (const auto& change : versions.changesSince(version)) {
        if (!isMeant(change)) continue;
        auto& changed = all[{change.aspect, change.instrument}];
        changed.ids.insert(change.id);
        changed.participants.insert(participant);
      }
    }
  }
  std::vector<base::Message> messages;
  for (const auto& [what, changed] : all) {
    std::string ids;
    for (const auto& id : changed.ids) ids += (ids.empty() ? "" : ", ") + id;
    messages.push_back(
        protocols::inWords(what.first, changed.participants.size(), people.size(), ids));
  }
  return messages;
}

std::vector<base::Message> changesBy(Study& study, const protocols::LoadedProtocol& newest) {
  VersionsOfPeople people;
  for (const auto& session : study.sessions().all()) {
    const bool isOfPerson =
        session.runMode != RunMode::Simulated && session.state != SessionState::Erased;
    if (isOfPerson) people[session.participant].insert(session.protocol);
  }
  return changesSince(ProtocolVersions(study, newest), people, [&](const auto& change) {
    return concernsResults(newest.protocol, change);
  });
}

bool concernsResults(const protocols::Protocol& protocol, const ChangedMeaning& change) {
  const auto uses = protocols::instrumentUses(protocol);
  return change.instrument.empty() || std::ranges::any_of(uses, [&](const auto& use) {
           return use.instrument == change.instrument && use.phase != protocols::PhaseType::Consent;
         });
}

}  // namespace study
