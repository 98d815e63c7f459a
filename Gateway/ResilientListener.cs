using System.Net;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Connections.Features;

namespace Nowpose.Gateway;

/// <summary>Accepts connections for the web server, and continues after an error of the operating system.</summary>
/// <remarks>
/// Kestrel closes a port permanently at the first exception of its listener. This listener keeps the last file descriptors free, because without a
/// free descriptor, Kestrel's own listener would fully load a processor core.
/// </remarks>
/// <param name="counters">Counts the connections that are refused because of the number of file descriptors.</param>
sealed class ResilientListener(IConnectionListener inner, ConnectionCounters counters, Action<string> log) : IConnectionListener
{
    internal static readonly TimeSpan PauseAfterFailure = TimeSpan.FromMilliseconds(50);

    readonly CancellationTokenSource _stop = new();

    public EndPoint EndPoint => inner.EndPoint;

    /// <summary>Waits for the next connection.</summary>
    /// <returns>The connection; null after the listener was unbound.</returns>
    public async ValueTask<ConnectionContext> AcceptAsync(CancellationToken cancellationToken = default)
    {
        while (!_stop.IsCancellationRequested)
        {
            ConnectionContext accepted = null;
            try
            {
                accepted = await inner.AcceptAsync(cancellationToken);
                if (accepted?.Features.Get<IConnectionSocketFeature>()?.Socket is { } socket) DescriptorLimit.Guard(socket);
                return accepted;
            }
            catch (Exception e) when (!_stop.IsCancellationRequested && !cancellationToken.IsCancellationRequested)
            {
                if (accepted != null) await accepted.DisposeAsync();
                counters.CountFailure(e);
                log(RequestMessages.NotAccepted(e.GetType().Name, e.Message));
                await Task.Delay(PauseAfterFailure, _stop.Token).ContinueWith(_ => { }, TaskScheduler.Default);
            }
        }

        return null;
    }

    public async ValueTask UnbindAsync(CancellationToken cancellationToken = default)
    {
        await _stop.CancelAsync();
        await inner.UnbindAsync(cancellationToken);
    }

    public ValueTask DisposeAsync() => inner.DisposeAsync();
}
