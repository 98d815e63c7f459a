using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Fills the tables of a mixture's forecasters after a sample. Hold, before the first one, has a table of zeros.</summary>
    sealed class ForecasterTables
    {
        /// <summary>Factor for the joint's speed after a change point at which it did not accelerate.</summary>
        const double ShareAfterStop = 0.5;

        readonly Forecaster[] _forecasters;
        readonly ParabolaForecaster _stopping = new ParabolaForecaster(usesReported: false);
        readonly int _first;
        readonly int _points;
        readonly bool _usesChangePoints;

        /// <param name="forecasters">By the number of their table; null before <paramref name="first"/>.</param>
        /// <param name="points">Number of points of each table that are used.</param>
        /// <param name="usesChangePoints">Whether samples before a change point are left out.</param>
        public ForecasterTables(Forecaster[] forecasters, int first, int points, bool usesChangePoints)
        {
            _forecasters = forecasters;
            _first = first;
            _points = points;
            _usesChangePoints = usesChangePoints;
        }

        public void Reset()
        {
            for (var i = _first; i < _forecasters.Length; i++) _forecasters[i].Reset();
        }

        /// <remarks>A forecaster without enough samples is replaced by a parabola that does not reverse, or by a line.</remarks>
        public void Fill(MotionState motion, double[] tables)
        {
            if (motion.Connected < 2)
            {
                Array.Clear(tables, 0, tables.Length);
                return;
            }
            var samples = _usesChangePoints ? motion.OfOneMotion : motion.Connected;
            if (samples <= 2)
            {
                var share = samples == 1 && !motion.ChangePoints.HasGrown ? ShareAfterStop : 1;
                for (var i = _first; i < _forecasters.Length; i++) FillLine(tables, i, motion.Speed * share);
                return;
            }
            for (var i = _first; i < _forecasters.Length; i++)
            {
                var forecaster = _forecasters[i];
                var solves = samples >= forecaster.Samples && forecaster.Solve(motion);
                if (!solves) _stopping.Solve(motion);
                (solves ? forecaster : _stopping).Fill(tables, i * ForecastTable.Points, _points);
            }
        }

        void FillLine(double[] tables, int forecast, double speed)
        {
            var (start, step) = (forecast * ForecastTable.Points, speed * ForecastTable.Step);
            for (var i = 0; i < _points; i++) tables[start + i] = i * step;
        }
    }
}
