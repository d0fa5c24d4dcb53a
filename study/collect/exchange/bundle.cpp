#include "study/collect/exchange/bundle.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <sodium.h>

#include "study/model/new_file.h"
#include "study/model/storage_error.h"
#include "study/model/user_error.h"
#include "study/storage/hasher.h"

namespace study::collect {
namespace {

// File format: a header line; the sealed key of the stream cipher; the header of its stream;
// records, each a length of eight bytes and so many encrypted bytes; a line with the signature of
// all bytes before it.
constexpr const char* kFirstWord = "palpate-bundle-1";
constexpr std::size_t kSignatureDigits = 128;
constexpr std::uint64_t kLargestRecord = std::uint64_t{256} * 1024 * 1024;  // [bytes]

using Key = std::array<unsigned char, crypto_secretstream_xchacha20poly1305_KEYBYTES>;
using PublicBox = std::array<unsigned char, crypto_box_PUBLICKEYBYTES>;
using SecretBox = std::array<unsigned char, crypto_box_SECRETKEYBYTES>;

[[noreturn]] void refuseBundle(const std::filesystem::path& file, const std::string& why) {
  throw InvalidBundle(file.string() + " cannot be taken in: " + why);
}

std::pair<PublicBox, SecretBox> boxOf(const storage::BlindingSecret& secret) {
  // A secret derived for a label that no station can have ('/' is not allowed), as a seed.
  const auto seed = secret.of("/bundles").bytes();
  static_assert(std::tuple_size_v<storage::BlindingSecret::Bytes> == crypto_box_SEEDBYTES);
  std::pair<PublicBox, SecretBox> box;
  crypto_box_seed_keypair(box.first.data(), box.second.data(), seed.data());
  return box;
}

unsigned char* bytesOf(std::string& text) {
  return reinterpret_cast<unsigned char*>(text.data());
}
const unsigned char* bytesOf(const std::string& text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

std::string numberAsBytes(std::uint64_t number) {
  std::string bytes(sizeof number, '\0');
  for (auto& byte : bytes) {
    byte = static_cast<char>(number & 0xFFU);
    number >>= 8U;
  }
  return bytes;
}

std::uint64_t numberIn(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

/// A hash of all bytes that were written or read so far.
class RunningHash {
 public:
  RunningHash() { crypto_generichash_init(&state_, nullptr, 0, crypto_generichash_BYTES); }
  void add(const std::string& bytes) {
    crypto_generichash_update(&state_, bytesOf(bytes), bytes.size());
  }
  /// The text that the station signs.
  std::string statement() {
    std::array<std::byte, crypto_generichash_BYTES> hash{};
    crypto_generichash_final(&state_, reinterpret_cast<unsigned char*>(hash.data()), hash.size());
    return std::string(kFirstWord) + " " + storage::inHexadecimal(hash);
  }

 private:
  crypto_generichash_state state_{};
};

/// Writes the file of a bundle.
class BundleWriter {
 public:
  explicit BundleWriter(const std::filesystem::path& file)
      : path_(file), stream_(file, std::ios::binary) {}

  void put(const std::string& bytes) {
    hash_.add(bytes);
    stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    written_ += bytes.size();
  }
  void putRecord(const std::string& plain, bool isLast) {
    std::string sealed(plain.size() + crypto_secretstream_xchacha20poly1305_ABYTES, '\0');
    crypto_secretstream_xchacha20poly1305_push(
        &cipher_,
        bytesOf(sealed),
        nullptr,
        bytesOf(plain),
        plain.size(),
        nullptr,
        0,
        isLast ? crypto_secretstream_xchacha20poly1305_TAG_FINAL : 0);
    put(numberAsBytes(sealed.size()));
    put(sealed);
  }
  void begin(const std::string& bundleKey) {
    Key key{};
    crypto_secretstream_xchacha20poly1305_keygen(key.data());
    const auto receiver = storage::fromHexadecimal<PublicBox>(bundleKey).value();
    std::string sealed(key.size() + crypto_box_SEALBYTES, '\0');
    crypto_box_seal(bytesOf(sealed), key.data(), key.size(), receiver.data());
    std::string head(crypto_secretstream_xchacha20poly1305_HEADERBYTES, '\0');
    crypto_secretstream_xchacha20poly1305_init_push(&cipher_, bytesOf(head), key.data());
    sodium_memzero(key.data(), key.size());
    put(sealed);
    put(head);
  }
  std::uint64_t finish(const storage::StationStore& station) {
    const auto signature = station.sign(hash_.statement());
    stream_ << signature << std::flush;
    if (!stream_) {
      throw storage::StorageError(
          path_.string() + " could not be written. Free some space, or choose another place.",
          storage::StorageError::Kind::DiskFull);
    }
    return written_ + signature.size();
  }

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
  RunningHash hash_;
  crypto_secretstream_xchacha20poly1305_state cipher_{};
  std::uint64_t written_ = 0;
};

/// A batch as one record: its text, and the bytes of its chunks, each after its length.
std::string asRecord(const Batch& batch) {
  const auto text = asText(batch);
  std::string record = numberAsBytes(text.size()) + text;
  for (const auto& sent : batch.chunks) {
    const auto& data = sent.chunk.data;
    record += numberAsBytes(data.size());
    record.append(reinterpret_cast<const char*>(data.data()), data.size());
  }
  return record;
}

/// Calls @p part with each part of a record (asRecord()). False if the record is malformed.
template <typename Part>
bool forEachPart(std::string_view record, const Part& part) {
  while (!record.empty()) {
    if (record.size() < sizeof(std::uint64_t)) return false;
    const auto size = numberIn(record.substr(0, sizeof(std::uint64_t)));
    record.remove_prefix(sizeof(std::uint64_t));
    if (size > record.size()) return false;
    part(record.substr(0, size));
    record.remove_prefix(size);
  }
  return true;
}

/// Reads the file of a bundle.
class BundleReader {
 public:
  explicit BundleReader(const std::filesystem::path& file)
      : path_(file), stream_(file, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(file, error);
    if (!stream_ || error) refuseBundle(file, "it cannot be read. Check its name and its rights.");
  }

  std::string take(std::uint64_t size) {
    if (size > kLargestRecord) refuseBundle(path_, "it is damaged.");
    std::string bytes(size, '\0');
    stream_.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uint64_t>(stream_.gcount()) != size) {
      refuseBundle(path_, "its end is missing. Copy it again from the station.");
    }
    return bytes;
  }

  BundleHeader head() {
    std::string line;
    if (!std::getline(stream_, line)) refuseBundle(path_, "it is empty.");
    std::istringstream words(line);
    std::string first;
    BundleHeader bundle;
    words >> first >> bundle.study >> bundle.station >> bundle.first >> bundle.last;
    if (!words || first != kFirstWord) {
      refuseBundle(path_, "it is no bundle of a station, or one of a later release.");
    }
    bundle.bytes = size_;
    return bundle;
  }

  void requireSigned(const std::string& key) {
    constexpr std::uint64_t kStep = std::uint64_t{1} << 20U;
    if (size_ <= kSignatureDigits) refuseBundle(path_, "its end is missing.");
    RunningHash hash;
    for (auto left = size_ - kSignatureDigits; left > 0;) {
      const auto size = std::min(left, kStep);
      hash.add(take(size));
      left -= size;
    }
    const auto signature = take(kSignatureDigits);
    stream_.clear();
    stream_.seekg(0);
    if (storage::StationStore::isSigned(hash.statement(), signature, key)) return;
    refuseBundle(
        path_,
        "its signature is not that of the station. It was changed on its way, cut off, or made by "
        "somebody else. Copy it again from the station.");
  }

  bool isAtSignature() {
    return static_cast<std::uint64_t>(stream_.tellg()) + kSignatureDigits >= size_;
  }

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

/// @return  how many bytes were written
std::uint64_t written(
    Outbox& outbox,
    const storage::StationStore& station,
    const std::string& bundleKey,
    const BundleHeader& bundle,
    const std::filesystem::path& file) {
  BundleWriter writer(file);
  writer.put(
      std::string(kFirstWord) + " " + bundle.study + " " + bundle.station + " " +
      std::to_string(bundle.first) + " " + std::to_string(bundle.last) + "\n");
  writer.begin(bundleKey);
  outbox.forEachBatch(bundle.first - 1, [&](const Batch& batch) {
    const bool isLast = !batch.events.empty() && batch.events.back().seq == bundle.last;
    writer.putRecord(asRecord(batch), isLast);
    return true;
  });
  return writer.finish(station);
}

}  // namespace

std::string bundleKeyOf(const storage::BlindingSecret& secret) {
  const auto box = boxOf(secret);
  return storage::inHexadecimal(box.first);
}

BundleHeader writeBundle(
    Outbox& outbox,
    const storage::StationStore& station,
    const std::string& bundleKey,
    std::int64_t after,
    const std::filesystem::path& file) {
  BundleHeader bundle{
      .study = outbox.study(),
      .station = outbox.station().uuid,
      .first = after + 1,
      .last = outbox.lastEvent()};
  if (after > bundle.last) {
    throw UserError(fmt::format(
        "There are {} events here, and {} is none of them. Is this the folder of the station that "
        "the server means?",
        bundle.last,
        after));
  }
  if (after == bundle.last) {
    throw UserError("The server has everything already: there is nothing to be put into a bundle.");
  }
  if (!storage::fromHexadecimal<PublicBox>(bundleKey)) {
    throw UserError(
        "This station was enrolled without a key for bundles. Ask for a new enrolment.");
  }
  writeNewFile(file.string(), "");  // for its owner alone, and never over another one
  try {
    bundle.bytes = written(outbox, station, bundleKey, bundle, file);
  } catch (...) {
    std::error_code ignored;
    // an incomplete file is useless and would block a second try
    std::filesystem::remove(file, ignored);
    throw;
  }
  return bundle;
}

BundleHeader readBundleHeader(const std::filesystem::path& file) {
  return BundleReader(file).head();
}
void readBundle(
    const std::filesystem::path& file,
    const storage::BlindingSecret& secret,
    const std::string& key,
    const std::function<
        bool(const std::string& text, const std::vector<std::vector<std::byte>>& chunks)>& take) {
  BundleReader reader(file);
  reader.requireSigned(key);
  reader.head();
  const auto [publicBox, secretBox] = boxOf(secret);
  Key streamKey{};
  const auto sealedKey = reader.take(streamKey.size() + crypto_box_SEALBYTES);
  const auto head = reader.take(crypto_secretstream_xchacha20poly1305_HEADERBYTES);
  crypto_secretstream_xchacha20poly1305_state cipher{};
  const bool isOurs = crypto_box_seal_open(
                          streamKey.data(),
                          bytesOf(sealedKey),
                          sealedKey.size(),
                          publicBox.data(),
                          secretBox.data()) == 0 &&
                      crypto_secretstream_xchacha20poly1305_init_pull(
                          &cipher, bytesOf(head), streamKey.data()) == 0;
  if (!isOurs) refuseBundle(file, "it is sealed for another study.");
  while (!reader.isAtSignature()) {
    const auto sealed = reader.take(numberIn(reader.take(sizeof(std::uint64_t))));
    if (sealed.size() < crypto_secretstream_xchacha20poly1305_ABYTES) {
      refuseBundle(file, "it is damaged.");
    }
    std::string plain(sealed.size() - crypto_secretstream_xchacha20poly1305_ABYTES, '\0');
    const int code = crypto_secretstream_xchacha20poly1305_pull(
        &cipher, bytesOf(plain), nullptr, nullptr, bytesOf(sealed), sealed.size(), nullptr, 0);
    std::string text;
    std::vector<std::vector<std::byte>> chunks;
    bool isText = true;
    const bool isSound = code == 0 && forEachPart(plain, [&](std::string_view part) {
                           if (std::exchange(isText, false)) {
                             text = part;
                             return;
                           }
                           const auto* first = reinterpret_cast<const std::byte*>(part.data());
                           chunks.emplace_back(first, first + part.size());
                         });
    if (!isSound) refuseBundle(file, "it is damaged.");
    if (!take(text, chunks)) return;
  }
}

}  // namespace study::collect
