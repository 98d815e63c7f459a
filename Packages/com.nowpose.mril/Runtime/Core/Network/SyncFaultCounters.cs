using System;
using System.Threading;
using Nowpose.Sync;

namespace Nowpose.Network
{
    /// <summary>Counts dropped sync exchanges by reason. Thread-safe.</summary>
    sealed class SyncFaultCounters
    {
        readonly long[] _counts = new long[Enum.GetValues(typeof(SyncExchangeFault)).Length];

        public long this[SyncExchangeFault fault] => Interlocked.Read(ref _counts[(int)fault]);

        public long Total
        {
            get
            {
                long total = 0;
                for (var i = 1; i < _counts.Length; i++) total += Interlocked.Read(ref _counts[i]);
                return total;
            }
        }

        internal void Count(SyncExchangeFault fault)
        {
            if (fault != SyncExchangeFault.None) Interlocked.Increment(ref _counts[(int)fault]);
        }
    }
}
