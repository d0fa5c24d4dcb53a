#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/text_reader.h"

namespace questionnaires {

/// The scale that @p node describes. Where only the points are labelled, the first and the last of
/// their labels are those of the ends.
Scale readScale(const Node& node, const TextReader& texts);

/// A scale that is none, in the place of one that could not be read.
Scale standInScale(const TextReader& texts);

/// What stands for a number that could not be read.
inline constexpr double kUnread = std::numeric_limits<double>::quiet_NaN();

/// Reads the items of an instrument.
///
/// Every type of item has keys of its own; a key of another type is refused and named as such. What
/// cannot be read is stood in for by something that problemsOf() has nothing to say about.
class ItemReader {
 public:
  /// @param scale  of the items that bring none of their own
  ItemReader(TextReader texts, std::optional<Scale> scale)
      : texts_(std::move(texts)), scale_(std::move(scale)) {}

  /// The item that @p node describes, the one with number @p index.
  Item read(const Node& node, std::size_t index) const;

 private:
  void readHead(const Node& node, Item& item) const;
  void readKind(const Node& node, Item& item) const;
  void readScaleOf(const Node& node, Item& item) const;
  void readEnds(const Node& node, Item& item) const;
  LocalizedText readText(const Node& node, std::string_view key, bool isWithheld) const;
  void readOptions(const Node& node, Item& item) const;
  Option readOption(const Node& node, std::size_t index) const;

  TextReader texts_;
  std::optional<Scale> scale_;
};

/// The id behind @p key, or, where there is none, one that nobody else has.
std::string idOrStandIn(const Node& node, std::string_view key, std::size_t index);

}  // namespace questionnaires
