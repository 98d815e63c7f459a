using System;
using System.Numerics;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    /// <summary>
    /// Computes the least-squares polynomial of the paper's Eq. 8 in exact rational arithmetic, from the textbook form of the normal
    /// equations.
    /// </summary>
    static class ExactPolynomial
    {
        public static double ValueAt(double time, int degree, double[] times, double[] positions)
        {
            var n = degree + 1;
            var system = new Fraction[n, n + 1];
            for (var row = 0; row < n; row++)
            {
                for (var column = 0; column < n; column++) system[row, column] = Sum(times, times, row + column, false);
                system[row, n] = Sum(times, positions, row, true);
            }
            var coefficients = Solve(system, n);
            var value = Fraction.Zero;
            for (var i = degree; i >= 0; i--) value = value * Fraction.Of(time) + coefficients[i];
            return value.ToDouble();
        }

        static Fraction Sum(double[] times, double[] positions, int power, bool weighted)
        {
            var sum = Fraction.Zero;
            for (var i = 0; i < times.Length; i++)
            {
                var term = weighted ? Fraction.Of(positions[i]) : Fraction.Of(1);
                for (var k = 0; k < power; k++) term *= Fraction.Of(times[i]);
                sum += term;
            }
            return sum;
        }

        static Fraction[] Solve(Fraction[,] system, int n)
        {
            for (var pivot = 0; pivot < n; pivot++)
                for (var row = 0; row < n; row++)
                {
                    // A Gram matrix of distinct times has no zero pivot.
                    if (row == pivot) continue;
                    var factor = system[row, pivot] / system[pivot, pivot];
                    for (var column = pivot; column <= n; column++) system[row, column] -= factor * system[pivot, column];
                }
            var solution = new Fraction[n];
            for (var i = 0; i < n; i++) solution[i] = system[i, n] / system[i, i];
            return solution;
        }

        readonly struct Fraction
        {
            readonly BigInteger _numerator;
            readonly BigInteger _denominator;

            Fraction(BigInteger numerator, BigInteger denominator)
            {
                var shared = BigInteger.GreatestCommonDivisor(numerator, denominator) * denominator.Sign;
                _numerator = numerator / shared;
                _denominator = denominator / shared;
            }

            public static Fraction Zero => Of(0);

            public static Fraction Of(double value)
            {
                var bits = BitConverter.DoubleToInt64Bits(value);
                var exponent = (int)((bits >> 52) & 0x7FF);
                var mantissa = exponent == 0 ? bits & 0xFFFFFFFFFFFFF : (bits & 0xFFFFFFFFFFFFF) | 0x10000000000000;
                exponent = Math.Max(exponent, 1) - 1075;
                var whole = new BigInteger(bits < 0 ? -mantissa : mantissa);
                return exponent >= 0
                    ? new Fraction(whole * BigInteger.Pow(2, exponent), 1)
                    : new Fraction(whole, BigInteger.Pow(2, -exponent));
            }

            public static Fraction operator +(Fraction a, Fraction b) =>
                new Fraction(a._numerator * b._denominator + b._numerator * a._denominator, a._denominator * b._denominator);

            public static Fraction operator -(Fraction a, Fraction b) =>
                new Fraction(a._numerator * b._denominator - b._numerator * a._denominator, a._denominator * b._denominator);

            public static Fraction operator *(Fraction a, Fraction b) =>
                new Fraction(a._numerator * b._numerator, a._denominator * b._denominator);

            public static Fraction operator /(Fraction a, Fraction b) =>
                new Fraction(a._numerator * b._denominator, a._denominator * b._numerator);

            public double ToDouble()
            {
                // Keeps 60 decimal places, which are more digits than a double holds for values above 1e-43.
                var scale = BigInteger.Pow(10, 60);
                return (double)(_numerator * scale / _denominator) / 1e60;
            }
        }
    }
}
