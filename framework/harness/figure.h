#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace muelle {

/// How a curve is drawn; the colours are told apart by the colour-blind (Okabe and Ito 2008).
enum class Pen {
  Line,        ///< solid, next colour of the palette
  Reference,   ///< dashed grey, drawn underneath: what the curve should follow
  Points,      ///< markers, next colour of the palette
  LinePoints,  ///< a line with a marker at each point: few points, such as errors against steps
  Arrows,      ///< from (x, y) by (dx, dy), next colour of the palette
  Cells,       ///< filled unit squares about the points: categories in a table
  Mesh,        ///< a hair line, next colour of the palette: many edges
  Structure,   ///< solid thin grey (white on a field), drawn underneath: what carries the marks of a drawing
  Nodes,       ///< dark discs: masses, wherever they are
};

/// One curve: numbers and the name in the key.
struct Series {
  std::string name;  ///< empty: not in the key
  std::vector<double> x;
  std::vector<double> y;
  Pen pen = Pen::Line;
  std::vector<double> dx = {};  ///< of arrows
  std::vector<double> dy = {};
  int colour = -1;  ///< position in the palette, from 0; -1: the next one
};

/// A few words at a point of a plot.
struct Note {
  double x, y;
  std::string text;
  bool centred;    ///< else to the right of the point
  int curve = -1;  ///< position in the panel of the curve that it names, and whose colour it has; -1: none
};

/// The ends of an axis or of a scale that are not left to the data.
using FixedRange = std::optional<std::pair<double, double>>;

/// Characters of a title, name or label, at most.
inline constexpr int longestFigureText = 200;

/// Values over a rectangle, shown by colour in bands.
struct Field {
  std::vector<double> x, y;    ///< grid lines, ascending and equally spaced
  std::vector<double> values;  ///< y.size() rows of x.size()
  std::string label;           ///< of the colour scale, with its unit
  FixedRange range = {};  ///< of the colours; empty: from the least to the greatest value. The scale says "≥", "≤"
                          ///< at an end that values go beyond.
  int bands = 24;         ///< how many colours, at least two
};

/// One plot of a figure. Panels are stacked and share the x axis, unless the figure is a slide.
struct Panel {
  std::string yLabel;  ///< with its unit: "height [m]"
  std::vector<Series> series;
  bool logY = false;
  /// What right answers reach: the axes of a curve that goes further end at three times that (see Figure).
  FixedRange xExpected = {}, yExpected = {};
  // The rest is for slides.
  std::string xLabel = {};  ///< empty: the figure's
  std::string heading = {};
  bool logX = false;
  bool equalAxes = false;
  std::vector<Note> notes = {};
  std::optional<Field> field = {};
  FixedRange xRange = {}, yRange = {};
  std::vector<std::string> xNames = {};  ///< instead of the numbers 0, 1, 2 ... on the axis
  std::vector<std::string> yNames = {};
};

