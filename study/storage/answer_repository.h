#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "study/model/given_answer.h"
#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// The table of answers. All SQL about answers is here.
class AnswerRepository {
 public:
  /// The database must outlive this object.
  explicit AnswerRepository(Database& database) : database_(database) {}

  /// Inserts or replaces an answer, inside the caller's transaction.
  void put(const VisitKey& visit, const GivenAnswer& answer, const std::string& utc);

  /// Deletes an answer, inside the caller's transaction.
  void remove(const VisitKey& visit, std::string_view item);

  std::optional<GivenAnswer> find(const VisitKey& visit, std::string_view item) const;

  /// All answers of one visit, in the order of the items on the page.
  std::vector<GivenAnswer> of(const VisitKey& visit) const;

 private:
  Database& database_;
};

/// A response as columns of the table: points and numbers in their own columns, an option or a text
/// unchanged, the ids of several options separated by spaces.
struct ResponseColumns {
  std::string kind;  ///< point, number, text, choices
  std::optional<std::int64_t> point;
  std::optional<double> number;
  std::optional<std::string> text;
};

/// The named values of an answer for the audit trail: {"item", "1.1"} and {"point", 4}, "number" or
/// "text"; a long text is replaced by "sha256".
base::NamedArguments valuesOf(const GivenAnswer& answer);

/// The columns of a response, and the response from its columns.
ResponseColumns stored(const questionnaires::Response& response);
questionnaires::Response restored(const ResponseColumns& response);

}  // namespace study::storage
