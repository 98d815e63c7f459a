using System;
using System.Collections.Generic;
using Nowpose.Protocol;

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

        /// <inheritdoc cref="SignalTrack.Resumed"/>
        public event Action<SignalTrack> Resumed;

        /// <inheritdoc cref="SignalTrack.Overflowed"/>
        public event Action<SignalTrack> Overflowed;

        public int Count => _signals.Count;

        public SignalTrack this[int index] => _signals[index];

        /// <summary>Returns a signal; null if the table does not have it.</summary>
        public SignalTrack Find(string name) => _indices.TryGetValue(name, out var index) ? _signals[index] : null;

        /// <summary>Returns a signal, which is added if the table does not have it; null if the table is full.</summary>
        public SignalTrack FindOrAdd(string name)
        {
            if (Find(name) is SignalTrack known) return known;
            var index = FreeIndex();
            if (index < 0) return null;
            _indices.Add(name, index);
            var signal = _signals[index] = new SignalTrack(name);
            signal.Restarted += restarted => Restarted?.Invoke(restarted);
            signal.Resumed += resumed => Resumed?.Invoke(resumed);
            signal.Overflowed += overflowed => Overflowed?.Invoke(overflowed);
            return signal;
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
