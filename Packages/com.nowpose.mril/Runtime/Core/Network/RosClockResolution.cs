using System;

namespace Nowpose.Network
{
    /// <summary>Estimates the resolution of a ROS clock from its responses, because ROS does not report it. Not thread-safe.</summary>
    /// <remarks>
    /// A simulated clock advances in whole steps, so every response is a multiple of the step. It returns the time of the newest message on
    /// /clock, so it stands still between messages. The larger of step and standstill is its resolution. The responses of a wall clock
    /// have no common divisor and never repeat. Only responses in quick succession show the length of a standstill, so it is measured
    /// at intervals (<see cref="IsMeasuring"/>); the value includes the previous measurement.
    /// </remarks>
    sealed class RosClockResolution
    {
        /// <summary>Minimum number of responses in a measurement. With this many, a common divisor larger than the step is very unlikely.</summary>
        const int MinAnswers = 16;

        /// <summary>Minimum number of changes in a measurement: one complete standstill lies between the first two changes.</summary>
        const int MinChanges = 2;

        static readonly TimeSpan MeasuredEvery = new TimeSpan(20 * TimeSpan.TicksPerSecond);

        /// <summary>Maximum standstill of a running clock. After a longer standstill, it counts as stopped, as in a paused simulation.</summary>
        static readonly TimeSpan MaxStandstill = new TimeSpan(TimeSpan.TicksPerSecond);

        long _step = TimeSpan.TicksPerSecond;
        ControlTime? _shown;
        HeadsetTime _sentLast, _sentBefore, _firstArrived, _measured;
        TimeSpan _still, _maxStill, _previousMaxStill;
        int _answers, _changes;

        /// <summary>Whether a measurement was completed.</summary>
        public bool IsKnown { get; private set; }

        /// <summary>Whether the next exchanges should follow in quick succession.</summary>
        public bool IsMeasuring { get; private set; } = true;

        /// <summary>Whether the clock has shown the same time for more than a second.</summary>
        public bool IsStopped => _still > MaxStandstill;

        public TimeSpan Value => Max(Max(new TimeSpan(_step), CoarseStill), Max(_maxStill, _previousMaxStill));

        // A stopped clock gives no information about its resolution.
        TimeSpan CoarseStill => IsStopped ? TimeSpan.Zero : _still;

        /// <param name="sent">Time of the request.</param>
        /// <param name="arrived">Arrival time of the response.</param>
        public void Add(ControlTime time, HeadsetTime sent, HeadsetTime arrived)
        {
            if (!IsMeasuring && arrived - _measured >= MeasuredEvery) BeginMeasurement();
            _answers++;
            _step = GreatestCommonDivisor(_step, Math.Abs(time.SinceEpoch.Ticks));
            // The first reading precedes its response's arrival, and this reading follows this request, so the clock stood still in between.
            if (time == _shown) _still = sent - _firstArrived;
            else Change(time, arrived);
            _sentLast = sent;
            if (!IsMeasuring || _answers < MinAnswers || _changes < MinChanges) return;
            IsMeasuring = false;
            IsKnown = true;
            _measured = arrived;
        }

        void BeginMeasurement()
        {
            IsMeasuring = true;
            _answers = _changes = 0;
            _previousMaxStill = _maxStill;
            _maxStill = TimeSpan.Zero;
        }

        void Change(ControlTime time, HeadsetTime arrived)
        {
            if (_shown is { } shown)
            {
                _changes++;
                _maxStill = Max(_maxStill, Max(CoarseStill, LengthOfStandstill(time - shown, arrived)));
            }
            _shown = time;
            _still = TimeSpan.Zero;
            _sentBefore = _sentLast;
            _firstArrived = arrived;
        }

        // The observed standstill is a lower bound. If the responses follow in quick succession, the advance of the clock is the length of the
        // standstill. An underestimate would make the error bound too small.
        TimeSpan LengthOfStandstill(TimeSpan advance, HeadsetTime arrived)
        {
            if (_still <= TimeSpan.Zero || IsStopped || arrived - _sentLast > _still) return TimeSpan.Zero;
            return Min(Min(advance, arrived - _sentBefore), MaxStandstill);
        }

        static TimeSpan Min(TimeSpan a, TimeSpan b) => a < b ? a : b;
        static TimeSpan Max(TimeSpan a, TimeSpan b) => a > b ? a : b;

        static long GreatestCommonDivisor(long a, long b)
        {
            while (b != 0) (a, b) = (b, a % b);
            return a;
        }
    }
}
