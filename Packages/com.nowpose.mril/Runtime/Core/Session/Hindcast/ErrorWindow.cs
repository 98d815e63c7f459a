using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Errors of one quantity over the last ten seconds, in steps of one second. Allocates nothing after construction.</summary>
    sealed class ErrorWindow
    {
        const int Seconds = 10;

        readonly Slot[] _slots = new Slot[Seconds];
        readonly ErrorSums[] _batches = new ErrorSums[Seconds];
        readonly ErrorHistogram _displayed = new ErrorHistogram();
        readonly ErrorHistogram _held = new ErrorHistogram();

        public ErrorWindow()
        {
            for (var i = 0; i < Seconds; i++) _slots[i] = new Slot();
        }

        public void Add(ControlTime at, in ErrorSample sample)
        {
            var second = SecondOf(at);
            var slot = _slots[(int)(((second % Seconds) + Seconds) % Seconds)];
            if (slot.Sums.Count > 0 && slot.Second > second) return;
            if (slot.Second != second) slot.Begin(second);
            slot.Add(sample);
        }

        /// <returns>Null without a sample in the ten seconds before <paramref name="now"/>.</returns>
        public DisplayedError? Read(ControlTime now)
        {
            var oldest = SecondOf(now) - Seconds + 1;
            var (sums, batches) = (default(ErrorSums), 0);
            _displayed.Clear();
            _held.Clear();
            foreach (var slot in _slots)
            {
                if (slot.Second < oldest || slot.Sums.Count == 0) continue;
                sums.Add(slot.Sums);
                _batches[batches++] = slot.Sums;
                _displayed.Add(slot.Displayed);
                _held.Add(slot.Held);
            }
            return sums.Count == 0 ? (DisplayedError?)null : ErrorRun.Of(sums, _displayed, _held, _batches.AsSpan(0, batches));
        }

        public void Reset()
        {
            foreach (var slot in _slots) slot.Begin(long.MinValue);
        }

        static long SecondOf(ControlTime at) => (long)Math.Floor(at.SinceEpoch.Ticks / (double)TimeSpan.TicksPerSecond);

        sealed class Slot
        {
            public readonly ErrorHistogram Displayed = new ErrorHistogram();
            public readonly ErrorHistogram Held = new ErrorHistogram();
            public ErrorSums Sums;

            public long Second { get; private set; }

            public void Begin(long second)
            {
                Second = second;
                Sums = default;
                Displayed.Clear();
                Held.Clear();
            }

            public void Add(in ErrorSample sample)
            {
                Sums.Add(sample);
                Displayed.Add(sample.DisplayedSquared);
                Held.Add(sample.HeldSquared);
            }
        }
    }
}
