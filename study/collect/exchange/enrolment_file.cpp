#include <array>
#include <cstdlib>

#include <nlohmann/json.hpp>
#include <sodium.h>

#include "base/file.h"
#include "study/collect/exchange/enrolment.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/hasher.h"
#include "study/storage/protocol_repository.h"

namespace study::collect {
namespace {

using nlohmann::json;

constexpr int kFormat = 3;  // 1 was not signed, 2 had one version of the protocol
constexpr const char* kServerSettingsFile = "collect.json";

[[noreturn]] void refuseEnrolment(const std::string& why) {
  throw UserError("This is no enrolment that can be used here: " + why);
}

std::string textIn(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string())
    refuseEnrolment("it is damaged, or of a later release.");
  return found->get<std::string>();
}

storage::BlindingSecret secretIn(const json& object) {
  const auto bytes =
      storage::fromHexadecimal<storage::BlindingSecret::Bytes>(textIn(object, "secret"));
  if (!bytes) refuseEnrolment("it is damaged.");
  return storage::BlindingSecret(*bytes);
}

/// The key pair with which a study signs enrolments.
struct SigningKey {
  std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
  std::array<unsigned char, crypto_sign_SECRETKEYBYTES> secret{};
};

SigningKey signingKeyOf(const storage::BlindingSecret& secret) {
  // A secret derived for a label that no station can have ('/' is not allowed), as a seed.
  const auto seed = secret.of("/enrolments").bytes();
  static_assert(std::tuple_size_v<storage::BlindingSecret::Bytes> == crypto_sign_SEEDBYTES);
  SigningKey key;
  crypto_sign_seed_keypair(key.open.data(), key.secret.data(), seed.data());
  return key;
}

std::string fingerprintOfPublicKey(const std::string& key) {
  constexpr std::size_t kDigits = 20;
  constexpr std::size_t kGroup = 4;
  std::string mark = storage::sha256(key).substr(0, kDigits);
  for (std::size_t at = kDigits - kGroup; at > 0; at -= kGroup) mark.insert(at, " ");
  return mark;
}

/// The signed text: the whole file without the signature.
std::string statementOf(const json& outside) {
  auto signedPart = outside;
  signedPart.erase("signature");
  return "palpate-enrolment " + signedPart.dump();
}

std::string signatureOf(const json& outside, const SigningKey& key) {
  const auto statement = statementOf(outside);
  std::array<unsigned char, crypto_sign_BYTES> signature{};
  crypto_sign_detached(
      signature.data(),
      nullptr,
      reinterpret_cast<const unsigned char*>(statement.data()),
      statement.size(),
      key.secret.data());
  return storage::inHexadecimal(signature);
}

std::vector<StationEnrolment::Protocol> protocolsIn(const json& inside) {
  const auto found = inside.find("protocols");
  const bool isList = found != inside.end() && found->is_array() && !found->empty();
  if (!isList) refuseEnrolment("it is damaged.");
  std::vector<StationEnrolment::Protocol> protocols;
  for (const auto& each : *found) {
    if (!each.is_object()) refuseEnrolment("it is damaged.");
    const auto files = each.find("files");
    if (files == each.end() || !files->is_object()) refuseEnrolment("it is damaged.");
    auto& protocol = protocols.emplace_back();
    protocol.text = textIn(each, "protocol");
    for (const auto& [name, content] : files->items()) {
      if (!content.is_string()) refuseEnrolment("it is damaged.");
      protocol.files.push_back({name, content.get<std::string>()});
    }
  }
  return protocols;
}

}  // namespace

std::string keyFingerprintOf(const storage::BlindingSecret& secret) {
  return fingerprintOfPublicKey(storage::inHexadecimal(signingKeyOf(secret).open));
}

