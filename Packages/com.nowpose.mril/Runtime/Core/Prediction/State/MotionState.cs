using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.State
{
    /// <summary>
    /// The newest samples of a motion relative to the newest one, its velocity, and whether it rests: the input of all forecasters. A joint's
    /// position has one component; the position and the angles of an object are two motions with three components each.
    /// </summary>
    /// <remarks>The components of a sample are adjacent in all arrays.</remarks>
    sealed class MotionState
    {
        /// <summary>
        /// Maximum displacement between two samples that repeat, relative to that at the maximum speed: the first samples of a move exceed it. With
        /// 1e-3, the errors of simulated motions are 0.6 % larger.
        /// </summary>
        const double StillRatio = 1e-4;

        readonly int _first, _capacity;

        // Null if all samples are used.
        readonly PositionCheck _check;

        // Time of the newest sample that was left out because its position is wrong, in s. Earlier ones are used again: if all were left out, the errors
        // with frequent wrong samples would be 1 % larger.
        double _wrongTime = double.NaN;

        bool _wasNewestForgotten;

        // Number of samples since the newest jump, including the sample after it, and the number before the newest sample; int.MaxValue if there is
        // no jump since the last gap.
        int _sinceJump, _sinceJumpBefore;

        /// <param name="first">Index of the first component in the samples.</param>
        /// <param name="capacity">Maximum number of samples that are used: three show both velocities.</param>
        /// <param name="timing">Timing of the samples, which the motions of an object share.</param>
        /// <param name="check">Check of the positions of this motion; null to use all samples.</param>
        public MotionState(int components, int first, int capacity, SampleTiming timing, PositionCheck check = null)
        {
            (Components, _first, _capacity, Timing, _check) = (components, first, capacity, timing, check);
            (Newest, Velocity, VelocityBefore) = (new double[components], new double[components], new double[components]);
            (Times, Displacements) = (new double[capacity], new double[capacity * components]);
            Reset();
        }

        public int Components { get; }

        /// <summary>Intervals of the samples, and the prediction horizon.</summary>
        public SampleTiming Timing { get; }

        /// <inheritdoc cref="SampleBuffer{TSample}.IsNewest"/>
        public bool IsNewest { get; private set; }

        /// <summary>Time of the newest sample, in s; negative infinity if there is none.</summary>
        public double NewestTime { get; private set; }

        /// <summary>Position of the newest sample, in rad or m.</summary>
        public double[] Newest { get; }

        /// <summary>
        /// Time from the previous to the newest sample, in s; 0 for the first sample and after a gap. Longer than <see cref="SampleTiming.Interval"/>
        /// after a wrong sample that was left out.
        /// </summary>
        public double Interval => Count > 1 ? -Times[1] : 0;

        /// <summary>Time of the sample before the newest, in s; that of the newest for the first sample and after a gap.</summary>
        public double PreviousTime => NewestTime - Interval;

        /// <summary>Number of newest samples without a gap that are stored here.</summary>
        public int Count { get; private set; }

        /// <summary>Number of newest samples without a gap or a jump.</summary>
        public int Connected => Math.Min(Count, _sinceJump);

        /// <summary>Times of the samples relative to the newest one, newest first, in s; not positive.</summary>
        public double[] Times { get; }

        /// <summary>Positions of the samples relative to the newest one, newest first, in rad or m.</summary>
        public double[] Displacements { get; }

        /// <summary>Returns the time of the sample with this age, in s.</summary>
        public double TimeAt(int age) => NewestTime + Times[age];

        /// <summary>Returns a component of the position of the sample with this age, in rad or m.</summary>
        public double PositionAt(int age, int component) => Newest[component] + Displacements[age * Components + component];

        /// <summary>Returns the distance of the sample with this age from the sample before it, in rad or m.</summary>
        public double DistanceFromPrevious(int age) =>
            Vectors.Distance(Displacements, age * Components, Displacements, (age + 1) * Components, Components);

        /// <summary>Mean velocity in the interval before the newest sample, per second; 0 until there are two samples.</summary>
        public double[] Velocity { get; }

        /// <summary>Mean velocity in the interval before that of <see cref="Velocity"/>, per second; 0 until there are three samples.</summary>
        public double[] VelocityBefore { get; }

        /// <summary>Magnitude of <see cref="Velocity"/>.</summary>
        public double Speed => Vectors.Length(Velocity);

        /// <inheritdoc cref="PositionCheck.KnownSpeed"/>
        public double KnownSpeed => _check?.KnownSpeed(this) ?? Speed;

        /// <summary>
        /// Maximum speed that was reached in both of two consecutive intervals in the same direction, per second; 0 before there are two such
        /// intervals. One interval is not enough, because an object that is moved elsewhere, or an angle that wraps from π to −π, can have any speed
        /// in a single interval.
        /// </summary>
        public double MaxSpeed { get; private set; }

        /// <summary>
        /// Whether the newest sample shows that the one before it was wrong: its position (<see cref="PositionCheck.IsPreviousWrong"/>), or its
        /// stamp, which was in the future. It is left out until another one is wrong, so that all velocities are those of the other samples: it would
        /// reappear in a forecast whenever the motion repeats. Counts of samples return to their values before it, and the forecasts from it are dropped.
        /// </summary>
        public bool IsPreviousWrong { get; private set; }

        /// <summary>Whether the newest position is right, and the displacement to it a velocity.</summary>
        public PositionVerdict Verdict { get; private set; }

        /// <inheritdoc cref="PositionVerdict.Unconfirmed"/>
        public bool IsUnconfirmed => Verdict == PositionVerdict.Unconfirmed;

        /// <inheritdoc cref="PositionVerdict.Jumped"/>
        public bool HasJumped => Verdict == PositionVerdict.Jumped;

        /// <summary>Velocity and acceleration that the source reported with the newest sample; NaN if it did not.</summary>
        public double ReportedVelocity { get; private set; }

        /// <inheritdoc cref="ReportedVelocity"/>
        public double ReportedAcceleration { get; private set; }

        /// <summary>Displacement in the newest interval at the maximum speed, in the samples' unit.</summary>
        public double MaxDisplacement => MaxSpeed * Interval;

        /// <summary>
        /// Whether the newest sample repeats the one before it, at a rest of a source without noise: their distance is at most
        /// <see cref="StillDistance"/>. The next sample may be the start of a move, so gates have separate scores for forecasts from such a rest, and
        /// template matching, braking and profiles begin a new move after it.
        /// </summary>
        public bool IsStill => StillSamples > 0;

        /// <summary>Number of newest samples that repeat the one before them.</summary>
        public int StillSamples { get; private set; }

        /// <summary>Maximum displacement between two samples that repeat, in the samples' unit.</summary>
        public double StillDistance { get; private set; }

        /// <summary>Returns the persistence of the motion (<see cref="Vectors.Persistence"/>), from all samples.</summary>
        public double MeasurePersistence() => Vectors.Persistence(Displacements, Count, Components);

        /// <summary>Takes the samples of a buffer that has added a sample.</summary>
        /// <param name="hasOtherMotionJumped">See <see cref="PositionCheck.Examine"/>.</param>
        public void Take<TSample>(SampleBuffer<TSample> buffer, bool hasOtherMotionJumped = false) where TSample : struct, ISample<TSample>
        {
            IsNewest = buffer.IsNewest;
            Read(buffer);
            IsPreviousWrong = IsNewest && _wasNewestForgotten;
            if (!IsNewest) return;
            _wasNewestForgotten = false;
            var (product, speed) = (Vectors.Dot(Velocity, VelocityBefore), Math.Min(Speed, Vectors.Length(VelocityBefore)));
            if (product > 0) MaxSpeed = Math.Max(MaxSpeed, speed);
            if (product < 0 && _check != null && PositionCheck.IsPreviousWrong(this, speed))
            {
                (IsPreviousWrong, _wrongTime) = (true, buffer[1].Time);
                Read(buffer);
            }
            StillDistance = StillRatio * MaxDisplacement;
            StillSamples = Count > 1 && DistanceFromPrevious(0) <= StillDistance ? Math.Min(StillSamples, int.MaxValue - 1) + 1 : 0;
            if (_check != null) Examine(hasOtherMotionJumped);
        }

        /// <summary>Counts the newest sample as wrong when the next one is taken, because its stamp is wrong and the buffer has removed it.</summary>
        public void ForgetNewest() => _wasNewestForgotten = true;

        public void Reset()
        {
            Count = 0;
            NewestTime = double.NegativeInfinity;
            Array.Clear(Newest, 0, Components);
            Array.Clear(Velocity, 0, Components);
            Array.Clear(VelocityBefore, 0, Components);
            MaxSpeed = StillDistance = 0;
            StillSamples = 0;
            (_wrongTime, IsPreviousWrong, _wasNewestForgotten) = (double.NaN, false, false);
            ForgetJumps();
        }

        void Read<TSample>(SampleBuffer<TSample> buffer) where TSample : struct, ISample<TSample>
        {
            // A copy, because the compiler would copy the sample at each access through a read-only reference.
            var newest = buffer[0];
            NewestTime = newest.Time;
            (ReportedVelocity, ReportedAcceleration) = (newest.Velocity, newest.Acceleration);
            for (var c = 0; c < Components; c++) Newest[c] = newest[_first + c];
            Count = Math.Min(Timing.ConnectedSamples, 1);
            for (int age = 1, at = Components; age < Timing.ConnectedSamples && Count < _capacity; age++)
            {
                var sample = buffer[age];
                if (sample.Time == _wrongTime) continue;
                Times[Count++] = sample.Time - NewestTime;
                for (var c = 0; c < Components; c++) Displacements[at++] = sample[_first + c] - Newest[c];
            }
            for (var c = 0; c < Components; c++) (Velocity[c], VelocityBefore[c]) = (VelocityAt(0, c), VelocityAt(1, c));
        }

        double VelocityAt(int age, int component) => age + 1 >= Count ? 0
            : (Displacements[age * Components + component] - Displacements[(age + 1) * Components + component]) / (Times[age] - Times[age + 1]);

        void Examine(bool hasOtherMotionJumped)
        {
            // The first displacement is not a jump, because the velocity before it is unknown.
            if (Count < 2)
            {
                ForgetJumps();
                return;
            }
            // The displacement to a wrong sample does not count as a jump.
            if (!IsPreviousWrong) _sinceJumpBefore = _sinceJump;
            Verdict = _check.Examine(this, hasOtherMotionJumped);
            _sinceJump = HasJumped ? 1 : Math.Min(_sinceJumpBefore, int.MaxValue - 1) + 1;
        }

        void ForgetJumps()
        {
            (Verdict, _sinceJump, _sinceJumpBefore) = (PositionVerdict.Right, int.MaxValue, int.MaxValue);
            _check?.Reset();
        }
    }
}
