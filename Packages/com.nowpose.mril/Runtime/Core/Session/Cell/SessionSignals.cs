using System;
using System.Collections.Generic;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Signals;

namespace Nowpose.Session.Cell
{
    /// <summary>Receives a value of a signal and the reason why it was dropped; <see cref="DropReason.None"/> if it was used.</summary>
    delegate void SignalJudged(in SignalValue value, ControlTime stamp, HeadsetTime arrival, DropReason reason);

    /// <summary>Signals of a session's cell, with their values at the display time and their faults.</summary>
    sealed class SessionSignals
    {
        /// <summary>Queue capacity in messages. Messages wait for a display frame with a known control time.</summary>
        const int QueueLength = 1000;

        readonly Arrivals<SignalsMessage> _arrivals = new Arrivals<SignalsMessage>(QueueLength);
        readonly NewestSignals _overflow = new NewestSignals();
        readonly List<ArrivedSignal> _kept = new List<ArrivedSignal>();
        // Has its full capacity from the start, because a frame must not allocate.
        readonly List<Arrival<SignalsMessage>> _taken = new List<Arrival<SignalsMessage>>(QueueLength);
        readonly Subscriptions _subscriptions;
        readonly DropCounters _drops;
        readonly ConnectionStart _connection;
        readonly SourceEnds _ends = new SourceEnds();
        readonly ShownNames _shown = new ShownNames();
        readonly object _gate;
        // The receiving thread replaces the whole dictionary, so readers need no lock.
        volatile Dictionary<string, JointReport> _ended = new Dictionary<string, JointReport>(StringComparer.Ordinal);

        bool _isTimeKnown = true, _isWaitingForClock, _areAllShown;
        ClockModel _clock;
        ControlTime? _disconnectedSince;

        /// <param name="gate">Lock of the session.</param>
        public SessionSignals(Subscriptions subscriptions, DropCounters drops, ConnectionStart connection, object gate)
        {
            _gate = gate;
            _connection = connection;
            _subscriptions = subscriptions;
            _drops = drops;
            Table = new SignalTable(IsEnded);
            Table.Overflowed += _ => drops.Count(DropReason.SlowReader);
        }

        public SignalTable Table { get; }

        /// <summary>
        /// Raised within <see cref="CompensationSession.Tick"/> for each value that leaves the queue, whether it is used or dropped. Not raised
        /// for values that were dropped because the queue was full.
        /// </summary>
        /// <remarks>A handler must be fast, must not throw, and must not call the session.</remarks>
        public event SignalJudged Judged;

        /// <summary>Reports the values that arrived earlier and are or will be visible, because a value is not sent again until it changes.</summary>
        public void ReportKept(SignalJudged report)
        {
            for (var i = 0; i < Table.Count; i++)
                if (Table[i].Received is HeadsetTime arrival) Table[i].Report((value, stamp) => report(value, stamp, arrival, DropReason.None));
        }

        /// <summary>
        /// Subscribes to signals. Called only when a signal is used, because a ROS system may not have the message type.
        /// </summary>
        public void Need()
        {
            _subscriptions.Add(RosTopics.Signals, RosTopics.SignalsType);
            _subscriptions.Add(RosTopics.SignalStatus, RosTopics.DiagnosticsType);
        }

        /// <summary>Subscribes to signals, and lists a signal among the <see cref="Faults"/>, even if no value of it has been received yet.</summary>
        public void Need(string name)
        {
            Need();
            lock (_gate) _shown.Add(name);
        }

        /// <summary>Subscribes to signals, and lists every received signal among the <see cref="Faults"/>.</summary>
        public void NeedAll()
        {
            Need();
            lock (_gate) _areAllShown = true;
        }

        /// <summary>Reverses one <see cref="Need(string)"/>.</summary>
        public void Leave(string name)
        {
            lock (_gate) _shown.Remove(name);
        }

        /// <summary>Returns the shown signals that are not current for a reason of their own. Call it under the lock of the session.</summary>
        /// <param name="isConnected">Whether messages can arrive.</param>
        /// <param name="now">Control time for the ages; null while unknown.</param>
        public List<PartStatus> Faults(bool isConnected, ControlTime? now)
        {
            var faults = new List<PartStatus>();
            foreach (var name in _shown.All) AddFault(name, isConnected, now, faults);
            for (var i = 0; _areAllShown && i < Table.Count; i++)
                if (!_shown.Contains(Table[i].Name)) AddFault(Table[i].Name, isConnected, now, faults);
            return faults;
        }

        void AddFault(string name, bool isConnected, ControlTime? now, List<PartStatus> to)
        {
            var (reason, since) = FaultOf(name, isConnected);
            if (reason == null || reason == SignalMessages.ClockUnsynchronised) return;
            var state = Table.Find(name)?.IsKnown == true ? PoseState.Held : PoseState.Incomplete;
            to.Add(new PartStatus(name, state, since, StateTimes.Age(since, now), reason));
        }

        /// <summary>
        /// Queues a message for the next frame with a known control time. When the queue is full, removes the oldest message but keeps the
        /// newest value of each of its signals. Thread-safe.
        /// </summary>
        public void Add(SignalsMessage message, HeadsetTime arrival)
        {
            lock (_overflow)
            {
                if (!_arrivals.Add(message, arrival, out var dropped)) return;
                var oldest = dropped.Message;
                for (var i = 0; i < oldest.Count; i++) _drops.Count(_overflow.Keep(new ArrivedSignal(oldest[i], oldest.Stamp, dropped.At)));
                oldest.Release();
            }
        }

