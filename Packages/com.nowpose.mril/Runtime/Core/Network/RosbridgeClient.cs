using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.ExceptionServices;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>
    /// Subscribes over rosbridge to topics of robots and of the cell, and publishes this headset's diagnostics and its displayed joints.
    /// Reconnects after every failure.
    /// </summary>
    sealed class RosbridgeClient : IDisposable
    {
        /// <summary>
        /// Interval of the diagnostics, and the interval while the state of the pose changes, so that the operations page shows the change at once.
        /// </summary>
        static readonly TimeSpan DiagnosticsInterval = ClockTicks.Span(1), MinDiagnosticsInterval = ClockTicks.Span(0.2);

        /// <summary>
        /// Interval of the displayed joints. It is sufficient for a smooth display, and its traffic is small compared with the received traffic.
        /// </summary>
        static readonly TimeSpan DisplayedInterval = ClockTicks.Span(0.05);

        static readonly TimeSpan TimerStep = new TimeSpan(TimeSpan.TicksPerMillisecond);

        readonly Func<IWebSocketLink> _newLink;
        readonly IHeadsetClock _clock;
        readonly IRosbridgeListener _listener;
        readonly bool _publishesDisplayed;
        readonly RosTimeExchanges _rosTime;
        readonly CancellationTokenSource _stop = new CancellationTokenSource();
        readonly Subscriptions _subscriptions;
        readonly Dictionary<string, NewestInBackground> _descriptions = new Dictionary<string, NewestInBackground>(StringComparer.Ordinal);
        readonly Task _running;
        volatile LinkStatus _status = LinkStatus.Connecting;
        volatile Task _ending;
        volatile TaskCompletionSource<bool> _silent;
        ReportedErrors _errors;
        long _lastReceived;

        /// <summary>Starts the client at once, on the thread pool; frames never wait for it.</summary>
        /// <param name="newLink">Creates the link of each attempt.</param>
        /// <param name="subscriptions">Topics to subscribe to; more can be added while the client runs.</param>
        /// <param name="publishesDisplayed">Whether to publish the listener's displayed joints.</param>
        /// <param name="rosTime">Exchanges timestamps with the same server; null if the control time has another source.</param>
        public RosbridgeClient(
            Func<IWebSocketLink> newLink, IHeadsetClock clock, IRosbridgeListener listener, Subscriptions subscriptions,
            bool publishesDisplayed = true, RosTimeExchanges rosTime = null)
        {
            _subscriptions = subscriptions;
            _publishesDisplayed = publishesDisplayed;
            _newLink = newLink;
            _clock = clock;
            _listener = listener;
            _rosTime = rosTime;
            // Runs outside the caller's synchronisation context, because under Unity its continuations would wait for the next frame.
            _running = Task.Run(RunAsync);
        }

        public LinkStatus Status => _ending == null ? _status : LinkStatus.Idle;

        /// <summary>State of the clock exchanges over this connection; idle if there are none.</summary>
        public LinkStatus ClockStatus
        {
            get
            {
                var status = _rosTime == null ? LinkStatus.Idle : Status;
                return status.State == LinkState.Connected ? _rosTime.Status : status;
            }
        }

        /// <summary>Completes after disposal, when the socket and the tasks have ended; waiting for it is optional.</summary>
        public Task Ended => _ending ?? _running;

        /// <summary>Ends the connection. Returns at once and does not wait for the socket; messages in flight may still arrive.</summary>
        public void Dispose()
        {
            // Runs on the thread pool, because cancelling closes sockets on the calling thread.
            if (_ending == null) _ending = Task.Run(EndAsync);
        }

        /// <summary>
        /// Ends a connection that has been silent for longer than <see cref="ProtocolLimits.MaxSilence"/>, because the gateway responds to another
        /// connection: after a gap of the network, TCP sends lost data again only after a time that may be as long as the gap.
        /// </summary>
        public bool EndIfSilent() => Silence > ProtocolLimits.MaxSilence && _silent != null && _silent.TrySetResult(true);

        async Task EndAsync()
        {
            _stop.Cancel();
            await _running.ConfigureAwait(false);
            _stop.Dispose();
        }

        async Task RunAsync()
        {
            var backoff = new Backoff(new Random());
            while (!_stop.IsCancellationRequested)
            {
                var end = await EndOfAsync(ServeAsync(backoff)).ConfigureAwait(false);
                _status = LinkStatus.Waiting("joint positions", end);
                await EndOfAsync(Task.Delay(backoff.Next(), _stop.Token)).ConfigureAwait(false);
            }
        }

        /// <summary>Awaits a task and catches every exception, because an uncaught exception would end the session silently.</summary>
        /// <returns>The task's exception; null if the task ended normally.</returns>
        static async Task<Exception> EndOfAsync(Task task)
        {
            try
            {
                await task.ConfigureAwait(false);
                return null;
            }
            catch (Exception failure)
            {
                return failure;
            }
        }

        async Task ServeAsync(Backoff backoff)
        {
            using (var link = _newLink())
            using (var sender = new LinkSender(link, _clock))
            using (var end = CancellationTokenSource.CreateLinkedTokenSource(_stop.Token))
            {
                await OpenAsync(link).ConfigureAwait(false);
                _listener.Connected(_clock.Now);
                var silent = _silent = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
                var subscribing = SubscribeAsync(sender, end.Token);
                var receiving = ReceiveAsync(link, backoff, end.Token);
                var publishing = PublishAsync(sender, end.Token);
                var exchanging = _rosTime == null ? publishing : _rosTime.RunAsync(sender, end.Token);
                var all = new[] { receiving, subscribing, publishing, exchanging, WatchAsync(silent, end.Token) };
                var first = await Task.WhenAny(all).ConfigureAwait(false);
                end.Cancel();
                link.Dispose();
                foreach (var task in all) await EndOfAsync(task).ConfigureAwait(false);
                // The first task that ends cancels the others. If a received message exceeds a limit, or the gateway closes the connection, that is
                // reported as the cause, even if a sending task fails first.
                var received = await EndOfAsync(receiving).ConfigureAwait(false);
                var reason = received is EndOfStreamException || received is MessageLimitException
                    ? received : await EndOfAsync(first).ConfigureAwait(false);
                ExceptionDispatchInfo.Capture(reason).Throw();
            }
        }

        async Task OpenAsync(IWebSocketLink link)
        {
            using (var inTime = CancellationTokenSource.CreateLinkedTokenSource(_stop.Token))
            {
                inTime.CancelAfter(ProtocolLimits.PongTimeout);
                try
                {
                    await link.OpenAsync(inTime.Token).ConfigureAwait(false);
                }
                catch (OperationCanceledException late) when (!_stop.IsCancellationRequested)
                {
                    throw new GatewayRefusalException(ConnectionMessages.NoResponse(ProtocolLimits.PongTimeout.TotalSeconds), late);
                }
            }
            MarkReceived(_clock.Now);
        }

        async Task SubscribeAsync(LinkSender sender, CancellationToken cancel)
        {
            for (var i = 0; ; i++)
            {
                var (topic, type) = await _subscriptions.At(i, cancel).ConfigureAwait(false);
                await sender.SendAsync(RosbridgeWriter.Subscribe(topic, type), cancel).ConfigureAwait(false);
            }
        }

        async Task AdvertiseAsync(LinkSender sender, CancellationToken cancel)
        {
            await sender.SendAsync(RosbridgeWriter.Advertise(RosTopics.Diagnostics, RosTopics.DiagnosticsType), cancel).ConfigureAwait(false);
            if (_publishesDisplayed)
                await sender.SendAsync(RosbridgeWriter.Advertise(RosTopics.Displayed, RosTopics.JointStateType), cancel).ConfigureAwait(false);
        }

        async Task ReceiveAsync(IWebSocketLink link, Backoff backoff, CancellationToken cancel)
        {
            var reader = new RosbridgeReader();
            var opened = _clock.Now;
            _errors = new ReportedErrors();
            try
            {
                var reason = await link.ReceiveAsync(Arrived, cancel).ConfigureAwait(false);
                throw new EndOfStreamException(ConnectionMessages.Closed(InputException.OneLine(reason ?? "", ProtocolLimits.NameLength)));
            }
            catch (MessageLimitException broken)
            {
                _listener.Dropped(broken.Reason);
                throw;
            }

            void Arrived(ReceivedText received)
            {
                _status = _errors.StatusAt(received.Arrival);
                backoff.ResetAfter(received.Arrival - opened);
                MarkReceived(received.Arrival);
                if (received.Dropped == DropReason.None) Take(reader, received);
                else _listener.Dropped(received.Dropped);
            }
        }

        void Take(RosbridgeReader reader, in ReceivedText received)
        {
            var isRead = reader.TryRead(received.Utf8.Span, out var message, out var reason);
            if (message?.Op == RosbridgeOp.ServiceResponse) _rosTime?.Answered(message, reason, received.Arrival);
            if (!isRead) _listener.Dropped(reason);
            else if (message.Op == RosbridgeOp.Status) _status = _errors.Add(message, received.Arrival);
            else if (message.JointState != null) _listener.Received(message.JointState, received.Arrival, message.RobotTopic.Robot);
            else if (message.JointTrajectory != null) _listener.Planned(message.JointTrajectory, received.Arrival, message.RobotTopic.Robot);
            else if (message.Transforms != null)
                _listener.FramesReceived(message.Transforms, isStationary: message.Topic == RosTopics.TfStatic, received.Arrival);
            else if (message.Signals != null) _listener.SignalsReceived(message.Signals, received.Arrival);
            else if (message.JointStatus != null) _listener.StatusReceived(message.JointStatus, received.Arrival);
            else if (message.SignalStatus != null) _listener.SignalStatusReceived(message.SignalStatus, received.Arrival);
            else if (message.Data != null && message.RobotTopic.Kind == RosTopics.Version) _listener.VersionReceived(message.Data);
            else if (message.Namespaces != null) _listener.NamespacesReceived(message.Namespaces);
            else if (message.Data != null) DescriptionsOf(message.RobotTopic.Robot).Add(message.Data);
        }

        // Needs no lock, because it is called only on the receiving threads of successive connections.
        NewestInBackground DescriptionsOf(string robot)
        {
            if (_descriptions.TryGetValue(robot, out var known)) return known;
            var descriptions = new NewestInBackground(urdf => Describe(urdf, robot));
            _descriptions.Add(robot, descriptions);
            return descriptions;
        }

        // Catches every exception: an invalid description must not prevent the client from reading the next description.
        void Describe(string urdf, string robot)
        {
            try
            {
                _listener.Described(urdf, robot);
            }
            catch (Exception)
            {
                _listener.Dropped(DropReason.NotUrdf);
            }
        }

        async Task PublishAsync(LinkSender sender, CancellationToken cancel)
        {
            await AdvertiseAsync(sender, cancel).ConfigureAwait(false);
            var last = _clock.Now;
            while (true)
            {
                await Task.Delay(_publishesDisplayed ? DisplayedInterval : MinDiagnosticsInterval, cancel).ConfigureAwait(false);
                var displayed = _publishesDisplayed ? _listener.Displayed() : null;
                if (displayed != null)
                    await sender.SendAsync(RosbridgeWriter.Publish(RosTopics.Displayed, displayed), cancel).ConfigureAwait(false);
                var now = _clock.Now;
                if (now - last < (_listener.HasPoseChanged ? MinDiagnosticsInterval : DiagnosticsInterval)) continue;
                last = now;
                await ReportAsync(sender, cancel).ConfigureAwait(false);
            }
        }

        // Publishes diagnostics. After a silence it also calls the gateway's time service, because a response distinguishes an idle plant
        // from a connection that was lost without notice, as happens on WiFi.
        async Task ReportAsync(LinkSender sender, CancellationToken cancel)
        {
            if (Silence >= ProtocolLimits.PingInterval)
                await sender.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime), cancel).ConfigureAwait(false);
            var diagnostics = _listener.Diagnostics();
            if (diagnostics != null)
                await sender.SendAsync(RosbridgeWriter.Publish(RosTopics.Diagnostics, diagnostics), cancel).ConfigureAwait(false);
            // Without a gateway, the call could delay an exchange of the clock.
            if (_rosTime == null && _listener.NeedsNamespaces)
                await sender.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTopics), cancel).ConfigureAwait(false);
        }

        // Runs separately from the tasks that send, because a send over a lost connection may never complete.
        async Task WatchAsync(TaskCompletionSource<bool> silent, CancellationToken cancel)
        {
            while (true)
            {
                var left = ProtocolLimits.PongTimeout - Silence;
                if (silent.Task.IsCompleted) throw new IOException(ConnectionMessages.NothingReceived(ProtocolLimits.MaxSilence.TotalSeconds));
                if (left < TimeSpan.Zero) throw new IOException(ConnectionMessages.NothingReceived(ProtocolLimits.PongTimeout.TotalSeconds));
                // Waits one timer step longer: the timer counts whole steps and would otherwise fire repeatedly within the last step.
                await (await Task.WhenAny(silent.Task, Task.Delay(left + TimerStep, cancel)).ConfigureAwait(false)).ConfigureAwait(false);
            }
        }

        TimeSpan Silence => _clock.Now - new HeadsetTime(new TimeSpan(Interlocked.Read(ref _lastReceived)));

        void MarkReceived(HeadsetTime at) => Interlocked.Exchange(ref _lastReceived, at.SinceEpoch.Ticks);
    }
}
