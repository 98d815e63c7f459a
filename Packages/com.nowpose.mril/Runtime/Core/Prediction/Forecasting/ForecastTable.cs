namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Forecast tables: positions relative to the newest sample's at 0, 50 … 500 ms after it.</summary>
    static class ForecastTable
    {
        public const int Points = 11;

        /// <summary>Interval of the points, in s: with 25 ms, the errors on recordings are 0.03 % smaller, and filling a table takes twice as long.</summary>
        public const double Step = 0.05;

        /// <summary>Time of the last point, in s.</summary>
        public const double Span = (Points - 1) * Step;

        /// <inheritdoc cref="TableTime.Read"/>
        /// <param name="ahead">Seconds after the newest sample; clamped to the table's range.</param>
        public static double Read(double[] table, int start, double ahead) => new TableTime(ahead).Read(table, start);
    }
}