std::string asText(
    const StationEnrolment& enrolment,
    const std::string& publicKey,
    const storage::BlindingSecret& studySecret) {
  json protocols = json::array();
  for (const auto& protocol : enrolment.protocols) {
    json files = json::object();
    for (const auto& file : protocol.files) files[file.name] = file.text;
    protocols.push_back({{"protocol", protocol.text}, {"files", std::move(files)}});
  }
  const json inside{
      {"study", enrolment.study},
      {"title", enrolment.title},
      {"seed", std::to_string(enrolment.seed)},
      {"secret", storage::inHexadecimal(enrolment.secret.bytes())},
      {"site", enrolment.station.site},
      {"station", enrolment.station.label},
      {"station_uuid", enrolment.station.uuid},
      {"server", enrolment.server},
      {"role", enrolment.role},
      {"bundle_key", enrolment.bundleKey},
      {"expires_utc", enrolment.expiresUtc},
      {"protocols", std::move(protocols)}};
  const auto key = signingKeyOf(studySecret);
  json outside{
      {"palpate_enrolment", kFormat},
      {"signed_by", storage::inHexadecimal(key.open)},
      {"title", enrolment.title},
      {"site", enrolment.station.site},
      {"station", enrolment.station.label},
      {"for_key", publicKey},
      {"expires_utc", enrolment.expiresUtc},
      {"sealed", storage::inBase64(storage::StationStore::sealFor(inside.dump(), publicKey))}};
  outside["signature"] = signatureOf(outside, key);
  return outside.dump(1) + "\n";
}

StationEnrolment enrolmentIn(const std::string& text, const storage::StationStore& station) {
  const auto outside = json::parse(text, nullptr, false);
  if (!outside.is_object() || !outside.contains("palpate_enrolment")) {
    refuseEnrolment("'palpate collect init --station' writes one.");
  }
  if (outside["palpate_enrolment"] != kFormat) {
    refuseEnrolment("another release wrote it. Ask for a new one.");
  }
  if (textIn(outside, "for_key") != station.publicKey()) {
    refuseEnrolment(
        "it is for another computer or account. 'palpate collect key' prints the key of this one.");
  }
  const auto signer = textIn(outside, "signed_by");
  if (!storage::StationStore::isSigned(
          statementOf(outside), textIn(outside, "signature"), signer)) {
    refuseEnrolment("it was changed on its way.");
  }
  const auto sealed = storage::fromBase64(textIn(outside, "sealed"));
  if (!sealed) refuseEnrolment("it is damaged.");
  const auto opened = station.unseal(*sealed);
  const auto inside = opened ? json::parse(*opened, nullptr, false) : json();
  if (!inside.is_object()) refuseEnrolment("it was changed on its way.");
  StationEnrolment enrolment{
      .study = textIn(inside, "study"),
      .title = textIn(inside, "title"),
      .seed = std::strtoull(textIn(inside, "seed").c_str(), nullptr, 10),
      .secret = secretIn(inside),
      .station =
          {.site = textIn(inside, "site"),
           .label = textIn(inside, "station"),
           .uuid = textIn(inside, "station_uuid")},
      .server = textIn(inside, "server"),
      .role = textIn(inside, "role"),
      .bundleKey = textIn(inside, "bundle_key"),
      .expiresUtc = textIn(inside, "expires_utc"),
      .protocols = protocolsIn(inside)};
  enrolment.mark = fingerprintOfPublicKey(signer);
  return enrolment;
}

void write(const ServerSettings& settings, const std::filesystem::path& folder) {
  const json content{
      {"server", settings.server}, {"role", settings.role}, {"bundle_key", settings.bundleKey}};
  writeNewFile((folder / kServerSettingsFile).string(), content.dump(1) + "\n");
}

ServerSettings serverSettingsOf(const std::filesystem::path& folder) {
  const auto text = base::readFile(folder / kServerSettingsFile).value_or("");
  const auto content = json::parse(text, nullptr, false);
  if (!content.is_object()) {
    throw UserError(
        folder.string() +
        " is a study of this computer alone: it was not made by 'palpate collect join', and "
        "nothing of it is collected.");
  }
  return {
      .server = textIn(content, "server"),
      .role = textIn(content, "role"),
      .bundleKey = textIn(content, "bundle_key")};
}

}  // namespace study::collect
