#pragma once

#include <concepts>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "haptics/devices/device_kind.h"
#include "study/model/data_table.h"

namespace study {

/// The type of a column's cells.
enum class ColumnType { Text, Integer, Number, Boolean, DateTime };

/// The name in codebooks: "date_time".
std::string_view nameOf(ColumnType type) noexcept;

/// A value of a closed list, and its meaning.
struct Level {
  std::string value;
  std::string label;
};

/// A closed list of values, which may depend on the study.
enum class ValueList {
  RunModes,
  Statuses,  ///< of sessions
  Verdicts,  ///< of trials
  ItemTypes,
  Cohorts,
  Blocks,
  ConditionCodes,
  Conditions,
  Sites,  ///< only if the study has several sites
};

/// The values of each list in their natural order.
using ValueLists = std::map<ValueList, std::vector<Level>>;

/// The intended readers of an export folder. They determine which columns are exported, and some of
/// the descriptions.
struct Readers {
  bool isBlinded = true;  ///< whether readers must not learn which condition a condition code
                          ///< stands for
  bool isPublic = false;  ///< the folder is for the public
  bool seeExact = false;  ///< whether to export exact dates, times of day, and numbers about
                          ///< the person
  bool seeTexts = false;  ///< whether to export free texts of participants and operators
  bool needParticipantColumn = true;  ///< false if the file's name identifies the participant of
                                      ///< all its rows
  /// Names of the quasi-identifiers that a public export releases (study/export/k_anonymity.h).
  std::set<std::string> releasedIdentifiers = {};
  ValueLists lists = {};
  /// The kind of device, if all devices of the study are of one kind; otherwise nullptr. A kind may
  /// have its own descriptions of tables.
  const haptics::devices::DeviceKind* device = nullptr;

  /// Whether the study has several sites.
  bool hasSites() const { return lists.count(ValueList::Sites) == 1; }

  /// The device's own text in place of @p description, if it has one; otherwise @p description.
  std::string inDeviceWords(const std::string& description) const;
};

/// A column of an exported table, as data dictionaries list it.
struct ExportedColumn {
  ExportedColumn(
      std::string columnName,
      ColumnType columnType,
      std::string columnUnit,
      std::string columnDescription)
      : name(std::move(columnName)),
        type(columnType),
        unit(std::move(columnUnit)),
        description(std::move(columnDescription)) {}

