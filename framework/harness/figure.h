#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

/// How a curve is drawn; the colours are told apart by the colour-blind (Okabe and Ito 2008).
enum class Pen {
  Line,       ///< solid, next colour of the palette
  Reference,  ///< dashed grey, drawn underneath: what the curve should follow
  Points,     ///< markers, next colour of the palette
};

/// One curve: numbers and the name in the key.
struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  Pen pen = Pen::Line;
};

/// One plot of a figure; panels are stacked and share the x axis's label.
struct Panel {
  std::string yLabel;  ///< with its unit: "height [m]"
  std::vector<Series> series;
  bool logY = false;
};

/// The one way to draw a plot: a data file, a gnuplot script that can be run again by hand, and an SVG.
///
///     Figure figure("oscillator", "A spring swings about its rest length", "time [s]");
///     figure.panel("position [m]").line("simulated", t, x).reference("analytic", t, exact);
///     figure.panel("energy [J]").line("total", t, E);
///     figure.write("out");   // out/oscillator.dat, out/oscillator.gp, out/oscillator.svg
///
/// Titles, names and labels come from this project's sources, never from a submission: they are checked against a
/// plain alphabet (std::invalid_argument otherwise) before gnuplot reads them. Not-finite numbers are gaps in a curve.
class Figure {
 public:
  /// Builds one panel.
  class PanelBuilder {
   public:
    explicit PanelBuilder(Panel& panel) : panel_(panel) {}
    PanelBuilder& line(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& reference(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& points(std::string name, std::vector<double> x, std::vector<double> y);
    PanelBuilder& logY();

   private:
    Panel& panel_;
  };

  /// \param id file name stem, letters, digits and _   \param title the message   \param xLabel with its unit
  Figure(std::string id, std::string title, std::string xLabel);

  PanelBuilder panel(std::string yLabel);
  /// Same scale on both axes: for paths in the plane.
  Figure& equalAxes();

  const std::string& id() const { return id_; }
  const std::string& title() const { return title_; }
  const std::string& xLabel() const { return xLabel_; }
  bool hasEqualAxes() const { return equalAxes_; }
  const std::vector<Panel>& panels() const { return panels_; }

  /// This figure with the curves of `reference` (same panels) underneath, in the reference pen and named "reference: ...".
  Figure over(const Figure& reference) const;

  /// Writes id.dat, id.gp and id.svg into the folder, which is made when missing.
  /// Throws std::runtime_error with gnuplot's words when it fails.
  void write(const std::filesystem::path& folder) const;

 private:
  std::string id_;
  std::string title_;
  std::string xLabel_;
  bool equalAxes_ = false;
  std::vector<Panel> panels_;
};

}  // namespace muelle
