#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

/// The data of a station, in a folder outside of all studies: its uuid, an Ed25519 key pair with
/// which it signs audit trails (docs/decisions/0041), and lists. A station is one account on one
/// computer. Only the owner can read or write the folder and its files.
class StationStore {
 public:
  /// $PALPATE_STATION; without it palpate/station in $XDG_DATA_HOME; without that
  /// ~/.local/share/palpate/station. Empty if the account has no home folder.
  static std::filesystem::path defaultFolder();

  /// Opens the store in @p folder; creates it if there is none.
  /// @throws StorageError  if the store cannot be created or read, or if other accounts can read
  ///     its key.
  static StationStore openOrCreate(const std::filesystem::path& folder);

  /// Opens the store in @p folder; std::nullopt if there is none. @throws StorageError  as
  /// openOrCreate()
  static std::optional<StationStore> find(const std::filesystem::path& folder);

  /// 128 random bits in hexadecimal; the same for all studies.
  const std::string& uuid() const noexcept { return uuid_; }

  /// 256 bits in hexadecimal. It is public; signatures are verified with it.
  const std::string& publicKey() const noexcept { return publicKey_; }

  /// The signature of @p text (Ed25519, 512 bits in hexadecimal).
  std::string sign(std::string_view text) const;

  /// Whether @p signature is a valid signature of @p text for that public key. False also for
  /// malformed keys and signatures.
  static bool isSigned(
      std::string_view text, const std::string& signature, const std::string& publicKey);

  /// Seals @p text so that only the station with @p publicKey can open it (crypto_box_seal of
  /// libsodium). @throws UserError  if @p publicKey is not the key of a station
  static std::vector<std::byte> sealFor(std::string_view text, const std::string& publicKey);

  /// The text that was sealed for this station; std::nullopt if it was sealed for another station
  /// or was changed.
  std::optional<std::string> unseal(std::span<const std::byte> sealed) const;

  /// Appends a line to a list. The list is on the disk on return. Several programs may append at
  /// the same time.
  /// @param list  a file name: "heads-1a2b"
  /// @throws StorageError
  void append(const std::string& list, const std::string& line) const;

  /// Replaces the content of a list by @p lines. The list is on the disk on return.
  /// @throws StorageError
  void rewrite(const std::string& list, const std::vector<std::string>& lines) const;

  /// The lines of a list; empty if there is no such list. @throws StorageError  if it cannot be
  /// read
  std::vector<std::string> lines(const std::string& list) const;

 private:
  explicit StationStore(std::filesystem::path folder);

  std::filesystem::path folder_;
  std::string uuid_;
  std::string publicKey_;
  std::array<unsigned char, 64> secretKey_{};
};

}  // namespace study::storage
