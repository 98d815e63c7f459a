using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction
{
    /// <summary>
    /// The way from samples to sections, which is the same for a joint and an object: orders and prepares the samples, solves a forecaster for each of their
    /// motions, and reads the curve through the samples or the forecast after them.
    /// </summary>
    /// <remarks>A joint has one motion; an object has two, its position and its angles.</remarks>
    sealed class PredictionPipeline<TSample> where TSample : struct, ISample<TSample>
    {
        readonly PredictionLimits _limits;
        readonly ArrivalOrder<TSample> _arrivals;
        readonly SampleBuffer<TSample> _buffer;
        readonly Forecaster[] _forecasters;
        readonly MotionState[] _motions;
        readonly int _components;
        readonly bool _interpolates;

        bool _isSolved;

        /// <param name="forecasters">One forecaster per motion, each of this joint or object only. The motions have equally many components.</param>
        /// <param name="checks">Check of the positions of each motion; null to use all samples.</param>
        /// <param name="interpolates">
        /// Whether positions before the newest sample are interpolated. Otherwise, they are those of the forecaster, as in the paper.
        /// </param>
        public PredictionPipeline(
            SampleBuffer<TSample> buffer, Forecaster[] forecasters, PositionCheck[] checks, PredictionLimits limits, bool interpolates)
        {
            (_buffer, _forecasters, _limits, _interpolates) = (buffer, forecasters, limits, interpolates);
            _arrivals = new ArrivalOrder<TSample>(limits.IsEndless);
            _components = default(TSample).Components / forecasters.Length;
            _motions = new MotionState[forecasters.Length];
            for (var i = 0; i < _motions.Length; i++)
                _motions[i] = new MotionState(_components, i * _components, buffer.Capacity, buffer.Timing, checks?[i]);
        }

        /// <summary>Whether no sample has been added.</summary>
        public bool IsEmpty => double.IsNegativeInfinity(NewestTime);

        /// <summary>The newest sample, even if it is left out; <c>default</c> before the first.</summary>
        public TSample Newest => _buffer.Newest;

        /// <inheritdoc cref="SampleBuffer{TSample}.NewestStamp"/>
        public double NewestStamp => _buffer.NewestStamp;

        /// <summary>Corrected time of the newest sample in use, in s; negative infinity before the first.</summary>
        public double NewestTime => _motions[0].NewestTime;

        /// <summary>Time after the newest sample from which on positions are held, s.</summary>
        public double MaxAhead => Math.Min(_limits.HorizonCap, _forecasters[0].Span);

        public SampleTiming Timing => _buffer.Timing;

        /// <inheritdoc cref="ArrivalOrder{TSample}.IsNewestStampWrong"/>
        public bool IsNewestStampWrong => _arrivals.IsNewestStampWrong;

        /// <summary>Number of times that the samples showed that their clock went back.</summary>
        public int Restarts => _arrivals.Restarts;

        /// <summary>Samples to use now (<see cref="ArrivalOrder{TSample}.Ready"/>).</summary>
        public ReadOnlySpan<TSample> Ready => _arrivals.Ready;

        /// <summary>State of one motion after the newest sample.</summary>
        public MotionState MotionOf(int index) => _motions[index];

        /// <inheritdoc cref="SampleBuffer{TSample}.HasNewestOrder"/>
        public bool HasNewestOrder(in TSample sample) => _buffer.HasNewestOrder(sample);

        /// <summary>
        /// Puts a received sample into order. It may be ready now or later. If the clock went back, all earlier samples are discarded; if only the newest stamp
        /// was wrong, its sample is discarded.
        /// </summary>
        /// <param name="hasRestarted">Whether the clock went back.</param>
        public DropReason Receive(in TSample sample, out bool hasRestarted)
        {
            var restarts = Restarts;
            // The oldest sample is not in the processor's cache, and only late samples are compared with it.
            var reason = _arrivals.Add(sample, _buffer.HasNewestOrder(sample) ? double.NegativeInfinity : _buffer.OldestOrder);
            hasRestarted = Restarts != restarts;
            if (hasRestarted) Restart();
            else if (IsNewestStampWrong && _buffer.RemoveNewest(after: Ready[0].Order))
                foreach (var motion in _motions) motion.ForgetNewest();
            return reason;
        }

        /// <summary>
        /// Prepares for adding a sample that is ready. Products of displacements as large as that of a far sample can overflow: if the sample is the
        /// newest, all earlier samples are discarded, and a late one cannot be added.
        /// </summary>
        /// <returns>Whether the sample can be added.</returns>
        public bool Admit(in TSample sample)
        {
            var isNear = true;
            for (var c = 0; c < sample.Components; c++) isNear &= Math.Abs(sample[c] - Newest[c]) < JointSample.MaxMagnitude;
            if (!isNear && HasNewestOrder(sample)) Restart();
            return isNear || IsEmpty;
        }

        /// <summary>Adds a sample for which <see cref="Admit"/> returned true.</summary>
        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        /// <returns>Whether the section has changed.</returns>
        public bool Add(in TSample sample, double displayed)
        {
            if (!_buffer.Add(sample, displayed)) return false;
            _isSolved = true;
            var hasJumped = false;
            for (var i = 0; i < _motions.Length; i++)
            {
                // If the position jumps, the object is elsewhere. A tracker may confuse two rotations although the position is right.
                _motions[i].Take(_buffer, hasJumped);
                _isSolved &= _forecasters[i].Solve(_motions[i]);
                hasJumped |= _motions[i].HasJumped;
            }
            return true;
        }

        /// <summary>Returns the place of a time in the section. Does not change the state.</summary>
        public SectionPlace PlaceOf(double time)
        {
            if (IsEmpty) return default;
            var (ahead, motion) = (time - NewestTime, _motions[0]);
            if (IsOnCurve(ahead))
            {
                var first = motion.Times[motion.Count - 1];
                return ahead < first ? new SectionPlace(PredictionKind.Held, first) : new SectionPlace(PredictionKind.Interpolated, ahead);
            }
            if (!_isSolved || double.IsNaN(time)) return new SectionPlace(PredictionKind.Held, double.NaN);
            if (ahead > MaxAhead) return new SectionPlace(PredictionKind.Held, MaxAhead);
            if (double.IsInfinity(ahead)) return new SectionPlace(PredictionKind.Held, double.NaN);
            // The paper's polynomials are used before their newest sample too. A section is as inaccurate before its oldest sample as it is far beyond
            // its newest sample, so its value at the oldest sample is held. Without a horizon cap, as in the paper, neither is limited.
            if (ahead < 0 && !double.IsPositiveInfinity(_limits.HorizonCap))
            {
                var start = _buffer.StartOf(Math.Min(Timing.ConnectedSamples, _forecasters[0].UsedSamples));
                if (ahead < start) return new SectionPlace(PredictionKind.Held, start);
            }
            if (ahead <= 0) return new SectionPlace(PredictionKind.Interpolated, ahead);
            // One motion of an object may jump while the other continues.
            foreach (var one in _motions)
                if (one.HasJumped) return new SectionPlace(PredictionKind.Held, ahead);
            return new SectionPlace(PredictionKind.Predicted, ahead);
        }

        /// <summary>Returns one component of a motion at a place of the section.</summary>
        public double At(in SectionPlace place, int motion, int component)
        {
            var newest = _motions[motion].Newest[component];
            if (IsOnCurve(place.Ahead)) return newest + new SampleCurve(_motions[motion], component).At(place.Ahead);
            if (double.IsNaN(place.Ahead)) return newest;
            var position = newest + _forecasters[motion].At(place.Ahead, component);
            // An overflow must not reach a transform.
            return double.IsFinite(position) ? position : newest;
        }

        /// <summary>Returns the standard deviation of one component at a given time; NaN where it is unknown.</summary>
        public double DeviationAt(double time)
        {
            var ahead = time - NewestTime;
            return _isSolved && ahead >= 0 && ahead <= _limits.HorizonCap ? _forecasters[0].DeviationAt(ahead) : double.NaN;
        }

        /// <summary>Discards everything.</summary>
        public void Reset()
        {
            _arrivals.Clear();
            Restart();
        }

        bool IsOnCurve(double ahead) => _interpolates && ahead <= 0 && _motions[0].Count > 1;

        // Keeps the order of arrivals.
        void Restart()
        {
            _buffer.Clear();
            _isSolved = false;
            for (var i = 0; i < _motions.Length; i++)
            {
                _motions[i].Reset();
                _forecasters[i].Reset();
            }
        }
    }

    /// <summary>Place of a time in a section, up to the newest sample or after it. <c>default</c> before the first sample.</summary>
    readonly struct SectionPlace
    {
        /// <param name="kind">How the position at this time is computed.</param>
        /// <param name="ahead">Seconds after the newest sample; NaN for the newest sample itself.</param>
        public SectionPlace(PredictionKind kind, double ahead) => (Kind, Ahead) = (kind, ahead);

        public PredictionKind Kind { get; }

        public double Ahead { get; }
    }
}
