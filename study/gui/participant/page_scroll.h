#pragma once

#include <QScrollArea>

namespace study::gui {

/// Scrolls a page that is higher than its window. The place of the bar is kept free where it is not
/// needed, so that pages with and without it look alike.
class PageScroll final : public QScrollArea {
 public:
  explicit PageScroll(QWidget* parent = nullptr);

  /// Whether a part of the page is below the lower edge.
  bool hasMoreBelow() const;
};

}  // namespace study::gui
