using System;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Signals;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>
    /// Follows one signal. Switches to the new session when the session component reconnects. Does not allocate in a frame.
    /// </summary>
    sealed class SignalFollower : IShownPart
    {
        readonly MrilSession _source;
        readonly string _title;
        readonly Action<SignalTrack> _changed;
        readonly Action<SignalTrack> _restarted;
        readonly Action<string> _judged;
        CompensationSession _session;
        string _fault;
        bool _isJudged, _hasLeft;

        SignalFollower(MrilSession source, string name, Action<SignalTrack> changed, Action<SignalTrack> restarted, Action<string> judged)
        {
            _source = source;
            Name = name;
            _changed = changed;
            _restarted = restarted;
            _judged = judged;
            _title = "signal " + name;
            _source.Computed += Update;
            _source.Parts.Add(this);
        }

        /// <summary>The component that has the session.</summary>
        public MrilSession Source => _source;

        /// <summary>Name of the signal since the component was enabled.</summary>
        public string Name { get; }

        /// <summary>Whether a listener of the component is being called.</summary>
        public bool IsRaising { get; private set; }

        /// <summary>The signal; null until its first value is known.</summary>
        public SignalTrack Track { get; private set; }

        /// <summary>Reason why the component cannot show the value, although it may be current; null if it can.</summary>
        public string Problem { get; set; }

        /// <summary>Reason why the value is not current or cannot be shown, in one line; null if there is none.</summary>
        public string Fault => CurrentFault ?? Problem;

        /// <summary>Reason why the value is not current, in one line; null if it is current.</summary>
        public string CurrentFault => _session == null || _source.Session == null ? StatusMessages.NoSession : SessionFault.Reason;

        string IShownPart.Title => _title;

        bool IShownPart.IsFaultCommon => Fault == SignalMessages.ClockUnsynchronised;

        public ControlTime? FaultSince => _session == null ? null : SessionFault.Since;

        (string Reason, ControlTime? Since) SessionFault => _session.Signals.FaultOf(Name, _session.CanReceiveSignals);

        /// <summary>Starts to follow a signal in the session of a component.</summary>
        /// <param name="kind">Kind of the component, for the text of the warning that is logged if it has no session.</param>
        /// <param name="changed">Called for the value at the start and then for each change, in order, when the change becomes visible.</param>
        /// <param name="restarted">Called when the times of the signal become invalid; its value remains. May be null.</param>
        /// <param name="judged">
        /// Called with the fault, null for none, in the first frame and then when the fault changes, after the changes of the value. May be null.
        /// </param>
        /// <returns>Null if the component has no session.</returns>
        public static SignalFollower Of(
            Component component, MrilSession assigned, string kind, string name, Action<SignalTrack> changed, Action<SignalTrack> restarted = null,
            Action<string> judged = null)
        {
            var source = component.RequiredSession(assigned, kind);
            return source == null ? null : new SignalFollower(source, name, changed, restarted, judged);
        }

        /// <summary>Stops following the signal.</summary>
        public void Leave()
        {
            _hasLeft = true;
            _source.Parts.Remove(this);
            _source.Computed -= Update;
            Follow(null);
        }

        /// <summary>Follows a new session of the component. Called in each frame; a component that moves before the other listeners calls it earlier.</summary>
        /// <param name="frame">Not used; may be null.</param>
        public void Update(DisplayFrame frame)
        {
            // A listener that ran before in the same frame may have disabled the component.
            if (_hasLeft) return;
            if (_source.Session != _session) Follow(_source.Session);
            Judge();
        }

        /// <summary>Reports the fault if it has changed. Called in each frame without a session; <see cref="Update"/> calls it in the others.</summary>
        public void Judge()
        {
            if (_hasLeft) return;
            var fault = Fault;
            if (_judged == null || (_isJudged && fault == _fault)) return;
            (_fault, _isJudged) = (fault, true);
            Raise(_judged, fault);
        }

        void Follow(CompensationSession session)
        {
            if (_session != null)
            {
                _session.Signals.Table.Changed -= Take;
                _session.Signals.Table.Restarted -= Restart;
                _session.Signals.Leave(Name);
            }
            Track = null;
            _session = session;
            if (session == null) return;
            session.Signals.Need(Name);
            session.Signals.Table.Changed += Take;
            session.Signals.Table.Restarted += Restart;
            if (session.Signals.Table.Find(Name) is SignalTrack known && known.IsKnown) Take(known);
        }

        void Take(SignalTrack signal)
        {
            // A listener of the same change that was called before may have disabled the component.
            if (_hasLeft || signal.Name != Name) return;
            Track = signal;
            Raise(_changed, signal);
        }

        // A listener of one component must not keep a change from the others, which would show an old state as current.
        void Raise<T>(Action<T> listener, T value)
        {
            IsRaising = true;
            try
            {
                listener(value);
            }
            catch (Exception fault)
            {
                Debug.LogException(fault, _source);
            }
            IsRaising = false;
        }

        void Restart(SignalTrack signal)
        {
            if (signal == Track) _restarted?.Invoke(signal);
        }
    }
}
