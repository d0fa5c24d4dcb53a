#include "study/report/pdf_report.h"

#include <array>
#include <memory>
#include <optional>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPalette>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextList>
#include <QTextObjectInterface>
#include <QTextOption>

#include "study/report/figure_drawing.h"
#include "study/report/page_layout.h"
#include "study/report/print_html.h"
#include "study/session/study.h"
#include "study/words/words.h"

namespace study::report {
namespace {

/// Draws figures in a text document as vectors, not as pixels.
class FigureObjects : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)

 public:
  explicit FigureObjects(const std::vector<std::string>& figures) {
    for (const auto& svg : figures) drawings_.push_back(std::make_unique<FigureDrawing>(svg));
  }

  QSizeF intrinsicSize(QTextDocument* document, int /*at*/, const QTextFormat& format) override {
    const QSizeF size = drawing(format).size();
    const auto* paper = document->documentLayout()->paintDevice();
    const double dpi = paper != nullptr ? paper->logicalDpiX() : 96.0;
    const double width = document->pageSize().width();  // not positive before it is set
    const double scale = width > 0.0 ? std::min(dpi / 96.0, width / size.width()) : dpi / 96.0;
    const double shrunk =
        format.hasProperty(kFigureScale) ? format.doubleProperty(kFigureScale) : 1.0;
    return size * scale * shrunk;
  }

  void drawObject(
      QPainter* painter,
      const QRectF& where,
      QTextDocument* /*document*/,
      int /*at*/,
      const QTextFormat& format) override {
    drawing(format).draw(*painter, where);
  }

 private:
  FigureDrawing& drawing(const QTextFormat& format) const {
    return *drawings_.at(static_cast<std::size_t>(format.property(kFigureNumber).toInt()));
  }

  std::vector<std::unique_ptr<FigureDrawing>> drawings_;
};

/// Replaces every image that stands for a figure by the figure.
void placeFigures(QTextDocument& document) {
  static const QString kPrefix = QStringLiteral("figure:");
  for (auto block = document.begin(); block.isValid(); block = block.next()) {
    for (auto it = block.begin(); !it.atEnd(); ++it) {
      const auto format = it.fragment().charFormat();
      const QString name = format.toImageFormat().name();
      if (!format.isImageFormat() || !name.startsWith(kPrefix)) continue;
      QTextCharFormat figure;
      figure.setObjectType(kFigure);
      figure.setProperty(kFigureNumber, name.mid(kPrefix.size()).toInt());
      QTextCursor cursor(&document);
      cursor.setPosition(it.fragment().position());
      cursor.setPosition(it.fragment().position() + 1, QTextCursor::KeepAnchor);
      cursor.setCharFormat(figure);
      break;  // the block has changed; a paragraph holds at most one figure
    }
  }
}

/// The offset in @p block of its first line that is on a later page than its beginning;
/// std::nullopt if all lines are on one page.
std::optional<int> firstOnNextPage(const QTextDocument& document, const QTextBlock& block) {
  const double page = document.pageSize().height();
  const auto& lines = *block.layout();
  const double top = document.documentLayout()->blockBoundingRect(block).top();
  const auto pageOf = [&](int line) {
    return static_cast<int>((top + lines.lineAt(line).rect().center().y()) / page);
  };
  for (int line = 1; line < lines.lineCount(); ++line) {
    if (pageOf(line) != pageOf(0)) return lines.lineAt(line).textStart();
  }
  return std::nullopt;
}

/// Splits blocks at page breaks. Qt draws the lines of a block that crosses a page break on both
/// pages, hidden, but still found when the text is searched and copied (Qt 6.4).
void splitAtPages(QTextDocument& document) {
  for (auto block = document.begin(); block.isValid(); block = block.next()) {
    const auto at = firstOnNextPage(document, block);
    if (!at) continue;
    auto upper = block.blockFormat();
    auto lower = upper;
    upper.setBottomMargin(0.0);
    lower.setTopMargin(0.0);
    lower.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    const auto* list = block.textList();
    QTextCursor cursor(block);
    cursor.setBlockFormat(upper);
    cursor.setPosition(block.position() + *at);
    cursor.insertBlock(lower);
    if (list != nullptr) {  // the second half gets no bullet
      lower.setIndent(lower.indent() + list->format().indent());
      lower.setObjectIndex(-1);
      cursor.setBlockFormat(lower);
    }
    layOutAgain(document);
  }
}

/// The font of a report on paper.
struct TextFont {
  QFont font;
  double scale;  ///< for sizes chosen for DejaVu Sans, whose small letters are large
};

TextFont textFont() {
  return {
      withoutLigatures(QFont(typeface())), typeface() == QLatin1String("DejaVu Sans") ? 1.0 : 1.1};
}

/// Gives headings their sizes. Qt sets them relative to the text, not as the style sheet says,
/// and ignores a size beside that property (Qt 6.4).
void setHeadingSizes(QTextDocument& document, double scale) {
  constexpr std::array kSizes{14.5, 13.0, 11.5, 9.5};  // [pt]
  for (auto block = document.begin(); block.isValid(); block = block.next()) {
    const int level = block.blockFormat().headingLevel();
    if (level < 1 || level > static_cast<int>(kSizes.size())) continue;
    auto format = block.begin().fragment().charFormat();
    format.clearProperty(QTextFormat::FontSizeAdjustment);
    format.setFontPointSize(scale * kSizes[static_cast<std::size_t>(level) - 1]);
    QTextCursor cursor(block);
    cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    cursor.setCharFormat(format);
  }
}

