using System;
using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Signals;

namespace Nowpose.Session.Cell
{
    /// <summary>A value of a signal with its stamp and its arrival.</summary>
    readonly struct ArrivedSignal
    {
        public ArrivedSignal(in SignalValue value, ControlTime stamp, HeadsetTime arrival)
        {
            Value = value;
            Stamp = stamp;
            Arrival = arrival;
        }

        public SignalValue Value { get; }
        public ControlTime Stamp { get; }
        public HeadsetTime Arrival { get; }
    }

    /// <summary>Keeps the newest value of each signal from messages that did not fit into a queue. Thread-safe.</summary>
    /// <remarks>A source may publish a value only once, so the newest value must not be lost.</remarks>
    sealed class NewestSignals
    {
        readonly object _gate = new object();
        readonly Dictionary<string, ArrivedSignal> _values = new Dictionary<string, ArrivedSignal>(StringComparer.Ordinal);

        /// <summary>Keeps a value unless a newer value of the same signal has overtaken it.</summary>
        /// <returns>Reason why the given or the kept value was dropped; <see cref="DropReason.None"/> if neither value was dropped.</returns>
        public DropReason Keep(in ArrivedSignal arrived)
        {
            lock (_gate)
            {
                var isKnown = _values.TryGetValue(arrived.Value.Name, out var kept);
                if (!isKnown && _values.Count >= ProtocolLimits.Signals) return DropReason.TooManySignals;
                if (!isKnown || !LateValues.IsOvertaken(arrived.Stamp, kept.Stamp)) _values[arrived.Value.Name] = arrived;
                return isKnown ? DropReason.SlowReader : DropReason.None;
            }
        }

        /// <summary>Moves all values to the end of a list.</summary>
        public void Take(List<ArrivedSignal> into)
        {
            lock (_gate)
            {
                if (_values.Count == 0) return;
                into.AddRange(_values.Values);
                _values.Clear();
            }
        }
    }
}
