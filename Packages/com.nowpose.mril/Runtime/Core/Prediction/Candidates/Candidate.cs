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

        /// <summary>
        /// Mean square error relative to that of the mixture (<see cref="CandidateGate.ErrorRatio"/>); infinite while the forecast must not replace the
        /// mixture.
        /// </summary>
        public double ErrorRatio { get; private set; } = double.PositiveInfinity;

        /// <summary>Adds a sample that is newer than all previous samples.</summary>
        /// <param name="points">Number of points of the table that are used.</param>
        public void Add(MotionState motion, int points)
        {
            _hasForecast = _forecaster.Solve(motion);
            if (_hasForecast) _forecaster.Fill(Table, 0, points, _components);
            ErrorRatio = _hasForecast ? _gate.ErrorRatio(motion.Rest.IsStill) : double.PositiveInfinity;
        }

        /// <summary>Returns a component of the forecast, relative to the newest sample; NaN without a forecast.</summary>
        public double At(in TableTime time, int component) => _hasForecast ? time.Read(Table, 0, component, _components) : double.NaN;

        /// <inheritdoc cref="CandidateGate.Score"/>
        public void Score(double error, double mixture, double displacement, bool wasStill, double time) =>
            _gate.Score(error, mixture, displacement, wasStill, time);

        public void Reset()
        {
            _forecaster.Reset();
            _gate.Reset();
            (_hasForecast, ErrorRatio) = (false, double.PositiveInfinity);
        }
    }
}