        /// <summary>Stores the reports of the signals whose source has ended. Thread-safe.</summary>
        public void Take(JointStatusMessage message, HeadsetTime arrival)
        {
            _ends.Add(message, arrival);
            var ended = new Dictionary<string, JointReport>(StringComparer.Ordinal);
            foreach (var report in message.Joints)
                if (!report.State.IsGood()) ended[report.Joint] = report;
            _ended = ended;
        }

        /// <summary>
        /// Returns the reason why a signal's value is not current, in one line, and the time since which it has not been current: the end of the
        /// connection or of the signal's source, or the start of the newest connection if the value is older. The time is null for another fault. Both are
        /// null if the value is current.
        /// </summary>
        /// <param name="isConnected">Whether messages can arrive.</param>
        public (string Reason, ControlTime? Since) FaultOf(string name, bool isConnected)
        {
            if (!isConnected) return (SignalMessages.NoConnection, _disconnectedSince);
            if (_ended.TryGetValue(name, out var report)) return (report.Reason, report.Since);
            var signal = Table.Find(name);
            if (signal?.Unplaced != null) return (SignalMessages.StampMismatch, null);
            if (signal?.IsKnown != true)
            {
                if (!_isWaitingForClock) return (SignalMessages.NoValue, null);
            }
            // The gateway sends each value again at once, unless it has restarted and has no value from the signal's source.
            else if (IsOlderThanConnection(signal))
            {
                return (SignalMessages.OlderThanConnection,
                    _clock.IsKnown && _connection.Newest is HeadsetTime start ? _clock.ToControl(start) : (ControlTime?)null);
            }
            return (_isTimeKnown ? null : SignalMessages.ClockUnsynchronised, null);
        }

        bool IsOlderThanConnection(SignalTrack signal) => !(signal.Received is HeadsetTime arrival) || !_connection.Includes(arrival);

        /// <summary>Discards all times, because they are no longer valid; see <see cref="SignalTrack.Restart"/>.</summary>
        public void Restart()
        {
            _disconnectedSince = null;
            Table.Restart();
        }

        /// <summary>Processes the queued messages, and shows each change whose stamp the display time has reached.</summary>
        /// <param name="isConnected">Whether messages can arrive.</param>
        public void Show(in DisplayMoment moment, bool isConnected)
        {
            _clock = moment.Clock;
            _disconnectedSince = isConnected ? null : _disconnectedSince ?? moment.DisplayTime;
            _isTimeKnown = moment.IsTrusted;
            _isWaitingForClock = !moment.DisplayTime.HasValue;
            if (!(moment.DisplayTime is ControlTime displayTime)) return;
            // In one step: a message that leaves the queue in between would be used in the next frame, after newer messages.
            lock (_overflow)
            {
                _overflow.Take(_kept);
                _arrivals.TakeAll(_taken);
            }
            foreach (var kept in _kept) Take(kept, moment.Clock);
            _kept.Clear();
            foreach (var taken in _taken)
            {
                var message = taken.Message;
                for (var i = 0; i < message.Count; i++) Take(new ArrivedSignal(message[i], message.Stamp, taken.At), moment.Clock);
                message.Release();
            }
            Table.Evaluate(displayTime);
        }

        // A gateway that has restarted does not report the sources that ended before. It sends the signals that it still has again, and there are not
        // more of them than the table can hold, so all of them find a place after a reconnection.
        bool IsEnded(SignalTrack signal) =>
            (_ended.TryGetValue(signal.Name, out var report) && report.State == JointDataState.Stale)
            || (signal.Received is HeadsetTime arrival && !_connection.Includes(arrival));

        // Over a new connection, the gateway first sends the value that it regards as the newest.
        bool IsAfterInterruption(SignalTrack signal, HeadsetTime arrival) => signal.Received is HeadsetTime former
            && (!_connection.Includes(former) || _ends.IsBetween(former, arrival, signal.Name));

        void Take(in ArrivedSignal arrived, in ClockModel clock)
        {
            var arrival = clock.ToControl(arrived.Arrival);
            var isInFuture = StampRule.IsInFuture(arrived.Stamp, arrival, clock.ErrorBound);
            var signal = Table.FindOrAdd(arrived.Value.Name);
            if (signal != null && (arrived.IsAfterLostChange || IsAfterInterruption(signal, arrived.Arrival))) signal.Interrupt();
            var reason = isInFuture ? DropReason.StampInFuture
                : signal == null ? DropReason.TooManySignals
                : signal.Add(arrived.Stamp, arrived.Value.Value, arrival);
            if (isInFuture) signal?.AddFuture(arrived.Value.Value);
            var isUsed = reason == DropReason.None || reason == DropReason.DuplicateSample;
            if (signal != null && (isUsed || signal.Unplaced.HasValue)) signal.Received = arrived.Arrival;
            _drops.Count(reason);
            Judged?.Invoke(arrived.Value, arrived.Stamp, arrived.Arrival, reason);
        }
    }
}
