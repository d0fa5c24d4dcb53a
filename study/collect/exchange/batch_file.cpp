
#include <nlohmann/json.hpp>

#include "study/collect/exchange/batch.h"
#include "study/model/storage_error.h"
#include "study/storage/hasher.h"
#include "study/storage/protocol_repository.h"

namespace study::collect {
namespace {

using nlohmann::json;
using storage::StorageError;

[[noreturn]] void refuseBatch(const char* what) {
  throw StorageError(
      std::string("What the server has of a ") + what +
          " cannot be read by this program. Install the release of the stations, or run 'palpate "
          "collect check'.",
      StorageError::Kind::Damaged);
}

json hexOrNull(const std::vector<std::byte>& bytes) {
  return bytes.empty() ? json() : json(storage::inHexadecimal(bytes));
}

json orNull(const std::optional<std::int64_t>& number) {
  return number ? json(*number) : json();
}

json asJson(const storage::NamedRow& row) {
  json object = json::object();
  for (const auto& [name, value] : row) {
    std::visit(
        [&, &column = name](const auto& held) {
          using Held = std::decay_t<decltype(held)>;
          if constexpr (std::is_same_v<Held, std::monostate>) {
            object[column] = nullptr;
          } else {
            object[column] = held;
          }
        },
        value);
  }
  return object;
}

bool isSingle(const std::string& table) {
  return table == "participant" || table == "session";
}

/// Reads the text of a session row by row: {"table": [{"column": value}]}, or without the list
/// where a table has one row. A tree of the whole text would take twice as long.
class FactsReader : public nlohmann::json_sax<json> {
 public:
  storage::SessionTables take() { return std::move(facts_); }

  bool null() override { return put(std::monostate()); }
  bool boolean(bool /*value*/) override { return false; }
  bool number_integer(number_integer_t value) override { return put(std::int64_t{value}); }
  bool number_unsigned(number_unsigned_t value) override {
    return put(static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*count*/) override {
    if (!isOpen_) return isOpen_ = true;
    if (table_ == nullptr || row_ != nullptr || isInList_ == isSingle_) return false;
    row_ = &table_->emplace_back();
    return true;
  }
  bool key(string_t& name) override {
    if (row_ != nullptr) {
      cell_ = &(*row_)[name];
    } else {
      isSingle_ = collect::isSingle(name);
      table_ = &facts_[name];
    }
    return true;
  }
  bool end_object() override {
    row_ = nullptr;
    cell_ = nullptr;
    return true;
  }
  bool start_array(std::size_t /*count*/) override {
    if (table_ == nullptr || row_ != nullptr || isInList_ || isSingle_) return false;
    return isInList_ = true;
  }
  bool end_array() override {
    isInList_ = false;
    return true;
  }
  bool parse_error(
      std::size_t /*place*/,
      const std::string& /*token*/,
      const nlohmann::detail::exception& /*error*/) override {
    return false;
  }

 private:
  bool put(storage::NamedRowValue value) {
    if (cell_ == nullptr) return false;
    *cell_ = std::move(value);
    return true;
  }

  storage::SessionTables facts_;
  bool isOpen_ = false;
  bool isSingle_ = false;
  bool isInList_ = false;
  std::vector<storage::NamedRow>* table_ = nullptr;
  storage::NamedRow* row_ = nullptr;
  storage::NamedRowValue* cell_ = nullptr;  ///< of the column that was named last
};

json asJson(const storage::StoredEvent& event) {
  return {
      {"seq", event.seq},
      {"session", orNull(event.session)},
      {"step", orNull(event.step)},
      {"attempt", orNull(event.attempt)},
      {"utc", event.utc},
      {"monotonic_ns", event.monotonic},
      {"actor", event.actor},
      {"kind", event.kind},
      {"detail", event.detail},
      {"sealed", hexOrNull(event.sealed)},
      {"content_hash", hexOrNull(event.content)},
      {"hash", storage::inHexadecimal(event.hash)}};
}

json asJson(const SentChunk& sent) {
  const auto& chunk = sent.chunk;
  const std::string_view data(reinterpret_cast<const char*>(chunk.data.data()), chunk.data.size());
  return {
      {"session", sent.session},
      {"step", chunk.step},
      {"attempt", chunk.attempt},
      {"number", chunk.number},
      {"samples", chunk.samples},
      {"layout", chunk.layout},
      {"hash", storage::inHexadecimal(chunk.hash)},
      {"sha256", storage::sha256(data)}};
}

}  // namespace

std::string asText(const storage::SessionTables& facts) {
  json all = json::object();
  for (const auto& [table, rows] : facts) {
    if (isSingle(table)) {
      all[table] = asJson(rows.at(0));
      continue;
    }
    json list = json::array();
    for (const auto& row : rows) list.push_back(asJson(row));
    all[table] = std::move(list);
  }
  return all.dump();
}

storage::SessionTables sessionTablesIn(const std::string& text) {
  FactsReader reader;
  if (!json::sax_parse(text, &reader)) refuseBatch("session");
  return reader.take();
}

std::string asText(const Batch& batch) {
  json events = json::array();
  for (const auto& event : batch.events) events.push_back(asJson(event));
  json sessions = json::array();
  for (const auto& session : batch.sessions) {
    sessions.push_back(
        {{"session", session.number},
         {"as_of", session.lastEvent},
         {"sha256", storage::sha256(session.facts)},
         {"facts", session.facts}});
  }
  json keys = json::array();
  for (const auto& key : batch.keys) {
    keys.push_back(
        {{"participant", key.participant}, {"key", storage::inHexadecimal(key.key.bytes())}});
  }
  json traces = json::array();
  for (const auto& chunk : batch.chunks) traces.push_back(asJson(chunk));
  const json all{
      {"format", kBatchFormat},
      {"study", batch.study},
      {"station", batch.station},
      {"after", batch.after},
      {"events", std::move(events)},
      {"sessions", std::move(sessions)},
      {"keys", std::move(keys)},
      {"traces", std::move(traces)}};
  return all.dump();
}

ServerAnswer answerIn(const std::string& text) {
  const auto said = json::parse(text, nullptr, false);
  if (!said.is_object() || !said.contains("have")) refuseBatch("batch");
  const auto textOf = [&](const char* key) {
    const auto found = said.find(key);
    return found != said.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  std::vector<ErasureReceipt> erased;
  for (const auto& receipt : said.value("erased", json::array())) {
    erased.push_back(
        {.session = receipt.value("session", std::int64_t{0}),
         .participant = receipt.value("participant", std::string()),
         .utc = receipt.value("utc", std::string()),
         .left = receipt.value("left", std::int64_t{0})});
  }
  return {
      .lastEvent = said["have"].get<std::int64_t>(),
      .head = textOf("head"),
      .refused = textOf("refused"),
      .detail = textOf("detail"),
      .erased = std::move(erased)};
}

}  // namespace study::collect
