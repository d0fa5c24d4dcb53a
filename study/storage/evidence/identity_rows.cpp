#include "study/storage/evidence/identity_rows.h"

#include <optional>
#include <utility>

#include "study/storage/statement.h"

namespace study::storage {
namespace {

constexpr const char* kRowName =
    "participant || '/' || session_number || '/' || step || '/' || attempt || '/' || item";

/// The bytes of one column, after their number, so that the limits of several columns in a row are
/// known.
std::string withSize(const std::string& bytes) {
  return std::to_string(bytes.size()) + ":" + bytes;
}

}  // namespace

std::vector<IdentityRow> identityRows(const Database& identities) {
  // Older formats lack the column `sealed`.
  Statement sealed(
      identities, "SELECT 1 FROM pragma_table_info('identifying_answer') WHERE name = 'sealed'");
  const std::string columns = std::string("text, saved_utc") + (sealed.step() ? ", sealed" : "");
  Statement select(
      identities,
      std::string("SELECT ") + kRowName + ", " + columns + " FROM identifying_answer ORDER BY 1");
  std::vector<IdentityRow> rows;
  while (select.step()) {
    IdentityRow row{.name = select.text(0)};
    for (int column = 0; column < select.columnCount(); ++column) {
      row.bytes += withSize(select.exactBytes(column));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<IdentityRow> identityRowsBeforeSealing(IdentityStore& identities) {
  Statement select(
      identities.database(),
      std::string("SELECT ") + kRowName +
          ", participant, saved_utc, sealed FROM identifying_answer WHERE sealed IS NOT NULL "
          "ORDER BY 1");
  std::vector<IdentityRow> rows;
  while (select.step()) {
    const auto key = identities.key(IdentityStore::Key::Identity, select.text(1));
    const auto text = key ? key->open(select.blob(3), select.text(0)) : std::nullopt;
    if (!text) continue;
    IdentityRow row{.name = select.text(0)};
    // As exactBytes() gives them: texts, and NULL in place of the sealed text.
    for (const auto& bytes :
         {"t" + row.name, "t" + *text, "t" + select.text(2), std::string("n")}) {
      row.bytes += withSize(bytes);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace study::storage
