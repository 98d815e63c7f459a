using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;

namespace Nowpose.Gateway;

/// <summary>Accepts connections for the web server, and goes on after any error of the system.</summary>
/// <remarks>
/// Kestrel's own listener tries again at once, so it takes a whole processor while there are no file descriptors left; and it ends for good
/// at errors that pass.
/// </remarks>
/// <param name="accept">Accepts the next connection.</param>
sealed class PatientListener(
    Socket socket, Func<CancellationToken, ValueTask<Socket>> accept, SocketConnectionContextFactory contexts, Action<string> log) : IConnectionListener
{
    internal static readonly TimeSpan PauseAfterFailure = TimeSpan.FromMilliseconds(50);

    readonly CancellationTokenSource _stop = new();

    public EndPoint EndPoint { get; } = socket.LocalEndPoint;

    /// <returns>Null when it was unbound.</returns>
    public async ValueTask<ConnectionContext> AcceptAsync(CancellationToken cancellationToken = default)
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(_stop.Token, cancellationToken);
        while (!stop.IsCancellationRequested)
        {
            Socket accepted = null;
            try
            {
                accepted = DescriptorLimit.Guarded(await accept(stop.Token));
                accepted.NoDelay = true;
                return contexts.Create(accepted);
            }
            catch (Exception e) when (!stop.IsCancellationRequested)
            {
                // All of them: an exception that leaves this method closes the port for good.
                accepted?.Dispose();
                await PauseAsync(e, stop.Token);
            }
            catch (OperationCanceledException)
            {
                // Unbound.
            }
            catch (Exception e) when (e is SocketException or ObjectDisposedException)
            {
                // Unbound.
            }
        }

        return null;
    }

    public ValueTask UnbindAsync(CancellationToken cancellationToken = default)
    {
        _stop.Cancel();
        socket.Dispose();
        return ValueTask.CompletedTask;
    }

    public async ValueTask DisposeAsync()
    {
        await UnbindAsync();
        contexts.Dispose();
        _stop.Dispose();
    }

    async Task PauseAsync(Exception failure, CancellationToken stop)
    {
        // A peer that went away before it was accepted is no failure.
        if (failure is SocketException { SocketErrorCode: SocketError.ConnectionReset or SocketError.ConnectionAborted }) return;
        log($"websocket: a connection could not be accepted ({failure.GetType().Name}: {failure.Message})");
        await Task.Delay(PauseAfterFailure, stop).ContinueWith(_ => { }, TaskScheduler.Default);
    }
}
