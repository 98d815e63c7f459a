using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>A forecaster of the mixture and its prior weight.</summary>
    readonly struct MixedForecaster
    {
        /// <param name="prior">Weight, 0 to 1.</param>
        /// <param name="priorWhenReported">Weight if samples contain their velocity and acceleration.</param>
        public MixedForecaster(Forecaster forecaster, double prior = 0, double priorWhenReported = 0) =>
            (Forecaster, Prior, PriorWhenReported) = (forecaster, prior, priorWhenReported);

        public Forecaster Forecaster { get; }

        public double Prior { get; }

        public double PriorWhenReported { get; }
    }

    /// <summary>The forecasters of a mixture: hold, whose table is zero, a line, and others. Fills their tables after a sample.</summary>
    /// <remarks>Several joints use them in turn if no forecaster keeps a state from sample to sample (<see cref="SharedForecasters"/>).</remarks>
    sealed class MixedForecasters
    {
        public const int Hold = 0, Line = 1;

        const int First = Line + 1;

        /// <summary>
        /// Factor by which the line multiplies the speed directly after a change point that did not increase it. Without the factor, the errors on
        /// recordings are 0.4 % larger.
        /// </summary>
        public const double SpeedRatioAfterStop = 0.5;

        readonly MixedForecaster[] _mixed;
        readonly double[] _priorWhenReported;
        readonly bool _usesChangePoints;
        double[] _tables = Array.Empty<double>();

        /// <param name="mixed">Forecasters in addition to hold and line. The prior weight of the line is one minus the weights of the others.</param>
        /// <param name="usesChangePoints">Whether samples before a change point are left out.</param>
        public MixedForecasters(MixedForecaster[] mixed, bool usesChangePoints)
        {
            _mixed = mixed;
            _usesChangePoints = usesChangePoints;
            Prior = Weights(one => one.Prior);
            _priorWhenReported = Weights(one => one.PriorWhenReported);
        }

        /// <summary>Number of forecasts, including hold and line.</summary>
        public int Count => First + _mixed.Length;

        /// <summary>Prior weights, which apply without evidence: one per forecast.</summary>
        public double[] Prior { get; }

        /// <summary>Returns the prior weights for a sample; they differ if the sample contains velocity and acceleration.</summary>
        public double[] PriorFor(in JointSample newest) => double.IsNaN(newest.Velocity + newest.Acceleration) ? Prior : _priorWhenReported;

        public void Reset()
        {
            foreach (var one in _mixed) one.Forecaster.Reset();
        }

        /// <summary>Returns an array for a number of tables. Its contents are valid until the next joint's sample.</summary>
        public double[] TablesFor(int forecasts)
        {
            var length = forecasts * ForecastTable.Points;
            if (_tables.Length < length) _tables = new double[length];
            return _tables;
        }

        /// <param name="points">Number of points of each table that are used.</param>
        /// <remarks>A line replaces a forecaster that has too few samples or no solution.</remarks>
        public void Fill(MotionState motion, double[] tables, int points)
        {
            if (motion.ConnectedSamples < 2)
            {
                Array.Clear(tables, 0, tables.Length);
                return;
            }
            var samples = _usesChangePoints ? motion.SamplesOfOneMotion : motion.ConnectedSamples;
            var speed = samples == 1 && !motion.ChangePoints.SpeedIncreased ? SpeedRatioAfterStop * motion.Speed : motion.Speed;
            FillLine(tables, Line * ForecastTable.Points, points, speed);
            for (int i = 0, start = First * ForecastTable.Points; i < _mixed.Length; i++, start += ForecastTable.Points)
            {
                var forecaster = _mixed[i].Forecaster;
                // With two samples all forecasts are the same line. They must not differ by rounding, which would decide between equal errors.
                if (samples > 2 && samples >= forecaster.Samples && forecaster.Solve(motion)) forecaster.Fill(tables, start, points);
                else FillLine(tables, start, points, speed);
            }
        }

        static void FillLine(double[] tables, int start, int points, double speed)
        {
            for (var i = 0; i < points; i++) tables[start + i] = i * speed * ForecastTable.Step;
        }

        double[] Weights(Func<MixedForecaster, double> weightOf)
        {
            var weights = new double[Count];
            weights[Line] = 1;
            for (var i = 0; i < _mixed.Length; i++)
            {
                weights[First + i] = weightOf(_mixed[i]);
                weights[Line] -= weights[First + i];
            }
            return weights;
        }
    }
}
