#include <algorithm>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"
#include "study/model/messages.h"
#include "study/storage/stored_values.h"

namespace study::storage {
namespace {

using base::Argument;
using questionnaires::Value;
using Json = nlohmann::ordered_json;

Json jsonOf(const Argument& argument) {
  return std::visit([](const auto& value) { return Json(value); }, argument);
}

std::optional<Argument> argumentIn(const Value& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value.data)) return *number;
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  return std::nullopt;
}

std::optional<Value> parsed(std::string_view text) {
  questionnaires::Problems problems;
  return questionnaires::parseJson(text, problems);
}

const Value* find(const Value::Object& object, std::string_view key) {
  const auto found = std::ranges::find_if(object, [&](const auto& m) { return m.key == key; });
  return found == object.end() ? nullptr : &found->value;
}

base::Message messageIn(const Value& entry) {
  const auto* object = std::get_if<Value::Object>(&entry.data);
  const Value* code = object == nullptr ? nullptr : find(*object, "code");
  const Value* list = object == nullptr ? nullptr : find(*object, "arguments");
  if (code == nullptr || list == nullptr) return {};
  const auto* key = std::get_if<std::string>(&code->data);
  const auto* values = std::get_if<Value::Array>(&list->data);
  if (key == nullptr || values == nullptr) return {};
  std::vector<Argument> arguments;
  for (const auto& value : *values) {
    if (auto argument = argumentIn(value)) arguments.push_back(std::move(*argument));
  }
  const auto kind =
      std::ranges::find_if(kMessages, [&](const auto& known) { return known.key == *key; });
  const bool isKnown =
      kind != kMessages.end() && base::placeholderCount(kind->english) == arguments.size();
  return isKnown ? base::Message(*kind, std::move(arguments)) : base::Message::verbatim(*key);
}

}  // namespace

std::string asJson(const std::vector<base::Message>& messages) {
  if (messages.empty()) return {};
  Json list = Json::array();
  for (const auto& message : messages) {
    Json arguments = Json::array();
    for (const auto& argument : message.arguments()) arguments.push_back(jsonOf(argument));
    list.push_back({{"code", message.key()}, {"arguments", std::move(arguments)}});
  }
  return list.dump();
}

std::vector<base::Message> messagesIn(std::string_view text) {
  const auto root = parsed(text);
  const auto* list = root ? std::get_if<Value::Array>(&root->data) : nullptr;
  std::vector<base::Message> messages;
  if (list == nullptr) return messages;
  for (const auto& entry : *list) messages.push_back(messageIn(entry));
  return messages;
}

std::string asJson(const base::NamedArguments& values) {
  Json object = Json::object();
  for (const auto& [name, value] : values) object[name] = jsonOf(value);
  return object.dump();
}

std::optional<base::NamedArguments> valuesIn(std::string_view text) {
  const auto root = parsed(text);
  const auto* object = root ? std::get_if<Value::Object>(&root->data) : nullptr;
  if (object == nullptr) return std::nullopt;
  base::NamedArguments values;
  for (const auto& [name, value] : *object) {
    auto argument = argumentIn(value);
    if (!argument) return std::nullopt;
    values.emplace_back(name, std::move(*argument));
  }
  return values;
}

}  // namespace study::storage