/// The blocks with a background. Qt would paint it without a margin around the text.
std::vector<std::pair<QTextBlock, QBrush>> takeBackgrounds(QTextDocument& document) {
  std::vector<std::pair<QTextBlock, QBrush>> taken;
  for (auto block = document.begin(); block.isValid(); block = block.next()) {
    auto format = block.blockFormat();
    if (!format.hasProperty(QTextFormat::BackgroundBrush)) continue;
    taken.emplace_back(block, format.background());
    format.clearBackground();
    const double margin = 8.0 * document.documentLayout()->paintDevice()->logicalDpiX() / 96.0;
    format.setLeftMargin(margin);  // Qt does not scale these two (Qt 6.4)
    format.setRightMargin(margin);
    QTextCursor(block).setBlockFormat(format);
  }
  return taken;
}

/// Paints all pages with their footers.
/// @param printHtml  the text of the footer, beside which is the page's number
void paintPages(
    QTextDocument& document, QPdfWriter& writer, QFont font, const PrintHtml& printHtml) {
  const auto backgrounds = takeBackgrounds(document);
  layOutAgain(document);
  const auto rules = rulesOf(document);
  const auto words = words::wordsIn(printHtml.language);
  const QSizeF page = document.pageSize();
  QPainter painter(&writer);
  QAbstractTextDocumentLayout::PaintContext context;
  context.palette.setColor(QPalette::Text, Qt::black);
  font.setPointSizeF(8.0);
  painter.setFont(font);
  for (int number = 0; number < document.pageCount(); ++number) {
    if (number > 0) writer.newPage();
    const QRectF foot(0.0, page.height(), page.width(), writer.height() - page.height());
    painter.drawText(
        foot,
        Qt::AlignRight | Qt::AlignBottom,
        QString::fromStdString(words.say("{} of {}", number + 1, document.pageCount())));
    painter.drawText(
        foot.adjusted(0.0, 0.0, -0.12 * foot.width(), 0.0),
        Qt::AlignLeft | Qt::AlignBottom,
        painter.fontMetrics().elidedText(
            QString::fromStdString(printHtml.foot),
            Qt::ElideRight,
            static_cast<int>(0.88 * foot.width())));
    const QRectF pageArea(QPointF(0.0, number * page.height()), page);
    // lines that only touch the page belong to its neighbour
    context.clip = pageArea.adjusted(0.0, 1.0, 0.0, -1.0);
    painter.save();
    painter.translate(0.0, -pageArea.top());
    painter.setClipRect(pageArea);
    for (const auto& [block, brush] : backgrounds) {
      const double padding = 6.0 * writer.logicalDpiY() / 96.0;
      const auto text = document.documentLayout()->blockBoundingRect(block);
      painter.fillRect(
          QRectF(0.0, text.top() - padding, page.width(), text.height() + 2.0 * padding), brush);
    }
    document.documentLayout()->draw(&painter, context);
    for (const auto& [line, thickness] : rules) {
      painter.setPen(QPen(Qt::black, thickness, Qt::SolidLine, Qt::FlatCap));
      if (pageArea.contains(line.center())) painter.drawLine(line);
    }
    painter.restore();
  }
}

}  // namespace

std::string asPdf(std::string_view html, std::string_view title, Paper paper) {
  const auto [font, scale] = textFont();
  const auto page = toPrintHtml(html, scale);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(paper == Paper::Letter ? QPageSize::Letter : QPageSize::A4));
  writer.setPageMargins(QMarginsF(20, 18, 20, 14), QPageLayout::Millimeter);
  writer.setTitle(QString::fromUtf8(bytesOf(title)));
  writer.setCreator(QStringLiteral("palpate ") + QString::fromUtf8(bytesOf(appVersion())));
  QTextDocument document;
  FigureObjects figures(page.figures);
  document.documentLayout()->registerHandler(kFigure, &figures);
  document.documentLayout()->setPaintDevice(&writer);
  document.setDocumentMargin(0.0);
  document.setIndentWidth(20.0);
  document.setDefaultFont(font);
  QTextOption wrapping = document.defaultTextOption();
  wrapping.setWrapMode(QTextOption::WordWrap);  // otherwise words break inside narrow columns
  document.setDefaultTextOption(wrapping);
  document.setHtml(QString::fromStdString(page.html));
  placeFigures(document);
  setHeadingSizes(document, scale);
  constexpr double kFooter = 6.5 / 25.4;  // [in]
  document.setPageSize(QSizeF(writer.width(), writer.height() - kFooter * writer.logicalDpiY()));
  fitColumns(document);
  numberContents(document);  // makes room for the numbers
  choosePageBreaks(document, QString::fromStdString(words::wordsIn(page.language)("continued")));
  splitAtPages(document);
  numberContents(document);
  paintPages(document, writer, font, page);
  return buffer.data().toStdString();
}

std::string figureAsPdf(std::string_view svg, double scale) {
  FigureDrawing figure(svg);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  constexpr double kPointsPerPixel = 72.0 / 96.0;
  writer.setPageSize(QPageSize(
      figure.size() * scale * kPointsPerPixel, QPageSize::Point, QString(), QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  QPainter painter(&writer);
  figure.draw(painter, QRectF(0.0, 0.0, writer.width(), writer.height()));
  painter.end();
  return buffer.data().toStdString();
}

std::string figureAsPng(std::string_view svg, double scale) {
  FigureDrawing figure(svg);
  constexpr double kDotsPerPixel = 300.0 / 96.0;
  QImage image((figure.size() * scale * kDotsPerPixel).toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  constexpr int kDotsPerMetre = 11811;  // 300 dpi
  image.setDotsPerMeterX(kDotsPerMetre);
  image.setDotsPerMeterY(kDotsPerMetre);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  figure.draw(painter, image.rect());
  painter.end();
  QBuffer buffer;
  image.save(&buffer, "PNG");
  return buffer.data().toStdString();
}

}  // namespace study::report

#include "pdf_report.moc"
