using System.Collections.Generic;
using Nowpose.Frames;
using Nowpose.Signals;

namespace Nowpose.Session.Cell
{
    /// <summary>
    /// Grippers of a session that grip objects within their reach. Each gripper follows a signal; a value of 0.5 or more means closed.
    /// </summary>
    sealed class SessionGrips
    {
        readonly SessionSignals _signals;
        readonly object _gate;
        readonly List<(ReachGrip Grip, string Signal)> _grips = new List<(ReachGrip, string)>();
        bool _canReceive;

        /// <param name="gate">Lock of the session.</param>
        public SessionGrips(SessionSignals signals, object gate)
        {
            _gate = gate;
            _signals = signals;
            signals.Table.Changed += Take;
            signals.Table.Restarted += Restart;
            signals.Table.Resumed += Resume;
        }

        /// <summary>Makes a gripper follow a signal from now on. Call it on the thread of <see cref="CompensationSession.Tick"/>.</summary>
        public void Add(ReachGrip grip, string signal)
        {
            _signals.Need(signal);
            lock (_gate)
            {
                _grips.Add((grip, signal));
                if (_signals.Table.Find(signal) is SignalTrack known && known.IsKnown) Change(grip, known);
                Judge(grip, signal);
            }
        }

        /// <summary>Removes a gripper. An object that it holds follows its own source again, and is not current until the source moves it.</summary>
        public void Remove(ReachGrip grip)
        {
            lock (_gate)
            {
                foreach (var (each, signal) in _grips)
                    if (each == grip) _signals.Leave(signal);
                _grips.RemoveAll(each => each.Grip == grip);
                grip.Leave();
            }
        }

        /// <summary>
        /// Decides what the grippers hold, or marks the objects of a gripper for which this is unknown. Call it after the signals are evaluated and
        /// before the frames are evaluated.
        /// </summary>
        /// <param name="canReceive">Whether values of signals can arrive.</param>
        public void Decide(in DisplayMoment moment, bool canReceive)
        {
            _canReceive = canReceive;
            foreach (var (grip, signal) in _grips)
            {
                if (moment.DisplayTime is ControlTime displayTime) grip.Decide(displayTime);
                Judge(grip, signal);
            }
        }

        /// <summary>Decides pending changes with the available samples. Call it before the samples are discarded.</summary>
        public void Settle()
        {
            foreach (var (grip, _) in _grips) grip.Settle();
        }

        void Take(SignalTrack signal)
        {
            foreach (var (grip, name) in _grips)
                if (name == signal.Name) Change(grip, signal);
        }

        // A restart of the signal's source invalidates the earlier stamps.
        void Restart(SignalTrack signal)
        {
            foreach (var (grip, name) in _grips)
                if (name == signal.Name) grip.Restart(isOfSource: signal.Newest.HasValue);
        }

        void Resume(SignalTrack signal)
        {
            foreach (var (grip, name) in _grips)
                if (name == signal.Name) grip.Resume(IsClosed(signal));
        }

        void Judge(ReachGrip grip, string signal)
        {
            var (reason, since) = _signals.FaultOf(signal, _canReceive);
            grip.Judge(reason, since);
        }

        static void Change(ReachGrip grip, SignalTrack signal) => grip.Change(IsClosed(signal), signal.Since);

        static bool IsClosed(SignalTrack signal) => SignalTrack.IsOn(signal.Value);
    }
}
