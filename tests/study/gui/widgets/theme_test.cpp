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
#include <QPushButton>
#include <QRegularExpression>

#include "study/gui/widgets/studio_settings.h"
#include "tests/study/gui/contrast.h"
#include "tests/support/colour_vision.h"

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

TEST_P(ThemeTest, DistinguishesStatesForEveryColourVision) {
  constexpr double kClearly = 20.0;
  const std::array states{theme_.good.background, theme_.warn.background, theme_.bad.background};
  for (const auto& eye : tests::kColourBlind) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      const auto& other = states[(i + 1) % states.size()];
      EXPECT_GT(tests::colourDifference(states[i], other, eye), kClearly) << said(states[i], other);
    }
    EXPECT_GT(tests::colourDifference(theme_.force, theme_.travel, eye), kClearly);
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

TEST(Theme, LeavesAButtonItsSizeWhenItHasTheFocus) {
  for (const char* role :
       {"", "main", "danger", "next", "back", "stop", "tool", "link", "point", "option"}) {
    for (const bool isChecked : {false, true}) {
      QWidget window;
      auto* button = new QPushButton(QStringLiteral("Close"), &window);
      auto* other = new QPushButton(QStringLiteral("Other"), &window);
      button->setProperty("role", QString::fromLatin1(role));
      button->setCheckable(isChecked);
      button->setChecked(isChecked);
      window.show();
      window.activateWindow();
      const auto sizeWithFocusOn = [&](QWidget* focused) {
        focused->setFocus();
        applyTheme(*qobject_cast<QApplication*>(QApplication::instance()));
        return button->sizeHint();
      };
      EXPECT_EQ(sizeWithFocusOn(button), sizeWithFocusOn(other)) << role << isChecked;
    }
  }
}

}  // namespace theme_test
}  // namespace study::gui
