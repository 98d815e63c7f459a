using System;
using Nowpose.Session;
using Nowpose.Signals;

namespace Nowpose.Unity.Cell
{
    /// <summary>Follows one signal over all sessions of a component. Allocates nothing in a frame.</summary>
    sealed class SignalFollower
    {
        readonly string _name;
        readonly Action<SignalTrack> _changed;
        CompensationSession _session;

        /// <param name="name">Name of the signal.</param>
        /// <param name="changed">Called with each change when it becomes visible, in order, and with the value at the start.</param>
        public SignalFollower(string name, Action<SignalTrack> changed)
        {
            _name = name;
            _changed = changed;
        }

        /// <summary>The signal; null while no value is known.</summary>
        public SignalTrack Track { get; private set; }

        /// <summary>Why the value is not current, in one line; null if it is.</summary>
        public string Fault => _session == null ? "no session"
            : _session.Signals.FaultOf(_name, _session.SampleLink.State == Network.LinkState.Connected);

        /// <summary>Follows the signal in a session; call it in each frame.</summary>
        /// <param name="session">Null for none.</param>
        public void Follow(CompensationSession session)
        {
            if (session == _session) return;
            Leave();
            _session = session;
            if (session == null) return;
            session.Signals.Need();
            session.Signals.Table.Changed += Take;
            var known = session.Signals.Table.IndexOf(_name);
            if (known >= 0 && session.Signals.Table[known].IsKnown) Take(session.Signals.Table[known]);
        }

        public void Leave()
        {
            if (_session != null) _session.Signals.Table.Changed -= Take;
            _session = null;
            Track = null;
        }

        void Take(SignalTrack signal)
        {
            if (signal.Name != _name) return;
            Track = signal;
            _changed(signal);
        }
    }
}
