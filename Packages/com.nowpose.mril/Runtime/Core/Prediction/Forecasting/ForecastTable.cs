using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Limits forecast tables and defines their form: positions 0, 50 … 500 ms after the newest sample, relative to its position. The components of a
    /// point are adjacent.
    /// </summary>
    static class ForecastTable
    {
        /// <summary>Number of points: they reach 0.5 s, which exceeds the default horizon cap of 0.3 s.</summary>
        public const int Points = 11;

        /// <summary>
        /// Interval of the points, in s: with 25 ms, the errors on recordings are 0.03 % smaller, and filling a table takes twice as long.
        /// </summary>
        public const double Step = 0.05;

        /// <summary>Time of the last point, in s.</summary>
        public const double Span = (Points - 1) * Step;

        /// <summary>Returns the number of points that are read up to the horizon cap: the spline also reads two points beyond it.</summary>
        /// <param name="horizonCap">Maximum time that is displayed, in s.</param>
        public static int PointsUpTo(double horizonCap) => (int)Math.Min(Points, Math.Floor(horizonCap / Step) + 3);

        /// <summary>Limits the forecast of a joint to the drive's maximum speed and maximum acceleration.</summary>
        /// <param name="table">Table with one component, which is changed in place.</param>
        /// <param name="points">Number of points of the table that are used.</param>
        /// <param name="velocity">Mean velocity in the interval before the newest sample, per second; smaller after a stop or a jump.</param>
        /// <param name="interval">Interval before the newest sample, in s.</param>
        public static void LimitToDrive(double[] table, int points, double velocity, double interval, PredictionLimits limits)
        {
            if (double.IsInfinity(limits.Velocity) && double.IsInfinity(limits.Acceleration)) return;
            // If the observed speed exceeds the limit, the observed speed applies, because URDFs can be wrong.
            var max = Math.Max(limits.Velocity, Math.Abs(velocity));
            var wanted = table[0];
            for (var i = 1; i < points; i++)
            {
                var displacement = table[i] - wanted;
                wanted = table[i];
                // The mean velocity is the velocity at the middle of the last interval, and that of a cell is the velocity at its middle.
                var change = limits.Acceleration * (interval / 2 + (i - 0.5) * Step);
                var slowest = Math.Max(-max, velocity - change);
                var fastest = Math.Min(max, velocity + change);
                table[i] = table[i - 1] + Math.Min(Math.Max(displacement, slowest * Step), fastest * Step);
            }
        }
    }

    /// <summary>
    /// A time in forecast tables: the weights of the points around this time in a Catmull-Rom spline. Can be used to read several tables.
    /// </summary>
    readonly struct TableTime
    {
        readonly int _before, _cell, _after;
        readonly double _weightBefore, _weight, _weightNext, _weightAfter;

        /// <param name="ahead">Seconds after the newest sample; clamped to the table's range.</param>
        public TableTime(double ahead)
        {
            var x = (ahead < 0 ? 0 : ahead > ForecastTable.Span ? ForecastTable.Span : ahead) / ForecastTable.Step;
            _cell = Math.Min((int)x, ForecastTable.Points - 2);
            var f = x - _cell;
            _weightBefore = -0.5 * f * (1 - f) * (1 - f);
            _weight = 1 - f * f * (2.5 - 1.5 * f);
            _weightNext = f * (0.5 + f * (2 - 1.5 * f));
            _weightAfter = -0.5 * f * f * (1 - f);
            (_before, _after) = (_cell - 1, _cell + 2);
            // A table continues as a line before its first and after its last point.
            if (_cell == 0)
            {
                _weight += 2 * _weightBefore;
                _weightNext -= _weightBefore;
                (_before, _weightBefore) = (_cell, 0);
            }
            else if (_cell == ForecastTable.Points - 2)
            {
                _weightNext += 2 * _weightAfter;
                _weight -= _weightAfter;
                (_after, _weightAfter) = (_cell, 0);
            }
        }

        /// <summary>Returns one component of a position.</summary>
        /// <param name="table">Array that contains the table from index <paramref name="start"/> on.</param>
        /// <param name="components">Number of components of a point.</param>
        public double Read(double[] table, int start, int component, int components)
        {
            var origin = start + component;
            return _weightBefore * table[origin + _before * components] + _weight * table[origin + _cell * components]
                + _weightNext * table[origin + (_cell + 1) * components] + _weightAfter * table[origin + _after * components];
        }

        /// <summary>Returns the same component without a table: only the four points around this time are forecast.</summary>
        public double Read(Forecaster forecaster, int component)
        {
            const double step = ForecastTable.Step;
            return _weightBefore * forecaster.At(_before * step, component) + _weight * forecaster.At(_cell * step, component)
                + _weightNext * forecaster.At((_cell + 1) * step, component) + _weightAfter * forecaster.At(_after * step, component);
        }
    }
}
