using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// A forecaster that is correct for some motions only, with the gate that decides when it replaces the mixture. Stores its newest forecast.
    /// </summary>
    sealed class Candidate
    {
        readonly int _components;
        readonly Forecaster _forecaster;
        readonly CandidateGate _gate;
        bool _hasForecast;

        /// <param name="components">Number of components of a position.</param>
        public Candidate(int components, Forecaster forecaster, CandidateGate gate)
        {
            (_components, _forecaster, _gate) = (components, forecaster, gate);
            Table = new double[ForecastTable.Points * components];
        }

        /// <summary>The forecast after the newest sample (<see cref="ForecastTable"/>), valid if there is one.</summary>
        public double[] Table { get; }

        /// <summary>Whether the forecast replaces the mixture, unless another candidate is better.</summary>
        public bool IsUsed { get; private set; }

        /// <summary>Adds a sample that is newer than all previous samples.</summary>
        /// <param name="points">Number of points of the table that are used.</param>
        public void Add(MotionState motion, int points)
        {
            _hasForecast = _forecaster.Solve(motion);
            if (_hasForecast) _forecaster.Fill(Table, 0, points, _components);
            IsUsed = !double.IsInfinity(ErrorRatio(motion.StillSamples > 0));
        }

        /// <inheritdoc cref="CandidateGate.ErrorRatio"/>
        public double ErrorRatio(bool isStill) => _hasForecast ? _gate.ErrorRatio(isStill) : double.PositiveInfinity;

        /// <summary>Returns the distance of the forecast made at the previous sample from the newest sample.</summary>
        /// <inheritdoc cref="Add" path="/param[@name='points']"/>
        public double DistanceFrom(MotionState motion, int points)
        {
            var ahead = Math.Min(motion.Timing.Interval, (points - 2) * ForecastTable.Step);
            var (time, squares) = (new TableTime(ahead), 0.0);
            for (var c = 0; c < _components; c++)
            {
                var difference = motion.Previous[c] + time.Read(Table, 0, c, _components) - motion.Newest[c];
                squares += difference * difference;
            }
            return Math.Sqrt(squares);
        }

        /// <summary>Computes the forecast position.</summary>
        /// <param name="time">Time after the newest sample.</param>
        /// <returns>False without a forecast.</returns>
        public bool TryForecast(in TableTime time, MotionState motion, double[] position)
        {
            for (var c = 0; c < _components && _hasForecast; c++) position[c] = motion.Newest[c] + time.Read(Table, 0, c, _components);
            return _hasForecast;
        }

        /// <summary>Scores a forecast.</summary>
        /// <param name="mixtureError">Error of the mixture for the same time.</param>
        /// <param name="truth">Position at that time.</param>
        /// <param name="from">Position of the sample that was the newest when the forecast was made.</param>
        /// <param name="wasStill">Whether the positions stood still then.</param>
        /// <param name="time">Time of the newest sample, in s.</param>
        public void Score(double[] forecast, double mixtureError, double[] truth, double[] from, bool wasStill, double time)
        {
            var displacement = Math.Max(Vectors.Distance(truth, from), Vectors.Distance(forecast, from));
            _gate.Score(Vectors.Distance(forecast, truth), mixtureError, displacement, wasStill, time);
        }

        public void Reset()
        {
            _forecaster.Reset();
            _gate.Reset();
            _hasForecast = IsUsed = false;
        }
    }
}
