#pragma once

#include <string>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// A text of an instrument that participants see, with a name that no other has.
struct TextPlace {
  std::string name;                   ///< "title", "scale/low_label", "items/1/text"
  std::vector<LocalizedText*> texts;  ///< the text and its copies: a common scale has many
};

/// The texts of @p instrument that participants see, in the order in which they do: those that are
/// there, and those that are withheld. Pointers are good as long as the instrument stays.
std::vector<TextPlace> textPlacesOf(Instrument& instrument);

}  // namespace questionnaires
