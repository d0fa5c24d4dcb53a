#include "study/storage/evidence/head_check.h"

#include <algorithm>
#include <iterator>

#include "study/model/event_kind.h"
#include "study/words/counted.h"

namespace study::storage {
namespace {

std::string asWords(const RecordedHead& noted) {
  const auto& head = noted.head;
  return std::to_string(head.events) + " events, " + inGroupsOfFour(head.hash) + " (signed " +
         head.utc + ", " + head.purpose + (noted.folder.empty() ? "" : ", in " + noted.folder) +
         ")";
}

/// The reason why the trail lacks a head, as far as the trail shows it.
std::string reasonFor(const TrailHeads& trail, const RecordedHead& noted) {
  const auto last = std::to_string(trail.lastSharedEvent());
  if (trail.endsBefore(noted.head)) {
    const auto goesOn = trail.lastSharedEvent() < trail.lastEvent()
                            ? " (erasures that were repeated here follow)"
                            : "";
    return "the study's events in the trail end with event " + last + goesOn +
           ", and had gone on to " + asWords(noted) +
           ": its end was cut off, or an older copy is in its place";
  }
  return "the trail is not the one that had " + asWords(noted) +
         ": it was written anew, or goes on from an older copy";
}

void addMissing(
    const TrailHeads& trail, const std::vector<RecordedHead>& missing, Findings& findings) {
  if (missing.empty()) return;
  // The first missing head shows where the trail was cut off or changed, the last one how long it
  // was.
  findings.problems.push_back(reasonFor(trail, missing.front()));
  if (missing.size() > 1) {
    findings.problems.push_back(
        "and " + std::to_string(missing.size() - 1) + " later, the last with " +
        asWords(missing.back()));
  }
  findings.problems.push_back(
      "A backup is verified with --older-copy. If an older copy was put back on purpose: palpate "
      "study restored --reason \"…\"");
}

/// Whether @p head was signed because the trail began at that station, or was accepted there on
/// purpose; heads are also signed for other purposes.
bool confirmsTrailStart(const SignedHead& head) {
  using enum EventKind;
  const auto is = [&](EventKind kind) { return head.purpose == study::nameOf(kind); };
  return is(MadeStudy) || is(CollectedStudy) || is(ResealedTrail) || is(RestoredCopy);
}

/// The heads in a station's list that concern one trail. Studies with the same uuid may have
/// different trails, if a study was created again, collected, or sealed again.
struct OwnHeads {
  /// Whether the trail began, or was accepted on purpose, at this station.
  bool beganAtThisStation = false;
  /// True with beganAtThisStation, and if the station's first noted head of this study belongs to
  /// this trail, or none was noted. If false, the station signed a different trail.
  bool isKnown = false;
  std::vector<RecordedHead> heads = {};  ///< heads that the trail must contain or explain
};

OwnHeads ownHeads(const TrailHeads& trail, const std::vector<RecordedHead>& noted) {
  const auto isOfTrail = [&](const RecordedHead& each) {
    return each.head.first == trail.firstHash();
  };
  OwnHeads own;
  own.beganAtThisStation = std::ranges::any_of(
      noted, [&](const auto& each) { return isOfTrail(each) && confirmsTrailStart(each.head); });
  own.isKnown = own.beganAtThisStation || noted.empty() || isOfTrail(noted.front());
  const auto last = std::ranges::find_if(
      noted, [&](const auto& each) { return trail.isLastOfPreviousTrail(each.head); });
  const auto before = last == noted.end() ? std::string() : last->head.first;
  std::ranges::copy_if(noted, std::back_inserter(own.heads), [&](const auto& each) {
    return !own.isKnown || isOfTrail(each) || each.head.first == before ||
           trail.isAbandoned(each.head);
  });
  return own;
}

}  // namespace

Findings checkHeads(
    const TrailHeads& trail, const std::vector<RecordedHead>& noted, bool isOlderCopy) {
  Findings findings;
  std::vector<RecordedHead> missing;
  std::size_t givenUp = 0;
  std::size_t later = 0;
  std::size_t before = 0;
  for (const auto& each : noted) {
    if (trail.holds(each.head)) continue;
    if (trail.isAbandoned(each.head)) {
      ++givenUp;
    } else if (trail.belongsToPreviousTrail(each.head)) {
      ++before;
    } else if (isOlderCopy && trail.endsBefore(each.head)) {
      ++later;
    } else {
      missing.push_back(each);
    }
  }
  addMissing(trail, missing, findings);
  if (givenUp > 0) {
    findings.remarks.push_back(
        words::counted(givenUp, "noted head was", "noted heads were") +
        " given up when an older copy was put back (event restored_copy)");
  }
  if (before > 0) {
    findings.remarks.push_back(
        words::counted(before, "noted head is", "noted heads are") +
        " of the trail before it was sealed again (event resealed_trail)");
  }
  if (later > 0) {
    findings.remarks.push_back(
        "an older copy: " + words::counted(later, "head was", "heads were") +
        " noted after its end. Whether an end was cut off cannot be told from that");
  }
  return findings;
}

Findings checkStation(
    const TrailHeads& trail,
    const StationStore& station,
    const RecordedHeads& listed,
    bool isOlderCopy) {
  const auto& [all, unsoundLines] = listed;
  const auto own = ownHeads(trail, all);
  const auto& noted = own.heads;
  if (!own.isKnown) {
    return {
        .problems = {
            "this station signed a study of this uuid with another first event, and goes on from " +
                asWords(all.back()) +
                ": the trail was written anew, or the study comes from elsewhere. It is not signed "
                "here",
            "If it is right that this study is here: palpate study restored --reason \"…\""}};
  }
  auto findings = checkHeads(trail, noted, isOlderCopy);
  if (all.empty()) {
    findings.remarks.push_back(
        "this station has noted nothing of this study: compare it with a head or a witness file "
        "from where it was made (--expect, --witness)");
  } else if (!own.beganAtThisStation) {
    findings.remarks.push_back(
        "this station did not note how the study began. What was before " + asWords(all.front()) +
        " is proven only by a head or a witness file of then (--expect, --witness)");
  }
  if (unsoundLines > 0) {
    findings.remarks.push_back(
        words::counted(unsoundLines, "line", "lines") +
        " of this station's list left out: not what it wrote");
  }
  // A head is noted after its events were stored, so the list may have grown since.
  const auto since = ownHeads(trail, readRecordedHeads(station, trail.study()).heads).heads;
  const auto unnoted = std::ranges::count_if(trail.all(), [&](const auto& each) {
    return each.isSound && each.head.key == station.publicKey() &&
           std::ranges::none_of(since, [&](const auto& other) {
             return other.head.signature == each.head.signature;
           });
  });
  if (unnoted > 0) {
    findings.remarks.push_back(
        words::counted(
            static_cast<std::uint64_t>(unnoted),
            "head that this station signed is",
            "heads that this station signed are") +
        " not in its own list");
  }
  return findings;
}

std::vector<SignedHead> missingHeads(const TrailHeads& trail, const RecordedHeads& listed) {
  const auto own = ownHeads(trail, listed.heads);
  std::vector<SignedHead> missing;
  for (const auto& [head, folder] : own.heads) {
    const bool isAccountedFor =
        trail.holds(head) || trail.isAbandoned(head) || trail.belongsToPreviousTrail(head);
    if (!own.isKnown || !isAccountedFor) missing.push_back(head);
  }
  return missing;
}

}  // namespace study::storage
