// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/testing/read_drawing.h"

#include <google/protobuf/text_format.h>
#include <zlib.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>

namespace flair::renderer {

const std::vector<std::string>& SampleLayouts() {
  static const auto& names = *new std::vector<std::string>{
      "attic_gym",     "bare_hall", "cloakroom",    "cross_chapel",   "crowded_kitchen", "l_shaped_studio",
      "long_corridor", "nursery",   "seminar_room", "small_bathroom", "vampire_bedroom", "writer_office"};
  return names;
}

v1::SolvedLayout ReadSample(const std::string& name) {
  std::ifstream file(std::string(FLAIR_SOURCE_DIR) + "/renderer_worker/drawing/testdata/" + name + ".textproto");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  v1::SolvedLayout layout;
  if (text.empty() || !google::protobuf::TextFormat::ParseFromString(text, &layout)) {
    std::cerr << "cannot read the sample layout " << name << "\n";
    std::abort();
  }
  return layout;
}

namespace {

[[noreturn]] void Stop(const std::string& what) {
  std::cerr << "cannot read back: " << what << "\n";
  std::abort();
}

// x' = a x + c y + e, y' = b x + d y + f.
struct Matrix {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  // This one first, then `next`.
  Matrix Then(const Matrix& next) const {
    return {next.a * a + next.c * b, next.b * a + next.d * b,          next.a * c + next.c * d,
            next.b * c + next.d * d, next.a * e + next.c * f + next.e, next.b * e + next.d * f + next.f};
  }
};

class Paths {
 public:
  void Move(Point p) {
    End();
    current_.push_back(p);
  }
  void Line(Point p) { current_.push_back(p); }
  void Rectangle(Point corner, Point opposite) {
    Move(corner);
    Line({opposite.x, corner.y});
    Line(opposite);
    Line({corner.x, opposite.y});
  }
  void End() {
    // Moves that nothing follows, and the repeated start of a closed path.
    if (current_.size() > 1) open_.push_back(std::move(current_));
    current_.clear();
  }
  void Paint(std::vector<PaintedPath>& into) {
    End();
    for (PaintedPath& path : open_) into.push_back(std::move(path));
    open_.clear();
  }
  void Discard() {
    current_.clear();
    open_.clear();
  }

 private:
  PaintedPath current_;
  std::vector<PaintedPath> open_;
};

std::optional<std::string> Attribute(const std::string& tag, const std::string& name) {
  const size_t at = tag.find(" " + name + "=\"");
  if (at == std::string::npos) return std::nullopt;
  const size_t from = at + name.size() + 3;
  return tag.substr(from, tag.find('"', from) - from);
}

double Number(const std::string& tag, const std::string& name) {
  const std::optional<std::string> text = Attribute(tag, name);
  return text.has_value() ? std::atof(text->c_str()) : 0;
}

void ReadSvgPath(const std::string& data, const Matrix& matrix, std::vector<PaintedPath>& into) {
  std::istringstream words(data);
  Paths paths;
  const auto point = [&words, &matrix] {
    Point p;
    if (!(words >> p.x >> p.y)) Stop("a point of an SVG path");
    return matrix(p);
  };
  for (std::string word; words >> word;) {
    if (word == "M") {
      paths.Move(point());
    } else if (word == "L") {
      paths.Line(point());
    } else if (word == "C") {
      point();
      point();
      paths.Line(point());
    } else if (word == "Z") {
      paths.End();
    } else {
      Stop("SVG path command " + word);
    }
  }
  paths.Paint(into);
}

std::string PageContent(const std::string& file) {
  const size_t filter = file.find("/FlateDecode"), start = file.find("stream\n", filter);
  if (filter == std::string::npos || start == std::string::npos) Stop("content of the PDF");
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) Stop("zlib");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(file.data() + start + 7));
  stream.avail_in = static_cast<uInt>(file.size() - start - 7);
  std::string content;
  std::string part(1 << 16, '\0');
  int result = Z_OK;
  while (result == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    result = inflate(&stream, Z_NO_FLUSH);
    content.append(part, 0, part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (result != Z_STREAM_END) Stop("compressed content of the PDF");
  return content;
}

// Runs the operators of a page; operands that are no numbers (names, dash arrays) do not matter for geometry.
void RunPdf(const std::string& content, Matrix matrix, std::vector<PaintedPath>& into) {
  std::istringstream words(content);
  std::vector<double> operands;
  std::vector<Matrix> saved;
  Paths paths;
  bool clips = false;
  const auto at = [&](size_t from_last) {
    if (operands.size() < from_last) Stop("operands of the PDF");
    return matrix({operands[operands.size() - from_last], operands[operands.size() - from_last + 1]});
  };
  for (std::string word; words >> word;) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (*end == '\0') {
      operands.push_back(number);
      continue;
    }
    if (word[0] == '/' || word[0] == '[' || word.back() == ']') continue;
    if (word == "m") {
      paths.Move(at(2));
    } else if (word == "l" || word == "c") {
      paths.Line(at(2));
    } else if (word == "re") {
      const size_t n = operands.size();
      if (n < 4) Stop("rectangle of the PDF");
      const Point corner{operands[n - 4], operands[n - 3]}, size{operands[n - 2], operands[n - 1]};
      paths.Rectangle(matrix(corner), matrix(corner + size));
    } else if (word == "h") {
      paths.End();
    } else if (word == "f" || word == "f*" || word == "S" || word == "s" || word == "B" || word == "B*" ||
               word == "b" || word == "b*") {
      paths.Paint(into);
    } else if (word == "W" || word == "W*") {
      clips = true;
    } else if (word == "n") {
      if (!clips) Stop("a path of the PDF that is not painted");
      paths.Discard();
      clips = false;
    } else if (word == "q") {
      saved.push_back(matrix);
    } else if (word == "Q") {
      if (saved.empty()) Stop("Q of the PDF");
      matrix = saved.back();
      saved.pop_back();
    } else if (word == "cm") {
      const size_t n = operands.size();
      if (n < 6) Stop("matrix of the PDF");
      matrix =
          Matrix{operands[n - 6], operands[n - 5], operands[n - 4], operands[n - 3], operands[n - 2], operands[n - 1]}
              .Then(matrix);
    }
    operands.clear();
  }
}

}  // namespace

