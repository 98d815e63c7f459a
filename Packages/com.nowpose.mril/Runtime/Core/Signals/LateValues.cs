using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Signals
{
    /// <summary>
    /// Detects that the clock of a signal's source went back. The evidence is several consecutive late values, each of them older than the newest
    /// stamp and newer than the previous late value. Fewer late values only show that newer messages have overtaken them on the network.
    /// </summary>
    sealed class LateValues
    {
        /// <summary>Number of consecutive late values that proves that the clock went back; the same number as for samples.</summary>
        const int Capacity = ArrivalLimits.MinLateForRestart;

        /// <summary>
        /// Number of consecutive late values that is sufficient if the last of them is late by more than <see cref="ArrivalLimits.MaxDelay"/>.
        /// </summary>
        const int MinFarBehind = 3;

        /// <summary>
        /// Maximum time by which newer messages overtake a value. Messages stay in order on a connection, and a server discards those that have waited
        /// for longer.
        /// </summary>
        static readonly TimeSpan MaxOvertaken = TimeSpan.FromSeconds(1);

        readonly (ControlTime Stamp, double Value)[] _oldestFirst = new (ControlTime, double)[Capacity];
        int _count;

        /// <summary>The values, oldest first.</summary>
        public ReadOnlySpan<(ControlTime Stamp, double Value)> All => _oldestFirst.AsSpan(0, _count);

        /// <summary>Returns whether a value is older than the newest one, and newer messages can have overtaken it.</summary>
        public static bool IsOvertaken(ControlTime stamp, ControlTime? newest) => stamp < newest && newest - stamp <= MaxOvertaken;

        /// <summary>
        /// Adds a received value. If the value is not late, the late values before it are discarded: newer messages have only overtaken them on the
        /// network.
        /// </summary>
        /// <param name="newest">Newest stamp of the signal, without announced changes; null before the first value.</param>
        /// <returns>Whether the source's clock went back. If so, use the values and then call <see cref="Clear"/>.</returns>
        public bool Add(ControlTime stamp, double value, ControlTime? newest)
        {
            if (_count > 0 && stamp == _oldestFirst[_count - 1].Stamp) return false;
            if (_count > 0 && stamp < _oldestFirst[_count - 1].Stamp) Clear();
            if (!(stamp < newest))
            {
                Clear();
                return false;
            }
            _oldestFirst[_count++] = (stamp, value);
            return _count == Capacity || (_count >= MinFarBehind && ArrivalLimits.IsFarBehind(stamp, newest.Value));
        }

        /// <summary>Returns the newest late value, if it is too late to have been overtaken on the network; otherwise null.</summary>
        /// <inheritdoc cref="Add" path="/param[@name='newest']"/>
        public double? NewestFarBehind(ControlTime? newest) =>
            _count > 0 && newest is ControlTime time && ArrivalLimits.IsFarBehind(_oldestFirst[_count - 1].Stamp, time) ? _oldestFirst[_count - 1].Value : (double?)null;

        public void Clear() => _count = 0;
    }
}
