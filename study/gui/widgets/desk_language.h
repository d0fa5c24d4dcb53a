#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <QMenu>
#include <QString>

#include "base/message.h"

namespace study::gui {

/// The language of the operator's windows: "en", or one that has a catalogue in study/words. The
/// participant's windows speak the language of their session, whatever this one is.
const std::string& deskLanguage() noexcept;

/// From now on in @p language; English if it has no catalogue. Windows that are open keep their
/// texts, apart from the home page, which is made again. Only while no task runs in the background.
void setDeskLanguage(std::string_view language);

/// The language that was chosen last; if none was, that of the computer.
void speakChosenLanguage();

/// Adds the languages to a menu. A choice is applied at once and stored.
void addLanguagesTo(QMenu& menu);

/// A text in the language of the desk; as it is where the catalogue has none. For texts that are
/// made outside of widgets, which have tr() for the same catalogue.
std::string said(std::string_view english);

/// The same with arguments for its {}.
template <typename First, typename... Rest>
std::string said(std::string_view english, First&& first, Rest&&... rest) {
  return fmt::format(
      fmt::runtime(said(english)), std::forward<First>(first), std::forward<Rest>(rest)...);
}

/// A text of another room, for a label.
QString spoken(std::string_view english);
/// A message of another room.
QString spoken(const base::Message& message);

}  // namespace study::gui
