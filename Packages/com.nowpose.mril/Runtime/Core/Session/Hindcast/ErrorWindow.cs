using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Errors of one quantity over the last ten seconds, in steps of one second. Allocates nothing after construction.</summary>
    sealed class ErrorWindow
    {
        const int Seconds = 10;

        readonly ErrorTotals[] _slots = new ErrorTotals[Seconds];
        readonly long[] _secondOfSlot = new long[Seconds];
        readonly ErrorSums[] _batches = new ErrorSums[Seconds];
        readonly ErrorTotals _totals = new ErrorTotals();

        public ErrorWindow()
        {
            for (var i = 0; i < Seconds; i++) _slots[i] = new ErrorTotals();
        }

        /// <returns>Whether the errors are plausible. If not, they are ignored.</returns>
        public bool Add(ControlTime at, in ErrorSums frame)
        {
            if (!frame.IsPlausible) return false;
            var second = SecondOf(at);
            var index = (int)(((second % Seconds) + Seconds) % Seconds);
            if (_slots[index].Sums.Count > 0 && _secondOfSlot[index] > second) return true;
            if (_secondOfSlot[index] != second) _slots[index].Clear();
            _secondOfSlot[index] = second;
            _slots[index].Add(frame);
            return true;
        }

        /// <returns>Null without a frame in the ten seconds before <paramref name="now"/>.</returns>
        public DisplayedError? Read(ControlTime now)
        {
            var oldest = SecondOf(now) - Seconds + 1;
            var batches = 0;
            _totals.Clear();
            for (var i = 0; i < Seconds; i++)
            {
                if (_secondOfSlot[i] < oldest || _slots[i].Sums.Count == 0) continue;
                _totals.Add(_slots[i]);
                _batches[batches++] = _slots[i].Sums;
            }
            return _totals.Read(_batches.AsSpan(0, batches));
        }

        public void Reset()
        {
            foreach (var slot in _slots) slot.Clear();
        }

        static long SecondOf(ControlTime at) => (long)Math.Floor(at.SinceEpoch.Ticks / (double)TimeSpan.TicksPerSecond);
    }
}
