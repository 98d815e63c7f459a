using System;
using System.Threading;

namespace Nowpose.Session.Cell
{
    /// <summary>
    /// Start of the newest connection. A value from before this time may have changed during the interruption, or the other side may have restarted without
    /// its source. Thread-safe.
    /// </summary>
    sealed class ConnectionStart
    {
        long _ticks = long.MinValue;

        public void Set(HeadsetTime at) => Interlocked.Exchange(ref _ticks, at.SinceEpoch.Ticks);

        /// <summary>Returns whether a message has arrived over the newest connection, or from a program that supplies the session.</summary>
        public bool Includes(HeadsetTime arrival) => arrival.SinceEpoch.Ticks >= Interlocked.Read(ref _ticks);

        /// <summary>Start of the newest connection; null before the first one.</summary>
        public HeadsetTime? Newest
        {
            get
            {
                var ticks = Interlocked.Read(ref _ticks);
                return ticks == long.MinValue ? (HeadsetTime?)null : new HeadsetTime(new TimeSpan(ticks));
            }
        }
    }
}
