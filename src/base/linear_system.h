#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rasterwalk {

/// Solves a x = b for a small matrix, by Gauss-Jordan elimination with row pivoting.
/// @param a by rows
/// @param b receives x
/// @return false if the matrix is singular; b is then meaningless
template <std::size_t n>
bool solve_linear_system(std::array<std::array<double, n>, n> a, std::array<double, n>& b) {
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column; row < n; ++row) {
            if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
        }
        if (!(std::abs(a[pivot][column]) > 0.0)) return false;
        std::swap(a[pivot], a[column]);
        std::swap(b[pivot], b[column]);
        for (std::size_t row = 0; row < n; ++row) {
            if (row == column) continue;
            const double factor = a[row][column] / a[column][column];
            for (std::size_t i = column; i < n; ++i)
                a[row][i] -= factor * a[column][i];
            b[row] -= factor * b[column];
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        b[i] /= a[i][i];
    return true;
}

} // namespace rasterwalk
