using System;
using System.IO;
using System.Net.Sockets;
using System.Threading;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Network
{
    /// <summary>Exchanges timestamps with the gateway over TCP, on a thread of its own so that stamps wait for nobody; reconnects for ever.</summary>
    public sealed class SyncClient : IDisposable
    {
        readonly ConnectionSettings _settings;
        readonly IHeadsetClock _clock;
        readonly ClockSynchroniser _synchroniser;
        readonly TimeSpan _interval;
        readonly CancellationTokenSource _stop = new CancellationTokenSource();
        readonly Thread _thread;
        volatile Stream _open;
        volatile LinkStatus _status = LinkStatus.Connecting;

        /// <summary>Starts at once.</summary>
        /// <param name="interval">From one exchange to the next.</param>
        /// <param name="synchroniser">Receives each exchange, on this client's thread.</param>
        public SyncClient(ConnectionSettings settings, IHeadsetClock clock, ClockSynchroniser synchroniser, TimeSpan interval)
        {
            _settings = settings;
            _clock = clock;
            _synchroniser = synchroniser;
            _interval = interval;
            _thread = new Thread(Run) { IsBackground = true, Name = "Nowpose clock sync" };
            _thread.Start();
        }

        public LinkStatus Status => _status;

        /// <summary>Exchanges that were dropped, by reason. Any thread.</summary>
        public SyncFaultCounters Faults { get; } = new SyncFaultCounters();

        /// <summary>Ends the connection and the thread.</summary>
        public void Dispose()
        {
            if (_stop.IsCancellationRequested) return;
            _stop.Cancel();
            _open?.Dispose();
            _thread.Join();
            _stop.Dispose();
            _status = LinkStatus.Idle;
        }

        void Run()
        {
            var backoff = new Backoff(new Random());
            do
            {
                try
                {
                    Serve(backoff);
                }
                catch (Exception failure) when (failure is IOException || failure is SocketException || failure is ObjectDisposedException)
                {
                    _status = LinkStatus.Waiting("clock sync: " + failure.Message);
                }
                catch (OperationCanceledException)
                {
                    return;
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
                stream.ReadTimeout = (int)ProtocolLimits.SyncReplyTimeout.TotalMilliseconds;
                var connection = new SyncConnection(stream, _clock);
                if (_settings.Token != null) connection.ShowToken(_settings.Token);
                ExchangeUntilStopped(connection, backoff);
            }
        }

        void ExchangeUntilStopped(SyncConnection connection, Backoff backoff)
        {
            var dropsInARow = 0;
            do
            {
                var fault = connection.Exchange(out var exchange);
                if (fault == SyncExchangeFault.None) _synchroniser.Add(exchange, out fault);
                Faults.Count(fault);
                dropsInARow = fault == SyncExchangeFault.None ? 0 : dropsInARow + 1;
                if (dropsInARow == ProtocolLimits.SyncDropsInARow)
                    throw new GatewayRefusalException(dropsInARow + " unusable replies in a row, the last: " + fault);
                if (dropsInARow > 0) continue;
                _status = LinkStatus.Connected;
                backoff.Reset();
            }
            while (!_stop.Token.WaitHandle.WaitOne(_interval));
        }
    }
}
