using System;
using System.Collections.Generic;
using Nowpose.Protocol;

namespace Nowpose.Session.Cell
{
    /// <summary>
    /// Arrival times of the newest reports that the values of signals are not current, because their sources have ended or cannot read them. Thread-safe.
    /// </summary>
    sealed class SourceEnds
    {
        /// <summary>Maximum number of signals whose reports are kept, in addition to those of the newest message.</summary>
        const int Capacity = ProtocolLimits.Signals;

        // The receiving thread replaces the whole dictionary, so readers need no lock.
        volatile Dictionary<string, HeadsetTime> _arrivals = new Dictionary<string, HeadsetTime>(StringComparer.Ordinal);

        public void Add(JointStatusMessage message, HeadsetTime arrival)
        {
            var arrivals = _arrivals.Count > Capacity
                ? new Dictionary<string, HeadsetTime>(StringComparer.Ordinal) : new Dictionary<string, HeadsetTime>(_arrivals, StringComparer.Ordinal);
            foreach (var report in message.Joints)
                if (!report.State.IsGood()) arrivals[report.Joint] = arrival;
            _arrivals = arrivals;
        }

        /// <summary>Returns whether a value of a signal was not current between the arrivals of two values.</summary>
        public bool IsBetween(HeadsetTime former, HeadsetTime next, string signal) =>
            _arrivals.TryGetValue(signal, out var ended) && former <= ended && ended <= next;
    }
}
