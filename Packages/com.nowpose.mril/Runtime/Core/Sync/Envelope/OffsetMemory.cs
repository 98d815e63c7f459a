using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Detects that the estimate has moved away from the extrapolation of an earlier estimate by more than the error of the estimate, which
    /// indicates a change of the path that is too small or too slow to be recognised. One of the two estimates is wrong by about that
    /// amount, so the estimated error increases by the same amount until the estimate restarts. Allocates nothing after construction.
    /// </summary>
    sealed class OffsetMemory
    {
        /// <summary>
        /// Interval: interval between stored estimates, s. Age: age of the stored estimate with which the current estimate is compared, s.
        /// </summary>
        const double Interval = 10, Age = 30;

        const int Capacity = (int)(Age / Interval) + 1;

        /// <summary>Minimum time from the first exchange to the first stored estimate, s. Before this time, the skew is too uncertain.</summary>
        const double MinRunning = 60;

        /// <summary>
        /// Minimum movement in standard errors of the offset. With a smaller value, the error would increase even if the path does not change.
        /// </summary>
        const double MinStandardErrors = 2;

        /// <summary>Change of the skew within the comparison interval that is not counted as a movement, dimensionless.</summary>
        const double SkewWander = 1e-6;

        readonly ClockLine[] _lines = new ClockLine[Capacity];
        readonly double[] _errors = new double[Capacity];
        int _count;

        /// <summary>Additional standard error of the offset, s.</summary>
        public double Error { get; private set; }

        public void Reset()
        {
            _count = 0;
            Error = 0;
        }

        /// <summary>
        /// Reports that a change of the path was recognised and corrected. This change explains the recent movement of the estimate. Only the oldest
        /// stored estimate is kept; the comparison with it shows any remaining movement.
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
