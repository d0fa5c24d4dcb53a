#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "study/model/clock.h"
#include "study/storage/database.h"
#include "study/storage/evidence/signed_head.h"

namespace study::storage {

/// Signs a study's audit trail with the key of this station, and notes each signed head in the
/// station's own list. Problems of the station's store never throw, because a finished session must
/// not fail for them. The trail then gets an event HeadNotSigned.
class TrailSigner {
 public:
  explicit TrailSigner(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Appends an event with the signed head of all events so far, inside the caller's transaction.
  /// @param purpose  why: the name of the last event's kind
  /// @throws StorageError  if the event cannot be appended.
  void sign(Database& study, std::string_view purpose, const Moment& now);

  /// Notes the signed head in the station's list. Call it after the commit, so that the list has no
  /// head that the trail never had.
  /// @return false if it could not be noted
  bool noteSigned() noexcept;

  /// Drops the head of a transaction that was rolled back.
  void forget() noexcept { signed_.reset(); }

 private:
  std::filesystem::path folder_;
  /// The last head that was signed and not noted; it covers earlier ones.
  std::optional<SignedHead> signed_;
};

/// Notes the first event of a study that was just made, as TrailSigner does. Nothing is written to
/// the study.
void noteNewStudy(const Database& study, const std::filesystem::path& folder, const Moment& now);

}  // namespace study::storage
