#include "study/session/audit_words.h"

#include "study/model/data_table.h"
#include "study/storage/answer_repository.h"
#include "study/storage/protocol_repository.h"

namespace study {

std::string auditWords(const GivenAnswer& answer) {
  const auto stored = storage::stored(answer.response);
  if (stored.point) return answer.item + " = " + std::to_string(*stored.point);
  if (stored.number) return answer.item + " = " + exactly(*stored.number);
  constexpr std::size_t kLongest = 200;
  const std::string text = stored.text.value_or("");
  return answer.item + " = " +
         (text.size() > kLongest ? "sha256:" + storage::sha256(text) : "'" + text + "'");
}

}  // namespace study
