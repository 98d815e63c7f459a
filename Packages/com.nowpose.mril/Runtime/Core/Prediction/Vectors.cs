using System;

namespace Nowpose.Prediction
{
    /// <summary>Lengths and products of positions with any number of components.</summary>
    static class Vectors
    {
        /// <summary>Copies a vector. For few components, this takes a tenth of the time of Array.Copy on Mono.</summary>
        public static void Copy(double[] from, double[] to)
        {
            for (var c = 0; c < from.Length; c++) to[c] = from[c];
        }

        public static double Length(double[] vector) => Math.Sqrt(Dot(vector, vector));

        public static double Dot(double[] one, double[] other)
        {
            var sum = 0.0;
            for (var c = 0; c < one.Length; c++) sum += one[c] * other[c];
            return sum;
        }

        public static double Distance(double[] one, double[] other) => Distance(one, 0, other, 0, one.Length);

        /// <param name="start">Index of the first component of one vector.</param>
        /// <param name="otherStart">Index of the first component of the other vector.</param>
        public static double Distance(double[] one, int start, double[] other, int otherStart, int components)
        {
            var squares = 0.0;
            for (var c = 0; c < components; c++)
            {
                var difference = one[start + c] - other[otherStart + c];
                squares += difference * difference;
            }
            return Math.Sqrt(squares);
        }

        /// <summary>
        /// Returns the mean ratio of a displacement to the one before it: 1 for a constant velocity, about 0 for a position that wanders at random,
        /// and −0.5 for white noise. 1 if it is unknown.
        /// </summary>
        /// <param name="positions">Newest first; the components of a position are adjacent.</param>
        /// <param name="count">Number of newest positions that are used.</param>
        public static double Persistence(double[] positions, int count, int components)
        {
            double products = 0, squares = 0;
            for (int age = 2, i = 0; age < count; age++)
                for (var c = 0; c < components; c++, i++)
                {
                    var before = positions[i + components] - positions[i + 2 * components];
                    products += (positions[i] - positions[i + components]) * before;
                    squares += before * before;
                }
            return squares > 0 ? products / squares : 1;
        }
    }
}
