using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Network
{
    /// <summary>
    /// Exchanges timestamps with the gateway over TCP; reconnects after failures. Has its own thread, so that it reads the clock without
    /// delay.
    /// </summary>
    sealed class SyncClient : IDisposable
    {
        readonly ConnectionSettings _settings;
        readonly IHeadsetClock _clock;
        readonly ClockSynchroniser _synchroniser;
        readonly SyncFaultCounters _faults;
        readonly ExchangePace _pace;
        readonly Action _responds;
        readonly CancellationTokenSource _stop = new CancellationTokenSource();
        readonly Task _running;
        volatile Stream _open;
        volatile LinkStatus _status = LinkStatus.Connecting;
        volatile Task _ending;

        /// <summary>Creates a client that connects immediately.</summary>
        /// <param name="synchroniser">Receives each exchange, on this client's thread.</param>
        /// <param name="faults">Counts dropped exchanges.</param>
        /// <param name="pace">Schedule of the exchanges; used by this client only.</param>
        /// <param name="responds">Called at the first response over each connection, on this client's thread; null for no call.</param>
        public SyncClient(
            ConnectionSettings settings, IHeadsetClock clock, ClockSynchroniser synchroniser, SyncFaultCounters faults, ExchangePace pace,
            Action responds = null)
        {
            _settings = settings;
            _clock = clock;
            _synchroniser = synchroniser;
            _faults = faults;
            _pace = pace;
            _responds = responds;
            // LongRunning creates a new thread. The scheduler is explicit because the caller's scheduler may run on the frame loop's thread.
            _running = Task.Factory.StartNew(Run, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        }

        public LinkStatus Status => _ending == null ? _status : LinkStatus.Idle;

        /// <summary>Completes after disposal, when the socket and the thread have ended; waiting for it is optional.</summary>
        public Task Ended => _ending ?? _running;

        /// <summary>Ends the connection and the thread. Returns at once and does not wait for the socket.</summary>
        public void Dispose()
        {
            // Runs on the thread pool, because cancelling closes sockets on the calling thread.
            if (_ending == null) _ending = Task.Run(EndAsync);
        }

        async Task EndAsync()
        {
            _stop.Cancel();
            _open?.Dispose();
            await _running.ConfigureAwait(false);
            _stop.Dispose();
        }

        void Run()
        {
            Thread.CurrentThread.Name = "Nowpose clock sync";
            var backoff = new Backoff(new Random());
            do
            {
                try
                {
                    Serve(backoff);
                }
                // Catches every exception: if the thread ended, the clock would never be synchronised again. Mono's TLS streams wrap exceptions.
                catch (Exception failure)
                {
                    _status = LinkStatus.Waiting("clock sync", failure);
                }
            }
            while (!_stop.Token.WaitHandle.WaitOne(backoff.Next()));
        }

        void Serve(Backoff backoff)
        {
            using (var stream = new GatewayDialer(_settings).OpenAsync(_settings.SyncPort, _stop.Token).GetAwaiter().GetResult())
            {
                _open = stream;
                _stop.Token.ThrowIfCancellationRequested();
                var connection = new SyncConnection(stream, _clock, _faults);
                if (_settings.Token != null) connection.ShowToken(_settings.Token);
                ExchangeUntilStopped(connection, backoff);
            }
        }

        void ExchangeUntilStopped(SyncConnection connection, Backoff backoff)
        {
            var opened = _clock.Now;
            var intake = new ExchangeIntake(_synchroniser, _faults, ConnectionMessages.UnusableReplies);
            TimeSpan pause;
            do
            {
                var begun = _clock.Now;
                var fault = connection.Exchange(out var exchange);
                var ended = _clock.Now;
                if (intake.Add(exchange, fault))
                {
                    if (_status.State != LinkState.Connected) _responds?.Invoke();
                    _status = LinkStatus.Connected;
                    backoff.ResetAfter(ended - opened);
                }
                pause = begun + _pace.Next(_synchroniser, ended) - ended;
            }
            while (!_stop.Token.WaitHandle.WaitOne(pause > TimeSpan.Zero ? pause : TimeSpan.Zero));
        }
    }
}
