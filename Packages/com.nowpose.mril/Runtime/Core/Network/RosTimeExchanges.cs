using System;
using System.Globalization;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Network
{
    /// <summary>
    /// Exchanges timestamps with the clock of ROS over a rosbridge connection: what <see cref="SyncClient"/> does over TCP, where no gateway is.
    /// </summary>
    /// <remarks>
    /// The answer holds one time, read at some moment between the call and the answer: it is t2 and t3 in one. What of the round trip
    /// the server spent before and after reading it is not known, so half the round trip bounds the error. One call is in
    /// flight, and an answer counts only for the call whose id it bears.
    /// </remarks>
    sealed class RosTimeExchanges
    {
        const string IdPrefix = "nowpose time ";
        const string Service = "clock of ROS: " + RosTopics.GetTime;

        static readonly TimeSpan PauseAfterRefusal = new TimeSpan(TimeSpan.TicksPerSecond);

        /// <summary>From one answer to the next question while the resolution is measured.</summary>
        static readonly TimeSpan QuickPause = new TimeSpan(3 * TimeSpan.TicksPerMillisecond);

        readonly IHeadsetClock _clock;
        readonly ClockSynchroniser _synchroniser;
        readonly SyncFaultCounters _faults;
        readonly ExchangePace _pace;
        readonly object _gate = new object();
        RosClockResolution _resolution = new RosClockResolution();
        TaskCompletionSource<RosTimeAnswer> _awaited;
        string _id;
        long _number;
        int _dropsInARow;
        volatile LinkStatus _status = LinkStatus.Connecting;

        /// <param name="pace">When to exchange; this one's own.</param>
        public RosTimeExchanges(IHeadsetClock clock, ClockSynchroniser synchroniser, SyncFaultCounters faults, ExchangePace pace)
        {
            _clock = clock;
            _synchroniser = synchroniser;
            _faults = faults;
            _pace = pace;
        }

        /// <summary>Where the exchanges stand while the connection does. Any thread.</summary>
        public LinkStatus Status => _status;

        /// <summary>Exchanges over one connection until that ends.</summary>
        /// <exception cref="IOException">No answer in time, or too many in a row that were of no use: the connection has to end.</exception>
        public async Task RunAsync(LinkSender sender, CancellationToken cancel)
        {
            // Perhaps another server, or the same one with a simulation that it had not before.
            _resolution = new RosClockResolution();
            _dropsInARow = 0;
            while (true)
            {
                var begun = _clock.Now;
                var pause = await ExchangeAsync(sender, cancel).ConfigureAwait(false);
                var left = begun + pause - _clock.Now;
                await Task.Delay(left > TimeSpan.Zero ? left : TimeSpan.Zero, cancel).ConfigureAwait(false);
            }
        }

        /// <summary>A service response, whatever it answers; on the receiver's thread.</summary>
        /// <param name="fault">Why the response could not be read.</param>
        public void Answered(RosbridgeMessage response, DropReason fault, HeadsetTime arrival)
        {
            if (response.Id == null || !response.Id.StartsWith(IdPrefix, StringComparison.Ordinal)) return;
            lock (_gate)
            {
                if (response.Id == _id && _awaited.TrySetResult(new RosTimeAnswer(response, fault, arrival))) return;
            }
            _faults.Count(SyncExchangeFault.WrongSequence);
        }

        /// <returns>Time from its start to the start of the next.</returns>
        async Task<TimeSpan> ExchangeAsync(LinkSender sender, CancellationToken cancel)
        {
            var (sent, answer) = await CallAsync(sender, cancel).ConfigureAwait(false);
            if (answer.Time is not { } time)
            {
                _status = LinkStatus.Waiting(Service + ": " + answer.Problem);
                return PauseAfterRefusal;
            }
            _resolution.Add(time, sent, answer.Arrival);
            if (_resolution.IsStopped) _status = LinkStatus.Waiting(Service + ": the clock stands still; is the simulation paused?");
            else if (_resolution.IsKnown) Take(new SyncExchange(sent, time, time, answer.Arrival, _resolution.Value));
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

        async Task<(HeadsetTime Sent, RosTimeAnswer Answer)> CallAsync(LinkSender sender, CancellationToken cancel)
        {
            using (var inTime = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                inTime.CancelAfter(ProtocolLimits.SyncReplyTimeout);
                try
                {
                    var awaited = NewCall(out var id);
                    var sent = await sender.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime, id), inTime.Token).ConfigureAwait(false);
                    return (sent, await awaited.OrCancelled(inTime.Token).ConfigureAwait(false));
                }
                catch (OperationCanceledException late) when (!cancel.IsCancellationRequested)
                {
                    throw new IOException(
                        Service + " did not answer within " + ProtocolLimits.SyncReplyTimeout.TotalSeconds + " s", late);
                }
            }
        }

        void Take(in SyncExchange exchange)
        {
            var fault = SyncExchangeRules.Check(exchange);
            if (fault == SyncExchangeFault.None && _synchroniser.Add(exchange, out fault) == SyncVerdict.SetAside)
                _faults.Count(SyncExchangeFault.Contradiction);
            _faults.Count(fault);
            _dropsInARow = fault == SyncExchangeFault.None ? 0 : _dropsInARow + 1;
            if (_dropsInARow == ProtocolLimits.SyncDropsInARow)
                throw new GatewayRefusalException(Service + ": " + _dropsInARow + " unusable answers in a row, the last: " + fault);
            if (_dropsInARow == 0) _status = LinkStatus.Connected;
        }
    }
}
