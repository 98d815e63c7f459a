using System;
using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Signals
{
    /// <summary>Keeps all signals of the cell, which are piecewise constant in control time, and shows their values at the display time.</summary>
    /// <remarks>Use it only on the thread that computes the display frames. Allocates only for a signal's first value.</remarks>
    sealed class SignalTable
    {
        readonly List<SignalTrack> _signals = new List<SignalTrack>();
        readonly Dictionary<string, int> _indices = new Dictionary<string, int>(StringComparer.Ordinal);
        readonly Predicate<SignalTrack> _isEnded;

        /// <param name="isEnded">
        /// Returns whether a signal may have no source any more. When the table is full, a new signal replaces such a signal. Null: no source ends.
        /// </param>
        public SignalTable(Predicate<SignalTrack> isEnded = null) => _isEnded = isEnded ?? (_ => false);

        /// <summary>
        /// Raised within <see cref="Evaluate"/> when a change becomes visible. The signal already has the new value. If several changes of one
        /// signal become visible at once, the event is raised for each of them, in the order of their stamps.
        /// </summary>
        public event Action<SignalTrack> Changed;

        /// <summary>
        /// Raised when the times of a signal are no longer valid; see <see cref="SignalTrack.Restarted"/>.
        /// </summary>
        public event Action<SignalTrack> Restarted;

        public int Count => _signals.Count;

        public SignalTrack this[int index] => _signals[index];

        /// <summary>Returns the index of a signal, valid until the next value is added; −1 if the table does not have the signal.</summary>
        public int IndexOf(string name) => _indices.TryGetValue(name, out var index) ? index : -1;

        /// <summary>Adds a received value.</summary>
        /// <param name="stamp">Control time from which the signal has the value.</param>
        /// <param name="arrival">Control time of the arrival; null if unknown.</param>
        /// <param name="isOfNewSource">See <see cref="SignalTrack.Add"/>.</param>
        /// <returns>Drop reason; <see cref="DropReason.None"/> if the value was used.</returns>
        public DropReason Add(ControlTime stamp, in SignalValue value, ControlTime? arrival = null, bool isOfNewSource = false)
        {
            var index = IndexOfNew(value.Name);
            return index < 0 ? DropReason.TooManySignals : _signals[index].Add(stamp, value.Value, arrival, isOfNewSource);
        }

        /// <summary>Keeps a received value whose stamp is in the future; see <see cref="SignalTrack.Unplaced"/>.</summary>
        public void AddFuture(in SignalValue value)
        {
            var index = IndexOfNew(value.Name);
            if (index >= 0) _signals[index].AddFuture(value.Value);
        }

        /// <summary>Returns the index of a signal, which is added if the table does not have it; −1 if the table is full.</summary>
        int IndexOfNew(string name)
        {
            var index = IndexOf(name);
            if (index >= 0) return index;
            index = FreeIndex();
            if (index < 0) return index;
            _indices.Add(name, index);
            _signals[index] = new SignalTrack(name);
            _signals[index].Restarted += signal => Restarted?.Invoke(signal);
            return index;
        }

        int FreeIndex()
        {
            if (_signals.Count < ProtocolLimits.Signals)
            {
                _signals.Add(null);
                return _signals.Count - 1;
            }
            for (var i = 0; i < _signals.Count; i++)
                if (_isEnded(_signals[i]))
                {
                    _indices.Remove(_signals[i].Name);
                    return i;
                }
            return -1;
        }

        /// <summary>Makes all changes visible whose stamps are at or before the display time.</summary>
        public void Evaluate(ControlTime at)
        {
            foreach (var signal in _signals)
                while (signal.Next(at)) Changed?.Invoke(signal);
        }

        /// <summary>Discards all times, because they are no longer valid; see <see cref="SignalTrack.Restart"/>.</summary>
        public void Restart()
        {
            foreach (var signal in _signals) signal.Restart();
        }
    }
}
