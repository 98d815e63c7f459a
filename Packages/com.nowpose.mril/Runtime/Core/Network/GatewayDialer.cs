using System;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Security;
using System.Net.Sockets;
using System.Security.Authentication;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Opens a byte stream to the gateway: TCP with NoDelay, inside TLS if the settings require it.</summary>
    sealed class GatewayDialer
    {
        /// <summary>
        /// Time without a connection after which a second attempt starts. Longer than the round-trip time in a local network, so that a second
        /// attempt is rare unless a packet was lost.
        /// </summary>
        static readonly TimeSpan SecondAttempt = TimeSpan.FromMilliseconds(300);

        readonly ConnectionSettings _settings;
        readonly ServerTrust _trust;
        readonly Func<TcpClient, IPAddress, int, Task> _connect;

        /// <param name="connect">Connects a client to an address and a port; null for a TCP connection.</param>
        public GatewayDialer(ConnectionSettings settings, Func<TcpClient, IPAddress, int, Task> connect = null)
        {
            _settings = settings;
            _trust = new ServerTrust(settings.Pin);
            _connect = connect ?? ((tcp, address, port) => tcp.ConnectAsync(address, port));
        }

        /// <exception cref="GatewayRefusalException">
        /// The certificate is not trusted, the TLS version is too old, or the gateway did not respond in time.
        /// </exception>
        /// <exception cref="SocketException">The gateway refused the connection, or the network is down.</exception>
        /// <exception cref="OperationCanceledException">The operation was cancelled.</exception>
        public async Task<Stream> OpenAsync(int port, CancellationToken cancel)
        {
            using (var inTime = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                inTime.CancelAfter(ProtocolLimits.DialTimeout);
                try
                {
                    return await TryAllAsync(port, inTime.Token).OrCancelled(inTime.Token).ConfigureAwait(false);
                }
                catch (Exception failure)
                {
                    cancel.ThrowIfCancellationRequested();
                    if (inTime.IsCancellationRequested)
                        throw new GatewayRefusalException(
                            _settings.Host + ":" + port + ": " + ConnectionMessages.NoResponse(ProtocolLimits.DialTimeout.TotalSeconds), failure);
                    throw;
                }
            }
        }

        async Task<Stream> TryAllAsync(int port, CancellationToken cancel)
        {
            var addresses = await AddressesAsync().ConfigureAwait(false);
            for (var i = 0; ; i++)
            {
                cancel.ThrowIfCancellationRequested();
                try
                {
                    return await OpenAsync(addresses[i], port, cancel).ConfigureAwait(false);
                }
                catch (SocketException) when (i + 1 < addresses.Length)
                {
                    // Tries the next address: the gateway may listen only on another of its addresses, or this machine may not support this
                    // address's protocol.
                }
            }
        }

        // IPv4 addresses come first, because a gateway listens on them by default and an address without a response uses up the timeout.
        async Task<IPAddress[]> AddressesAsync()
        {
            if (IPAddress.TryParse(_settings.Host, out var literal)) return new[] { literal };
            var found = await Dns.GetHostAddressesAsync(_settings.Host).ConfigureAwait(false);
            if (found.Length == 0) throw new SocketException((int)SocketError.HostNotFound);
            return found.OrderBy(address => address.AddressFamily == AddressFamily.InterNetwork ? 0 : 1).ToArray();
        }

        async Task<Stream> OpenAsync(IPAddress address, int port, CancellationToken cancel)
        {
            var tcp = await ConnectAsync(address, port, cancel).ConfigureAwait(false);
            try
            {
                // Closing the socket is the only way to cancel a connection attempt or a TLS handshake on .NET Standard 2.1.
                using (cancel.Register(tcp.Dispose))
                {
                    var plain = tcp.GetStream();
                    return _settings.Security == TransportSecurity.Plain ? plain : await SecureAsync(plain).ConfigureAwait(false);
                }
            }
            catch
            {
                tcp.Dispose();
                throw;
            }
        }

        // The system repeats a lost packet of a connection attempt only after a second. A second attempt replaces it sooner. The attempt that ends
        // first decides, because a refusal applies to both.
        async Task<TcpClient> ConnectAsync(IPAddress address, int port, CancellationToken cancel)
        {
            using (var stop = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                var first = AttemptAsync(address, port, stop.Token);
                var ended = first;
                await Task.WhenAny(first, Task.Delay(SecondAttempt, stop.Token)).ConfigureAwait(false);
                if (!first.IsCompleted)
                {
                    var second = AttemptAsync(address, port, stop.Token);
                    ended = await Task.WhenAny(first, second).ConfigureAwait(false);
                    _ = (ended == first ? second : first).ContinueWith(
                        DisposeResult, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
                }

                // Ends the other attempt and the delay.
                stop.Cancel();
                return await ended.ConfigureAwait(false);
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

        async Task<Stream> SecureAsync(Stream plain)
        {
            string refusal = null;
            var secure = new SslStream(plain, leaveInnerStreamOpen: false, (sender, certificate, chain, errors) =>
            {
                refusal = _trust.Refusal(certificate, errors, DateTime.Now);
                return refusal == null;
            });
            try
            {
                // SslProtocols.None lets the platform choose its best version; .NET Standard 2.1 has no constant for TLS 1.3.
                await secure.AuthenticateAsClientAsync(
                    _settings.Host, null, SslProtocols.None, checkCertificateRevocation: false).ConfigureAwait(false);
                if (secure.SslProtocol < SslProtocols.Tls12)
                    throw new GatewayRefusalException(ConnectionMessages.TlsVersion(secure.SslProtocol));
                return secure;
            }
            catch (AuthenticationException failure)
            {
                throw new GatewayRefusalException(refusal ?? ConnectionMessages.TlsFailed(failure.Message), failure);
            }
        }
    }
}
