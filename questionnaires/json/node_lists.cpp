#include <algorithm>
#include <set>

#include "questionnaires/json/document.h"

namespace questionnaires {

std::optional<Node> Node::object(std::string_view key) const {
  const Value* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (!std::holds_alternative<Value::Object>(value->data)) {
    problem(key, "an object is expected here, not " + typeName(*value), "write { … }");
    return std::nullopt;
  }
  return at(key, *value);
}

std::optional<Node> Node::requiredObject(std::string_view key) const {
  return require(key) ? object(key) : std::nullopt;
}

std::vector<Node> Node::list(std::string_view key, std::size_t most) const {
  const Value* value = find(key);
  if (value == nullptr) return {};
  const auto* array = std::get_if<Value::Array>(&value->data);
  if (array == nullptr) {
    problem(key, "a list is expected here, not " + typeName(*value), "write [ … ]");
    return {};
  }
  if (array->size() > most) {
    problem(key, "this list has more than " + std::to_string(most) + " entries", "shorten it");
  }
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < std::min(array->size(), most); ++i) {
    nodes.emplace_back((*array)[i], pathOf(key) + "[" + std::to_string(i) + "]", *problems_);
  }
  return nodes;
}

std::vector<Node> Node::requiredList(std::string_view key) const {
  const Value* value = required(key);
  if (value == nullptr) return {};
  auto nodes = list(key);
  if (nodes.empty() && std::holds_alternative<Value::Array>(value->data)) {
    problem(key, "this list is empty", "it needs at least one entry");
  }
  return nodes;
}

std::optional<Node> Node::member(std::string_view key) const {
  const Value* value = find(key);
  return value == nullptr ? std::nullopt : std::optional(at(key, *value));
}

std::vector<std::pair<std::string, Node>> Node::members() const {
  std::vector<std::pair<std::string, Node>> result;
  if (const auto* object = std::get_if<Value::Object>(&value_->data)) {
    for (const auto& member : *object) {
      result.emplace_back(member.key, at(member.key, member.value));
    }
  }
  return result;
}

std::vector<std::string> Node::texts(std::string_view key) const {
  std::vector<std::string> result;
  for (const auto& node : list(key)) result.push_back(node.asText());
  return result;
}

std::vector<double> Node::numbers(std::string_view key, double least, double most) const {
  std::vector<double> result;
  const auto nodes = list(key);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string place = std::string(key) + "[" + std::to_string(i) + "]";
    result.push_back(numberIn(place, *nodes[i].value_, least, most).value_or(least));
  }
  return result;
}

std::vector<std::string> Node::ids(std::string_view key) const {
  std::vector<std::string> result;
  std::set<std::string> seen;
  for (const auto& node : list(key)) {
    std::string id = node.asText();
    if (node.isText() && !isValidId(id)) {
      node.problem("", "'" + shown(id) + "' cannot be an id", std::string(kIdRule));
    }
    if (node.isText() && !seen.insert(id).second) {
      node.problem("", "'" + shown(id) + "' stands in this list twice", "keep one");
    }
    result.push_back(std::move(id));
  }
  return result;
}

}  // namespace questionnaires
