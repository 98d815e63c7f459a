using System;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Signals;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>Follows one signal over all sessions of a session component. Allocates nothing in a frame.</summary>
    sealed class SignalFollower : IShownPart
    {
        readonly MrilSession _source;
        readonly string _name;
        readonly string _title;
        readonly Action<SignalTrack> _changed;
        readonly Action<SignalTrack> _restarted;
        CompensationSession _session;

        SignalFollower(MrilSession source, string name, Action<SignalTrack> changed, Action<SignalTrack> restarted)
        {
            _source = source;
            _name = name;
            _changed = changed;
            _restarted = restarted;
            _title = "signal " + name;
            _source.Shown += Show;
            _source.Parts.Add(this);
        }

        /// <summary>The signal; null while no value is known.</summary>
        public SignalTrack Track { get; private set; }

        /// <summary>Why the value is not current, in one line; null if it is.</summary>
        public string Fault => FaultOf(_session, _name);

        string IShownPart.Title => _title;

        /// <summary>Starts to follow a signal in the session of a component.</summary>
        /// <param name="kind">Kind of the component, for the warning if it has no session.</param>
        /// <param name="changed">Called with each change when it becomes visible, in order, and with the value at the start.</param>
        /// <param name="restarted">Called when the times of the signal are no longer valid, with the value that stays; null for nothing.</param>
        /// <returns>Null without a session.</returns>
        public static SignalFollower Of(
            Component component, MrilSession assigned, string kind, string name, Action<SignalTrack> changed, Action<SignalTrack> restarted = null)
        {
            var source = component.RequiredSession(assigned, kind);
            return source == null ? null : new SignalFollower(source, name, changed, restarted);
        }

        /// <summary>Returns why a signal's value is not current, in one line; null if it is.</summary>
        /// <param name="session">Null for none.</param>
        public static string FaultOf(CompensationSession session, string name) =>
            session == null ? "no session" : session.Signals.FaultOf(name, session.SampleLink.State == LinkState.Connected);

        /// <summary>Ends following.</summary>
        public void Leave()
        {
            _source.Parts.Remove(this);
            _source.Shown -= Show;
            Follow(null);
        }

        void Show(DisplayFrame frame)
        {
            if (_source.Session != _session) Follow(_source.Session);
        }

        void Follow(CompensationSession session)
        {
            if (_session != null)
            {
                _session.Signals.Table.Changed -= Take;
                _session.Signals.Table.Restarted -= Restart;
            }
            Track = null;
            _session = session;
            if (session == null) return;
            session.Signals.Need();
            session.Signals.Table.Changed += Take;
            session.Signals.Table.Restarted += Restart;
            var known = session.Signals.Table.IndexOf(_name);
            if (known >= 0 && session.Signals.Table[known].IsKnown) Take(session.Signals.Table[known]);
        }

        void Take(SignalTrack signal)
        {
            if (signal.Name != _name) return;
            Track = signal;
            _changed(signal);
        }

        void Restart(SignalTrack signal)
        {
            if (signal == Track) _restarted?.Invoke(signal);
        }
    }
}
