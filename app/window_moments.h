#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace enfilade {

/// Side of a window of structural similarity [pixels].
inline constexpr std::size_t kWindowTaps = 11;

/// What a window says of two pictures: weighted means and raw second moments.
struct Moments {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
};

/// Columns [low, high); empty when low ≥ high.
struct Columns {
  std::size_t low = 0, high = 0;
};

/// The moments of a row of Gaussian windows, sigma 1.5: down the rows first, then along the row.
class WindowRow {
 public:
  explicit WindowRow(std::size_t width);

  /// `a`, `b`: the first of kWindowTaps rows of the pictures, `width` each; `windows`: those, by
  /// their first column, whose moments are wanted.
  void filter(const double* a, const double* b, const Columns& windows);

  /// Of the window whose first column is x.
  Moments at(std::size_t x) const {
    return {windows_[0][x], windows_[1][x], windows_[2][x], windows_[3][x], windows_[4][x]};
  }

 private:
  void addRow(const double* row_a, const double* row_b, double tap, const Columns& pixels);

  std::array<std::vector<double>, 5> down_, windows_;  ///< means of a, b, a², b², a·b
};

}  // namespace enfilade
