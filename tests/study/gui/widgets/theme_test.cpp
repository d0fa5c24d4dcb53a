#include "study/gui/widgets/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>

#include "study/gui/widgets/studio_settings.h"

namespace study::gui {
namespace theme_test {

constexpr double kForGraphics = 3.0;  // WCAG 1.4.11

class ThemeTest : public testing::TestWithParam<ThemeName> {
 protected:
  const Theme& theme_ = themeNamed(GetParam());
  double least_ = GetParam() == ThemeName::HighContrast ? 7.0 : 4.5;  // WCAG 1.4.6 and 1.4.3
};

std::vector<Fill> fillsOf(const Theme& t) {
  return {
      t.window,
      t.field,
      t.header,
      t.disabled,
      t.accent,
      t.selection,
      t.stop,
      t.good,
      t.warn,
      t.bad,
      t.paleGood,
      t.paleWarn,
      t.paleBad};
}

std::string said(const QColor& text, const QColor& background) {
  return (text.name() + " on " + background.name()).toStdString();
}

TEST_P(ThemeTest, HasReadableTextOnEveryBackground) {
  for (const auto& fill : fillsOf(theme_)) {
    EXPECT_GE(contrast(fill.text, fill.background), least_) << said(fill.text, fill.background);
  }
  for (const auto& ground : {theme_.window.background, theme_.field.background}) {
    for (const auto& words : {theme_.quiet, theme_.link, theme_.force, theme_.travel}) {
      EXPECT_GE(contrast(words, ground), least_) << said(words, ground);
    }
  }
}

/// The colour that a rule of the style sheet sets; invalid if it sets none.
QColor colourIn(const QString& rule, const QString& key) {
  const QRegularExpression pattern(
      QStringLiteral("(?:^|[{;\\s])%1:\\s*(#[0-9a-f]{6})").arg(QRegularExpression::escape(key)));
  const auto match = pattern.match(rule);
  return match.hasMatch() ? QColor(match.captured(1)) : QColor();
}

TEST_P(ThemeTest, HasReadableTextInEveryStyleRule) {
  static const QRegularExpression kRule(QStringLiteral("([^{}]+)\\{([^}]*)\\}"));
  auto rules = kRule.globalMatch(styleSheetOf(theme_));
  int judged = 0;
  while (rules.hasNext()) {
    const auto rule = rules.next();
    const QColor text = colourIn(rule.captured(2), QStringLiteral("color"));
    if (!text.isValid()) continue;
    const QColor own = colourIn(rule.captured(2), QStringLiteral("background"));
    const auto grounds = own.isValid()
                             ? std::vector{own}
                             : std::vector{theme_.window.background, theme_.field.background};
    for (const auto& ground : grounds) {
      EXPECT_GE(contrast(text, ground), least_)
          << rule.captured(1).trimmed().toStdString() << ": " << said(text, ground);
      ++judged;
    }
  }
  EXPECT_GT(judged, 25);
}

TEST_P(ThemeTest, HasReadablePlaceHolders) {
  auto& application = *qobject_cast<QApplication*>(QApplication::instance());
  applyTheme(application, GetParam());
  QLineEdit line;
  line.ensurePolished();
  const auto words = line.palette().color(QPalette::PlaceholderText);
  EXPECT_EQ(words.alpha(), 255);
  EXPECT_GE(contrast(words, theme_.field.background), least_) << words.name().toStdString();
  const auto written = line.palette().color(QPalette::Text);
  EXPECT_GE(contrast(written, theme_.field.background), least_) << written.name().toStdString();
  applyTheme(application);
}

/// The largest contrast of a pixel with the colour that most pixels have.
double contrastWithin(const QImage& picture) {
  std::map<QRgb, int> counts;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) ++counts[picture.pixel(x, y)];
  }
  const auto ground = std::max_element(
      counts.begin(), counts.end(), [](auto& a, auto& b) { return a.second < b.second; });
  double most = 1.0;
  for (const auto& [colour, count] : counts) {
    most = std::max(most, contrast(QColor(colour), QColor(ground->first)));
  }
  return most;
}

TEST_P(ThemeTest, HasReadableEntriesInDropDownListsAlsoUnderTheCursor) {
  auto& application = *qobject_cast<QApplication*>(QApplication::instance());
  applyTheme(application, GetParam());
  QComboBox box;
  box.addItems({QStringLiteral("live"), QStringLiteral("pilot"), QStringLiteral("simulated")});
  box.show();
  box.showPopup();
  auto* list = box.view();
  list->setCurrentIndex(list->model()->index(1, 0));
  QCoreApplication::processEvents();
  const QImage shown = list->viewport()->grab().toImage();
  for (int row = 0; row < box.count(); ++row) {
    const auto place = list->visualRect(list->model()->index(row, 0)).adjusted(4, 4, -4, -4);
    EXPECT_GE(contrastWithin(shown.copy(place)), least_) << "row " << row;
  }
  box.hidePopup();
  applyTheme(application);
}

