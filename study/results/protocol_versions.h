#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "protocols/changed_meaning.h"
#include "study/session/study.h"

namespace study {

/// The newest version of a study's protocol, and the versions with which sessions were run. Results
/// are arranged by the newest one; each answer is read by the version of its own session. The
/// protocols must outlive this object.
class ProtocolVersions {
 public:
  /// Of a protocol that has no earlier version.
  ProtocolVersions(const protocols::LoadedProtocol& newest)  // NOLINT(google-explicit-constructor)
      : newest_(&newest) {}

  /// @throws storage::StorageError  if a version cannot be read.
  explicit ProtocolVersions(Study& study) : ProtocolVersions(study, study.protocol()) {}

  /// As above, as if @p newest were the newest version.
  ProtocolVersions(Study& study, const protocols::LoadedProtocol& newest);

  const protocols::LoadedProtocol& newest() const noexcept { return *newest_; }

  /// The version with this id; the newest one if no session was run with it.
  const protocols::LoadedProtocol& of(ProtocolId id) const;

  /// The item as it was asked with a version; nullptr if that version lacks it.
  const questionnaires::Item* item(
      ProtocolId id, const std::string& instrument, const std::string& item) const;

  /// Whether answers to an item of a version can be pooled with answers to the newest version of
  /// the item. True for an item that one of them lacks.
  bool isPooled(ProtocolId id, const std::string& instrument, const std::string& item) const;

  /// What was changed since that version.
  const std::vector<protocols::ChangedMeaning>& changesSince(ProtocolId id) const;

 private:
  const protocols::LoadedProtocol* newest_;
  std::map<ProtocolId, const protocols::LoadedProtocol*> versions_;
  std::map<ProtocolId, std::vector<protocols::ChangedMeaning>> changes_;
};

/// The versions with which each participant took part, by the participant's code.
using VersionsOfPeople = std::map<std::string, std::set<ProtocolId>>;

/// Which changes are described.
using IsMeant = std::function<bool(const protocols::ChangedMeaning&)>;

/// What was changed since people answered: a message for each aspect of an instrument, and of the
/// conditions.
std::vector<base::Message> changesSince(
    const ProtocolVersions& versions, const VersionsOfPeople& people, const IsMeant& isMeant);

/// What @p newest, a new version, changes for people who took part in live or pilot sessions.
/// @throws storage::StorageError
std::vector<base::Message> changesBy(Study& study, const protocols::LoadedProtocol& newest);

/// Whether a change concerns what results show: anything but consent forms.
bool concernsResults(const protocols::Protocol& protocol, const protocols::ChangedMeaning& change);

}  // namespace study
