#include "analysis/data/csv_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/search.h"

namespace analysis {
namespace {

std::string listed(const std::vector<std::string>& problems) {
  constexpr std::size_t kMost = 10;
  std::string text;
  const std::size_t shown = std::min(problems.size(), kMost);
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : "\n") + problems[i];
  if (problems.size() > shown) {
    text += "\nand " + std::to_string(problems.size() - shown) + " more";
  }
  return text;
}

std::string linePhrase(std::size_t line) {
  return "line " + std::to_string(line) + ": ";
}

std::string countPhrase(std::size_t number, const std::string& what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

/// Reads a CSV text row by row.
class CsvScanner {
 public:
  CsvScanner(std::string_view text, char separator) : rest_(text), separator_(separator) {}

  bool isAtEnd() const { return rest_.empty(); }

  CsvRow row() {
    CsvRow row{.line = line_, .cells = {}};
    row.cells.push_back(cell());
    while (consumeIf(separator_)) row.cells.push_back(cell());
    endLine();
    return row;
  }

 private:
  std::string cell() { return consumeIf('"') ? readQuotedCell() : readPlainCell(); }

  std::string readPlainCell() {
    const std::string_view cell = rest_.substr(0, rest_.find_first_of(cellEnds_));
    rest_.remove_prefix(cell.size());
    return std::string(base::trimmed(cell));
  }

  std::string readQuotedCell() {
    const std::size_t opened = line_;
    std::string cell;
    for (;;) {
      const auto quote = rest_.find('"');
      if (quote == std::string_view::npos) {
        throw base::UserError(
            linePhrase(opened) + "a quotation mark is opened here and never closed");
      }
      cell += consume(quote);
      rest_.remove_prefix(1);
      if (!consumeIf('"')) break;
      cell += '"';
    }
    if (!rest_.empty() && cellEnds_.find(rest_.front()) == std::string::npos) {
      throw base::UserError(
          linePhrase(line_) +
          "there is text after a closing quotation mark; within quotation marks, write \"\" for "
          "\"");
    }
    return cell;
  }

  /// Consumes and returns the next @p length characters, and counts their line ends.
  std::string_view consume(std::size_t length) {
    const std::string_view text = rest_.substr(0, length);
    for (std::size_t i = 0; i < length; ++i) {
      const bool isPair = text[i] == '\r' && i + 1 < length && text[i + 1] == '\n';
      if (text[i] == '\n' || (text[i] == '\r' && !isPair)) ++line_;
    }
    rest_.remove_prefix(length);
    return text;
  }

  void endLine() {
    consumeIf('\r');
    consumeIf('\n');
    ++line_;
  }

  bool consumeIf(char character) {
    const bool isThere = rest_.starts_with(character);
    if (isThere) rest_.remove_prefix(1);
    return isThere;
  }

  std::string_view rest_;
  char separator_;
  std::string cellEnds_ = std::string("\r\n") + separator_;
  std::size_t line_ = 1;
};

bool isBlank(const CsvRow& row) {
  return std::ranges::all_of(row.cells, [](const std::string& cell) { return cell.empty(); });
}

/// The most frequent separator in the first line with text, outside quotation marks.
char separatorOf(std::string_view text) {
  constexpr std::string_view kSeparators = ",;\t";
  std::array<int, kSeparators.size()> counts{};
  bool isQuoted = false;
  text.remove_prefix(std::min(text.find_first_not_of("\r\n"), text.size()));
  for (const char character : text) {
    if (character == '"') isQuoted = !isQuoted;
    if (isQuoted) continue;
    if (character == '\r' || character == '\n') break;
    const auto separatorIndex = kSeparators.find(character);
    if (separatorIndex != std::string_view::npos) ++counts[separatorIndex];
  }
  return kSeparators[static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin())];
}

std::string_view utf8Of(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw base::UserError("the file is in UTF-16: save it as CSV in UTF-8");
  }
  return base::withoutByteOrderMark(text);
}

}  // namespace

base::UserError errorOf(const std::vector<std::string>& problems) {
  return base::UserError(listed(problems));
}

std::size_t CsvTable::columnIndex(std::string_view name) const {
  const auto count = std::ranges::count(columns, name);
  if (count > 1) throw base::UserError("there are two columns '" + std::string(name) + "'");
  if (count == 1) {
    return static_cast<std::size_t>(std::ranges::find(columns, name) - columns.begin());
  }
  const auto nearest = nearestName(name, columns);
  throw base::UserError(
      "there is no column '" + std::string(name) + "'; the columns are " + enumerated(columns) +
      (nearest ? "; did you mean '" + *nearest + "'?" : ""));
}

CsvTable readCsv(std::string_view text) {
  text = utf8Of(text);
  CsvTable table;
  table.separator = separatorOf(text);
  std::vector<std::string> problems;
  for (CsvScanner scanner(text, table.separator); !scanner.isAtEnd();) {
    CsvRow row = scanner.row();
    if (isBlank(row)) continue;
    if (table.columns.empty()) {
      table.columns = std::move(row.cells);
    } else if (row.cells.size() == table.columns.size()) {
      table.rows.push_back(std::move(row));
    } else {
      problems.push_back(
          "line " + std::to_string(row.line) + " has " + countPhrase(row.cells.size(), "cell") +
          ", and the header has " + countPhrase(table.columns.size(), "column"));
    }
  }
  if (table.columns.empty()) throw base::UserError("the file is empty");
  if (!problems.empty()) throw errorOf(problems);
  return table;
}

std::optional<std::string> nearestName(std::string_view meant, std::span<const std::string> names) {
  const auto word = base::lowerCase(meant);
  std::optional<std::string> nearest;
  auto fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const auto& name : names) {
    const auto edits = base::editDistance(word, base::lowerCase(name));
    if (edits >= fewest || edits >= std::max(word.size(), name.size())) continue;
    fewest = edits;
    nearest = name;
  }
  return nearest;
}

std::string enumerated(std::span<const std::string> names) {
  constexpr std::size_t kMost = 8;
  const std::size_t shown = std::min(names.size(), kMost);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool isLast = i + 1 == names.size();
    if (i > 0) text += isLast ? " and " : ", ";
    text += "'" + names[i] + "'";
  }
  if (names.size() > shown) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

}  // namespace analysis
