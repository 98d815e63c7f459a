using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Solves small symmetric positive definite systems in place; unlike MathNet's solver it does not allocate.</summary>
    static class Cholesky
    {
        /// <summary>Pivots below this are rounding errors of an exactly singular system.</summary>
        const double MinPivot = 1e-12;

        /// <param name="matrix">
        /// Row-major n×n matrix. Only its lower triangle is read. Receives the factor L with the reciprocals of its diagonal elements, because
        /// multiplications take less time than divisions.
        /// </param>
        public static void Factor(double[] matrix, int n)
        {
            for (var i = 0; i < n; i++)
            {
                var row = i * n;
                for (var j = 0; j <= i; j++)
                {
                    var other = j * n;
                    var sum = matrix[row + j];
                    for (var k = 0; k < j; k++) sum -= matrix[row + k] * matrix[other + k];
                    matrix[row + j] = i == j ? 1 / Math.Sqrt(sum > MinPivot ? sum : MinPivot) : sum * matrix[other + j];
                }
            }
        }

        /// <summary>Solves A x = vector, where A is the factored matrix.</summary>
        /// <param name="matrix">Result of <see cref="Factor"/>.</param>
        /// <param name="vector">Right-hand side. Receives the solution.</param>
        public static void Solve(double[] matrix, Span<double> vector)
        {
            SolveLower(matrix, vector);
            var n = vector.Length;
            for (var i = n - 1; i >= 0; i--)
            {
                var value = vector[i];
                for (int k = i + 1, at = k * n + i; k < n; k++, at += n) value -= matrix[at] * vector[k];
                vector[i] = value * matrix[i * n + i];
            }
        }

        /// <summary>Solves L x = vector. The sum of the squares of x equals vectorᵀ A⁻¹ vector.</summary>
        /// <inheritdoc cref="Solve"/>
        public static void SolveLower(double[] matrix, Span<double> vector)
        {
            for (int i = 0, row = 0; i < vector.Length; i++, row += vector.Length)
            {
                var value = vector[i];
                for (var k = 0; k < i; k++) value -= matrix[row + k] * vector[k];
                vector[i] = value * matrix[row + i];
            }
        }
    }
}
