using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Limits a forecast to the drive's maximum speed and maximum acceleration.</summary>
    static class SpeedLimits
    {
        /// <param name="table">Contains a table of <see cref="ForecastTable"/> from <paramref name="start"/> on, which is changed in place.</param>
        /// <param name="points">Number of points of the table that are used.</param>
        /// <param name="speed">Mean speed over the interval before the newest sample.</param>
        /// <param name="interval">That interval, in s.</param>
        public static void Apply(double[] table, int start, int points, double speed, double interval, PredictionLimits limits)
        {
            if (double.IsInfinity(limits.Velocity) && double.IsInfinity(limits.Acceleration)) return;
            // The observed speed overrides a smaller limit, because URDFs can be wrong.
            var max = Math.Max(limits.Velocity, Math.Abs(speed));
            var wanted = table[start];
            for (var cell = 1; cell < points; cell++)
            {
                var i = start + cell;
                var displacement = table[i] - wanted;
                wanted = table[i];
                // The mean speed is that of half an interval ago, and a cell's speed is that at its middle.
                var change = limits.Acceleration * (interval / 2 + (cell - 0.5) * ForecastTable.Step);
                var slowest = Math.Max(-max, speed - change);
                var fastest = Math.Min(max, speed + change);
                table[i] = table[i - 1] + Math.Min(Math.Max(displacement, slowest * ForecastTable.Step), fastest * ForecastTable.Step);
            }
        }
    }
}
