#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "questionnaires/model/answer.h"
#include "study/export/column.h"

namespace study {

/// How an answer about a person may be told to strangers: in grains, from fine to coarse.
///
/// A number is told as a band: the first grain has bands of 1, 2 or 5 times a power of ten, of at
/// least five steps and a twentieth of what may be answered; each grain after it has bands twice as
/// wide. Options whose ids begin with a digit are themselves bands ("25-34"): from grain to grain
/// neighbours become one. Other options, and sets of options, are told as they are or not at all.
class Coarsening {
 public:
  /// @param language  of the options' labels
  Coarsening(const questionnaires::Item& item, std::string_view language);

  std::size_t grains() const noexcept { return grains_.size(); }

  /// What may be told in a grain, in its order; empty where it is no closed list.
  const std::vector<Level>& values(std::size_t grain) const { return grains_.at(grain).values; }

  /// What is told of @p response; empty where it is none of the item's.
  std::string told(std::size_t grain, const questionnaires::Response& response) const;

 private:
  struct Grain {
    std::vector<Level> values;
    std::map<std::string, std::string> byOption;  ///< what is told of each option
    double width = 0.0;                           ///< of a number's bands, in its unit
  };

  void addBands(const questionnaires::Item& item);
  void addOptions(const questionnaires::Item& item, std::string_view language);
  std::string band(double from, double width) const;

  std::vector<Grain> grains_;
  bool isWhole_ = false;  ///< a number of whole steps: "20 to 24", else "20 to <25"
};

/// Whether answers to @p item say something about the person that acquaintances may know: a choice
/// or a number. Points of scales are opinions; words are never told.
bool isAboutThePerson(const questionnaires::Item& item) noexcept;

}  // namespace study
