#pragma once

#include <optional>
#include <string_view>

#include <QApplication>
#include <QColor>
#include <QMenu>
#include <QString>
#include <QWidget>

namespace study::gui {

enum class ThemeName { Light, Dark, HighContrast };

/// A colour, and that of the words on it.
struct Fill {
  QColor background;
  QColor text;
};

/// Colours of the windows, by what they are for. Words on their background have a contrast of at
/// least 4.5 to 1, in the high-contrast theme 7 to 1 (WCAG 2.1). Nothing is told by colour alone:
/// every state bears a word or a sign as well.
struct Theme {
  Fill window;     ///< pages, and ordinary words
  Fill field;      ///< what can be written in; tables
  Fill header;     ///< of tables
  Fill disabled;   ///< what cannot be pressed now
  Fill accent;     ///< the next thing to do; what is chosen
  Fill selection;  ///< rows and words that are marked
  Fill stop;       ///< no force at once
  Fill good;       ///< running, sound, PASS
  Fill warn;       ///< WARN
  Fill bad;        ///< broken, FAIL
  Fill paleGood;   ///< the same behind a row of a table
  Fill paleWarn;   ///< … also the row that is now
  Fill paleBad;
  QColor quiet;   ///< words that matter less, on window and field
  QColor link;    ///< on window and field
  QColor border;  ///< round what can be pressed
  QColor line;    ///< between things
  QColor focus;   ///< round what the keyboard is at
  QColor force;   ///< a curve of force, on field
  QColor travel;  ///< a curve of travel, on field
};

const Theme& themeNamed(ThemeName name) noexcept;

/// What the windows wear now.
const Theme& theme() noexcept;

/// What @p widget wears: its window may wear one of its own.
const Theme& themeOf(const QWidget& widget) noexcept;

/// Calm colours, large targets, a visible focus: the same on every desktop.
void applyTheme(QApplication& application, ThemeName name = ThemeName::Light);

/// Lets one window look the same whatever the others wear: what a participant sees belongs to the
/// study, and not to whoever sits at the desk.
void wearTheme(QWidget& window, ThemeName name);

/// The style sheet of a theme.
QString styleSheetOf(const Theme& theme);

/// How much one colour stands out from another, 1 to 21 (WCAG 2.1, "contrast ratio").
double contrast(const QColor& one, const QColor& other) noexcept;

/// The name by which a choice is stored: "light", "dark", "high-contrast".
QString nameOf(ThemeName name);
std::optional<ThemeName> themeCalled(const QString& name);

/// Puts on what was chosen last; until somebody chooses, light or dark as the desktop is. To be
/// called before any theme is worn, since afterwards the desktop's colours cannot be seen.
void applyChosenTheme(QApplication& application);

/// A menu to choose from: as the desktop, light, dark, high contrast. A choice is worn at once and
/// remembered.
void addThemesTo(QMenu& menu);

}  // namespace study::gui
