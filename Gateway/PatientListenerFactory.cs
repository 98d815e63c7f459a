using System.Net;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Microsoft.Extensions.Logging.Abstractions;
using Microsoft.Extensions.Options;

namespace Nowpose.Gateway;

/// <summary>Opens the port of the web server.</summary>
sealed class PatientListenerFactory(IOptions<SocketTransportOptions> options, Action<string> log) : IConnectionListenerFactory
{
    public ValueTask<IConnectionListener> BindAsync(EndPoint endpoint, CancellationToken cancellationToken = default)
    {
        var transport = options.Value;
        var socket = transport.CreateBoundListenSocket(endpoint);
        socket.Listen(transport.Backlog);
        var contexts = new SocketConnectionContextFactory(
            new SocketConnectionFactoryOptions
            {
                MaxReadBufferSize = transport.MaxReadBufferSize, MaxWriteBufferSize = transport.MaxWriteBufferSize,
            },
            NullLogger.Instance);
        return ValueTask.FromResult<IConnectionListener>(new PatientListener(socket, socket.AcceptAsync, contexts, log));
    }
}
