#pragma once

#include <exception>
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
/// participant's windows use the language of their session instead.
const std::string& deskLanguage() noexcept;

/// Sets the language; English if @p language has no catalogue. Open windows keep their texts, apart
/// from the home page and, between sessions, the operator's window, which are created again. Call
/// it only while no task runs in the background.
void setDeskLanguage(std::string_view language);

/// Sets the language that was chosen last; if none was, that of the computer.
void applyChosenLanguage();

/// Adds the languages to a menu. A choice is applied at once and stored.
void addLanguagesTo(QMenu& menu);

/// Translates a text into the language of the desk; unchanged if the catalogue does not have it.
/// For code outside of widgets, which use tr() with the same catalogue.
std::string translated(std::string_view english);

/// Translates a text and replaces its {} by the arguments.
template <typename First, typename... Rest>
std::string translated(std::string_view english, First&& first, Rest&&... rest) {
  return fmt::format(
      fmt::runtime(translated(english)), std::forward<First>(first), std::forward<Rest>(rest)...);
}

/// Translates a text from outside study/gui, for a label.
QString deskText(std::string_view english);
/// Translates a message from outside study/gui.
QString deskText(const base::Message& message);
/// What an error says: translated if it is of a device or of the storage, else its own words.
QString deskText(const std::exception& error);

}  // namespace study::gui
