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
    }
}
