using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Finds out that the estimate has moved away from where earlier estimates lead, by more than it is known: a change of the
    /// path that was too small or too slow to be recognised. One of the two is wrong by about that much, and nothing tells which,
    /// so the estimated error grows by it until the estimate restarts. Allocates nothing.
    /// </summary>
    sealed class OffsetMemory
    {
        /// <summary>From one remembered estimate to the next, and how old the one is that the present is compared with, s.</summary>
        const double Interval = 10, Age = 30;

        const int Capacity = (int)(Age / Interval) + 1;

        /// <summary>Shortest time since the first exchange, s, after which an estimate is kept for comparison: before, its skew is too uncertain.</summary>
        const double MinRunning = 60;

        /// <summary>Standard errors beyond which a movement counts: fewer would widen the estimate of undisturbed paths.</summary>
        const double MinStandardErrors = 2;

        /// <summary>How much the rates of the clocks may change within the time, dimensionless.</summary>
        const double SkewWander = 1e-6;

        readonly ClockLine[] _lines = new ClockLine[Capacity];
        readonly double[] _errors = new double[Capacity];
        int _count;

        /// <summary>One standard error of the offset that comes from it, s.</summary>
        public double Error { get; private set; }

        public void Reset()
        {
            _count = 0;
            Error = 0;
        }

        /// <summary>
        /// A change of the path was recognised and corrected. It explains how the estimate has moved of late; what it does not explain shows in
        /// the comparison with the oldest estimate.
        /// </summary>
        public void Explain()
        {
            if (_count == 0) return;
            Error = _errors[Oldest];
            (_lines[0], _errors[0], _count) = (_lines[Oldest], Error, 1);
        }

        /// <param name="running">Time since the first exchange, s.</param>
        public void Add(in ClockLine line, double running)
        {
            if (_count > 0) Compare(line, _lines[Oldest]);
            if (running < MinRunning) return;
            if (_count > 0 && ClockTicks.Seconds(line.Reference - _lines[(_count - 1) % Capacity].Reference) < Interval) return;
            _errors[_count % Capacity] = Error;
            _lines[_count++ % Capacity] = line;
        }

        int Oldest => _count < Capacity ? 0 : _count % Capacity;

        void Compare(in ClockLine line, in ClockLine earlier)
        {
            var passed = ClockTicks.Seconds(line.Reference - earlier.Reference);
            var moved = Math.Abs(ClockTicks.Seconds(line.Offset - earlier.Offset) - earlier.Skew * passed);
            if (moved > MinStandardErrors * ClockTicks.Seconds(line.OffsetError) + SkewWander * passed) Error = Math.Max(Error, moved / 3);
        }
    }
}
