#include "study/report/marked_text.h"

#include <gtest/gtest.h>

namespace study::report {
namespace marked_text_test {

std::string html(const char* markdown) {
  return asHtml(QString::fromUtf8(markdown)).remove(QLatin1Char('\n')).toStdString();
}

TEST(MarkedText, HasHeadingsParagraphsListsAndBold) {
  EXPECT_EQ(
      html("## Risks\n\nNone.\n\n- one\n- **two**\n\nThe *end*."),
      "<h3>Risks</h3><p>None.</p><ul><li>one</li><li><b>two</b></li></ul><p>The <i>end</i>.</p>");
  EXPECT_EQ(html("1. one\n2. two"), "<ol><li>one</li><li>two</li></ol>");
}

TEST(MarkedText, KeepsTheLineBreaksOfPlainText) {
  EXPECT_EQ(html("one\ntwo\n\nthree"), "<p>one<br/>two</p><p>three</p>");
}

TEST(MarkedText, EndsAParagraphWhereAListOrAHeadingBegins) {
  EXPECT_EQ(html("Bring:\n- a pen\n- time"), "<p>Bring:</p><ul><li>a pen</li><li>time</li></ul>");
  EXPECT_EQ(html("# Title\nText"), "<h2>Title</h2><p>Text</p>");
}

TEST(MarkedText, LoadsNothing) {
  EXPECT_EQ(html("see [the page](http://example.org)"), "<p>see the page</p>");
  const auto picture = html("before ![x](file:///etc/passwd) after");
  EXPECT_EQ(picture.find("<img"), std::string::npos) << picture;
  EXPECT_EQ(picture.find("passwd"), std::string::npos) << picture;
  const auto tag = html("a <img src='file:///etc/passwd'> b");
  EXPECT_EQ(tag.find("<img"), std::string::npos) << tag;
}

TEST(MarkedText, ShowsWhatIsNoMarkup) {
  EXPECT_EQ(html("5 < 6 & [[institution]]"), "<p>5 &lt; 6 &amp; [[institution]]</p>");
  EXPECT_EQ(html("2 \\* 3"), "<p>2 * 3</p>");
  EXPECT_EQ(html(""), "");
}

}  // namespace marked_text_test
}  // namespace study::report
