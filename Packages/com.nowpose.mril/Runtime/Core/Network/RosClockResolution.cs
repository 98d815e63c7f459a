using System;

namespace Nowpose.Network
{
    /// <summary>What the answers of a ROS clock tell of its resolution, which ROS does not say. One thread.</summary>
    /// <remarks>
    /// A simulated clock moves in whole steps, so every answer is a multiple of one; and it shows the newest message on
    /// /clock, so it stands still from one message to the next. The greater of both is its resolution. A wall clock's answers have
    /// nothing in common, and none is the same as the one before. Only answers in quick succession show how long a clock stands
    /// still, so it is measured now and then (<see cref="IsMeasuring"/>); of the past, the last measurement counts.
    /// </remarks>
    sealed class RosClockResolution
    {
        /// <summary>Of a measurement. By so many answers chance has left hardly any multiple of the step.</summary>
        const int FewestAnswers = 16;

        /// <summary>Between the first two changes lies one whole standstill.</summary>
        const int FewestChanges = 2;

        static readonly TimeSpan MeasuredEvery = new TimeSpan(20 * TimeSpan.TicksPerSecond);

        /// <summary>A clock that stands still for longer is stopped, not coarse: a simulation that is paused.</summary>
        static readonly TimeSpan Longest = new TimeSpan(TimeSpan.TicksPerSecond);

        long _step = TimeSpan.TicksPerSecond;
        ControlTime? _shown;
        HeadsetTime _sentLast, _sentBefore, _firstArrived, _measured;
        TimeSpan _still, _longestStill, _longestStillBefore;
        int _answers, _changes;

        /// <summary>Whether it has been measured once.</summary>
        public bool IsKnown { get; private set; }

        /// <summary>Whether the next answers are wanted in quick succession.</summary>
        public bool IsMeasuring { get; private set; } = true;

        /// <summary>Whether the clock has shown the same time for more than a second.</summary>
        public bool IsStopped => _still > Longest;

        public TimeSpan Value => Greatest(Greatest(new TimeSpan(_step), CoarseStill), Greatest(_longestStill, _longestStillBefore));

        // A stop says nothing about how coarse the clock is.
        TimeSpan CoarseStill => IsStopped ? TimeSpan.Zero : _still;

        /// <param name="sent">When it was asked for.</param>
        /// <param name="arrived">When the answer was there.</param>
        public void Add(ControlTime time, HeadsetTime sent, HeadsetTime arrived)
        {
            if (!IsMeasuring && arrived - _measured >= MeasuredEvery) BeginMeasurement();
            _answers++;
            _step = GreatestCommonDivisor(_step, Math.Abs(time.SinceEpoch.Ticks));
            // Read after the earlier answer was there, and before this one was: it stood still for at least as long.
            if (time == _shown) _still = sent - _firstArrived;
            else Change(time, arrived);
            _sentLast = sent;
            if (!IsMeasuring || _answers < FewestAnswers || _changes < FewestChanges) return;
            IsMeasuring = false;
            IsKnown = true;
            _measured = arrived;
        }

        void BeginMeasurement()
        {
            IsMeasuring = true;
            _answers = _changes = 0;
            _longestStillBefore = _longestStill;
            _longestStill = TimeSpan.Zero;
        }

        void Change(ControlTime time, HeadsetTime arrived)
        {
            if (_shown is { } shown)
            {
                _changes++;
                _longestStill = Greatest(_longestStill, Greatest(CoarseStill, LengthOfStandstill(time - shown, arrived)));
            }
            _shown = time;
            _still = TimeSpan.Zero;
            _sentBefore = _sentLast;
            _firstArrived = arrived;
        }

        // It was seen to stand for less than it stood: by how much it goes on tells the length, where the answers come quickly enough.
        // Said too small, it would be believed to the tick.
        TimeSpan LengthOfStandstill(TimeSpan advance, HeadsetTime arrived)
        {
            if (_still <= TimeSpan.Zero || IsStopped || arrived - _sentLast > _still) return TimeSpan.Zero;
            return Least(Least(advance, arrived - _sentBefore), Longest);
        }

        static TimeSpan Least(TimeSpan a, TimeSpan b) => a < b ? a : b;
        static TimeSpan Greatest(TimeSpan a, TimeSpan b) => a > b ? a : b;

        static long GreatestCommonDivisor(long a, long b)
        {
            while (b != 0) (a, b) = (b, a % b);
            return a;
        }
    }
}
