// draw_icon: writes the icon as a PNG file of a given size, for desktops without SVG. Used by the
// build only; it is not installed.
#include <cstdio>
#include <cstdlib>

#include <QImage>
#include <QPainter>
#include <QString>
#include <QSvgRenderer>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: draw_icon FILE.svg PIXELS FILE.png\n", stderr);
    return 2;
  }
  const int pixels = std::atoi(argv[2]);
  QSvgRenderer svg(QString::fromLocal8Bit(argv[1]));
  if (!svg.isValid() || pixels <= 0) {
    std::fprintf(stderr, "draw_icon: %s is no SVG that can be drawn.\n", argv[1]);
    return 1;
  }
  QImage picture(pixels, pixels, QImage::Format_ARGB32);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  svg.render(&painter);
  painter.end();
  if (!picture.save(QString::fromLocal8Bit(argv[3]), "PNG")) {
    std::fprintf(stderr, "draw_icon: %s could not be written.\n", argv[3]);
    return 1;
  }
  return 0;
}