TEST_P(ThemeTest, ReplacesEveryColourNameInItsStyleSheet) {
  EXPECT_FALSE(styleSheetOf(theme_).contains(QLatin1Char('@')));
}

TEST_P(ThemeTest, ShowsTheFocusAndTheBordersOfControls) {
  for (const auto& ground : {theme_.window.background, theme_.field.background}) {
    EXPECT_GE(contrast(theme_.focus, ground), kForGraphics) << said(theme_.focus, ground);
    EXPECT_GE(contrast(theme_.border, ground), kForGraphics) << said(theme_.border, ground);
  }
}

using Matrix = std::array<std::array<double, 3>, 3>;

/// A colour as seen with one kind of cone missing (Machado, Oliveira and Fernandes 2009, severity
/// 1, in linear light).
constexpr Matrix kProtan{
    {{0.152286, 1.052583, -0.204868},
     {0.114503, 0.786281, 0.099216},
     {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan{
    {{0.367322, 0.860646, -0.227968},
     {0.280085, 0.672501, 0.047413},
     {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritan{
    {{1.255528, -0.076749, -0.178779},
     {-0.078411, 0.930809, 0.147602},
     {0.004733, 0.691367, 0.303900}}};

using Triple = std::array<double, 3>;

Triple inLab(const Triple& rgb) {
  const Triple xyz{
      (0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505,
      0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2],
      (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089};
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  return {
      116.0 * f(xyz[1]) - 16.0, 500.0 * (f(xyz[0]) - f(xyz[1])), 200.0 * (f(xyz[1]) - f(xyz[2]))};
}

Triple seen(const QColor& colour, const Matrix& eye) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const Triple rgb{linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())};
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i] += eye[i][j] * rgb[j];
    result[i] = std::clamp(result[i], 0.0, 1.0);
  }
  return inLab(result);
}

/// The colour difference ΔE (CIE 1976). Below about 2.3 it is invisible.
double difference(const QColor& one, const QColor& other, const Matrix& eye) {
  const auto a = seen(one, eye);
  const auto b = seen(other, eye);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST_P(ThemeTest, DistinguishesStatesForEveryColourVision) {
  constexpr double kClearly = 20.0;
  const std::array states{theme_.good.background, theme_.warn.background, theme_.bad.background};
  for (const auto& eye : {kProtan, kDeutan, kTritan}) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      const auto& other = states[(i + 1) % states.size()];
      EXPECT_GT(difference(states[i], other, eye), kClearly) << said(states[i], other);
    }
    EXPECT_GT(difference(theme_.force, theme_.travel, eye), kClearly);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    ThemeTest,
    testing::Values(ThemeName::Light, ThemeName::Dark, ThemeName::HighContrast),
    [](const auto& each) {
      std::string name = nameOf(each.param).toStdString();
      std::erase(name, '-');
      return name;
    });

TEST(Contrast, MatchesWcag) {
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-9);
  EXPECT_NEAR(contrast(Qt::white, Qt::white), 1.0, 1e-9);
  EXPECT_NEAR(
      contrast(QColor("#777777"), Qt::white),
      4.48,
      0.01);  // a well-known colour that just misses 4.5
}

TEST(ThemeChoice, IsAppliedAtOnceAndStored) {
  auto& application = *qobject_cast<QApplication*>(QApplication::instance());
  QMenu menu;
  addThemesTo(menu);
  menu.findChild<QAction*>(QStringLiteral("theme-dark"))->trigger();
  EXPECT_EQ(theme().window.background, themeNamed(ThemeName::Dark).window.background);
  applyTheme(application);
  applyChosenTheme(application);
  EXPECT_EQ(theme().window.background, themeNamed(ThemeName::Dark).window.background);
  studioSettings().remove(QStringLiteral("theme"));
  applyTheme(application);
}

TEST(ThemeChoice, KeepsAWindowsOwnTheme) {
  auto& application = *qobject_cast<QApplication*>(QApplication::instance());
  QWidget window;
  QWidget inside(&window);
  setWindowTheme(window, ThemeName::Light);
  applyTheme(application, ThemeName::HighContrast);
  EXPECT_EQ(themeOf(inside).window.background, themeNamed(ThemeName::Light).window.background);
  inside.ensurePolished();
  EXPECT_EQ(inside.palette().color(QPalette::WindowText), themeNamed(ThemeName::Light).window.text);
  applyTheme(application);
}

}  // namespace theme_test
}  // namespace study::gui