/// A plot as data; figures/write.h draws it.
///
///     Figure figure("oscillator", "A spring swings about its rest length", "time [s]");
///     figure.panel("position [m]").line("simulated", t, x).reference("analytic", t, exact);
///     figure.panel("energy [J]").line("total", t, E);
///
/// Titles, names and labels are UTF-8 and drawn as they are written, whatever stands in them: an index, a power or a
/// Greek letter is its own character (xₐ, m², ω). What is no printable text on one line of at most longestFigureText
/// characters throws std::invalid_argument. Numbers that are not finite or beyond 1e100 are gaps in a curve, as are
/// those below or at zero on a logarithmic axis; a curve with no point left says "no data". A linear axis never shows
/// round-off: values that differ by less than 1e-9 of their size, or are all below 1e-12, look constant.
///
/// Where a panel expects a range, its linear axis shows at most three times that, about its middle: a curve that
/// diverges does not flatten the others, ends where it leaves the picture, even if its numbers come back, and its name
/// says where.
///
/// Figures for lectures are slides: see slide().
class Figure {
 public:
  /// Adds curves to one panel; stays valid while the figure stays where it is. Throws std::invalid_argument when x and
  /// y differ in length or the name cannot be drawn.
  class PanelBuilder {
   public:
    PanelBuilder(Figure& figure, std::size_t index) : figure_(figure), index_(index) {}
    PanelBuilder& line(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& reference(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& points(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& linePoints(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& logY();
    /// What a right answer reaches along y (along x, for a path). Throw std::invalid_argument unless low < high.
    PanelBuilder& expect(double low, double high);
    PanelBuilder& expectX(double low, double high);

    /// Arrows from (x, y) by (dx, dy), in the units of the axes.
    PanelBuilder& arrows(std::string name, std::vector<double> x, std::vector<double> y, std::vector<double> dx,
                         std::vector<double> dy);
    /// Many edges, thin, with a gap after each; the structure that other marks stand on, in grey.
    PanelBuilder& mesh(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& structure(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& nodes(std::string name, std::vector<double> x, std::vector<double> y);
    /// A category of a table: a square about each point, one wide and one high.
    PanelBuilder& cells(std::string name, std::vector<double> x, std::vector<double> y);
    /// The palette's colour for the curve added last, so that one thing has one colour in several panels.
    PanelBuilder& colour(int position);
    // For slides:
    PanelBuilder& heading(std::string text);
    PanelBuilder& xLabel(std::string text);
    PanelBuilder& logX();
    PanelBuilder& equalAxes();
    /// Throw std::invalid_argument unless low < high, both finite.
    PanelBuilder& xRange(double low, double high);
    PanelBuilder& yRange(double low, double high);
    PanelBuilder& note(double x, double y, std::string text, bool centred = false);
    /// A note in the colour of the curve added last: a name at the curve, in place of one in the key.
    PanelBuilder& nameAt(double x, double y, std::string text, bool centred = false);
    /// A triangle under a power law on logarithmic axes, grey: from (x, y) to the right by the factor `across`, up by
    /// across^power, and back; `text` stands beside its upright side. Throws std::invalid_argument unless x and y are
    /// positive, across > 1 and power > 0.
    PanelBuilder& slope(double x, double y, double across, double power, std::string text);
    /// Throws std::invalid_argument when the values do not fill the grid, its lines are not equally spaced, or there
    /// are fewer than two bands.
    PanelBuilder& field(Field field);
    /// Names instead of 0, 1, 2 ... along an axis.
    PanelBuilder& xNames(std::vector<std::string> names);
    PanelBuilder& yNames(std::vector<std::string> names);

   private:
    PanelBuilder& add(Series series);
    Panel& panel() { return figure_.panels_[index_]; }

    Figure& figure_;
    std::size_t index_;
  };

  /// \param id file name stem, letters, digits and _   \param title the message   \param xLabel with its unit
  Figure(std::string id, std::string title, std::string xLabel);

  PanelBuilder panel(std::string yLabel);
  /// Same scale on both axes: for paths in the plane.
  Figure& equalAxes();
  /// Logarithmic x axis: for errors against steps.
  Figure& logX();

  /// For a lecture: 16 : 9, panels side by side in so many columns, each with an x axis of its own. The label of the x
  /// axis is left out where the panel below has the same. Throws std::invalid_argument when columns < 1.
  Figure& slide(int columns = 1);

  /// This figure with a few words more behind its title: "A node on a spring; you predicted: 0.6 s". Throws as the
  /// constructor does.
  Figure withRemark(const std::string& remark) const;

  const std::string& id() const { return id_; }
  const std::string& title() const { return title_; }
  const std::string& xLabel() const { return xLabel_; }
  bool hasEqualAxes() const { return equalAxes_; }
  bool hasLogX() const { return logX_; }
  bool isSlide() const { return columns_ > 0; }
  int columns() const { return columns_; }  ///< of a slide; otherwise 0
  const std::vector<Panel>& panels() const { return panels_; }

  /// This figure with the curves of `reference` underneath in the reference pen: what the grader draws, a submission's
  /// figure over that of the oracle. One curve of a panel is named "reference: its name", several share the name
  /// "reference". Curves that are already drawn as references (an analytic solution) are not drawn twice,
  /// nor are markers that do not go from left to right. What the reference reaches is expected of this figure.
  /// Throws std::invalid_argument when the panels differ in number.
  Figure over(const Figure& reference) const;

 private:
  std::string id_;
  std::string title_;
  std::string xLabel_;
  bool equalAxes_ = false;
  bool logX_ = false;
  int columns_ = 0;
  std::vector<Panel> panels_;
};

}  // namespace muelle
