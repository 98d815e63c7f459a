using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Session.Cell
{
    /// <summary>
    /// Everything that a session shows of the cell: robots, objects, signals, and grippers that grip within their reach. Computes them in the order in
    /// which they depend on each other.
    /// </summary>
    sealed class SessionCell
    {
        readonly object _gate;
        ClockModel _clock;
        bool _canReceiveSignals;

        /// <param name="latency">Statistics of L_app, updated with each sample.</param>
        /// <param name="drops">Counts of dropped messages.</param>
        /// <param name="gate">Lock of the session.</param>
        public SessionCell(SessionSettings settings, ApplicationLatency latency, DropCounters drops, Subscriptions subscriptions, object gate)
        {
            _gate = gate;
            Frames = new SessionFrames(settings.Prediction, subscriptions, drops, Connection, gate);
            Signals = new SessionSignals(subscriptions, drops, Connection, gate);
            Grips = new SessionGrips(Signals, gate);
            Robots = new SessionRobots(settings, latency, drops, Frames, subscriptions, Connection, gate);
        }

        /// <summary>Start of the newest connection. Set on the socket's thread.</summary>
        public ConnectionStart Connection { get; } = new ConnectionStart();

        public SessionRobots Robots { get; }

        public SessionFrames Frames { get; }

        public SessionSignals Signals { get; }

        public SessionGrips Grips { get; }

        /// <summary>Computes everything for the display time of a frame.</summary>
        /// <param name="canReceiveSignals">Whether values of signals can arrive.</param>
        public void Show(in DisplayMoment moment, bool canReceiveSignals)
        {
            (_clock, _canReceiveSignals) = (moment.Clock, canReceiveSignals);
            Robots.Show(moment);
            Frames.Take(moment);
            Signals.Show(moment, canReceiveSignals);
            // A gripper takes an object in the frame in which its signal's change is visible.
            Grips.Decide(moment, canReceiveSignals);
            Frames.Show(moment);
            Robots.PlaceRoots(moment);
        }

        /// <summary>Returns the objects and signals that were shown and not current in the newest frame; allocates. Thread-safe.</summary>
        /// <param name="now">Headset time for the ages.</param>
        public CellFaults Faults(HeadsetTime now)
        {
            List<PartStatus> objects, signals;
            lock (_gate)
            {
                var control = _clock.IsKnown ? _clock.ToControl(now) : (ControlTime?)null;
                objects = Frames.Faults(control);
                signals = Signals.Faults(_canReceiveSignals, control);
            }
            return new CellFaults(objects, signals);
        }

        /// <summary>Discards all samples after the control clock stepped or became known. Open grips are decided first from the old samples.</summary>
        public void Restart()
        {
            Grips.Settle();
            Robots.Restart();
            Frames.Restart();
            Signals.Restart();
        }
    }
}