Document ReadSvg(const std::string& file) {
  Document document;
  bool defines = false;
  for (size_t at = file.find('<'); at != std::string::npos; at = file.find('<', at + 1)) {
    const std::string tag = file.substr(at, file.find('>', at) - at);
    if (tag.starts_with("<svg ")) {
      const std::string box = Attribute(tag, "viewBox").value_or("");
      document.page_mm = {Number(tag, "width"), Number(tag, "height")};
      std::ostringstream expected;
      expected << "0 0 " << document.page_mm.width << " " << document.page_mm.height;
      if (Attribute(tag, "width").value_or("").find("mm") == std::string::npos || box != expected.str())
        Stop("unit of the SVG: " + tag);
    }
    if (tag == "<defs") defines = true;
    if (tag == "</defs") defines = false;
    if (defines) continue;
    Matrix matrix;
    if (const auto transform = Attribute(tag, "transform"); transform.has_value()) {
      if (std::sscanf(transform->c_str(), "matrix(%lf,%lf,%lf,%lf,%lf,%lf)", &matrix.a, &matrix.b, &matrix.c, &matrix.d,
                      &matrix.e, &matrix.f) != 6)
        Stop("transform " + *transform);
    }
    if (tag.starts_with("<path ")) ReadSvgPath(Attribute(tag, "d").value_or(""), matrix, document.paths);
    if (tag.starts_with("<rect ")) {
      const Point corner{Number(tag, "x"), Number(tag, "y")}, size{Number(tag, "width"), Number(tag, "height")};
      Paths rectangle;
      rectangle.Rectangle(matrix(corner), matrix(corner + size));
      rectangle.Paint(document.paths);
    }
  }
  return document;
}

Document ReadPdf(const std::string& file) {
  constexpr double kMm = 25.4 / 72;
  Document document;
  const size_t box = file.find("/MediaBox [");
  double x0 = 0, y0 = 0, width = 0, height = 0;
  if (box == std::string::npos ||
      std::sscanf(file.c_str() + box, "/MediaBox [ %lf %lf %lf %lf", &x0, &y0, &width, &height) != 4 || x0 != 0 ||
      y0 != 0)
    Stop("page of the PDF");
  document.page_mm = {width * kMm, height * kMm};
  // From points, upwards from the lower left corner.
  RunPdf(PageContent(file), {kMm, 0, 0, -kMm, 0, height * kMm}, document.paths);
  return document;
}

}  // namespace flair::renderer
