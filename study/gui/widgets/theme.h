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

/// A background colour and the colour of text on it.
struct Fill {
  QColor background;
  QColor text;
};

/// The colours of the windows, by purpose. Text has a contrast of at least 4.5 to 1 with its
/// background, and 7 to 1 in the high-contrast theme (WCAG 2.1). No state is shown by colour alone:
/// each has a text or a symbol as well.
struct Theme {
  Fill window;     ///< pages and normal text
  Fill field;      ///< text fields and tables
  Fill header;     ///< of tables
  Fill disabled;   ///< disabled controls
  Fill accent;     ///< default buttons and selected options
  Fill selection;  ///< selected rows and text
  Fill stop;       ///< the stop button
  Fill good;       ///< running, valid, PASS
  Fill warn;       ///< WARN
  Fill bad;        ///< failed, FAIL
  Fill paleGood;   ///< good, as a row's background
  Fill paleWarn;   ///< warn, as a row's background; also for the current step
  Fill paleBad;
  QColor quiet;   ///< secondary text, on window and field
  QColor link;    ///< links, on window and field
  QColor border;  ///< around controls
  QColor line;    ///< separators
  QColor focus;   ///< frame around the focused control
  QColor force;   ///< force curve, on field
  QColor travel;  ///< travel curve, on field
  QColor torque;  ///< torque curve, on field
};

const Theme& themeNamed(ThemeName name) noexcept;

/// The theme of the application.
const Theme& theme() noexcept;

/// The theme of @p widget, whose window may have its own.
const Theme& themeOf(const QWidget& widget) noexcept;

/// Applies a theme to the whole application, the same on every desktop: calm colours, large
/// controls, a visible focus.
void applyTheme(QApplication& application, ThemeName name = ThemeName::Light);

/// Gives one window its own theme. The participant's window must look the same in every session,
/// whatever theme the operator chose.
/// @param scale  of text and controls; 1: as in all other windows.
void setWindowTheme(QWidget& window, ThemeName name, double scale = 1.0);

/// A length at the scale of the window that @p widget is in.
/// @param length  at scale 1 [px].
int scaled(const QWidget& widget, int length) noexcept;

/// The style sheet of a theme.
QString styleSheetOf(const Theme& theme, double scale = 1.0);

/// The name under which a theme is stored: "light", "dark", "high-contrast".
QString nameOf(ThemeName name);
std::optional<ThemeName> themeNameIn(const QString& name);

/// Applies the theme that was chosen last; if none was, light or dark as on the desktop. Call it
/// before any other theme is applied, because afterwards the desktop's colours cannot be read.
void applyChosenTheme(QApplication& application);

/// Adds the theme choices to a menu: as the desktop, light, dark, high contrast. A choice is
/// applied at once and stored.
void addThemesTo(QMenu& menu);

}  // namespace study::gui
