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
        public ArrivedSignal(in SignalValue value, ControlTime stamp, HeadsetTime arrival, bool isAfterLostChange = false) =>
            (Value, Stamp, Arrival, IsAfterLostChange) = (value, stamp, arrival, isAfterLostChange);

        public SignalValue Value { get; }
        public ControlTime Stamp { get; }
        public HeadsetTime Arrival { get; }

        /// <summary>Whether another value before this one was dropped.</summary>
        public bool IsAfterLostChange { get; }

        public ArrivedSignal AfterLostChange() => new ArrivedSignal(Value, Stamp, Arrival, isAfterLostChange: true);
    }

    /// <summary>Keeps the newest value of each signal from messages that did not fit into a queue. Not thread-safe.</summary>
    /// <remarks>
    /// A source may publish a value only once, so the newest value must not be lost. If messages have repeated it, the first of them is kept too,
    /// because it has the time of the change.
    /// </remarks>
    sealed class NewestSignals
    {
        readonly Dictionary<string, (ArrivedSignal First, ArrivedSignal Newest)> _values =
            new Dictionary<string, (ArrivedSignal, ArrivedSignal)>(StringComparer.Ordinal);

        /// <summary>Keeps a value unless a newer value of the same signal has overtaken it.</summary>
        /// <returns>Reason why the given or the kept value was dropped; <see cref="DropReason.None"/> if neither value was dropped.</returns>
        public DropReason Keep(in ArrivedSignal arrived)
        {
            var isKnown = _values.TryGetValue(arrived.Value.Name, out var kept);
            if (!isKnown && _values.Count >= ProtocolLimits.Signals) return DropReason.TooManySignals;
            var isDropped = false;
            _values[arrived.Value.Name] = isKnown ? Newest(kept, arrived, out isDropped) : (arrived, arrived);
            return isDropped ? DropReason.SlowReader : DropReason.None;
        }

        /// <summary>Moves all values to the end of a list, those of each signal in the order of their arrival.</summary>
        public void Take(List<ArrivedSignal> into)
        {
            if (_values.Count == 0) return;
            foreach (var (first, newest) in _values.Values)
            {
                into.Add(first);
                if (newest.Arrival != first.Arrival) into.Add(newest);
            }
            _values.Clear();
        }

        static (ArrivedSignal First, ArrivedSignal Newest) Newest(
            in (ArrivedSignal First, ArrivedSignal Newest) kept, in ArrivedSignal arrived, out bool isDropped)
        {
            var isOvertaken = LateValues.IsOvertaken(arrived.Stamp, kept.Newest.Stamp);
            var newest = isOvertaken ? kept.Newest : arrived;
            if (arrived.Value.Value == kept.Newest.Value.Value)
            {
                isDropped = isOvertaken || kept.Newest.Arrival != kept.First.Arrival;
                return (kept.First, newest);
            }
            isDropped = true;
            newest = newest.AfterLostChange();
            return (newest, newest);
        }
    }
}
