#include "study/storage/evidence/trail_heads.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "study/model/event_kind.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"

namespace study::storage {
namespace {

bool isSealedAgain(const SignedHead& head) {
  return head.purpose == study::nameOf(EventKind::ResealedTrail);
}

std::int64_t numberIn(const base::NamedArguments& values, std::string_view name) {
  return storedValue<std::int64_t>(values, name).value_or(0);
}

/// Number and values of all events of @p kind.
std::vector<std::pair<std::int64_t, base::NamedArguments>> eventsOf(
    const Database& study, std::string_view kind) {
  Statement select(study, "SELECT seq, detail FROM event WHERE kind = ? ORDER BY seq");
  select.bindAll(kind);
  std::vector<std::pair<std::int64_t, base::NamedArguments>> events;
  while (select.step()) {
    events.emplace_back(
        select.number(0), valuesIn(select.text(1)).value_or(base::NamedArguments()));
  }
  return events;
}

}  // namespace

std::string nameOf(const SignedHead& head) {
  constexpr std::size_t kDigits = 32;
  return std::to_string(head.events) + ":" + head.hash.substr(0, kDigits);
}

TrailHeads::TrailHeads(const Database& study) : database_(study) {
  Statement select(
      study, "SELECT (SELECT uuid FROM study WHERE id = 1), coalesce(max(seq), 0) FROM event");
  select.step();
  study_ = select.text(0);
  lastEvent_ = select.number(1);
  firstHash_ = hashOf(1);
  readResealed();
  readRepeatedErasures();
  readSigned();
  readAbandonedHeads();
}

std::string TrailHeads::hashOf(std::int64_t seq) const {
  Statement select(database_, "SELECT lower(hex(hash)) FROM event WHERE seq = ?");
  select.bindAll(seq);
  return select.step() ? select.text(0) : std::string();
}

void TrailHeads::readResealed() {
  for (const auto& [seq, values] : eventsOf(database_, study::nameOf(EventKind::ResealedTrail))) {
    if (seq != 1) continue;
    previousTrailEvents_ = numberIn(values, "events");
    previousTrailHead_ = storedText(values, "head");
  }
  // In a collected study, the heads that stations signed belong to the stations' trails, which were
  // checked when the study was collected.
  for (const auto& [seq, values] : eventsOf(database_, study::nameOf(EventKind::CollectedStudy))) {
    if (seq != 1) continue;
    previousTrailEvents_ = numberIn(values, "events");
    isCollected_ = true;
  }
}

void TrailHeads::readRepeatedErasures() {
  lastSharedEvent_ = lastEvent_;
  for (const auto& [seq, values] : eventsOf(database_, study::nameOf(EventKind::Erased))) {
    if (numberIn(values, "again") != 0) lastSharedEvent_ = std::min(lastSharedEvent_, seq - 1);
  }
}

void TrailHeads::readSigned() {
  const auto heads = eventsOf(database_, study::nameOf(EventKind::SignedHead));
  for (const auto& [seq, values] : heads) {
    if (previousTrailEvents_ > 0 && seq <= previousTrailEvents_ + 1) {
      ++previousTrailHeads_;
      continue;
    }
    Signed found{
        .seq = seq,
        .head = {
            .study = study_,
            .first = firstHash_,
            .events = numberIn(values, "events"),
            .hash = storedText(values, "hash"),
            .utc = storedText(values, "utc"),
            .purpose = storedText(values, "purpose"),
            .key = storedText(values, "key"),
            .signature = storedText(values, "signature")}};
    found.isSound =
        found.head.events == seq - 1 && found.head.hash == hashOf(seq - 1) && found.head.isSigned();
    signed_.push_back(std::move(found));
  }
}

void TrailHeads::readAbandonedHeads() {
  for (const auto& event : eventsOf(database_, study::nameOf(EventKind::RestoredCopy))) {
    // Counts only if the station that signed the given-up heads also signed this event.
    const auto signature = std::ranges::find_if(signed_, [&](const auto& each) {
      return each.isSound && each.head.events == event.first &&
             each.head.purpose == study::nameOf(EventKind::RestoredCopy);
    });
    if (signature == signed_.end()) continue;
    std::istringstream names(storedText(event.second, "given_up"));
    for (std::string name; names >> name;) abandonedHeads_[signature->head.key].insert(name);
  }
}

bool TrailHeads::holds(const SignedHead& head) const {
  if (head.events < 1 || hashOf(head.events) != head.hash) return false;
  const bool isElsewhereOnly =
      head.purpose == kWitness || head.purpose == study::nameOf(EventKind::MadeStudy);
  return isElsewhereOnly || std::ranges::any_of(signed_, [&](const auto& each) {
           const bool isIt = each.seq == head.events + 1 && each.head.signature == head.signature;
           // A copy of this trail was sealed again, but this trail continued: the same station
           // signed it later.
           const bool wentOn = isSealedAgain(head) && each.isSound && each.head.key == head.key &&
                               each.head.events > head.events;
           return isIt || wentOn;
         });
}

bool TrailHeads::endsBefore(const SignedHead& head) const {
  const bool isOfAnother = previousTrailEvents_ > 0 && head.first != firstHash_;
  if (isOfAnother) return head.events > previousTrailEvents_;
  if (isSealedAgain(head) && hashOf(head.events) == head.hash) return true;
  return head.events > lastSharedEvent_ ||
         (head.events == lastSharedEvent_ && hashOf(lastSharedEvent_) == head.hash);
}

bool TrailHeads::belongsToPreviousTrail(const SignedHead& head) const {
  if (previousTrailEvents_ == 0 || head.first == firstHash_ || head.events > previousTrailEvents_)
    return false;
  // Only a signature right after that event counts. A later signature proves nothing, because the
  // station may sign sessions of a study whose first events were replaced.
  const auto purpose =
      study::nameOf(isCollected_ ? EventKind::CollectedStudy : EventKind::ResealedTrail);
  return std::ranges::any_of(signed_, [&](const auto& each) {
    return each.isSound && each.head.key == head.key && each.head.purpose == purpose &&
           each.head.events == previousTrailEvents_ + 1;
  });
}

bool TrailHeads::isLastOfPreviousTrail(const SignedHead& head) const {
  return isSealedAgain(head) && head.events == previousTrailEvents_ &&
         head.hash == previousTrailHead_;
}

bool TrailHeads::isAbandoned(const SignedHead& head) const {
  const auto found = abandonedHeads_.find(head.key);
  return found != abandonedHeads_.end() && found->second.count(nameOf(head)) > 0;
}

Findings TrailHeads::checkSignatures(const std::string& key) const {
  Findings findings;
  std::map<std::string, int> others;
  std::int64_t signedUpTo = 0;
  for (const auto& each : signed_) {
    if (!each.isSound) {
      findings.problems.push_back(
          "the signature in event " + std::to_string(each.seq) +
          " is not of the events before it, or not by the station that it names");
      continue;
    }
    signedUpTo = each.seq;
    if (each.head.key != key) ++others[each.head.key];
  }
  for (const auto& [other, count] : others) {
    findings.remarks.push_back(
        std::to_string(count) + " signed by another station, whose key is " +
        inGroupsOfFour(other) + ": ask there whether that is its key");
  }
  if (previousTrailHeads_ > 0) {
    findings.remarks.push_back(
        std::to_string(previousTrailHeads_) +
        (isCollected_ ? " signed at stations, and checked when they were collected (event "
                        "collected_study)"
                      : " signed before the trail was sealed again (event resealed_trail)"));
  }
  if (signedUpTo == 0) {
    findings.remarks.push_back("no station has signed anything of it yet");
  } else if (signedUpTo < lastEvent_) {
    const auto last = std::to_string(lastEvent_);
    findings.remarks.push_back(
        (signedUpTo + 1 == lastEvent_
             ? "event " + last + " is"
             : "events " + std::to_string(signedUpTo + 1) + " to " + last + " are") +
        " not signed yet: that happens at the end of a session, and for exports, reports and "
        "backups, if no noted head is missing");
  }
  return findings;
}

}  // namespace study::storage
