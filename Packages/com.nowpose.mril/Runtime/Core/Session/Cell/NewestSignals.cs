using System;
using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

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

    /// <summary>The newest value of each signal, of messages for which a queue has no place. Thread-safe.</summary>
    /// <remarks>A source may publish a value once only, so the newest one must not be lost.</remarks>
    sealed class NewestSignals
    {
        readonly object _gate = new object();
        readonly Dictionary<string, ArrivedSignal> _values = new Dictionary<string, ArrivedSignal>(StringComparer.Ordinal);

        /// <summary>Keeps a value if its stamp is not older than that of the kept one.</summary>
        /// <returns>Why a value was dropped, this one or the kept one; <see cref="DropReason.None"/> if none was.</returns>
        public DropReason Keep(in ArrivedSignal arrived)
        {
            lock (_gate)
            {
                var isKnown = _values.TryGetValue(arrived.Value.Name, out var kept);
                if (!isKnown && _values.Count >= ProtocolLimits.Signals) return DropReason.TooManySignals;
                if (!isKnown || kept.Stamp <= arrived.Stamp) _values[arrived.Value.Name] = arrived;
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
