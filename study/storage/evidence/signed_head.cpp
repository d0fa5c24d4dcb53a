#include "study/storage/evidence/signed_head.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/text_table.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

constexpr std::string_view kFirstWord = "palpate-head-1";

/// The text that is signed. Its first word distinguishes it from other texts that a station signs.
std::string statementOf(const SignedHead& head) {
  std::string text(kFirstWord);
  for (const auto& field :
       {head.study, head.first, std::to_string(head.events), head.hash, head.utc, head.purpose}) {
    text += " " + field;
  }
  return text;
}

}  // namespace

bool SignedHead::isSigned() const {
  return StationStore::isSigned(statementOf(*this), signature, key);
}

std::string SignedHead::asLine() const {
  return statementOf(*this) + " " + key + " " + signature;
}

base::NamedArguments SignedHead::asValues() const {
  return {
      {"events", events},
      {"hash", hash},
      {"utc", utc},
      {"purpose", purpose},
      {"key", key},
      {"signature", signature}};
}

std::optional<SignedHead> headIn(const std::string& line, std::string* rest) {
  std::istringstream words(line);
  std::string first;
  std::string count;
  SignedHead head;
  words >> first >> head.study >> head.first >> count >> head.hash >> head.utc >> head.purpose >>
      head.key >> head.signature;
  const auto events = base::numberFrom<std::int64_t>(count);
  if (!words || first != kFirstWord || !events) return std::nullopt;
  head.events = *events;
  if (rest != nullptr) std::getline(words >> std::ws, *rest);
  return head;
}

TrailEnd endOf(const Database& study) {
  Statement select(study, "SELECT seq, lower(hex(hash)) FROM event ORDER BY seq DESC LIMIT 1");
  if (!select.step()) return {};
  return {select.number(0), select.text(1)};
}

SignedHead signHead(
    const Database& study, const StationStore& station, std::string_view purpose, std::string utc) {
  Statement select(
      study,
      "SELECT (SELECT uuid FROM study WHERE id = 1), lower(hex(hash)) FROM event WHERE seq = 1");
  if (!select.step()) throw std::logic_error("an audit trail without events cannot be signed");
  const auto end = endOf(study);
  SignedHead head{
      .study = select.text(0),
      .first = select.text(1),
      .events = end.events,
      .hash = end.hash,
      .utc = std::move(utc),
      .purpose = std::string(purpose),
      .key = station.publicKey()};
  head.signature = station.sign(statementOf(head));
  return head;
}

std::string inGroupsOfFour(const std::string& hash) {
  constexpr std::size_t kDigits = 32;  // 128 bits
  std::string words;
  for (std::size_t i = 0; i < std::min(kDigits, hash.size()); i += 4) {
    words += (words.empty() ? "" : " ") + hash.substr(i, 4);
  }
  return words;
}

}  // namespace study::storage
