namespace Nowpose.Prediction.Forecasting
{
    /// <summary>A time in forecast tables, to read several of them: the weights of the points around it in a Catmull-Rom spline.</summary>
    readonly struct TableTime
    {
        /// <summary>Margin before the last point, in s, so that each read is within the last cell.</summary>
        const double Inside = 1e-9;

        readonly int _before, _cell, _after;
        readonly double _weightBefore, _weight, _weightNext, _weightAfter;

        /// <param name="ahead">Seconds after the newest sample; clamped to the table's range.</param>
        public TableTime(double ahead)
        {
            const double last = ForecastTable.Span - Inside;
            var x = (ahead < 0 ? 0 : ahead > last ? last : ahead) / ForecastTable.Step;
            _cell = (int)x;
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

        /// <summary>Returns a position of a table.</summary>
        /// <param name="table">An array that contains the table from <paramref name="start"/> on.</param>
        public double Read(double[] table, int start) => _weightBefore * table[start + _before] + _weight * table[start + _cell]
            + _weightNext * table[start + _cell + 1] + _weightAfter * table[start + _after];
    }
}
