using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Mixing;

namespace Nowpose.Frames
{
    /// <summary>The forecasts of a <see cref="VectorMixture"/>: hold, a line, and weighted sums of the newest samples.</summary>
    /// <remarks>Forecasts are relative to the newest sample. Allocates nothing after construction.</remarks>
    sealed class VectorForecasts
    {
        public const int Hold = 0, Line = 1;

        const int First = Line + 1;

        readonly BodyPart _part;
        readonly PositionWeights[] _forecasters;

        // The newest samples relative to the newest one.
        readonly Vector3D[] _vectors;

        // One bit per forecaster that has enough samples of the present motion. A line replaces the others.
        uint _usable;

        /// <param name="forecasters">Result of <see cref="NewForecasters"/>.</param>
        public VectorForecasts(BodyPart part, PositionWeights[] forecasters)
        {
            (_part, _forecasters) = (part, forecasters);
            _vectors = new Vector3D[SamplesOf(forecasters)];
        }

        /// <summary>Velocity of the line, m/s or rad/s. It is zero for a single sample and after a jump, and reduced after an abrupt stop.</summary>
        public Vector3D LineSpeed { get; private set; }

        /// <summary>
        /// Creates the forecasters of a mixture in addition to hold and line. The Gaussian process has the rest of the prior. Polynomials with a history
        /// longer than their degree are least-squares fits, which reduce noise.
        /// </summary>
        public static PositionWeights[] NewForecasters() => new PositionWeights[]
        {
            new GaussianProcess(), new PolynomialWeights(2, 2), new PolynomialWeights(3, 3), new PolynomialWeights(2, 4), new PolynomialWeights(2, 9),
            new PolynomialWeights(1, 9)
        };

        /// <summary>Returns the number of newest samples that the forecasters use.</summary>
        public static int SamplesOf(PositionWeights[] forecasters)
        {
            var samples = 0;
            foreach (var forecaster in forecasters) samples = Math.Max(samples, forecaster.Samples);
            return samples;
        }

        /// <summary>Returns the weights that apply without evidence: one per forecast, with the sum 1.</summary>
        public double[] Prior()
        {
            var prior = new double[First + _forecasters.Length];
            (prior[Line], prior[First]) = (Predictors.LinePrior, 1 - Predictors.LinePrior);
            return prior;
        }

        /// <summary>Prepares the forecasts from the newest samples of one motion.</summary>
        /// <param name="changePoints">Abrupt changes of the motion. Samples before the newest change are left out.</param>
        /// <param name="hasJumped">Whether the newest sample is at another place, so that the velocity there is unknown.</param>
        public void Prepare(BodySamples samples, ChangePointDetector changePoints, bool hasJumped)
        {
            var (history, connected) = (samples.History, samples.Timing.ConnectedSamples);
            var ofOneMotion = Math.Min(connected, changePoints.SamplesSince);
            for (var age = 1; age < Math.Min(ofOneMotion, _vectors.Length); age++) _vectors[age] = history[age][_part] - history[0][_part];
            var isAfterStop = ofOneMotion == 1 && !changePoints.SpeedIncreased;
            LineSpeed = connected < 2 || hasJumped ? default
                : (history[0][_part] - history[1][_part]) * ((isAfterStop ? MixedForecasters.SpeedRatioAfterStop : 1) / samples.Timing.Interval);
            _usable = 0;
            for (var i = 0; i < _forecasters.Length; i++)
                if (_forecasters[i].Samples <= ofOneMotion && _forecasters[i].Update(history, _forecasters[i].Samples)) _usable |= 1u << i;
        }

        /// <summary>Returns one forecast.</summary>
        /// <param name="ahead">Seconds after the newest sample.</param>
        /// <param name="time">The same time as a place in a table.</param>
        public Vector3D At(int forecast, double ahead, in TableTime time)
        {
            if (forecast == Hold) return default;
            if (forecast == Line || (_usable & 1u << forecast - First) == 0) return LineSpeed * ahead;
            var (table, samples, sum) = (_forecasters[forecast - First].Table, _forecasters[forecast - First].Samples, default(Vector3D));
            // The vector of the newest sample is zero.
            for (var j = 1; j < samples; j++) sum += _vectors[j] * time.Read(table, j, samples);
            return sum;
        }

        /// <summary>Returns the weighted sum of all forecasts. Adds the weights per sample before it multiplies them by the vectors.</summary>
        /// <param name="point">Point of the table (<see cref="ForecastTable"/>).</param>
        /// <param name="line">Forecast of the line at this point.</param>
        /// <param name="values">One weight per forecast.</param>
        public Vector3D MixtureAt(int point, in Vector3D line, double[] values)
        {
            Span<double> weights = stackalloc double[_vectors.Length];
            var ofLine = values[Line];
            for (var i = 0; i < _forecasters.Length; i++)
            {
                var weight = values[First + i];
                if (weight == 0) continue;
                if ((_usable & 1u << i) == 0)
                {
                    ofLine += weight;
                    continue;
                }
                var (table, samples) = (_forecasters[i].Table, _forecasters[i].Samples);
                for (int j = 1, at = point * samples + 1; j < samples; j++, at++) weights[j] += weight * table[at];
            }
            var sum = line * ofLine;
            for (var j = 1; j < weights.Length; j++)
                if (weights[j] != 0) sum += _vectors[j] * weights[j];
            return sum;
        }
    }
}
