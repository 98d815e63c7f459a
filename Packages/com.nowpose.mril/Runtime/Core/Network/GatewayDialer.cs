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
        readonly ConnectionSettings _settings;
        readonly ServerTrust _trust;
        readonly ConnectionAttempts _attempts;
        readonly Func<string, Task<IPAddress[]>> _resolve;

        /// <param name="connect">Connects a client to an address and a port; null for a TCP connection.</param>
        /// <param name="resolve">Gets the addresses of a host name; null for those of the system.</param>
        public GatewayDialer(
            ConnectionSettings settings, Func<TcpClient, IPAddress, int, Task> connect = null, Func<string, Task<IPAddress[]>> resolve = null)
        {
            _settings = settings;
            _trust = new ServerTrust(settings.Pin);
            _attempts = new ConnectionAttempts(connect ?? ((tcp, address, port) => tcp.ConnectAsync(address, port)));
            _resolve = resolve ?? Dns.GetHostAddressesAsync;
        }

        /// <exception cref="GatewayRefusalException">
        /// The host name is unknown, the gateway refused the connection or did not respond in time, the network is down, the certificate is not
        /// trusted, or the gateway does not support TLS 1.2.
        /// </exception>
        /// <exception cref="OperationCanceledException">The operation was cancelled.</exception>
        public async Task<Stream> OpenAsync(int port, CancellationToken cancel)
        {
            using (var inTime = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                inTime.CancelAfter(ProtocolLimits.DialTimeout);
                var lookup = AddressesAsync();
                try
                {
                    return await OpenStreamAsync(lookup, port, inTime.Token).OrCancelled(inTime.Token).ConfigureAwait(false);
                }
                catch (Exception failure)
                {
                    cancel.ThrowIfCancellationRequested();
                    var address = _settings.Host + ":" + port;
                    if (inTime.IsCancellationRequested)
                        throw new GatewayRefusalException(address + ": " + NotInTime(lookup.IsCompleted), failure);
                    if (failure is GatewayRefusalException) throw;
                    if (failure.GetBaseException() is SocketException refused)
                        throw new GatewayRefusalException(
                            ConnectionMessages.NotConnected(address, _settings.IsLoopback, refused.SocketErrorCode), failure);
                    throw;
                }
            }
        }

        static string NotInTime(bool isResolved)
        {
            var seconds = ProtocolLimits.DialTimeout.TotalSeconds;
            return isResolved ? ConnectionMessages.NoResponse(seconds) : ConnectionMessages.NotResolved(seconds);
        }

        // IPv4 addresses come first, because a gateway listens on them by default.
        async Task<IPAddress[]> AddressesAsync()
        {
            if (IPAddress.TryParse(_settings.Host, out var literal)) return new[] { literal };
            var found = await _resolve(_settings.Host).ConfigureAwait(false);
            if (found.Length == 0) throw new SocketException((int)SocketError.HostNotFound);
            return found.OrderBy(address => address.AddressFamily == AddressFamily.InterNetwork ? 0 : 1).ToArray();
        }

        async Task<Stream> OpenStreamAsync(Task<IPAddress[]> lookup, int port, CancellationToken cancel)
        {
            var tcp = await _attempts.ConnectAsync(await lookup.ConfigureAwait(false), port, cancel).ConfigureAwait(false);
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

        // Unity's TLS derives its range of versions from this argument: with SslProtocols.None, it is empty, and every handshake fails.
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
                await secure.AuthenticateAsClientAsync(
                    _settings.Host, null, SslProtocols.Tls12, checkCertificateRevocation: false).ConfigureAwait(false);
                return secure;
            }
            catch (Exception failure) when (refusal != null || !(failure is IOException || failure is ObjectDisposedException))
            {
                // The outer exception often only refers to the inner one. Unity's TLS throws types of its own.
                throw new GatewayRefusalException(refusal ?? ConnectionMessages.TlsFailed(failure.GetBaseException().Message), failure);
            }
        }
    }
}