  std::string name;  ///< snake_case, with its unit
  ColumnType type;
  std::string unit;  ///< "s", "N"; empty if the values have no unit, or if it depends on the device
  std::string description;
  bool isFreeText = false;         ///< entered by a participant or an operator
  std::vector<Level> levels = {};  ///< all allowed values in order; empty: any value
};

/// An exported table: the same columns for all rows.
struct ExportedTable {
  std::string name;  ///< of the file, without its extension
  std::string description;
  std::vector<ExportedColumn> columns;
  std::vector<std::vector<Cell>> rows;
};

/// The types of columns. The getter of a column must return a value of the column's type, a
/// std::optional of such a value, or a Cell. Tables are written as
///
///     {"contact_s", Number{"s"}, "How long something was felt", &StoredTrial::contact}
namespace holds {

/// Codes and names. An empty text is a missing value.
struct Text {
  static constexpr ColumnType kType = ColumnType::Text;
};
/// Free text, which spreadsheets must not read as a formula.
struct FreeText {
  static constexpr ColumnType kType = ColumnType::Text;
};
/// One value of a list that several columns use.
struct OneOf {
  static constexpr ColumnType kType = ColumnType::Text;
  ValueList list;
};
/// One value of a list that only this column uses.
struct OneOfOwnList {
  static constexpr ColumnType kType = ColumnType::Text;
  std::vector<Level> levels;
};
struct Integer {
  static constexpr ColumnType kType = ColumnType::Integer;
};
struct Number {
  static constexpr ColumnType kType = ColumnType::Number;
  std::string_view unit = {};
};
struct Boolean {
  static constexpr ColumnType kType = ColumnType::Boolean;
};
/// ISO 8601, UTC.
struct Utc {
  static constexpr ColumnType kType = ColumnType::DateTime;
};

/// The type inside a std::optional; other types are unchanged.
template <typename Value>
struct WithoutOptional {
  using Type = Value;
};
template <typename Value>
struct WithoutOptional<std::optional<Value>> {
  using Type = Value;
};

/// An enum whose enumerators have names in files.
template <typename Value>
concept Named = std::is_enum_v<Value> && requires(Value value) {
  { nameOf(value) } -> std::same_as<std::string_view>;
};

/// Whether the getter of a column of type @p type may return @p Value.
template <ColumnType type, typename Value>
constexpr bool fits() {
  using V = typename WithoutOptional<std::remove_cvref_t<Value>>::Type;
  if constexpr (std::same_as<V, Cell>) return true;
  if constexpr (type == ColumnType::Boolean) return std::same_as<V, bool>;
  if constexpr (type == ColumnType::Integer) return std::integral<V> && !std::same_as<V, bool>;
  if constexpr (type == ColumnType::Number) return std::floating_point<V>;
  if constexpr (Named<V>) return true;
  return std::convertible_to<V, std::string_view>;
}

template <typename Value>
Cell asCell(const Value& value) {
  if constexpr (std::same_as<Value, Cell> || std::same_as<Value, bool>) {
    return value;
  } else if constexpr (std::integral<Value>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::floating_point<Value>) {
    return static_cast<double>(value);
  } else if constexpr (Named<Value>) {
    return std::string(nameOf(value));
  } else {
    const std::string_view text = value;
    return text.empty() ? Cell() : Cell(std::string(text));
  }
}
template <typename Value>
Cell asCell(const std::optional<Value>& value) {
  return value ? asCell(*value) : Cell();
}

}  // namespace holds

/// Whether @p Getter returns a value for a column of type @p Holding.
template <typename Getter, typename Holding, typename Row>
concept GetterOf = std::invocable<Getter, const Row&> &&
    holds::fits<Holding::kType, std::invoke_result_t<Getter, const Row&>>();

/// One column of an exported file: its description, and how its cells are computed from a row.
/// Files, codebooks and dictionaries are all made from these columns. There are no defaults: a
/// column without a type or description does not compile.
template <typename Row>
class Column {
 public:
  /// @param name  snake_case, with its unit
  /// @param getter  a member of the row, or a function of the row
  template <typename Holding, GetterOf<Holding, Row> Getter>
  Column(std::string name, Holding holding, std::string description, Getter getter)
      : head_(std::move(name), Holding::kType, {}, std::move(description)),
        cell_([getter = std::move(getter)](const Row& row) {
          return holds::asCell(std::invoke(getter, row));
        }) {
    if constexpr (std::same_as<Holding, holds::Number>) head_.unit = holding.unit;
    if constexpr (std::same_as<Holding, holds::OneOf>) list_ = holding.list;
    if constexpr (std::same_as<Holding, holds::OneOfOwnList>)
      head_.levels = std::move(holding.levels);
    head_.isFreeText = std::same_as<Holding, holds::FreeText>;
  }

  /// The column reveals the condition; blinded folders leave it out.
  Column revealsCondition() && {
    revealsCondition_ = true;
    return std::move(*this);
  }

  /// The column is so exact that it may identify a person; folders without exact values leave it
  /// out.
  Column exact() && {
    isExact_ = true;
    return std::move(*this);
  }

  /// The column has free text, which may name people; folders leave it out unless texts were
  /// requested.
  Column onRequest() && {
    isOnRequest_ = true;
    return std::move(*this);
  }

  /// The column identifies session and participant. Files whose names identify them already leave
  /// it out.
  Column identifiesParticipant() && {
    identifiesParticipant_ = true;
    return std::move(*this);
  }

