#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "questionnaires/model/answer.h"
#include "study/export/column.h"

namespace study {

/// How public exports release the answers to an item about the person. Every type of item has one
/// of these forms.
enum class PublicForm {
  None,     ///< not released as a fact about the person
  Bands,    ///< a number, released as a band because the exact number may identify
  Options,  ///< one option
  Sets,     ///< several options, released unchanged or not at all
};
/// The form of an item. Points of scales and sliders are opinions, and free text is never released:
/// both are None.
PublicForm publicFormOf(const questionnaires::Item& item) noexcept;

/// Whether answers to @p item are facts about the person that an acquaintance may know as well.
inline bool isQuasiIdentifier(const questionnaires::Item& item) noexcept {
  return publicFormOf(item) != PublicForm::None;
}

/// Generalisation of answers about a person for public exports, in levels from fine to coarse.
///
/// A number becomes a band. On the first level bands are 1, 2 or 5 times a power of ten wide, and
/// at least five steps and a twentieth of the item's range; each further level doubles the width.
/// Options whose ids begin with a digit are bands already ("25-34"): each further level joins two
/// neighbours. Other options, and sets of options, are released unchanged or not at all.
class GeneralisationHierarchy {
 public:
  /// @param item  about the person, see isQuasiIdentifier().
  /// @param language  of the labels of options
  GeneralisationHierarchy(const questionnaires::Item& item, std::string_view language);

  std::size_t levelCount() const noexcept { return levels_.size(); }

  /// The width of the bands of the first level, in the item's unit; std::nullopt for an item
  /// without bands.
  std::optional<double> bandWidth() const;
  /// Whether band labels have the form "20 to 24" (whole numbers) instead of "20 to <25".
  bool isWhole() const noexcept { return isWhole_; }

  /// The released values of a level, in order; empty for sets of options, which have no list.
  const std::vector<Level>& values(std::size_t level) const { return levels_.at(level).values; }

  /// The released value of @p response; empty if the response is not valid for the item.
  std::string releasedValue(std::size_t level, const questionnaires::Response& response) const;

 private:
  /// The released values of one level.
  struct GeneralisationLevel {
    std::vector<Level> values;
    std::map<std::string, std::string> byOption;  ///< released value of each option
    double width = 0.0;                           ///< width of the bands, in the item's unit
  };

  void addBands(const questionnaires::Item& item);
  void addOptions(const questionnaires::Item& item, std::string_view language);
  /// The label of the band that begins at @p from.
  std::string bandLabel(double from, double width) const;

  std::vector<GeneralisationLevel> levels_;
  bool isWhole_ = false;  ///< see isWhole()
};

}  // namespace study
