#include "study/storage/evidence/identity_rows.h"

#include "study/storage/statement.h"

namespace study::storage {

std::vector<IdentityRow> identityRows(const Database& identities) {
  // Older formats lack the column `sealed`.
  Statement sealed(
      identities, "SELECT 1 FROM pragma_table_info('identifying_answer') WHERE name = 'sealed'");
  const std::string columns = std::string("text, saved_utc") + (sealed.step() ? ", sealed" : "");
  Statement select(
      identities,
      "SELECT participant || '/' || session_number || '/' || step || '/' || attempt || '/' || "
      "item, " +
          columns + " FROM identifying_answer ORDER BY 1");
  std::vector<IdentityRow> rows;
  while (select.step()) {
    IdentityRow row{.name = select.text(0)};
    for (int column = 0; column < select.columnCount(); ++column) {
      const auto bytes = select.exactBytes(column);
      row.bytes += std::to_string(bytes.size()) + ":" + bytes;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace study::storage