  /// Public folders include the column. They leave out all columns without inPublic().
  /// @param description  in public folders; empty: the usual description. If it is given, the
  ///     column is not marked as free text.
  Column inPublic(const std::string& description = {}) && {
    public_ = InPublic{.requiredIdentifier = {}, .description = description};
    return std::move(*this);
  }

  /// As inPublic(), but only if the public folder releases the quasi-identifier @p identifier (a
  /// property of people, such as their age).
  Column inPublicIfReleased(const std::string& identifier, const std::string& description = {}) && {
    public_ = InPublic{.requiredIdentifier = identifier, .description = description};
    return std::move(*this);
  }

  /// Whether the column is exported for @p readers.
  bool isFor(const Readers& readers) const {
    if (revealsCondition_ && readers.isBlinded) return false;
    if (isExact_ && !readers.seeExact) return false;
    if (isOnRequest_ && !readers.seeTexts) return false;
    if (identifiesParticipant_ && !readers.needParticipantColumn) return false;
    if (list_ == ValueList::Sites && !readers.hasSites()) return false;
    if (!readers.isPublic) return true;
    return public_ && (public_->requiredIdentifier.empty() ||
                       readers.releasedIdentifiers.count(public_->requiredIdentifier) == 1);
  }

  /// The heading of the column, with the description and levels for @p readers.
  ExportedColumn exportedColumnFor(const Readers& readers) const {
    auto head = head_;
    if (readers.isPublic && !public_->description.empty()) {
      head.description = public_->description;
      head.isFreeText = false;
    }
    head.description = readers.inDeviceWords(head.description);
    const auto known = list_ ? readers.lists.find(*list_) : readers.lists.end();
    if (known != readers.lists.end()) head.levels = known->second;
    return head;
  }

  const std::string& name() const noexcept { return head_.name; }
  const std::string& description() const noexcept { return head_.description; }

  Cell cell(const Row& row) const { return cell_(row); }

 private:
  /// How public folders include the column.
  struct InPublic {
    std::string requiredIdentifier;
    std::string description;
  };

  ExportedColumn head_;
  std::function<Cell(const Row&)> cell_;
  std::optional<ValueList> list_;
  bool revealsCondition_ = false;
  bool isExact_ = false;
  bool isOnRequest_ = false;
  bool identifiesParticipant_ = false;
  std::optional<InPublic> public_;
};

template <typename Row>
using Columns = std::vector<Column<Row>>;

/// One exported file: its description and columns.
template <typename Row>
struct Table {
  std::string name;  ///< of the file, without its extension
  std::string description;
  Columns<Row> columns;
  /// Whether the table reveals conditions; blinded folders then leave it out.
  bool revealsCondition = false;
  /// Whether the table has free texts only; folders then leave it out unless texts were requested.
  bool isFreeTextTable = false;
  /// Description in public folders; std::nullopt: public folders leave the table out.
  std::optional<std::string> inPublic = std::nullopt;

  /// Whether the table is exported for @p readers.
  bool isFor(const Readers& readers) const {
    return !(revealsCondition && readers.isBlinded) && !(isFreeTextTable && !readers.seeTexts) &&
           (inPublic || !readers.isPublic);
  }
};

/// The exported table of @p rows, with the columns for @p readers.
template <typename Row>
ExportedTable exportedTable(
    const Table<Row>& table, const std::vector<Row>& rows, const Readers& readers) {
  ExportedTable result{
      .name = table.name,
      .description =
          readers.isPublic ? table.inPublic.value() : readers.inDeviceWords(table.description),
      .columns = {},
      .rows = {}};
  std::vector<const Column<Row>*> columns;
  for (const auto& column : table.columns) {
    if (!column.isFor(readers)) continue;
    columns.push_back(&column);
    result.columns.push_back(column.exportedColumnFor(readers));
  }
  result.rows.reserve(rows.size());
  for (const auto& row : rows) {
    auto& cells = result.rows.emplace_back();
    cells.reserve(columns.size());
    for (const auto* column : columns) cells.push_back(column->cell(row));
  }
  return result;
}

}  // namespace study
