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
/// station's list. Errors of the station's store are not thrown, because a finished session must
/// not fail because of them; the trail then gets an event HeadNotSigned.
class TrailSigner {
 public:
  explicit TrailSigner(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Appends an event with the signed head of all events before it, inside the caller's
  /// transaction.
  /// @param purpose  name of the kind of the last event, which causes the signature
  /// @throws StorageError  if the event cannot be appended.
  void sign(Database& study, std::string_view purpose, const Moment& now);

  /// Notes the signed head in the station's list. Call it after the commit, so that the list never
  /// has a head that the trail lacks.
  /// @return false if the head could not be noted
  bool recordSignedHead() noexcept;

  /// Discards the head of a transaction that was rolled back.
  void forget() noexcept { signed_.reset(); }

 private:
  std::filesystem::path folder_;
  /// The last head that was signed but not noted; it covers earlier ones.
  std::optional<SignedHead> signed_;
};

/// Notes the first event of a new study in the station's list, as TrailSigner does. The study is
/// not changed.
void recordNewStudy(const Database& study, const std::filesystem::path& folder, const Moment& now);

}  // namespace study::storage
