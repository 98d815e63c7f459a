using System;
using System.Collections.Generic;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>Opens a TCP connection to the first address of a host that responds.</summary>
    sealed class ConnectionAttempts
    {
        /// <summary>
        /// Time without a connection after which the next attempt starts. Longer than the round-trip time in a local network, so that a second
        /// attempt is rare unless a packet was lost or an address does not respond.
        /// </summary>
        static readonly TimeSpan NextAttempt = TimeSpan.FromMilliseconds(300);

        readonly Func<TcpClient, IPAddress, int, Task> _connect;

        public ConnectionAttempts(Func<TcpClient, IPAddress, int, Task> connect) => _connect = connect;

        /// <summary>
        /// Tries each address twice, the next one as soon as an address has refused or has not responded in time. Earlier attempts continue.
        /// </summary>
        /// <remarks>
        /// An address may not respond, or refuse: the gateway may listen only on another of its addresses, or this machine may not support the
        /// protocol of the address. The second attempt replaces a lost packet sooner than the system, which repeats it only after a second.
        /// </remarks>
        /// <exception cref="SocketException">All addresses refused the connection.</exception>
        public async Task<TcpClient> ConnectAsync(IPAddress[] addresses, int port, CancellationToken cancel)
        {
            var planned = addresses.Concat(addresses).ToList();
            var attempts = new List<(IPAddress Address, Task<TcpClient> Result)>();
            var refused = new HashSet<IPAddress>();
            Task<TcpClient> decisive = null;
            using (var stop = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                try
                {
                    while (decisive == null)
                    {
                        cancel.ThrowIfCancellationRequested();
                        if (planned.Count > 0)
                        {
                            attempts.Add((planned[0], AttemptAsync(planned[0], port, stop.Token)));
                            planned.RemoveAt(0);
                        }
                        var pause = Task.Delay(planned.Count > 0 ? NextAttempt : Timeout.InfiniteTimeSpan, stop.Token);
                        var open = attempts.Where(attempt => !refused.Contains(attempt.Address)).ToList();
                        var ended = await Task.WhenAny(open.Select(attempt => attempt.Result).Append(pause)).ConfigureAwait(false);
                        if (ended == pause) continue;
                        var (address, result) = open.Find(attempt => attempt.Result == ended);
                        // A refusal applies to all attempts to the address.
                        if (result.Exception?.InnerException is SocketException) refused.Add(address);
                        planned.RemoveAll(refused.Contains);
                        if (!refused.Contains(address) || addresses.All(refused.Contains)) decisive = result;
                    }
                }
                finally
                {
                    // Ends the other attempts and the pause.
                    stop.Cancel();
                    foreach (var (_, result) in attempts)
                        if (result != decisive) _ = result.ContinueWith(DisposeResult, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
                }

                return await decisive.ConfigureAwait(false);
            }
        }

        async Task<TcpClient> AttemptAsync(IPAddress address, int port, CancellationToken cancel)
        {
            // The address family is explicit, because without it a client supports only IPv4 under Mono and IL2CPP.
            var tcp = new TcpClient(address.AddressFamily) { NoDelay = true };
            try
            {
                using (cancel.Register(tcp.Dispose))
                    await _connect(tcp, address, port).ConfigureAwait(false);
                return tcp;
            }
            catch
            {
                tcp.Dispose();
                throw;
            }
        }

        // Reads the exception of a failed attempt, so that it is not reported as unobserved.
        static void DisposeResult(Task<TcpClient> attempt)
        {
            if (attempt.Status == TaskStatus.RanToCompletion) attempt.Result.Dispose();
            else _ = attempt.Exception;
        }
    }
}
