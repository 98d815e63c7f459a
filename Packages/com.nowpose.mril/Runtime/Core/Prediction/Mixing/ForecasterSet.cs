using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>The forecasters of a mixture: hold, whose table is zero, a line, and others. Fills their tables after a sample.</summary>
    /// <remarks>
    /// The joints of one robot, or the objects of one cell, use the same set in turn, because its forecasters keep no state from sample to sample. Their
    /// weights are then computed once per message, and their memory stays in the processor's cache.
    /// </remarks>
    sealed class ForecasterSet
    {
        public const int Hold = 0, Line = 1;

        const int First = Line + 1;

        readonly Forecaster[] _forecasters;
        readonly double[] _prior, _priorWhenReported, _sharedPrior;
        readonly int _components;
        readonly double[] _tables;

        /// <param name="components">Number of components of the motions.</param>
        /// <param name="forecasters">
        /// Forecasters in addition to hold and line. Each has two weights, 0 to 1, that apply without evidence; the second one applies if the source
        /// reports velocity and acceleration. The line has the remaining weight.
        /// </param>
        public ForecasterSet(int components, params (Forecaster Forecaster, double Prior, double PriorWhenReported)[] forecasters)
        {
            (_components, _forecasters) = (components, Array.ConvertAll(forecasters, one => one.Forecaster));
            (_tables, _prior, _priorWhenReported, _sharedPrior) = (new double[Start(Count)], new double[Count], new double[Count], new double[Count]);
            _prior[Line] = _priorWhenReported[Line] = 1;
            for (var i = First; i < Count; i++)
            {
                (_, _prior[i], _priorWhenReported[i]) = forecasters[i - First];
                _prior[Line] -= _prior[i];
                _priorWhenReported[Line] -= _priorWhenReported[i];
            }
        }

        /// <summary>Number of forecasts, including hold and line.</summary>
        public int Count => First + _forecasters.Length;

        /// <summary>Returns the weights that apply without evidence: one per forecast, with the sum 1. They are valid until the next call.</summary>
        /// <param name="isReported">Whether the source reports velocity and acceleration.</param>
        /// <param name="share">Weight of the forecasts of a motion, 0 to 1; hold has the remainder.</param>
        public double[] Prior(bool isReported, double share)
        {
            var prior = isReported ? _priorWhenReported : _prior;
            for (var i = 0; i < prior.Length; i++) _sharedPrior[i] = share * prior[i];
            _sharedPrior[Hold] = 1 - share;
            return _sharedPrior;
        }

        /// <summary>Fills the tables of all forecasts. They are valid until the next sample of any motion.</summary>
        /// <param name="samples">Number of newest samples that belong to one motion.</param>
        /// <param name="lineFactor">Factor by which the line multiplies the velocity in the last interval.</param>
        /// <param name="points">Number of points of each table that are used.</param>
        /// <remarks>A line replaces a forecaster that has too few samples or no solution.</remarks>
        public void Fill(MotionState motion, int samples, double lineFactor, int points)
        {
            FillLine(motion, lineFactor, points);
            for (var i = First; i < Count; i++)
            {
                var forecaster = _forecasters[i - First];
                if (samples >= forecaster.SamplesInMixture(motion) && forecaster.Solve(motion)) forecaster.Fill(_tables, Start(i), points, _components);
                else Array.Copy(_tables, Start(Line), _tables, Start(i), points * _components);
            }
        }

        /// <summary>Returns a component of one forecast, relative to the newest sample.</summary>
        public double At(int forecast, in TableTime time, int component) => time.Read(_tables, Start(forecast), component, _components);

        /// <summary>Adds one component of a forecast, multiplied by a weight, to a table.</summary>
        public void AddTo(double[] table, int component, int forecast, double weight, int points)
        {
            var start = Start(forecast);
            for (var i = component; i < points * _components; i += _components) table[i] += weight * _tables[start + i];
        }

        int Start(int forecast) => forecast * ForecastTable.Points * _components;

        void FillLine(MotionState motion, double factor, int points)
        {
            for (int point = 0, i = Start(Line); point < points; point++)
                for (var c = 0; c < _components; c++) _tables[i++] = point * ForecastTable.Step * factor * motion.Velocity[c];
        }
    }
}
