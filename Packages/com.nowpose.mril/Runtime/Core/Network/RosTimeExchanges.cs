using System;
using System.Globalization;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Network
{
    /// <summary>
    /// Exchanges timestamps with the ROS clock over a rosbridge connection, in place of <see cref="SyncClient"/> on connections without a gateway.
    /// </summary>
    /// <remarks>
    /// The response contains one time, which the server read between the call and the response; this time is used as both t2 and t3. The server's
    /// processing times before and after the reading are unknown, so half the round-trip time bounds the error. Only one call is in flight at a
    /// time. A late response to an earlier call is counted as a fault.
    /// </remarks>
    sealed class RosTimeExchanges
    {
        const string IdPrefix = "nowpose time ";
        const string Service = "clock of ROS: " + RosTopics.GetTime;

        static readonly TimeSpan PauseAfterRefusal = new TimeSpan(TimeSpan.TicksPerSecond);

        /// <summary>Interval from a response to the next request while the resolution is measured.</summary>
        static readonly TimeSpan QuickPause = new TimeSpan(3 * TimeSpan.TicksPerMillisecond);

        readonly IHeadsetClock _clock;
        readonly ClockSynchroniser _synchroniser;
        readonly SyncFaultCounters _faults;
        readonly ExchangePace _pace;
        readonly object _gate = new object();
        RosClockResolution _resolution = new RosClockResolution();
        TaskCompletionSource<RosTimeAnswer> _awaited;
        string _id;
        string _service;
        long _number;
        ExchangeIntake _intake;
        volatile LinkStatus _status = LinkStatus.Connecting;

        /// <param name="pace">Schedule of the exchanges; used by this object only.</param>
        public RosTimeExchanges(IHeadsetClock clock, ClockSynchroniser synchroniser, SyncFaultCounters faults, ExchangePace pace) =>
            (_clock, _synchroniser, _faults, _pace) = (clock, synchroniser, faults, pace);

        /// <summary>State of the exchanges while the connection is open. Thread-safe.</summary>
        public LinkStatus Status => _status;

        /// <summary>Runs exchanges over one connection until it ends.</summary>
        /// <exception cref="IOException">
        /// No response arrived in time, or too many consecutive responses were unusable. The caller must close the connection.
        /// </exception>
        public async Task RunAsync(LinkSender sender, CancellationToken cancel)
        {
            // The connection may lead to another server, or the server may have started or stopped a simulation.
            _status = LinkStatus.Connecting;
            _resolution = new RosClockResolution();
            _service = RosTopics.GetTime;
            _intake = new ExchangeIntake(_synchroniser, _faults, (drops, fault) => ConnectionMessages.UnusableAnswers(Service, drops, fault));
            while (true)
            {
                var begun = _clock.Now;
                var pause = await ExchangeAsync(sender, cancel).ConfigureAwait(false);
                var left = begun + pause - _clock.Now;
                await Task.Delay(left > TimeSpan.Zero ? left : TimeSpan.Zero, cancel).ConfigureAwait(false);
            }
        }

        /// <summary>
        /// Receives every service response, on the receiver's thread. Ignores responses to other services, and counts a late response to an earlier
        /// call as a fault.
        /// </summary>
        /// <param name="fault">Reason why the response could not be read.</param>
        public void Answered(RosbridgeMessage response, DropReason fault, HeadsetTime arrival)
        {
            if (response.Id.Text?.StartsWith(IdPrefix, StringComparison.Ordinal) != true) return;
            lock (_gate)
            {
                if (response.Id == _id && _awaited.TrySetResult(new RosTimeAnswer(response, fault, arrival))) return;
            }
            _faults.Count(SyncExchangeFault.WrongSequence);
        }

        /// <returns>Interval from the start of this exchange to the start of the next.</returns>
        async Task<TimeSpan> ExchangeAsync(LinkSender sender, CancellationToken cancel)
        {
            var (sent, answer) = await CallAsync(_service, sender, cancel).ConfigureAwait(false);
            if (answer.IsServiceMissing)
            {
                var other = _service == RosTopics.GetTime ? RosTopics.GetTimeOfNamespace : RosTopics.GetTime;
                (sent, answer) = await CallAsync(other, sender, cancel).ConfigureAwait(false);
                if (answer.Time != null) _service = other;
            }
            if (answer.Time is not { } time)
            {
                _status = LinkStatus.Waiting(Service + ": " + answer.Problem);
                return PauseAfterRefusal;
            }
            _resolution.Add(time, sent, answer.Arrival);
            if (_resolution.IsStopped) _status = LinkStatus.Waiting(ConnectionMessages.RosClockStopped(Service));
            else if (_resolution.IsKnown && _intake.Add(new SyncExchange(sent, time, time, answer.Arrival, _resolution.Value))) _status = LinkStatus.Connected;
            var pause = _pace.Next(_synchroniser, answer.Arrival);
            return _resolution.IsMeasuring && !_resolution.IsStopped ? answer.Arrival - sent + QuickPause : pause;
        }

        Task<RosTimeAnswer> NewCall(out string id)
        {
            lock (_gate)
            {
                _awaited = new TaskCompletionSource<RosTimeAnswer>(TaskCreationOptions.RunContinuationsAsynchronously);
                _id = id = IdPrefix + (++_number).ToString(CultureInfo.InvariantCulture);
                return _awaited.Task;
            }
        }

        async Task<(HeadsetTime Sent, RosTimeAnswer Answer)> CallAsync(string service, LinkSender sender, CancellationToken cancel)
        {
            using (var inTime = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                inTime.CancelAfter(ProtocolLimits.SyncReplyTimeout);
                try
                {
                    var awaited = NewCall(out var id);
                    var sent = await sender.SendAsync(RosbridgeWriter.CallService(service, id), inTime.Token).ConfigureAwait(false);
                    return (sent, await awaited.OrCancelled(inTime.Token).ConfigureAwait(false));
                }
                catch (OperationCanceledException late) when (!cancel.IsCancellationRequested)
                {
                    throw new IOException(ConnectionMessages.NoAnswer(Service, ProtocolLimits.SyncReplyTimeout.TotalSeconds), late);
                }
            }
        }
    }
}
