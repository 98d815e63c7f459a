namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Forecast tables: positions relative to the newest sample's at 0, 25 … 500 ms after it.</summary>
    /// <remarks>Tables are read by Catmull-Rom interpolation.</remarks>
    static class ForecastTable
    {
        public const int Points = 21;

        /// <summary>Interval of the points, in s.</summary>
        public const double Step = 0.025;

        /// <summary>Time of the last point, in s.</summary>
        public const double Span = (Points - 1) * Step;

        /// <summary>Margin before the last point, in s, so that each read is within the last cell.</summary>
        const double Inside = 1e-9;

        /// <param name="table">An array that contains the table from <paramref name="start"/> on.</param>
        /// <param name="ahead">Seconds after the newest sample; clamped to the table's range.</param>
        public static double Read(double[] table, int start, double ahead)
        {
            var x = ahead < 0 ? 0 : ahead > Span - Inside ? Span - Inside : ahead;
            x /= Step;
            var cell = (int)x;
            var f = x - cell;
            var i = start + cell;
            var p1 = table[i];
            var p2 = table[i + 1];
            var p0 = cell > 0 ? table[i - 1] : 2 * p1 - p2;
            var p3 = cell < Points - 2 ? table[i + 2] : 2 * p2 - p1;
            return p1 + 0.5 * f * (p2 - p0 + f * (2 * p0 - 5 * p1 + 4 * p2 - p3 + f * (3 * (p1 - p2) + p3 - p0)));
        }
    }
}
