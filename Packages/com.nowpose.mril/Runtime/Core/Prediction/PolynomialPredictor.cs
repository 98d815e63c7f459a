using System;

namespace Nowpose.Prediction
{
    /// <summary>
    /// Section-wise polynomials of Schnierle &amp; Röck 2022, Eq. (8): interpolating for h = n, least squares for h &gt; n.
    /// </summary>
    /// <remarks>
    /// A section is solved once when a sample counts and only evaluated per frame. Fewer than h + 1 samples, or stamps
    /// that coincide, are met by the highest degree they determine; a single sample is held.
    /// </remarks>
    public sealed class PolynomialPredictor : IJointPredictor
    {
        const int HighestDegree = 3;

        /// <summary>Greatest h.</summary>
        public const int LongestHistory = 100;

        readonly PredictionLimits _limits;
        readonly SampleHistory _history;
        readonly PolynomialSection _section;

        /// <param name="degree">n, 1 to 3.</param>
        /// <param name="history">h, the samples used besides the newest one; n to 100.</param>
        /// <param name="limits">Bounds of time and position.</param>
        /// <exception cref="ArgumentOutOfRangeException">Degree or history is outside its range.</exception>
        public PolynomialPredictor(int degree, int history, PredictionLimits limits)
        {
            if (degree < 1 || degree > HighestDegree)
                throw new ArgumentOutOfRangeException(nameof(degree), degree, "1 to " + HighestDegree);
            if (history < degree || history > LongestHistory)
                throw new ArgumentOutOfRangeException(nameof(history), history, "from the degree to " + LongestHistory);

            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
            _history = new SampleHistory(history + 1);
            _section = new PolynomialSection(degree, history + 1);
        }

        /// <inheritdoc/>
        public double Hold => _history.NewestPosition;

        /// <inheritdoc/>
        public double NewestTime => _history.NewestTime;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var outcome = _history.Add(sample);
            if (outcome == SampleOutcome.Accepted || outcome == SampleOutcome.Late)
                _section.Solve(_history, _history.CountWithoutGap(_limits.MaximumGap));
            return outcome;
        }

        /// <inheritdoc/>
        public JointPrediction At(double time)
        {
            if (_history.Count == 0) return default;
            ref readonly var newest = ref _history[0];
            var ahead = time - newest.Time;
            var kind = ahead <= 0 ? PredictionKind.Interpolated : PredictionKind.Predicted;
            if (ahead > _limits.HorizonCap)
            {
                ahead = _limits.HorizonCap;
                kind = PredictionKind.Held;
            }
            // Before its oldest sample a section extrapolates as wildly as after its newest one.
            else if (ahead < _section.Oldest && !double.IsPositiveInfinity(_limits.HorizonCap))
            {
                ahead = _section.Oldest;
                kind = PredictionKind.Held;
            }
            var position = newest.Position + _section.At(ahead);
            // Absurd samples overflow and an absurd time has no answer: neither may reach a transform.
            if (!double.IsFinite(position)) position = newest.Position;
            else if (_section.Degree > 0) return new JointPrediction(_limits.Clamp(position), kind);
            return new JointPrediction(_limits.Clamp(position), PredictionKind.Held);
        }

        /// <inheritdoc/>
        public void Reset() => _history.Clear();
    }
}
