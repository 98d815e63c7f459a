using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Keeps a forecast within what the drive can do: its greatest speed, and how fast its speed can change.</summary>
    static class SpeedLimits
    {
        /// <param name="table">Holds a table of <see cref="ForecastTable"/> from <paramref name="start"/> on, changed in place.</param>
        /// <param name="speed">Mean speed over the interval before the newest sample.</param>
        /// <param name="interval">That interval, s.</param>
        public static void Apply(double[] table, int start, double speed, double interval, PredictionLimits limits)
        {
            if (double.IsInfinity(limits.Velocity) && double.IsInfinity(limits.Acceleration)) return;
            // A joint that is seen to be faster is: URDFs err.
            var greatest = Math.Max(limits.Velocity, Math.Abs(speed));
            var wanted = table[start];
            for (var cell = 1; cell < ForecastTable.Points; cell++)
            {
                var i = start + cell;
                var displacement = table[i] - wanted;
                wanted = table[i];
                // The mean speed was the speed half an interval ago, and a cell's is the one at its middle.
                var change = limits.Acceleration * (interval / 2 + (cell - 0.5) * ForecastTable.Step);
                var slowest = Math.Max(-greatest, speed - change);
                var fastest = Math.Min(greatest, speed + change);
                table[i] = table[i - 1] + Math.Min(Math.Max(displacement, slowest * ForecastTable.Step), fastest * ForecastTable.Step);
            }
        }
    }
}
