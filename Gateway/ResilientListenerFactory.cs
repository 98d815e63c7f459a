using System.Net;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Microsoft.Extensions.Logging.Abstractions;
using Microsoft.Extensions.Options;

namespace Nowpose.Gateway;

/// <summary>Creates the <see cref="ResilientListener"/> on the web server's port.</summary>
sealed class ResilientListenerFactory(IOptions<SocketTransportOptions> options, ConnectionCounters counters, Action<string> log)
    : IConnectionListenerFactory
{
    readonly SocketTransportFactory _sockets = new(options, NullLoggerFactory.Instance);

    public async ValueTask<IConnectionListener> BindAsync(EndPoint endpoint, CancellationToken cancellationToken = default) =>
        new ResilientListener(await _sockets.BindAsync(endpoint, cancellationToken), counters, log);
}
