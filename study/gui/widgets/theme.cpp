#include "study/gui/widgets/theme.h"

#include <array>
#include <cmath>
#include <utility>

#include <QActionGroup>
#include <QFont>
#include <QPalette>
#include <QRegularExpression>
#include <QStyleFactory>

#include "study/gui/widgets/studio_settings.h"
#include "study/gui/widgets/theme_colours.h"

namespace study::gui {

namespace {

constexpr const char* kThemeProperty = "wears";
constexpr const char* kScaleProperty = "scale";
constexpr int kBodyFontSize = 17;  // [px] at scale 1: all running text of participants

/// Button layout 3 puts the action at the right end and the cancel button to its left, as in the
/// other dialogs.
/// @name stands for a background colour and @name.text for the colour of text on it. Normal text
/// has the palette's colours: if a rule sets one, Qt halves the contrast of placeholder text.
constexpr const char* kStyleSheet = R"css(
QWidget { background: @window; font-size: 16px; }
QLabel[role="title"] { font-size: 30px; font-weight: 600; }
QLabel[role="heading"] { font-size: 20px; font-weight: 600; }
QLabel[role="section"] { font-weight: 600; }
QLabel[role="huge"] { font-size: 54px; font-weight: 600; }
QLabel[role="text"] { font-size: 17px; }
QLabel[role="statement"] { font-size: 20px; }
QLabel[role="quiet"] { color: @quiet; }
QLabel[role="anchor"] { font-size: 16px; }
QLabel[role="key"] { font-size: 20px; font-weight: 600; }
QLabel[role="code"] { font-size: 36px; font-weight: 600; }
QLabel[role="count"] { font-size: 28px; font-weight: 600; }
QWidget[role="column"] { max-width: 640px; }
QWidget[role="lines"] { max-width: 660px; }
QWidget[role="page"] { max-width: 1380px; }
QWidget[role="scene"] { background: @header; }
QFrame[role="fold"] { background: @line; border: none; min-height: 1px; max-height: 1px; }
QLabel[role="good"] { color: @paleGood.text; background: @paleGood; border-left: 5px solid @good; padding: 8px 12px; font-weight: 600; }
QLabel[role="resting"] { color: @header.text; background: @header; border-left: 5px solid @border; padding: 8px 12px; font-weight: 600; }
QLabel[role="warn"] { color: @paleWarn.text; background: @paleWarn; border-left: 5px solid @warn; padding: 8px 12px; font-weight: 600; }
QLabel[role="bad"] { color: @paleBad.text; background: @paleBad; border-left: 5px solid @bad; padding: 8px 12px; font-weight: 600; }
QLabel[role="mark-good"], QLabel[role="mark-warn"], QLabel[role="mark-bad"] {
  border-radius: 9px; min-width: 18px; max-width: 18px; min-height: 18px; max-height: 18px; font-size: 12px; font-weight: 700; }
QLabel[role="mark-good"], QFrame[role="card"] QLabel[role="mark-good"] { color: @good.text; background: @good; }
QLabel[role="mark-warn"], QFrame[role="card"] QLabel[role="mark-warn"] { color: @warn.text; background: @warn; }
QLabel[role="mark-bad"], QFrame[role="card"] QLabel[role="mark-bad"] { color: @bad.text; background: @bad; }
QLabel[role="finding"] { font-size: 18px; font-weight: 600; }
QPushButton { color: @field.text; background: @field; border: 2px solid @border; border-radius: 8px;
              padding: 6px 16px; min-height: 24px; }
QPushButton, QCheckBox { outline: none; }
QPushButton:hover { border-color: @accent; }
QPushButton:focus { border: 3px solid @focus; padding: 5px 15px; }
QPushButton:disabled { color: @disabled.text; background: @disabled; border-color: @line; }
QPushButton:checked { color: @accent.text; background: @accent; border-color: @accent; }
QPushButton:checked:focus { border: 6px double @accent.text; padding: 2px 12px; }
QPushButton[role="next"] { color: @accent.text; background: @accent; border-color: @accent; font-size: 20px;
                           font-weight: 600; min-height: 46px; min-width: 180px; }
QPushButton[role="next"]:disabled { color: @disabled.text; background: @disabled; border-color: @line; }
QPushButton[role="next"]:focus { border: 6px double @accent.text; padding: 2px 12px; }
QPushButton[role="main"] { color: @accent.text; background: @accent; border-color: @accent; font-weight: 600; }
QPushButton[role="main"]:disabled { color: @disabled.text; background: @disabled; border-color: @line; }
QPushButton[role="main"]:focus { border: 6px double @accent.text; border-radius: 0; padding: 2px 12px; }
QPushButton[role="danger"] { color: @bad.text; background: @bad; border-color: @bad; font-weight: 600; }
QPushButton[role="danger"]:disabled { color: @disabled.text; background: @disabled; border-color: @line; }
QPushButton[role="danger"]:focus { border: 6px double @bad.text; border-radius: 0; padding: 2px 12px; }
QPushButton[role="back"] { font-size: 20px; min-height: 46px; }
QPushButton[role="point"], QPushButton[role="option"] { border-width: 1px; }
QPushButton[role="point"] { font-size: 20px; min-width: 40px; min-height: 46px; padding: 5px; }
QPushButton[role="point"]:focus { border-width: 3px; padding: 3px; }
QPushButton[role="point"]:checked:focus { border-width: 6px; padding: 0px; }
QPushButton[role="option"] { text-align: left; min-height: 40px; font-size: 18px; padding: 7px 15px 7px 43px; }
QPushButton[role="option"][isLarge="true"] { min-height: 64px; font-size: 20px; }
QPushButton[role="option"]:focus { border-width: 3px; padding: 5px 13px 5px 41px; }
QPushButton[role="option"]:checked:focus { border-width: 6px; padding: 2px 10px 2px 38px; }
QPushButton[role="option"][isMirrored="true"] { text-align: right; padding: 7px 43px 7px 15px; }
QPushButton[role="option"][isMirrored="true"]:focus { padding: 5px 41px 5px 13px; }
QPushButton[role="option"][isMirrored="true"]:checked:focus { padding: 2px 38px 2px 10px; }
QCheckBox[role="option"] { color: @field.text; background: @field; border: 2px solid @border; border-radius: 8px;
                           min-height: 40px; font-size: 18px; padding: 6px 14px; spacing: 12px; }
QCheckBox[role="option"]:checked { border-color: @accent; }
QCheckBox[role="option"]:focus { border: 3px solid @focus; border-radius: 8px; padding: 5px 13px; }
QCheckBox[role="option"]::indicator { width: 20px; height: 20px; }
QLineEdit[role="answer"], QPlainTextEdit[role="answer"] { font-size: 18px; }
QLineEdit[role="answer"] { min-height: 36px; }
QLineEdit[role="number"] { font-size: 18px; min-width: 120px; max-width: 120px; }
QPlainTextEdit[role="answer"] { min-height: 110px; }
QSlider[role="answer"] { min-height: 56px; }
QPushButton[role="tool"] { min-height: 21px; padding: 5px 10px; }
QPushButton[role="tool"]:focus { padding: 4px 9px; }
QPushButton[role="tool"]:checked:focus { padding: 1px 6px; }
QPushButton[role="stop"] { color: @stop.text; background: @stop; border-color: @stop; font-size: 24px;
                           font-weight: 700; min-height: 64px; }
QPushButton[role="stop"]:focus { border: 6px double @stop.text; padding: 2px 12px; }
QPushButton[role="stop"]:disabled { color: @disabled.text; background: @disabled; border-color: @line; }
QLineEdit, QPlainTextEdit, QComboBox {
  background: @field; border: 2px solid @border; border-radius: 6px; padding: 6px; }
QLineEdit:focus, QPlainTextEdit:focus, QComboBox:focus { border: 3px solid @focus; padding: 5px; }
QLineEdit:disabled, QComboBox:disabled { color: @disabled.text; background: @disabled; }
QSpinBox, QDoubleSpinBox {
  color: @field.text; background: @field; border: 2px solid @border; border-radius: 6px; padding: 6px 30px 6px 6px; }
QSpinBox:focus, QDoubleSpinBox:focus { border: 3px solid @focus; padding: 5px 29px 5px 5px; }
QSpinBox:disabled, QDoubleSpinBox:disabled { color: @disabled.text; background: @disabled; }
QSpinBox::up-button, QDoubleSpinBox::up-button {
  subcontrol-origin: border; subcontrol-position: top right; width: 28px; border: none; margin: 3px 2px 0 0; }
QSpinBox::down-button, QDoubleSpinBox::down-button {
  subcontrol-origin: border; subcontrol-position: bottom right; width: 28px; border: none; margin: 0 2px 3px 0; }
QSpinBox::up-arrow, QDoubleSpinBox::up-arrow { image: url(@up); width: 12px; height: 12px; }
QSpinBox::down-arrow, QDoubleSpinBox::down-arrow { image: url(@arrow); width: 12px; height: 12px; }
QCheckBox::indicator { width: 18px; height: 18px; background: @field; border: 2px solid @border; border-radius: 4px; }
QCheckBox::indicator:checked { background: @accent; border-color: @accent; image: url(@check); }
QCheckBox::indicator:disabled { background: @disabled; border-color: @line; }
QComboBox[role="language"] { padding: 2px 6px; }
QComboBox[role="language"]:focus { padding: 1px 5px; }
QComboBox::drop-down { border: none; width: 28px; }
QComboBox::down-arrow { image: url(@arrow); width: 12px; height: 12px; }
QComboBox { combobox-popup: 0; }
QComboBox QAbstractItemView { color: @field.text; background: @field; border: 1px solid @border;
                              selection-color: @selection.text; selection-background-color: @selection; }
QComboBox QAbstractItemView::item { min-height: 28px; }
QComboBox QAbstractItemView::item:selected { color: @selection.text; background: @selection; }
QCheckBox:focus { border: 2px solid @focus; border-radius: 4px; }
QCheckBox:disabled { color: @disabled.text; background: @disabled; }
QProgressBar { border: none; background: @line; border-radius: 4px; max-height: 8px; }
QProgressBar::chunk { background: @accent; border-radius: 4px; }
QFrame[role="card"] { color: @field.text; background: @field; border: 1px solid @line; border-radius: 10px; }
QFrame[role="card"][isOpen="true"] { border: 2px solid @focus; }
QFrame[role="card"] QLabel { background: transparent; }
QWidget[role="plain"] { background: transparent; }
QFrame[role="card"] QScrollArea, QFrame[role="card"] QWidget[role="plain"],
QFrame[role="card"] QWidget#qt_scrollarea_viewport { background: transparent; }
QFrame[role="card"] QLabel[role="good"] { color: @paleGood.text; background: @paleGood; }
QFrame[role="card"] QLabel[role="warn"] { color: @paleWarn.text; background: @paleWarn; }
QFrame[role="card"] QLabel[role="bad"] { color: @paleBad.text; background: @paleBad; }
QFrame[role="clause"] { background: @field; border: none; border-left: 4px solid @accent; }
QFrame[role="clause"] QLabel { background: transparent; }
QLabel[role="done"] { color: @good.text; background: @good; border-radius: 35px; font-size: 40px; font-weight: 600;
                      min-width: 72px; max-width: 72px; min-height: 72px; max-height: 72px; }
QPushButton[role="link"] { color: @link; background: transparent; border: 2px solid transparent; border-radius: 6px;
                           min-height: 22px; padding: 3px 6px 3px 1px; text-align: left; }
QPushButton[role="link"]:hover { text-decoration: underline; }
QPushButton[role="link"]:focus { border: 3px solid @focus; padding: 2px 5px 2px 0; }
QPushButton[role="link"]:disabled { color: @disabled.text; background: transparent; border-color: transparent; }
QTableView[role="cards"], QTableView[role="cards"]:focus {
  background: transparent; border: none; selection-background-color: transparent; }
QTableView[role="cards"]::item:selected { background: transparent; }
QFrame[role="screen"], QScrollArea[role="screen"] { border: 1px solid @border; border-radius: 8px; }
QFrame[role="rule"] { background: @line; border: none; min-height: 1px; max-height: 1px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; button-layout: 3; }
QScrollArea { border: none; }
QScrollBar:vertical { background: @header; width: 14px; margin: 0; border: none; border-radius: 7px; }
QScrollBar::handle:vertical { background: @border; min-height: 40px; border-radius: 7px; }
QScrollBar:horizontal { background: @header; height: 14px; margin: 0; border: none; border-radius: 7px; }
QScrollBar::handle:horizontal { background: @border; min-width: 40px; border-radius: 7px; }
QScrollBar:disabled, QScrollBar::handle:disabled { background: transparent; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QTableView, QTreeView, QListView, QTextBrowser {
  color: @field.text; background: @field; border: 1px solid @line; gridline-color: @line;
  selection-color: @selection.text; selection-background-color: @selection; }
QTableView:focus, QTreeView:focus, QListView:focus, QTextBrowser:focus { border: 2px solid @focus; }
QTableView::item:selected, QTreeView::item:selected, QListView::item:selected {
  color: @selection.text; background: @selection; }
QListView::item { border: none; padding: 5px 6px; }
QTableView::item { border: none; padding: 4px 5px; }
QHeaderView::section { color: @header.text; background: @header; border: none; padding: 4px 8px; font-weight: 600; }
QTableCornerButton::section { background: @header; border: none; }
QTabBar::tab { color: @window.text; background: @window; border: 1px solid @line; padding: 8px 16px; }
QTabBar::tab:selected { background: @field; border-bottom: 4px solid @accent; padding: 8px 16px 5px 16px; }
QTabBar::tab:focus { border: 2px solid @focus; padding: 7px 15px; }
QTabWidget::pane { border: 1px solid @line; }
QMenuBar { color: @window.text; background: @window; }
QMenuBar::item { padding: 6px 12px; background: transparent; }
QMenuBar::item:selected { color: @selection.text; background: @selection; }
QMenu { color: @field.text; background: @field; border: 1px solid @border; padding: 4px; }
QMenu::item { padding: 6px 28px; }
QMenu::item:selected { color: @selection.text; background: @selection; }
QMenu::item:disabled { color: @disabled.text; }
QMenu::separator { height: 1px; background: @line; margin: 4px 8px; }
QToolTip { color: @field.text; background: @field; border: 1px solid @border; padding: 4px; }
QSplitter::handle { background: @line; }
)css";

ThemeName& applicationTheme() noexcept {
  static ThemeName worn = ThemeName::Light;
  return worn;
}

/// The palette for what Qt paints without a style sheet: menus of combo boxes, links, placeholder
/// text.
QPalette paletteOf(const Theme& theme) {
  QPalette palette;
  palette.setColor(QPalette::Window, theme.window.background);
  palette.setColor(QPalette::WindowText, theme.window.text);
  palette.setColor(QPalette::Base, theme.field.background);
  palette.setColor(QPalette::AlternateBase, theme.header.background);
  palette.setColor(QPalette::Text, theme.field.text);
  palette.setColor(QPalette::Button, theme.field.background);
  palette.setColor(QPalette::ButtonText, theme.field.text);
  palette.setColor(QPalette::ToolTipBase, theme.field.background);
  palette.setColor(QPalette::ToolTipText, theme.field.text);
  palette.setColor(QPalette::PlaceholderText, theme.quiet);
  palette.setColor(QPalette::Highlight, theme.selection.background);
  palette.setColor(QPalette::HighlightedText, theme.selection.text);
  palette.setColor(QPalette::Link, theme.link);
  palette.setColor(QPalette::LinkVisited, theme.link);
  return palette;
}

/// The style sheet @p sheet with all lengths multiplied by @p scale and rounded.
QString withLengths(const QString& sheet, double scale) {
  static const QRegularExpression kLength(QStringLiteral("(\\d+)px"));
  QString result;
  qsizetype done = 0;
  for (auto found = kLength.globalMatch(sheet); found.hasNext();) {
    const auto length = found.next();
    const auto pixels = std::lround(scale * length.captured(1).toInt());
    result += sheet.mid(done, length.capturedStart() - done);
    result += QString::number(pixels) + QStringLiteral("px");
    done = length.capturedEnd();
  }
  return result + sheet.mid(done);
}

}  // namespace

/// A property of @p widget or of its nearest ancestor that has it: the window may be embedded in
/// another one.
static QVariant ownProperty(const QWidget& widget, const char* name) {
  for (const auto* up = &widget; up != nullptr; up = up->parentWidget()) {
    const auto value = up->property(name);
    if (value.isValid()) return value;
  }
  return {};
}

const Theme& themeNamed(ThemeName name) noexcept {
  static const std::array<Theme, 3> kThemes{lightTheme(), darkTheme(), highContrastTheme()};
  return kThemes[static_cast<std::size_t>(name)];
}

const Theme& theme() noexcept {
  return themeNamed(applicationTheme());
}

const Theme& themeOf(const QWidget& widget) noexcept {
  const auto own = themeNameIn(ownProperty(widget, kThemeProperty).toString());
  return own ? themeNamed(*own) : theme();
}

void applyTheme(QApplication& application, ThemeName name) {
  applicationTheme() = name;
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(16);
  QApplication::setFont(font);
  QApplication::setPalette(paletteOf(theme()));
  application.setStyleSheet(styleSheetOf(theme()));
}

void setWindowTheme(QWidget& window, ThemeName name, double scale) {
  window.setProperty(kThemeProperty, nameOf(name));
  window.setProperty(kScaleProperty, scale);
  window.setPalette(paletteOf(themeNamed(name)));
  // Without these rules the application's palette applies where the style sheet sets no colour.
  const auto& own = themeNamed(name);
  window.setStyleSheet(
      QStringLiteral(
          "QWidget { color: %1; }\nQLineEdit, QPlainTextEdit, QComboBox { color: %2; }\n")
          .arg(own.window.text.name(), own.field.text.name()) +
      styleSheetOf(own, scale) +
      QStringLiteral("QLabel[role=\"quiet\"] { font-size: %1px; }\n")
          .arg(scaled(window, kBodyFontSize)));
}

int scaled(const QWidget& widget, int length) noexcept {
  const auto scale = ownProperty(widget, kScaleProperty);
  return scale.isValid() ? static_cast<int>(std::lround(scale.toDouble() * length)) : length;
}

QString styleSheetOf(const Theme& theme, double scale) {
  const std::array<std::pair<const char*, Fill>, 13> fills{
      {{"window", theme.window},
       {"field", theme.field},
       {"header", theme.header},
       {"disabled", theme.disabled},
       {"accent", theme.accent},
       {"selection", theme.selection},
       {"stop", theme.stop},
       {"good", theme.good},
       {"warn", theme.warn},
       {"bad", theme.bad},
       {"paleGood", theme.paleGood},
       {"paleWarn", theme.paleWarn},
       {"paleBad", theme.paleBad}}};
  const std::array<std::pair<const char*, QColor>, 5> colours{
      {{"quiet", theme.quiet},
       {"link", theme.link},
       {"border", theme.border},
       {"line", theme.line},
       {"focus", theme.focus}}};
  QString sheet = QString::fromUtf8(kStyleSheet);
  for (const auto& [name, fill] : fills) {
    const QString token = QStringLiteral("@") + QString::fromUtf8(name);
    sheet.replace(token + QStringLiteral(".text"), fill.text.name());
    sheet.replace(token, fill.background.name());
  }
  for (const auto& [name, colour] : colours) {
    sheet.replace(QStringLiteral("@") + QString::fromUtf8(name), colour.name());
  }
  const std::array<std::pair<const char*, Fill>, 3> pictures{
      {{"arrow", theme.field}, {"up", theme.field}, {"check", theme.accent}}};
  for (const auto& [name, ground] : pictures) {
    const bool isDark = ground.background.lightness() < ground.text.lightness();
    sheet.replace(
        QStringLiteral("@%1").arg(QLatin1String(name)),
        QStringLiteral(":/gui/%1-%2.png")
            .arg(QLatin1String(name), isDark ? QLatin1String("chalk") : QLatin1String("ink")));
  }
  return scale == 1.0 ? sheet : withLengths(sheet, scale);
}

QString nameOf(ThemeName name) {
  constexpr std::array kNames{"light", "dark", "high-contrast"};
  return QString::fromUtf8(kNames[static_cast<std::size_t>(name)]);
}

std::optional<ThemeName> themeNameIn(const QString& name) {
  for (const auto each : {ThemeName::Light, ThemeName::Dark, ThemeName::HighContrast}) {
    if (nameOf(each) == name) return each;
  }
  return std::nullopt;
}

namespace {

constexpr const char* kThemeKey = "theme";

ThemeName& desktopTheme() noexcept {
  static ThemeName name = ThemeName::Light;
  return name;
}

void applyChosen(QApplication& application) {
  const auto chosen = themeNameIn(studioSettings().value(QLatin1String(kThemeKey)).toString());
  applyTheme(application, chosen.value_or(desktopTheme()));
}

void addChoice(QMenu& menu, QActionGroup* group, const QString& words, const QString& stored) {
  auto* action = menu.addAction(words);
  action->setObjectName(QStringLiteral("theme-") + stored);
  action->setCheckable(true);
  action->setChecked(studioSettings().value(QLatin1String(kThemeKey)).toString() == stored);
  group->addAction(action);
  QObject::connect(action, &QAction::triggered, action, [stored] {
    studioSettings().setValue(QLatin1String(kThemeKey), stored);
    applyChosen(*qobject_cast<QApplication*>(QApplication::instance()));
  });
}

}  // namespace

void applyChosenTheme(QApplication& application) {
  const auto palette = QApplication::palette();
  const bool isDark =
      palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  desktopTheme() = isDark ? ThemeName::Dark : ThemeName::Light;
  applyChosen(application);
}

void addThemesTo(QMenu& menu) {
  auto* group = new QActionGroup(&menu);
  addChoice(menu, group, QObject::tr("As the desktop"), {});
  addChoice(menu, group, QObject::tr("Light"), nameOf(ThemeName::Light));
  addChoice(menu, group, QObject::tr("Dark"), nameOf(ThemeName::Dark));
  addChoice(menu, group, QObject::tr("High contrast"), nameOf(ThemeName::HighContrast));
}

}  // namespace study::gui
