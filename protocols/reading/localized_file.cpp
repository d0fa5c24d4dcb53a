#include "protocols/reading/localized_file.h"

#include <string>

#include "questionnaires/reading/text_reader.h"

namespace protocols {

questionnaires::LocalizedText readLocalized(
    const questionnaires::Node& node, std::string_view key) {
  const questionnaires::TextReader reader({"en"});
  auto text = reader.required(node, key);
  if (!text.has("en")) {
    node.problem(key, "the English text is missing", "add \"en\": every text falls back to it");
  }
  return text;
}

}  // namespace protocols
