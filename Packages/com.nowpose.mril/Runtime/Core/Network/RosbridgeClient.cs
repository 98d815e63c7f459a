using System;
using System.IO;
using System.Runtime.ExceptionServices;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Subscribes to the joint positions, the set-points ahead and the robot description over rosbridge and publishes this headset's diagnostics; reconnects for ever.</summary>
    public sealed class RosbridgeClient : IDisposable
    {
        static readonly TimeSpan DiagnosticsInterval = TimeSpan.FromSeconds(1);

        readonly Func<IWebSocketLink> _newLink;
        readonly IHeadsetClock _clock;
        readonly IRosbridgeListener _listener;
        readonly CancellationTokenSource _stop = new CancellationTokenSource();
        readonly NewestInBackground _descriptions;
        readonly Task _running;
        volatile LinkStatus _status = LinkStatus.Connecting;
        volatile Task _ending;
        long _lastHeard;

        /// <summary>Starts at once, on threads of the pool: no frame ever waits for it.</summary>
        /// <param name="newLink">Makes the link of each attempt.</param>
        public RosbridgeClient(Func<IWebSocketLink> newLink, IHeadsetClock clock, IRosbridgeListener listener)
        {
            _newLink = newLink;
            _clock = clock;
            _listener = listener;
            _descriptions = new NewestInBackground(Describe);
            // Away from the caller's synchronisation context: under Unity, continuations there wait for the next frame.
            _running = Task.Run(RunAsync);
        }

        public LinkStatus Status => _ending == null ? _status : LinkStatus.Idle;

        /// <summary>Completes when the client has been disposed of and its socket and tasks are gone; nobody has to wait for it.</summary>
        public Task Ended => _ending ?? _running;

        /// <summary>Ends the connection. Returns at once: a frame's thread waits for no socket. What is under way may still arrive.</summary>
        public void Dispose()
        {
            // Cancelling closes sockets on the thread that asks for it.
            if (_ending == null) _ending = Task.Run(EndAsync);
        }

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
                _status = end == null
                    ? LinkStatus.Waiting("joint positions: the gateway closed the connection")
                    : LinkStatus.Waiting("joint positions", end);
                await WaitAsync(backoff.Next()).ConfigureAwait(false);
            }
        }

        /// <returns>What the task threw, whatever it is (one that is not caught would end the session without a word); null at its end.</returns>
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
            using (var end = CancellationTokenSource.CreateLinkedTokenSource(_stop.Token))
            {
                await OpenAsync(link).ConfigureAwait(false);
                await SubscribeAsync(link, end.Token).ConfigureAwait(false);
                var receiving = ReceiveAsync(link, backoff, end.Token);
                var tending = TendAsync(link, end.Token);
                var first = await Task.WhenAny(receiving, tending).ConfigureAwait(false);
                end.Cancel();
                link.Dispose();
                var received = await EndOfAsync(receiving).ConfigureAwait(false);
                var tended = await EndOfAsync(tending).ConfigureAwait(false);
                // One that ends takes the other down; a limit that was broken is the reason even if its victim was quicker.
                var reason = received is MessageLimitException || first == receiving ? received : tended;
                if (reason != null) ExceptionDispatchInfo.Capture(reason).Throw();
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
                    throw new GatewayRefusalException("no answer within " + ProtocolLimits.PongTimeout.TotalSeconds + " s", late);
                }
            }
            Heard(_clock.Now);
        }

        static async Task SubscribeAsync(IWebSocketLink link, CancellationToken cancel)
        {
            await link.SendAsync(RosbridgeWriter.Subscribe(RosTopics.JointStates, RosTopics.JointStateType), cancel).ConfigureAwait(false);
            await link.SendAsync(
                RosbridgeWriter.Subscribe(RosTopics.JointTrajectory, RosTopics.JointTrajectoryType), cancel).ConfigureAwait(false);
            await link.SendAsync(RosbridgeWriter.Subscribe(RosTopics.RobotDescription, RosTopics.StringType), cancel).ConfigureAwait(false);
            await link.SendAsync(RosbridgeWriter.Advertise(RosTopics.Diagnostics, RosTopics.DiagnosticsType), cancel).ConfigureAwait(false);
        }

        async Task ReceiveAsync(IWebSocketLink link, Backoff backoff, CancellationToken cancel)
        {
            while (true)
            {
                var received = await NextAsync(link, cancel).ConfigureAwait(false);
                if (received.IsClosed) return;
                // Not before: a server that accepts and closes at once would be called again five times a second.
                _status = LinkStatus.Connected;
                backoff.Reset();
                Heard(received.Arrival);
                if (received.Text == null) _listener.Dropped(received.Dropped);
                else Take(received);
            }
        }

        async Task<ReceivedText> NextAsync(IWebSocketLink link, CancellationToken cancel)
        {
            try
            {
                return await link.ReceiveAsync(cancel).ConfigureAwait(false);
            }
            catch (MessageLimitException broken)
            {
                _listener.Dropped(broken.Reason);
                throw;
            }
        }

        void Take(in ReceivedText received)
        {
            if (!RosbridgeReader.TryRead(received.Text, out var message, out var reason)) _listener.Dropped(reason);
            else if (message.JointState != null) _listener.Received(message.JointState, received.Arrival);
            else if (message.JointTrajectory != null) _listener.Planned(message.JointTrajectory, received.Arrival);
            else if (message.Data != null) _descriptions.Add(message.Data);
        }

        // Whatever is wrong with it: a description must not keep the next one from being read.
        void Describe(string urdf)
        {
            try
            {
                _listener.Described(urdf);
            }
            catch (Exception)
            {
                _listener.Dropped(DropReason.NotUrdf);
            }
        }

        // Publishes diagnostics, and asks the time of a gateway that has been silent: the answer tells a quiet plant from a
        // connection that is gone without a word, as WiFi connections go.
        async Task TendAsync(IWebSocketLink link, CancellationToken cancel)
        {
            while (true)
            {
                await Task.Delay(DiagnosticsInterval, cancel).ConfigureAwait(false);
                var silence = _clock.Now - new HeadsetTime(new TimeSpan(Interlocked.Read(ref _lastHeard)));
                if (silence > ProtocolLimits.PongTimeout)
                    throw new IOException("nothing heard for " + ProtocolLimits.PongTimeout.TotalSeconds + " s");
                if (silence >= ProtocolLimits.PingInterval)
                    await link.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime), cancel).ConfigureAwait(false);
                var diagnostics = _listener.Diagnostics();
                if (diagnostics != null)
                    await link.SendAsync(
                        RosbridgeWriter.PublishDiagnostics(RosTopics.Diagnostics, diagnostics, RosTimeForm.Sec), cancel).ConfigureAwait(false);
            }
        }

        void Heard(HeadsetTime at) => Interlocked.Exchange(ref _lastHeard, at.SinceEpoch.Ticks);

        async Task WaitAsync(TimeSpan length)
        {
            try
            {
                await Task.Delay(length, _stop.Token).ConfigureAwait(false);
            }
            catch (OperationCanceledException)
            {
                // Stopping: the loop ends by itself.
            }
        }
    }
}
