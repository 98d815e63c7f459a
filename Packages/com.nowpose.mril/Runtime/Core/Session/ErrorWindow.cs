using System;

namespace Nowpose.Session
{
    /// <summary>Root mean squares of two errors over the newest ten seconds, which pass in steps of one. Allocates nothing once made.</summary>
    sealed class ErrorWindow
    {
        const int Seconds = 10;

        readonly Slot[] _slots = new Slot[Seconds];

        /// <param name="displayedSquared">Square of the displayed pose's error, m².</param>
        /// <param name="heldSquared">Square of the error that the hold would have had, m².</param>
        public void Add(ControlTime at, double displayedSquared, double heldSquared)
        {
            var second = SecondOf(at);
            ref var slot = ref _slots[(int)(((second % Seconds) + Seconds) % Seconds)];
            if (slot.Count > 0 && slot.Second > second) return;
            if (slot.Second != second) slot = new Slot { Second = second };
            slot.Count++;
            slot.Displayed += displayedSquared;
            slot.Held += heldSquared;
        }

        /// <returns>False when nothing was added within ten seconds before <paramref name="now"/>.</returns>
        public bool TryRead(ControlTime now, out double displayedMetres, out double heldMetres)
        {
            var oldest = SecondOf(now) - Seconds + 1;
            var sum = default(Slot);
            foreach (ref readonly var slot in _slots.AsSpan())
            {
                if (slot.Second < oldest) continue;
                sum.Count += slot.Count;
                sum.Displayed += slot.Displayed;
                sum.Held += slot.Held;
            }
            displayedMetres = Math.Sqrt(sum.Displayed / Math.Max(1, sum.Count));
            heldMetres = Math.Sqrt(sum.Held / Math.Max(1, sum.Count));
            return sum.Count > 0;
        }

        public void Reset() => Array.Clear(_slots, 0, _slots.Length);

        static long SecondOf(ControlTime at) => (long)Math.Floor(at.SinceEpoch.Ticks / (double)TimeSpan.TicksPerSecond);

        struct Slot
        {
            public long Second;
            public int Count;
            public double Displayed, Held;
        }
    }
}
