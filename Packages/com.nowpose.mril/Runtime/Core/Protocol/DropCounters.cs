using System;
using System.Collections.Generic;
using System.Threading;

namespace Nowpose.Protocol
{
    /// <summary>Counts drops by reason. Thread-safe; counting allocates nothing.</summary>
    sealed class DropCounters
    {
        static readonly int ReasonCount = Enum.GetValues(typeof(DropReason)).Length;
        readonly long[] _counts = new long[ReasonCount];

        /// <summary>Number of drops for a reason.</summary>
        public long this[DropReason reason] => Interlocked.Read(ref _counts[(int)reason]);

        /// <summary>Number of drops for any reason.</summary>
        public long Total
        {
            get
            {
                var total = 0L;
                for (var i = 0; i < _counts.Length; i++)
                    total += Interlocked.Read(ref _counts[i]);
                return total;
            }
        }

        /// <summary>Counts one drop; ignores <see cref="DropReason.None"/>.</summary>
        public void Count(DropReason reason) => Count(reason, 1);

        /// <summary>Counts several drops for the same reason; ignores <see cref="DropReason.None"/>.</summary>
        public void Count(DropReason reason, int drops)
        {
            if (reason != DropReason.None)
                Interlocked.Add(ref _counts[(int)reason], drops);
        }

        /// <summary>Returns the reasons that occurred with their counts, in the order of the enumeration.</summary>
        public IReadOnlyList<KeyValuePair<DropReason, long>> Snapshot()
        {
            var occurred = new List<KeyValuePair<DropReason, long>>();
            for (var i = 0; i < _counts.Length; i++)
            {
                var count = Interlocked.Read(ref _counts[i]);
                if (count > 0)
                    occurred.Add(new KeyValuePair<DropReason, long>((DropReason)i, count));
            }

            return occurred;
        }
    }
}
